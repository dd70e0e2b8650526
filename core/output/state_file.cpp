// Rows of the state file.
#include "core/output/state_file.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "sluice/error.hpp"

namespace sluice {

Field particle_field(const std::string& option, const std::string& name, const Plan& plan) {
  const FieldSet planned = plan.fields();
  std::string known;
  for (uint32_t f = 0; f < field_count; ++f) {
    const Field field = static_cast<Field>(f);
    if (!planned.has(field) || is_integer(field) || info(field).length != Length::fluid) continue;
    if (info(field).name == name) return field;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", info(field).name);
  }
  throw InputError(fmt::format("{}: found \"{}\", expected fields of particles that this scene has: {}",
                               option, name, known));
}

StateColumns columns_of(Field field, const Simulator& simulator) {
  const std::string name(info(field).name);
  StateColumns columns{{}, simulator.reals(field)};
  switch (components(info(field).type)) {
    case 1: columns.names = {name}; break;
    case 2: columns.names = {name + "_x", name + "_y"}; break;
    default: columns.names = {name + "_xx", name + "_xy", name + "_yx", name + "_yy"};
  }
  return columns;
}

void write_state(OutputFile& file, const Snapshot& snapshot, Precision precision,
                 const std::vector<StateColumns>& more) {
  std::string header = "id,x,y,vx,vy,density,pressure";
  for (const StateColumns& columns : more)
    for (const std::string& name : columns.names) header += ',' + name;
  file.write(header + '\n');
  std::string row;
  for (size_t i = 0; i < snapshot.x.size(); ++i) {
    row = std::to_string(i);
    const Vec2 x = snapshot.x[i], v = snapshot.v[i];
    const double density = snapshot.step == 0 ? 0 : snapshot.density[i],
                 pressure = snapshot.step == 0 ? 0 : snapshot.pressure[i];
    for (const double value : {x.x, x.y, v.x, v.y, density, pressure})
      row += ',' + round_trip(value, precision);
    for (const StateColumns& columns : more)
      for (size_t k = 0; k < columns.names.size(); ++k)
        row += ',' + round_trip(columns.values[columns.names.size() * i + k], precision);
    row += '\n';
    file.write(row);
  }
  file.commit();
}

}  // namespace sluice

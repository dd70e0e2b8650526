// Rows of the state file.
#include "core/output/state_file.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "sluice/error.hpp"

namespace sluice {

StateColumns columns_of(const std::string& option, const std::string& field, const Simulator& simulator) {
  const FieldSet planned = simulator.plan().fields();
  std::string known;
  for (uint32_t f = 0; f < field_count; ++f) {
    const Field candidate = static_cast<Field>(f);
    const FieldInfo& row = info(candidate);
    if (!planned.has(candidate) || is_integer(candidate) || row.length != Length::fluid) continue;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", row.name);
    if (row.name != field) continue;
    StateColumns columns{{}, simulator.reals(candidate)};
    if (row.type == Type::real) columns.names = {field};
    if (row.type == Type::vec2) columns.names = {field + "_x", field + "_y"};
    if (row.type == Type::vec4) columns.names = {field + "_xx", field + "_xy", field + "_yx", field + "_yy"};
    return columns;
  }
  throw InputError(fmt::format("{}: found \"{}\", expected fields of particles that this scene has: {}",
                               option, field, known));
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

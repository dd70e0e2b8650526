// Rows of the state file.
#include "core/output/state_file.hpp"

#include "core/text.hpp"

namespace sluice {

void write_state(OutputFile& file, const Snapshot& snapshot, Precision precision) {
  file.write("id,x,y,vx,vy,density,pressure\n");
  std::string row;
  for (size_t i = 0; i < snapshot.x.size(); ++i) {
    row = std::to_string(i);
    const Vec2 x = snapshot.x[i], v = snapshot.v[i];
    const double density = snapshot.step == 0 ? 0 : snapshot.density[i],
                 pressure = snapshot.step == 0 ? 0 : snapshot.pressure[i];
    for (const double value : {x.x, x.y, v.x, v.y, density, pressure})
      row += ',' + round_trip(value, precision);
    row += '\n';
    file.write(row);
  }
  file.commit();
}

}  // namespace sluice

// The state of a run as CSV: id,x,y,vx,vy,density,pressure in id order.
#pragma once

#include "core/output/output_file.hpp"
#include "core/solver/simulator.hpp"

namespace sluice {

/// Further columns of the state: a field's numbers, as many per particle as it has columns.
struct StateColumns {
  std::vector<std::string> names;
  std::vector<double> values;
};

/// Writes the rows of `snapshot`, with `more` behind, and commits the file. At step 0 density and pressure
/// have not been computed by a step yet and are written as 0.
void write_state(OutputFile& file, const Snapshot& snapshot, Precision precision,
                 const std::vector<StateColumns>& more = {});

/// The field of reals per particle with this name that the plan has. InputError, with `option` before what
/// was found, when there is none.
Field particle_field(const std::string& option, const std::string& name, const Plan& plan);
/// Its columns: NAME, or NAME_x and NAME_y of a vector, NAME_xx, ... of a matrix.
StateColumns columns_of(Field field, const Simulator& simulator);

}  // namespace sluice

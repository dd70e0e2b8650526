// The state of a run as CSV: id,x,y,vx,vy,density,pressure in id order.
#pragma once

#include "core/output/output_file.hpp"
#include "core/solver/simulator.hpp"

namespace sluice {

/// Writes the rows of `snapshot` and commits the file. At step 0 density and pressure have not been computed
/// by a step yet and are written as 0.
void write_state(OutputFile& file, const Snapshot& snapshot, Precision precision);

}  // namespace sluice

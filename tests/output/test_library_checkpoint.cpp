// Checkpoints of the library's Simulation.
#include <gtest/gtest.h>

#include "sluice/cpu.hpp"
#include "sluice/load.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

Simulation dam_in_double() {
  return Simulation(load_scene("breaking_dam"), cpu::device({.precision = Precision::double_}));
}

TEST(LibraryCheckpoint, GoesOnFromACheckpointWithTheSameBits) {
  const TemporaryFolder folder;
  Simulation whole = dam_in_double(), first = dam_in_double();
  for (int k = 0; k < 8; ++k) whole.step();
  for (int k = 0; k < 5; ++k) first.step();
  first.write_checkpoint(folder / "five");
  Simulation second = Simulation::resume(folder / "five", cpu::device({.precision = Precision::double_}));
  EXPECT_EQ(second.steps(), 5u);
  for (int k = 0; k < 3; ++k) second.step();
  EXPECT_EQ(second.snapshot().x, whole.snapshot().x);
  EXPECT_THROW(Simulation::resume(folder / "five", cpu::device()), InputError);
  EXPECT_THROW(Simulation::resume(folder / "none", cpu::device()), InputError);
}

}  // namespace
}  // namespace sluice::test

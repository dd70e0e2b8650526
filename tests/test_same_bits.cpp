// The scenes of the thesis keep their bits, whatever is added or made faster: digests of the states after 100
// steps, as they were when the thesis's tables were first met. A change that moves them on purpose writes
// them anew and says why.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>

#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// FNV-1a over the bits of a state.
uint64_t digest(const Snapshot& snapshot) {
  uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](double value) { hash = (hash ^ std::bit_cast<uint64_t>(value)) * 0x100000001b3; };
  for (size_t i = 0; i < snapshot.x.size(); ++i) {
    for (const Vec2 pair : {snapshot.x[i], snapshot.v[i], Vec2(snapshot.density[i], snapshot.pressure[i])}) {
      add(pair.x);
      add(pair.y);
    }
  }
  return hash;
}

struct Known {
  ShippedRun run;
  Precision precision;
  const char* digest;
};

TEST(SameBits, OfTheScenesOfTheThesis) {
  for (const auto& [run, precision, expected] : {
           Known{{"breaking_dam", "iisph"}, Precision::single_, "23a8bdaa393c5685"},
           Known{{"breaking_dam", "iisph"}, Precision::double_, "5e464f2811e91298"},
           Known{{"breaking_dam", "ssph"}, Precision::single_, "e547668e793c5685"},
           Known{{"leaking_dam", "iisph"}, Precision::single_, "698c44605ffb81a5"},
           Known{{"falling_from_platform", "iisph"}, Precision::single_, "93dbf42fa5612605"},
           Known{{"inclined_plane", "iisph"}, Precision::single_, "93d8445d29a75f05"},
           Known{{"resting_fluid", "iisph"}, Precision::single_, "497d50cf89088bd5"},
           Known{{"resting_fluid", "ssph"}, Precision::double_, "ee286f0dc2f2594c"},
       }) {
    Simulation simulation(run.load(), precision, 2);
    simulation.run(100);
    EXPECT_EQ(fmt::format("{:016x}", digest(simulation.simulator->snapshot())), expected)
        << run.name() << (precision == Precision::double_ ? " in double" : " in float");
  }
}

}  // namespace
}  // namespace sluice::test

// The scenes of the thesis keep their bits, whatever is added or made faster: digests of the states after 100
// steps. A change that moves them on purpose writes them anew and says why; last: the pressure system is
// solved in q = p/rho^2, whose roundings are others than those of p.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>

#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// FNV-1a over the bits of a state, half a number at a time.
uint64_t digest(const Snapshot& snapshot) {
  uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](double value) {
    const auto bits = std::bit_cast<uint64_t>(value);
    for (const uint64_t half : {bits >> 32, bits & 0xffffffff}) {
      hash = (hash ^ half) * 0x100000001b3;
      hash ^= hash >> 32;
    }
  };
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
           Known{{"breaking_dam", "iisph"}, Precision::single_, "11ff9ae5feb60fe3"},
           Known{{"breaking_dam", "iisph"}, Precision::double_, "a308f74dc28c5bc2"},
           Known{{"breaking_dam", "ssph"}, Precision::single_, "d633aa5bad3ec911"},
           Known{{"leaking_dam", "iisph"}, Precision::single_, "1ac96556841f8b00"},
           Known{{"falling_from_platform", "iisph"}, Precision::single_, "969ad0c2c82f774f"},
           Known{{"inclined_plane", "iisph"}, Precision::single_, "62c1ff3a464014b9"},
           Known{{"resting_fluid", "iisph"}, Precision::single_, "21ef97260870e377"},
           Known{{"resting_fluid", "ssph"}, Precision::double_, "80cc55657dc4c440"},
       }) {
    Simulation simulation(run.load(), precision, 2);
    simulation.run(100);
    EXPECT_EQ(fmt::format("{:016x}", digest(simulation.simulator->snapshot())), expected)
        << run.name() << (precision == Precision::double_ ? " in double" : " in float");
  }
}

}  // namespace
}  // namespace sluice::test

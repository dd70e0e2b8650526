// The scenes of the thesis keep their bits, whatever is added or made faster: digests of the states after 100
// steps, as they were when the thesis's tables were first met. A change that moves them on purpose writes
// them anew and says why.
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
           Known{{"breaking_dam", "iisph"}, Precision::single_, "20a8be6abfe40422"},
           Known{{"breaking_dam", "iisph"}, Precision::double_, "06af8f8013f0de06"},
           Known{{"breaking_dam", "ssph"}, Precision::single_, "90a76321dc954546"},
           Known{{"leaking_dam", "iisph"}, Precision::single_, "fca4820fdab2b486"},
           Known{{"falling_from_platform", "iisph"}, Precision::single_, "4a69d239de3e3ea0"},
           Known{{"inclined_plane", "iisph"}, Precision::single_, "b3f3f0be951b7c0d"},
           Known{{"resting_fluid", "iisph"}, Precision::single_, "ea2afd31361d1abc"},
           Known{{"resting_fluid", "ssph"}, Precision::double_, "7047a1d136c333aa"},
       }) {
    Simulation simulation(run.load(), precision, 2);
    simulation.run(100);
    EXPECT_EQ(fmt::format("{:016x}", digest(simulation.simulator->snapshot())), expected)
        << run.name() << (precision == Precision::double_ ? " in double" : " in float");
  }
}

}  // namespace
}  // namespace sluice::test

// The scenes of the thesis keep their bits, whatever is added or made faster: digests of the states after 100
// steps. A change that moves them on purpose writes them anew and says why; last: the pressure system is
// solved in q = p/rho^2, whose roundings are others than those of p.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

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

/// Every method, viscosity and boundary at once; as many particles as make several blocks of a sweep.
std::vector<Scene> scenes_of_all_models() {
  std::vector<Scene> scenes;
  for (const std::string method : {"iisph", "ssph", "wcsph"}) {
    for (const std::string viscosity : {"xsph", "laplacian"}) {
      scenes.push_back(shipped("breaking_dam", {"pressure.method=" + method, "viscosity.model=" + viscosity,
                                                "viscosity.coefficient=0.05", "particles.spacing=2.5",
                                                "time.dt=0.002", "fluid.jitter=0.1"}));
    }
  }
  scenes.push_back(shipped("breaking_dam", {"pressure.iisph.solver=barzilai-borwein",
                                            "pressure.iisph.wall=symmetric", "particles.spacing=2.5",
                                            "viscosity.coefficient=20", "time.dt=0.02", "fluid.jitter=0.1"}));
  scenes.push_back(shipped("iisph_box"));
  scenes.push_back(shipped("wcsph_box"));
  return scenes;
}

TEST(SameBits, WithAllInstructionsThatThisProcessorHas) {
  for (const Scene& scene : scenes_of_all_models()) {
    for (const Precision precision : {Precision::single_, Precision::double_}) {
      std::string expected;
      for (const cpu::Instructions set : cpu::available_instructions()) {
        for (const int threads : {1, 3}) {
          Simulation simulation(scene, precision, threads, set);
          simulation.run(20);
          const std::string found = fmt::format("{:016x}", digest(simulation.simulator->snapshot()));
          if (expected.empty()) expected = found;
          EXPECT_EQ(found, expected) << scene.title << ", instructions " << name_of(set) << ", threads "
                                     << threads;
        }
      }
    }
  }
}

}  // namespace
}  // namespace sluice::test

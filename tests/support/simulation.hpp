// A scene set up to run, and comparisons of fields.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/agree/agree.hpp"
#include "core/solver/simulator.hpp"
#include "cpu/backend.hpp"
#include "sluice/load.hpp"
#include "sluice/sampling.hpp"

namespace sluice::test {

/// Everything a run needs, kept together.
struct Simulation {
  Scene scene;
  Samples samples;
  std::unique_ptr<Backend> backend;
  std::unique_ptr<Simulator> simulator;

  explicit Simulation(Scene scene_to_run, Precision precision = Precision::double_, int threads = 1,
                      cpu::Instructions instructions = cpu::widest_instructions())
      : scene(std::move(scene_to_run)),
        samples(sample(scene)),
        backend(cpu::make_backend(precision, threads, instructions)),
        simulator(std::make_unique<Simulator>(scene, samples, *backend)) {}

  /// Runs `steps` steps and returns the reports.
  std::vector<StepReport> run(uint64_t steps) {
    std::vector<StepReport> reports;
    for (uint64_t step = 0; step < steps && !simulator->failure(); ++step)
      reports.push_back(simulator->step());
    return reports;
  }
};

inline Scene shipped(const std::string& name, std::vector<std::string> overrides = {}) {
  return load_scene(name, overrides);
}

/// A shipped scene with one of the methods it has a table for.
struct ShippedRun {
  std::string scene, method;

  std::string name() const { return scene + "_" + method; }
  Scene load(std::vector<std::string> overrides = {}) const {
    overrides.push_back("pressure.method=" + method);
    return shipped(scene, overrides);
  }
};

inline void PrintTo(const ShippedRun& run, std::ostream* out) { *out << run.name(); }

/// Every shipped scene with every method it has a table for.
std::vector<ShippedRun> shipped_runs();

/// Largest |a - b| relative to the largest |b|; infinite when sizes differ or something is not finite.
double relative_difference(const std::vector<double>& a, const std::vector<double>& b);
double relative_difference(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace sluice::test

// A scene set up to run, and comparisons of fields.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/agree.hpp"
#include "core/sampling.hpp"
#include "core/scene_file.hpp"
#include "core/simulator.hpp"
#include "cpu/backend.hpp"

namespace sluice::test {

/// Everything a run needs, kept together.
struct Simulation {
  Scene scene;
  Samples samples;
  std::unique_ptr<Backend> backend;
  std::unique_ptr<Simulator> simulator;

  explicit Simulation(Scene scene_to_run, Precision precision = Precision::double_, int threads = 1)
      : scene(std::move(scene_to_run)),
        samples(sample(scene)),
        backend(cpu::make_backend(precision, threads)),
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

/// Names of the shipped scenes that can run with the methods there are.
inline std::vector<std::string> all_scenes() { return shipped_scenes(); }

/// Largest |a - b| relative to the largest |b|; infinite when sizes differ or something is not finite.
double relative_difference(const std::vector<double>& a, const std::vector<double>& b);
double relative_difference(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace sluice::test

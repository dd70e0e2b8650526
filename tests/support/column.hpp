// Columns of water at rest (tests/data/column.toml), and what their pressure should be.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/simulation.hpp"

namespace sluice::test {

/// A column so many particles wide and deep, with steps of `lambda` h / sqrt(g depth).
struct Column {
  uint32_t width = 10, depth = 200;
  double nu = 200, lambda = 0.4;

  std::string name() const { return fmt::format("{} x {}, nu {}, lambda {}", width, depth, nu, lambda); }

  Scene load(std::vector<std::string> settings) const {
    settings.insert(settings.end(), {fmt::format("fluid.rect.0.count=[{},{}]", width, depth),
                                     fmt::format("domain.max=[\"{}h\",4800]", width + 5),
                                     fmt::format("boundary.container.0.max=[\"{}h\",4800]", width + 5),
                                     fmt::format("viscosity.coefficient={}", nu),
                                     fmt::format("time.dt={}", lambda * 8 / std::sqrt(9.81 * 8 * depth))});
    return load_scene(SLUICE_SOURCE_DIR "/tests/data/column.toml", settings);
  }
};

const std::vector<std::string> sound{"pressure.iisph.solver=barzilai-borwein",
                                     "pressure.iisph.wall=symmetric"};

/// Expects `seconds` without a loss, a solve that does not converge, or very many sweeps.
inline void expect_held(const Column& column, const std::vector<std::string>& settings, double seconds) {
  SCOPED_TRACE(column.name());
  Simulation simulation(column.load(settings));
  const auto steps = static_cast<uint64_t>(seconds / simulation.scene.dt);
  const auto reports = simulation.run(steps);
  ASSERT_EQ(reports.size(), steps) << simulation.simulator->failure()->reason;
  EXPECT_EQ(reports.back().diagnostics.lost, 0u);
  EXPECT_TRUE(std::ranges::all_of(reports, &StepReport::converged));
  double sweeps = 0;
  for (const StepReport& report : reports) sweeps += report.iterations;
  EXPECT_LT(sweeps / static_cast<double>(steps), 25);
}

/// Time averages of pressure by height, in bins of h, beside rho0 g depth.
class PressureProfile {
 public:
  explicit PressureProfile(const Scene& scene) : scene_(scene) {}

  void add(const Snapshot& snapshot) {
    for (size_t i = 0; i < snapshot.x.size(); ++i) {
      const auto bin = static_cast<size_t>(std::max(snapshot.x[i].y / scene_.spacing, 0.0));
      if (bin >= sums_.size()) sums_.resize(bin + 1), counts_.resize(bin + 1), heights_.resize(bin + 1);
      sums_[bin] += snapshot.pressure[i];
      heights_[bin] += snapshot.x[i].y;
      ++counts_[bin];
    }
    ++snapshots_;
  }

  /// Root mean square of the error over the bins, relative to that of the pressure. `columns` particles stand
  /// beside each other; bins that are not full at all times, at the surface, are left out.
  double error(uint32_t columns) const {
    double particles = 0;
    for (const double count : counts_) particles += count;
    EXPECT_GT(particles, 0);
    const double rows = particles / (snapshots_ * columns);
    const double surface = (rows + 2.5) * scene_.spacing;  // the lowest row stands at 3h
    double squares = 0, all = 0;
    for (size_t bin = 0; bin < sums_.size(); ++bin) {
      if (counts_[bin] < 0.5 * columns * snapshots_) continue;
      const double depth = surface - heights_[bin] / counts_[bin];
      const double expected = -scene_.rest_density * scene_.gravity.y * depth;
      const double error = sums_[bin] / counts_[bin] - expected;
      squares += error * error;
      all += expected * expected;
    }
    return std::sqrt(squares / all);
  }

 private:
  const Scene& scene_;
  std::vector<double> sums_, heights_, counts_;
  double snapshots_ = 0;
};

}  // namespace sluice::test

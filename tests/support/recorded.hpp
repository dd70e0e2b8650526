// A short recording made through the library, and what went into it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/solver/simulator.hpp"
#include "cpu/backend.hpp"
#include "media/recording.hpp"
#include "sluice/load.hpp"

namespace sluice::test {

inline void add(media::RecordingWriter& writer, const media::Moment& moment) {
  writer.add(moment.report, moment.seconds_per_step, moment.state);
}

struct Recorded {
  Scene scene;
  Samples samples;
  std::vector<media::Moment> moments;

  /// The start of `name` and so many steps, one frame each; a last frame repeats the step before.
  Recorded(const std::filesystem::path& path, const std::string& name, uint64_t steps,
           Precision precision = Precision::single_, const std::vector<std::string>& overrides = {})
      : scene(load_scene(name, overrides)), samples(sample(scene)) {
    const auto backend = cpu::make_backend(precision, 1);
    Simulator simulator(scene, samples, *backend);
    media::RecordingWriter writer(path, scene, precision, "a test");
    StepReport report;
    report.dt = simulator.dt();
    for (uint64_t k = 0;; ++k) {
      moments.push_back({report, 1e-3 * static_cast<double>(k), simulator.snapshot()});
      add(writer, moments.back());
      if (k == steps) break;
      report = simulator.step();
      report.diagnostics.lost = static_cast<uint32_t>(k + 1);  // none are, and yet it has to come back
    }
    moments.push_back(moments.back());
    add(writer, moments.back());
    writer.commit();
  }
};

}  // namespace sluice::test

// Names and values of probes.
#include "core/measure/probes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/measure/point.hpp"
#include "core/text.hpp"
#include "sluice/error.hpp"

namespace sluice {

std::vector<std::string> probe_columns(const Scene& scene) {
  std::vector<std::string> columns;
  for (const Probe& probe : scene.probes) {
    if (probe.at)
      for (const char* what : {"pressure", "density", "vx", "vy"})
        columns.push_back(fmt::format("{}.{}", probe.name, what));
    else
      columns.push_back(fmt::format("{}.{}", probe.name, probe.x ? "level" : "front"));
  }
  return columns;
}

std::vector<std::optional<double>> probe_values(const Scene& scene, const Snapshot& state) {
  std::vector<std::optional<double>> values;
  for (const Probe& probe : scene.probes) {
    if (!probe.at) {
      values.push_back(probe.x ? level_at(scene, state, *probe.x) : front_at(scene, state, *probe.y));
      continue;
    }
    const PointValues there = values_at(scene, state, *probe.at);
    for (const double value : {there.pressure, there.density, there.velocity.x, there.velocity.y})
      values.push_back(value);
  }
  return values;
}

StepFile probes_file(const std::filesystem::path& path, Outliving<Scene> scene,
                     Outliving<Simulator> simulator) {
  const Scene& its_scene = scene;
  const Simulator& its_simulator = simulator;
  if (its_scene.probes.empty()) {
    throw InputError(
        fmt::format("{}: probe: found none, expected at least one [[probe]] for --probes", its_scene.file));
  }
  return {path, fmt::format("step,time,{}", fmt::join(probe_columns(its_scene), ",")),
          [&its_scene, &its_simulator](const StepReport& report) {
            std::string row = fmt::format("{},{}", report.step, round_trip(report.time, Precision::double_));
            for (const auto& value : probe_values(its_scene, its_simulator.snapshot()))
              row += ',' + (value ? round_trip(*value, Precision::single_) : "");
            return row + '\n';
          }};
}

}  // namespace sluice

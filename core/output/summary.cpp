// Statistics, the JSON summary and the table at the end of a run.
#include "core/output/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/model/larger.hpp"
#include "core/scene/settings.hpp"
#include "core/text.hpp"
#include "sluice/version.hpp"

namespace sluice {
namespace {

double sweep_seconds(const RunSummary& summary) {
  double seconds = 0;
  for (const Stage stage : summary.simulator.plan()[Phase::sweep]) seconds += summary.backend.seconds(stage);
  return seconds;
}

double sweeps_per_second(const RunSummary& summary) {
  const double seconds = sweep_seconds(summary);
  const RunStatistics& statistics = summary.statistics;
  const double sweeps = static_cast<double>(summary.samples.fluid.size()) *
                        static_cast<double>(statistics.iterations() - statistics.before().iterations);
  return seconds > 0 ? sweeps / seconds : 0;
}

/// The stages of a step without repetition. What runs once, before the first step, is not timed.
std::vector<Stage> distinct_stages(const Plan& plan) {
  std::vector<Stage> distinct;
  for (const Stage stage : plan.stages()) {
    const bool known = std::find(distinct.begin(), distinct.end(), stage) != distinct.end();
    if (!known && !runs_once(stage)) distinct.push_back(stage);
  }
  return distinct;
}

}  // namespace

void RunStatistics::add(const StepReport& report) {
  const Diagnostics& d = report.diagnostics;
  ++counts_.steps;
  counts_.iterations += report.iterations;
  counts_.iterations_max = std::max(counts_.iterations_max, report.iterations);
  if (!report.converged) ++counts_.not_converged;
  counts_.compression_sum += d.mean_compression;
  counts_.compression_max = larger(counts_.compression_max, d.max_compression);
  counts_.cfl_max = larger(counts_.cfl_max, d.cfl);
  counts_.lost = d.lost;
  counts_.repeats += report.repeats;
  counts_.dt_min = std::min(counts_.dt_min, report.dt);
  counts_.dt_max = std::max(counts_.dt_max, report.dt);
}

nlohmann::ordered_json to_json(const RunSummary& summary) {
  const auto& [scene, samples, backend, simulator, statistics, watch, start_from] = summary;
  const auto others = watch.others();
  nlohmann::ordered_json json;
  json["format"] = 1;
  json["version"] = version();
  json["commit"] = commit().empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(commit());
  json["scene"] = scene.name;
  json["title"] = scene.title;
  json["backend"] = backend.name();
  json["device"] = backend.device();
  json["precision"] = name_of(backend.precision());
  json["threads"] = backend.threads();
  json["fluid"] = samples.fluid.size();
  json["boundary"] = samples.boundary.size();
  json["steps"] = simulator.steps();
  json["time"] = simulator.time();
  json["valid"] = !simulator.failure().has_value();
  json["failure"] = nullptr;
  if (const auto& failure = simulator.failure()) {
    json["failure"] = {{"step", failure->step}, {"time", failure->time}, {"id", failure->id},
                       {"x", failure->x.x},     {"y", failure->x.y},     {"reason", failure->reason}};
  }
  json["lost"] = statistics.lost();
  json["iterations_mean"] = statistics.iterations_mean();
  json["iterations_max"] = statistics.iterations_max();
  json["not_converged"] = statistics.not_converged();
  json["compression_mean"] = statistics.compression_mean();
  json["compression_max"] = statistics.compression_max();
  json["cfl_max"] = statistics.cfl_max();
  json["seconds"] = {{"total", watch.wall()},
                     {"cpu", watch.cpu()},
                     {"busy", was_busy(others)},
                     {"others", others ? nlohmann::ordered_json(*others) : nlohmann::ordered_json(nullptr)},
                     {"stages", nlohmann::ordered_json::object()}};
  for (const Stage stage : distinct_stages(simulator.plan())) {
    json["seconds"]["stages"][std::string(info(stage).name)] = backend.seconds(stage);
  }
  json["particle_sweeps_per_second"] = sweeps_per_second(summary);
  json["settings"] = settings_of(scene);
  json["start_from"] =
      start_from.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(start_from);
  return json;
}

std::string to_text(const RunSummary& summary) {
  const auto& [scene, samples, backend, simulator, statistics, watch, start_from] = summary;
  const uint64_t before = statistics.before().steps;
  const std::string last = before > 0 ? fmt::format(", the last {}", statistics.steps() - before) : "";
  std::string text = fmt::format(
      "{}: {} steps of {}, {:g} simulated{} in {:.3g} s ({:.3g} s of processors), {} + {} particles\n",
      scene.title, statistics.steps(), title_of(scene.method), simulator.time(), last, watch.wall(),
      watch.cpu(), samples.fluid.size(), samples.boundary.size());
  if (const auto others = watch.others(); was_busy(others)) {
    text += fmt::format(
        "the machine was busy: other programs had {:.1f} processors; compare no seconds but those "
        "of processors\n",
        *others);
  }
  if (simulator.plan().sweeps()) {
    text +=
        fmt::format("iterations {:.2f} on average, {} at most; {} steps did not converge\n",
                    statistics.iterations_mean(), statistics.iterations_max(), statistics.not_converged());
  }
  if (scene.adaptive && statistics.steps() > 0) {
    text += fmt::format("dt {:.3g} to {:.3g}, {:.3g} on average; {} steps were repeated with a smaller one\n",
                        statistics.dt_min(), statistics.dt_max(),
                        simulator.time() / static_cast<double>(statistics.steps()), statistics.repeats());
  }
  text += fmt::format(
      "compression {:.2e} on average, {:.2e} at most; cfl {:.3f} at most; {} particles lost\n\n",
      statistics.compression_mean(), statistics.compression_max(), statistics.cfl_max(), statistics.lost());
  text += fmt::format("{:<24}{:>10}{:>8}\n", "stage", "seconds", "share");
  double staged = 0;
  const auto row = [&text, total = watch.wall()](std::string_view name, double spent) {
    text += fmt::format("{:<24}{:>10.3f}{:>7.1f}%\n", name, spent, total > 0 ? 100 * spent / total : 0);
  };
  for (const Stage stage : distinct_stages(simulator.plan())) {
    staged += backend.seconds(stage);
    row(info(stage).name, backend.seconds(stage));
  }
  row("between the stages", std::max(watch.wall() - staged, 0.0));
  row("total", watch.wall());
  return text;
}

std::string version() { return SLUICE_VERSION; }

}  // namespace sluice

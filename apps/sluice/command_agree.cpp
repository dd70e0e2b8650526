// `sluice agree`: the GPU backend against the CPU backend in float.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/sluice/agree_text.hpp"
#include "apps/sluice/commands.hpp"
#include "apps/sluice/machine.hpp"
#include "core/agree/agree.hpp"
#include "core/output/checkpoint.hpp"
#include "core/output/output_file.hpp"
#include "core/solver/memory.hpp"
#include "media/recording.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice::app {
namespace {

void print_end(const std::string& whose, const std::optional<Failure>& failure) {
  if (failure) fmt::print("{} became invalid in step {}: {}\n", whose, failure->step, failure->reason);
}

std::string text_of(const RunAgreement& run) {
  const std::string states =
      run.equal ? "equal to the last bit"
                : fmt::format("first difference in step {}, then up to {:.3g} spacings apart",
                              run.first_difference_step, run.max_dx_over_h);
  return fmt::format("{}; iterations {}", states, run.iterations_equal ? "equal" : "differ");
}

nlohmann::ordered_json to_json(const RunAgreement& run) {
  nlohmann::ordered_json json;
  json["equal"] = run.equal;
  json["first_difference_step"] =
      run.equal ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(run.first_difference_step);
  json["max_dx_over_h"] = run.max_dx_over_h;
  json["iterations_equal"] = run.iterations_equal;
  return json;
}

/// What it is that disagrees.
std::string culprits(const Agreement& agreement) {
  std::string text;
  for (const StageAgreement& row : agreement.stages) {
    if (!row.pass) text += fmt::format("{}{}", text.empty() ? "" : ", ", info(row.stage).name);
  }
  if (!agreement.run.passes(agreement.tolerance)) text += text.empty() ? "the run" : " and the run";
  if (agreement.stepped && !agreement.stepped->passes(0))
    text += fmt::format("{}the GPU's run with itself, stage by stage", text.empty() ? "" : ", and ");
  return text;
}

void print(const Agreement& agreement, const std::string& title, const std::string& reference,
           const std::string& other, uint64_t steps) {
  fmt::print("{}: {} and {}\n\n", title, reference, other);
  fmt::print("{}", table_of(agreement.stages));
  const RunAgreement& run = agreement.run;
  fmt::print("\nrun of {} steps{}: {}\n", run.steps,
             run.steps < steps ? fmt::format(", {} were asked for", steps) : "", text_of(run));
  if (agreement.stepped)
    fmt::print("the GPU's run with itself, stage by stage: {}\n", text_of(*agreement.stepped));
  print_end("the CPU's", run.reference_failure);
  print_end("the GPU's", run.other_failure);
  fmt::print("tolerance: {}\n{}\n", tolerance_text(agreement.tolerance),
             agreement.pass ? "they agree" : "THEY DISAGREE: " + culprits(agreement));
}

/// Numbers that are not finite are written as null.
nlohmann::ordered_json to_json(const Agreement& agreement, const std::string& scene,
                               const std::string& device) {
  nlohmann::ordered_json json;
  json["format"] = 1;
  json["scene"] = scene;
  json["device"] = device;
  json["steps"] = agreement.run.steps;
  json["stages"] = nlohmann::ordered_json::array();
  for (const StageAgreement& row : agreement.stages) {
    json["stages"].push_back({{"name", info(row.stage).name},
                              {"max_abs", row.difference.max_abs},
                              {"max_ulp", row.difference.max_ulp},
                              {"equal_share", row.difference.equal_share()},
                              {"tolerance", agreement.tolerance},
                              {"pass", row.pass}});
  }
  json["run"] = to_json(agreement.run);
  if (agreement.stepped) json["gpu_with_itself"] = to_json(*agreement.stepped);
  json["pass"] = agreement.pass;
  return json;
}

}  // namespace

int agree_command(const AgreeOptions& options) {
  if (options.stage) return agree_stage_command(options);
  media::refuse_recording(options.scene);
  refuse_checkpoint(options.scene);
  const Scene scene = load_scene(options.scene, options.overrides);
  const Plan plan = make_plan(model_of(scene));
  const Stage split = options.split ? stage_named("--split", *options.split, plan) : Stage::count;
  require_memory(scene, Precision::single_, available_memory(), 7);
  const Samples samples = sample(scene);
  Machine machine(on_gpu(options.machine), samples.fluid.size());
  std::optional<OutputFile> summary;
  if (options.summary) summary.emplace(*options.summary);

  const auto reference = make_cpu_backend(options.machine);
  const auto other = gpu::make_backend(machine.context(), {.timed = false});
  const auto again = gpu::make_backend(machine.context(), {.timed = false});
  const auto first_half = make_cpu_backend(options.machine);
  SplitBackend halves(*first_half, *other, split);
  Backend& run_other = options.split ? static_cast<Backend&>(halves) : *other;
  const double tolerance = tolerance_on(machine.context());
  const Agreement agreement =
      agree(scene, samples, {*reference, machine.backend(), run_other, options.split ? nullptr : again.get()},
            options.steps, tolerance);

  const std::string device = machine.backend().device();
  print(agreement, scene.title, fmt::format("cpu, {}", reference->device()),
        options.split ? fmt::format("cpu up to {}, then gpu, {}", *options.split, device) : "gpu, " + device,
        options.steps);
  if (summary) {
    summary->write(to_json(agreement, scene.name, device).dump(2) + '\n');
    summary->commit();
  }
  return agreement.pass ? 0 : 1;
}

}  // namespace sluice::app

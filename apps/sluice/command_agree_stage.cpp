// `sluice agree --stage`: one stage on the CPU and on the GPU, and what it wrote.
#include <fmt/format.h>

#include "apps/sluice/agree_text.hpp"
#include "apps/sluice/commands.hpp"
#include "apps/sluice/machine.hpp"
#include "core/output/checkpoint.hpp"
#include "core/solver/memory.hpp"
#include "core/text.hpp"
#include "media/recording.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice::app {
namespace {

/// The fields to print, those of a stage's row.
FieldSet fields_named(const std::vector<std::string>& names, Stage stage, const Needs& needs) {
  const FieldSet own = reads_of(stage, needs) | writes_of(stage, needs);
  FieldSet found;
  for (const std::string& name : names) {
    bool known = false;
    std::string all;
    for (uint32_t i = 0; i < field_count; ++i) {
      const Field field = static_cast<Field>(i);
      if (!own.has(field)) continue;
      all += fmt::format(" {}", info(field).name);
      if (info(field).name != name) continue;
      found = found | FieldSet{field};
      known = true;
    }
    if (!known) {
      throw InputError(fmt::format("--dump: found \"{}\", expected fields that {} reads or writes:{}", name,
                                   info(stage).name, all));
    }
  }
  return found;
}

std::string number_text(const FieldValues& values, size_t k) {
  if (k < values.integers.size()) return std::to_string(values.integers[k]);
  return k < values.reals.size() ? round_trip(values.reals[k], Precision::single_) : "";
}

/// A row per number: field, its place in the field, and what the two have there.
void print_csv(const std::vector<WatchedField>& fields) {
  fmt::print("field,place,cpu,gpu\n");
  for (const WatchedField& watched : fields) {
    const auto size = [](const FieldValues& values) { return values.integers.size() + values.reals.size(); };
    const size_t count = std::max(size(watched.reference), size(watched.other));
    for (size_t k = 0; k < count; ++k) {
      fmt::print("{},{},{},{}\n", info(watched.field).name, k, number_text(watched.reference, k),
                 number_text(watched.other, k));
    }
  }
}

}  // namespace

int agree_stage_command(const AgreeOptions& options) {
  media::refuse_recording(options.scene);
  refuse_checkpoint(options.scene);
  const Scene scene = load_scene(options.scene, options.overrides);
  const Plan plan = make_plan(model_of(scene));
  const Stage stage = stage_named("--stage", *options.stage, plan);
  const FieldSet fields = fields_named(options.dump, stage, plan.needs);
  require_memory(scene, Precision::single_, available_memory(), 3);
  const Samples samples = sample(scene);
  Machine machine(on_gpu(options.machine), samples.fluid.size());
  const auto reference = make_cpu_backend(options.machine);
  const double tolerance = tolerance_on(machine.context());
  const StageTrial trial =
      try_stage(scene, samples, *reference, machine.backend(), stage, fields, options.steps, tolerance);

  // The numbers go where a program can read them, and the verdict where a person does.
  std::FILE* verdict = options.dump.empty() ? stdout : stderr;
  fmt::print(verdict, "{}: cpu, {} and gpu, {}\n\n{}\n{} steps; tolerance: {}\n{}\n", scene.title,
             reference->device(), machine.backend().device(), table_of({trial.agreement}), trial.steps,
             tolerance_text(tolerance), trial.agreement.pass ? "they agree" : "THEY DISAGREE");
  if (trial.failure)
    fmt::print(verdict, "the run became invalid in step {}: {}\n", trial.failure->step,
               trial.failure->reason);
  if (trial.agreement.difference.all_zero) fmt::print(verdict, "only zeros were compared\n");
  if (!options.dump.empty()) print_csv(trial.fields);
  return trial.agreement.pass ? 0 : 1;
}

}  // namespace sluice::app

// `sluice info`: what this machine offers; with a scene, its counts, memory and plan.
#include <fmt/format.h>

#include "apps/sluice/agree_text.hpp"
#include "apps/sluice/commands.hpp"
#include "core/model/plan.hpp"
#include "core/output/checkpoint.hpp"
#include "core/output/summary.hpp"
#include "core/solver/memory.hpp"
#include "core/text.hpp"
#include "cpu/backend.hpp"
#include "gpu/context.hpp"
#include "gpu/stage_program.hpp"
#include "media/recording.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"
#include "sluice/sampling.hpp"
#include "sluice/version.hpp"

namespace sluice::app {
namespace {

void print_machine() {
  fmt::print("sluice {}\nprocessor: {}, {} threads, {} of memory free\n", version(), cpu::processor_name(),
             cpu::hardware_threads(), bytes_text(available_memory()));
  fmt::print("instructions (for --instructions): {}\n", cpu::names_of(cpu::available_instructions()));
  fmt::print("OpenGL devices (for --backend gpu and pictures):\n");
  try {
    fmt::print("{}\n", gpu::describe(gpu::list_devices()));
  } catch (const EnvironmentError& error) {
    fmt::print("  none: {}\n", error.what());
  }
}

void print_stages(std::string_view title, const std::vector<Stage>& stages) {
  if (stages.empty()) return;
  fmt::print("  {}\n", title);
  for (const Stage stage : stages) fmt::print("    {:<24}{}\n", info(stage).name, info(stage).equation);
}

void print_scene(const std::string& name, const std::vector<std::string>& overrides) {
  media::refuse_recording(name);
  refuse_checkpoint(name);
  const Scene scene = load_scene(name, overrides);
  require_memory(scene, Precision::double_, available_memory());
  const Samples samples = sample(scene);
  fmt::print("{} ({})\n", scene.title, scene.file);
  if (!scene.source.empty()) fmt::print("source: {}\n", scene.source);
  fmt::print("particles: {} fluid + {} boundary = {}", samples.fluid.size(), samples.boundary.size(),
             samples.fluid.size() + samples.boundary.size());
  if (samples.boundary_dropped > 0)
    fmt::print(" ({} boundary samples dropped, being where others are)", samples.boundary_dropped);
  fmt::print("\nspacing h {:g}, smoothing length H {:g}, particle mass m {:g}\n", scene.spacing,
             scene.smoothing_length(), scene.mass());
  fmt::print("method: {}, ", title_of(scene.method));
  if (const auto& adaptive = scene.adaptive) {
    fmt::print("dt {:g} to {:g} at a cfl of {:g}, duration {:g}\n", adaptive->dt_min, adaptive->dt_max,
               adaptive->cfl, scene.duration);
  } else {
    fmt::print("dt {:g}, duration {:g}: {:.0f} steps\n", scene.dt, scene.duration,
               std::round(scene.duration / scene.dt));
  }
  for (const Precision precision : {Precision::single_, Precision::double_}) {
    const MemoryNeed need = memory_need(scene, precision);
    fmt::print("memory in {}: {:.0f} bytes per fluid particle, about {} in all\n", name_of(precision),
               need.per_particle, bytes_text(need.bytes));
  }
  const Plan plan = make_plan(model_of(scene));
  for (const PhaseInfo& phase : phase_table) {
    if (phase.runs == Runs::once)
      print_stages(fmt::format("{}:\n  boundary", phase.title), plan[phase.phase]);
  }
  fmt::print("one step:\n");
  for (const PhaseInfo& phase : phase_table) {
    if (phase.runs != Runs::once) print_stages(phase.title, plan[phase.phase]);
  }
}

}  // namespace

int info_command(const std::optional<std::string>& scene, const std::vector<std::string>& overrides) {
  if (scene)
    print_scene(*scene, overrides);
  else
    print_machine();
  return 0;
}

int shader_command(const std::string& name, const std::vector<std::string>& overrides,
                   const std::string& stage, const std::optional<std::filesystem::path>& shader_dir) {
  media::refuse_recording(name);
  refuse_checkpoint(name);
  const Scene scene = load_scene(name, overrides);
  const Plan plan = make_plan(model_of(scene));
  fmt::print("{}", gpu::stage_listing(gpu::ShaderLibrary(shader_dir), stage_named("--shader", stage, plan),
                                      plan.needs));
  return 0;
}

}  // namespace sluice::app

// What was poor about a run, and what often helps.
#include "apps/sluice/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "core/solver/time_step.hpp"

namespace sluice::app {

void warn(bool quiet, const std::string& message) {
  if (!quiet) fmt::print(stderr, "sluice: warning: {}\n", message);
}

void warn_of_unused_opengl(const MachineOptions& options, bool quiet) {
  const std::string reason = "has no effect, since nothing runs on OpenGL; use --backend gpu or --frames";
  if (options.shader_dir) warn(quiet, "--shader-dir " + reason);
  if (options.gl_device) warn(quiet, "--gl-device " + reason);
}

namespace {

/// The key that makes the steps of a run shorter.
std::string steps_key(const Scene& scene) { return scene.adaptive ? "time.cfl" : scene.dt_key; }

/// What often helps against a run that became invalid.
std::string remedy(const Scene& scene, const RunStatistics& statistics, const Failure& failure) {
  if (failure.collapsed && scene.method == PressureMethod::iisph) {
    return "a smaller time.dt_min may help, but not against a start that is compressed: IISPH undoes that in "
           "one step, however short, and over several with a pressure.iisph.source_weight such as 0.1";
  }
  if (failure.collapsed) return "a smaller time.dt_min often helps";
  const std::string smaller_dt = "a smaller " + steps_key(scene);
  if (scene.viscosity_model == ViscosityModel::xsph && scene.viscosity > largest_alpha)
    return fmt::format("a viscosity.coefficient below {:g} helps", largest_alpha);
  if (failure.step <= 10) {
    return fmt::format(
        "so early, look whether fluid starts inside a wall or in other fluid; otherwise {} often "
        "helps",
        smaller_dt);
  }
  const StepBound sound = sound_bound(scene);
  const bool stable = least_dt(scene) <= sound.largest * sound.duration;
  if (scene.method != PressureMethod::iisph && stable && statistics.compression_mean() > 0.03) {
    return fmt::format("the fluid is compressed by {:.0f} % on average, and a larger {} often helps",
                       100 * statistics.compression_mean(), stiffness_key(scene.method));
  }
  return smaller_dt + " often helps";
}

/// What may help a pressure solve, in the order in which to try it.
std::string solver_remedy(const Scene& scene) {
  std::string text;
  if (scene.iisph.solver == Solver::jacobi) text += "pressure.iisph.solver \"barzilai-borwein\", ";
  if (scene.boundary_model == BoundaryModel::mirror && scene.iisph.wall == Wall::thesis)
    text += "pressure.iisph.wall \"symmetric\", ";
  return text + fmt::format("a smaller {} or a larger pressure.iisph.max_iterations", steps_key(scene));
}

}  // namespace

std::string failure_text(const Scene& scene, const RunStatistics& statistics, const Failure& failure) {
  return fmt::format("{} at step {}, time {:g}, particle {} near ({:g}, {:g}); {}", failure.reason,
                     failure.step, failure.time, failure.id, failure.x.x, failure.x.y,
                     remedy(scene, statistics, failure));
}

void warn_of_losses(const RunStatistics& statistics, const std::vector<Loss>& losses, bool quiet) {
  constexpr size_t most_named = 5;
  if (statistics.lost() == 0) return;
  std::string text = fmt::format("{} particles left the domain", statistics.lost());
  for (size_t k = 0; k < std::min(losses.size(), most_named); ++k) {
    const Loss& loss = losses[k];
    text += fmt::format("{} particle {} at step {}, time {:g}, near ({:g}, {:g})", k == 0 ? ":" : ";",
                        loss.id, loss.step, loss.time, loss.x.x, loss.x.y);
  }
  if (losses.size() > most_named) text += fmt::format("; and {} more", losses.size() - most_named);
  warn(quiet, text);
}

void warn_of_poor_run(const Scene& scene, const RunStatistics& statistics, const std::vector<Loss>& losses,
                      bool quiet) {
  if (statistics.not_converged() > 0) {
    warn(quiet, fmt::format("the pressure of {} of {} steps did not converge; use {}",
                            statistics.not_converged(), statistics.steps(), solver_remedy(scene)));
  }
  if (statistics.cfl_max() > 1) {
    warn(quiet, fmt::format("particles moved by up to {:.3g} spacings in one step; use a smaller {}",
                            statistics.cfl_max(), steps_key(scene)));
  }
  if (statistics.compression_mean() > 0.05) {
    warn(quiet, fmt::format("the fluid is compressed by {:.0f} % on average; use {}a smaller {}",
                            100 * statistics.compression_mean(),
                            scene.method == PressureMethod::iisph
                                ? ""
                                : fmt::format("a larger {} or ", stiffness_key(scene.method)),
                            steps_key(scene)));
  }
  warn_of_losses(statistics, losses, quiet);
}

}  // namespace sluice::app

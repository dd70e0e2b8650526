// The limits behind the warnings.
#include "apps/sluice/warnings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <optional>

#include "core/text.hpp"

namespace sluice {

void warn(bool quiet, const std::string& message) {
  if (!quiet) fmt::print(stderr, "sluice: warning: {}\n", message);
}

void warn_of_unused_opengl(const MachineOptions& options, bool quiet) {
  const std::string reason = "has no effect, since nothing runs on OpenGL; use --backend gpu or --frames";
  if (options.shader_dir) warn(quiet, "--shader-dir " + reason);
  if (options.gl_device) warn(quiet, "--gl-device " + reason);
}

namespace {

/// Beyond this alpha XSPH overshoots.
constexpr double largest_alpha = 2;

/// nu dt / h^2; an explicit viscosity bears about 0.5.
double viscous_number(const Scene& scene) {
  if (scene.viscosity_model != ViscosityModel::laplacian) return 0;
  return scene.viscosity * scene.dt / (scene.spacing * scene.spacing);
}

/// Spacings that sound at rest density travels in a step.
double sound_number(const Scene& scene) {
  switch (scene.method) {
    case PressureMethod::ssph:
      return std::sqrt(scene.ssph->stiffness / scene.rest_density) * scene.dt / scene.spacing;
    case PressureMethod::wcsph: return std::sqrt(scene.wcsph->kappa) * scene.dt / scene.spacing;
    case PressureMethod::iisph: return 0;
  }
  return 0;
}

/// Up to where that went well in the shipped scenes: Tait's equation stiffens as it is compressed.
double largest_sound_number(PressureMethod method) { return method == PressureMethod::wcsph ? 1.35 : 1.8; }

std::string stiffness_key(PressureMethod method) {
  return method == PressureMethod::wcsph ? "pressure.wcsph.kappa" : "pressure.ssph.stiffness";
}

/// The key that the time step of this run comes from.
std::string dt_key(const Scene& scene) {
  const std::string method(name_of(scene.method));
  const auto& tables = scene.settings["pressure"];
  return tables[method].contains("dt") ? "pressure." + method + ".dt" : "time.dt";
}

/// Layers of a wall; none for shapes that have no layers.
std::optional<uint32_t> layers_of(const BoundaryShape& shape) {
  if (const auto* container = std::get_if<Container>(&shape.geometry)) return container->layers;
  if (const auto* segment = std::get_if<Segment>(&shape.geometry)) return segment->layers;
  return std::nullopt;
}

/// What often helps against a run that became invalid in `step`.
std::string remedy(const Scene& scene, const RunStatistics& statistics, uint64_t step) {
  const std::string smaller_dt = "a smaller " + dt_key(scene);
  if (scene.viscosity_model == ViscosityModel::xsph && scene.viscosity > largest_alpha)
    return fmt::format("a viscosity.coefficient below {:g} helps", largest_alpha);
  if (step <= 10) {
    return fmt::format(
        "so early, look whether fluid starts inside a wall or in other fluid; otherwise {} often "
        "helps",
        smaller_dt);
  }
  if (scene.method != PressureMethod::iisph && sound_number(scene) <= largest_sound_number(scene.method) &&
      statistics.compression_mean() > 0.03) {
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
  return text + fmt::format("a smaller {} or a larger pressure.iisph.max_iterations", dt_key(scene));
}

}  // namespace

std::vector<std::string> beyond_limits(const Scene& scene) {
  std::vector<std::string> found;
  if (scene.viscosity_model == ViscosityModel::xsph && scene.viscosity > largest_alpha) {
    found.push_back(
        fmt::format("viscosity.coefficient is {:g}, and above about {:g} XSPH no longer smooths "
                    "velocities but overshoots; use a smaller one",
                    scene.viscosity, largest_alpha));
  }
  if (viscous_number(scene) > 0.5) {
    found.push_back(
        fmt::format("viscosity.coefficient dt / spacing^2 is {:.2g}, above the limit of an explicit "
                    "viscosity, about 0.5; use a smaller {} or viscosity.coefficient",
                    viscous_number(scene), dt_key(scene)));
  }
  if (sound_number(scene) > largest_sound_number(scene.method)) {
    found.push_back(fmt::format(
        "sound travels {:.2g} spacings in a step, and above about {:g} a state equation "
        "tends to blow up; use a smaller {} or {}",
        sound_number(scene), largest_sound_number(scene.method), dt_key(scene), stiffness_key(scene.method)));
  }
  if (scene.boundary_model != BoundaryModel::mirror) return found;
  for (const BoundaryShape& shape : scene.boundary) {
    const auto layers = layers_of(shape);
    if (!layers || *layers >= 3) continue;
    found.push_back(
        fmt::format("{}.layers is {}, and mirror samples fill the kernel with 3; thinner walls leak, "
                    "use more or boundary.model \"akinci\"",
                    shape.key, *layers));
  }
  return found;
}

std::string failure_text(const Scene& scene, const RunStatistics& statistics, const Failure& failure) {
  return fmt::format("{} at step {}, time {:g}, particle {} near ({:g}, {:g}); {}", failure.reason,
                     failure.step, failure.time, failure.id, failure.x.x, failure.x.y,
                     remedy(scene, statistics, failure.step));
}

void warn_of_poor_run(const Scene& scene, const RunStatistics& statistics, bool quiet) {
  if (statistics.not_converged() > 0) {
    warn(quiet, fmt::format("the pressure of {} of {} steps did not converge; use {}",
                            statistics.not_converged(), statistics.steps(), solver_remedy(scene)));
  }
  if (statistics.cfl_max() > 1) {
    warn(quiet, fmt::format("particles moved by up to {:.3g} spacings in one step; use a smaller {}",
                            statistics.cfl_max(), dt_key(scene)));
  }
  if (statistics.compression_mean() > 0.05) {
    warn(quiet, fmt::format("the fluid is compressed by {:.0f} % on average; use {}a smaller {}",
                            100 * statistics.compression_mean(),
                            scene.method == PressureMethod::iisph
                                ? ""
                                : fmt::format("a larger {} or ", stiffness_key(scene.method)),
                            dt_key(scene)));
  }
  if (statistics.lost() > 0) warn(quiet, fmt::format("{} particles left the domain", statistics.lost()));
}

}  // namespace sluice

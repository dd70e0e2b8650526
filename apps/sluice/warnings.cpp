// The limits behind the warnings.
#include "apps/sluice/warnings.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace sluice {

void warn(bool quiet, const std::string& message) {
  if (!quiet) fmt::print(stderr, "sluice: warning: {}\n", message);
}

void warn_of_unused_opengl(const MachineOptions& options, bool quiet) {
  const std::string reason = "has no effect, since nothing runs on OpenGL; use --backend gpu or --frames";
  if (options.shader_dir) warn(quiet, "--shader-dir " + reason);
  if (options.gl_device) warn(quiet, "--gl-device " + reason);
}

void warn_of_viscous_limit(const Scene& scene, bool quiet) {
  if (scene.viscosity_model == ViscosityModel::xsph && scene.viscosity > 2) {
    warn(quiet,
         fmt::format("viscosity.coefficient is {:g}, and above about 2 XSPH no longer smooths velocities "
                     "but overshoots; use a smaller one",
                     scene.viscosity));
  }
  if (scene.viscosity_model != ViscosityModel::laplacian) return;
  const double number = scene.viscosity * scene.dt / (scene.spacing * scene.spacing);
  if (number <= 0.5) return;
  warn(quiet, fmt::format(
                  "viscosity.coefficient dt / spacing^2 is {:.2g}, above the limit of an explicit viscosity, "
                  "about 0.5; use a smaller time.dt or viscosity.coefficient",
                  number));
}

void warn_of_poor_run(const RunStatistics& statistics, bool quiet) {
  if (statistics.not_converged() > 0) {
    warn(quiet,
         fmt::format("the pressure of {} of {} steps did not converge; use a smaller time.dt or a larger "
                     "pressure.iisph.max_iterations",
                     statistics.not_converged(), statistics.steps()));
  }
  if (statistics.cfl_max() > 1) {
    warn(quiet, fmt::format("particles moved by up to {:.3g} spacings in one step; use a smaller time.dt",
                            statistics.cfl_max()));
  }
  if (statistics.compression_mean() > 0.05) {
    warn(quiet,
         fmt::format("the fluid is compressed by {:.0f} % on average; use a larger stiffness or a smaller "
                     "time.dt",
                     100 * statistics.compression_mean()));
  }
  if (statistics.lost() > 0) warn(quiet, fmt::format("{} particles left the domain", statistics.lost()));
}

}  // namespace sluice

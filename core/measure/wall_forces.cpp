// The boundary term of the pressure acceleration, sample by sample, in double.
#include "core/measure/wall_forces.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/agree/agreement.hpp"
#include "core/measure/kernel.hpp"
#include "core/text.hpp"
#include "sluice/error.hpp"

namespace sluice {
std::string name_of(const BoundaryShape& shape) {
  return shape.name.empty() ? shape.key.substr(shape.key.find('.') + 1) : shape.name;
}

WallForces::WallForces(const Scene& scene, const Samples& samples)
    : params_(make_params(scene, static_cast<uint32_t>(samples.fluid.size()))),
      pseudo_mass_(needs_of(model_of(scene)).pseudo_mass),
      shapes_(scene.boundary.size()),
      boundary_(sort_boundary(samples.boundary, params_)) {
  for (const uint32_t sample : boundary_.sample) shape_.push_back(samples.boundary_shape[sample]);
}

std::vector<WallForce> WallForces::in(const Backend& backend, const Sizes& sizes) const {
  const auto reals = [&](Field field) { return values_of(backend, field, sizes).reals; };
  const std::vector<double> x = reals(Field::x), q = reals(Field::q), rho = reals(Field::rho);
  const std::vector<double> Psi = pseudo_mass_ ? reals(Field::Psi) : std::vector<double>(shape_.size(), 1);
  std::vector<WallForce> forces(shapes_);
  for (size_t i = 0; i < q.size(); ++i) {
    const Vec2 x_i(x[2 * i], x[2 * i + 1]);
    const double pressure = params_.m * (q[i] + q[i] * rho[i] * rho[i] * params_.wall_pressure);
    if (pressure == 0) continue;
    const uint32_t cell = cell_of(params_, x_i);
    for (const uint32_t row : {cell - params_.columns, cell, cell + params_.columns}) {
      for (uint32_t b = boundary_.C[row - 1]; b < boundary_.C[row + 2]; ++b) {
        const Vec2 x_ib = x_i - boundary_.x[b];
        const double r_squared = glm::dot(x_ib, x_ib);
        if (!(r_squared < params_.support_squared)) continue;
        const Vec2 force = pressure * params_.wall_gradient_mass * Psi[b] *
                           kernel_gradient(params_, x_ib, std::sqrt(r_squared));
        const Vec2 at = params_.origin + boundary_.x[b];
        forces[shape_[b]].force += force;
        forces[shape_[b]].torque += at.x * force.y - at.y * force.x;
      }
    }
  }
  return forces;
}

StepFile wall_forces_file(const std::filesystem::path& path, Outliving<Scene> scene,
                          Outliving<Samples> samples, Outliving<Backend> backend,
                          Outliving<Simulator> simulator) {
  const Scene& its_scene = scene;
  const Samples& its_samples = samples;
  const Backend& its_backend = backend;
  const Simulator& its_simulator = simulator;
  if (its_scene.boundary.empty()) {
    throw InputError(
        fmt::format("{}: boundary: found none, expected walls for --wall-forces to be on", its_scene.file));
  }
  std::string header = "step,time";
  for (const BoundaryShape& shape : its_scene.boundary)
    for (const char* what : {"fx", "fy", "torque"}) header += fmt::format(",{}.{}", name_of(shape), what);
  return {
      path, header,
      [&its_backend, &its_simulator, forces = WallForces(its_scene, its_samples)](const StepReport& report) {
        std::string row = fmt::format("{},{}", report.step, round_trip(report.time, Precision::double_));
        for (const auto& [force, torque] : forces.in(its_backend, its_simulator.sizes()))
          for (const double value : {force.x, force.y, torque})
            row += ',' + round_trip(value, Precision::single_);
        return row + '\n';
      }};
}

}  // namespace sluice

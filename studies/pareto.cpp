// Points: a curve over dt for each method, solver and tolerance. The report is in pareto_report.cpp.
#include "studies/pareto.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/pareto_scenes.hpp"
#include "studies/settings.hpp"

namespace sluice::study {

namespace {

std::vector<std::string> nothing(int) { return {}; }
std::vector<std::string> single_layer(int) { return {"boundary.model=akinci"}; }
std::vector<std::string> viscous(int n) { return {fmt::format("viscosity.coefficient={:.17g}", 0.4 / n)}; }

}  // namespace

const ValidationCase& ParetoScene::validation() const {
  return *std::ranges::find(validation_cases(), name, &ValidationCase::name);
}

const std::vector<ParetoScene>& pareto_scenes() {
  static const std::vector<ParetoScene> all{
      {"dam_break", "height", 200, 0.32, 0.5, true, single_layer},
      {"hydrostatic_tank", "pressure", 100, 0.8, 0, false, viscous},
      {"oscillating_drop", "semi-axes, largest error", 50, 0.8, 0.5, true, nothing},
  };
  return all;
}

namespace {

using namespace pareto;

/// A way to compute a scene.
struct Curve {
  std::string stem, family, label;
  Settings overrides;
  std::vector<double> steps;  ///< in spacings
  std::string converged;      ///< the stem of the run that it is compared with
  bool state_equation = false;
};

/// Every curve has its smoothing and its start written out, so that it does not depend on the scene's own.
Settings start(const ParetoScene& scene, bool relaxed, double smoothing) {
  const bool relax = relaxed && scene.free_surface;
  return {fmt::format("particles.smoothing={:g}", smoothing),
          fmt::format("fluid.jitter={:g}", relax ? 0.15 : 0), fmt::format("fluid.relax={}", relax ? 20 : 0)};
}

std::vector<double> halves(double longest, int count) {
  std::vector<double> steps;
  for (int i = 0; i < count; ++i) steps.push_back(longest / std::pow(2, i));
  return steps;
}

Curve state_equation(const ParetoScene& scene, const std::string& method, double times,
                     const std::string& percent) {
  const bool wcsph = method == "wcsph";
  const double stiffness = times * scene.stiffness;
  Settings overrides = start(scene, true, 1);
  overrides.push_back("pressure.method=" + method);
  overrides.push_back(fmt::format("pressure.{}.{}={:g}", method, wcsph ? "kappa" : "stiffness", stiffness));
  const std::string title = wcsph ? "WCSPH" : "SSPH";
  return {fmt::format("{}_{}", method, percent),
          title,
          fmt::format("{}, {} % compressible", title, percent),
          std::move(overrides),
          halves(0.4 / std::sqrt(stiffness), 2),
          scene.calmed == single_layer ? "converged_akinci" : "converged",
          true};
}

Curve iisph(const ParetoScene& scene, const std::string& stem, const std::string& label,
            const Settings& overrides, int steps) {
  return {stem,
          "IISPH, Barzilai-Borwein",
          "IISPH, Barzilai-Borwein" + label,
          with(with(start(scene, true, 1), recommended), overrides),
          halves(scene.longest, steps),
          "converged"};
}

std::vector<Curve> curves_of(const ParetoScene& scene) {
  const Settings tight{"pressure.iisph.tolerance=1e-4"};
  std::vector<Curve> curves;
  for (const std::string method : {"ssph", "wcsph"}) {
    curves.push_back(state_equation(scene, method, 0.1, "10"));
    curves.push_back(state_equation(scene, method, 1, "1"));
    curves.push_back(state_equation(scene, method, 10, "0.1"));
  }
  curves.push_back(
      {"jacobi", "IISPH, Jacobi", "IISPH, Jacobi, 1e-3",
       with(start(scene, true, 1), {"pressure.iisph.solver=jacobi", "pressure.iisph.wall=symmetric",
                                    "pressure.iisph.warm_start=0.5", "pressure.iisph.tolerance=1e-3"}),
       halves(scene.longest, 4), "converged"});
  curves.push_back(Curve(curves.back()));
  curves.back().stem = "jacobi_4";
  curves.back().label = "IISPH, Jacobi, 1e-4";
  curves.back().overrides.back() = "pressure.iisph.tolerance=1e-4";
  curves.push_back(iisph(scene, "bb_2", ", 1e-2", {"pressure.iisph.tolerance=1e-2"}, 3));
  curves.push_back(iisph(scene, "bb_3", ", 1e-3", {"pressure.iisph.tolerance=1e-3"}, 4));
  curves.push_back(iisph(scene, "bb_4", ", 1e-4", tight, 4));
  curves.push_back(iisph(scene, "bb_pressure", ", for pressure", quiet_pressure, 3));
  if (scene.free_surface) {
    curves.push_back(
        iisph(scene, "bb_lattice", ", 1e-4, lattice start", with(start(scene, false, 1), tight), 3));
    curves.back().family += ", lattice start";
    curves.back().converged = "converged_lattice";
  }
  curves.push_back(
      iisph(scene, "bb_smooth", ", 1e-4, smoothing 1.2", with(start(scene, true, 1.2), tight), 3));
  curves.back().family += ", smoothing 1.2";
  curves.back().converged = "converged_smooth";
  return curves;
}

/// The source corrects the density over five steps: with all of it at once the pressure becomes noisier, not
/// better, as steps become shorter. Runs of half and twice this step are within 0.02 h of each other.
std::vector<Curve> converged_runs(const ParetoScene& scene) {
  if (scene.before_chaos == 0) return {};
  std::vector<Curve> curves;
  for (const auto& [stem, overrides] : {std::pair<std::string, Settings>{"converged", {}},
                                        {"converged_lattice", start(scene, false, 1)},
                                        {"converged_smooth", start(scene, true, 1.2)},
                                        {"converged_akinci", {"boundary.model=akinci"}}}) {
    if (stem == "converged_akinci" && scene.calmed != single_layer) continue;
    Curve curve =
        iisph(scene, stem, "", with(with(overrides, quiet_pressure), {"pressure.iisph.tolerance=1e-4"}), 1);
    curve.family = curve.label = converged;
    curve.steps = {scene.longest / 8};
    curves.push_back(curve);
  }
  return curves;
}

struct Machine {
  const char *name, *backend, *precision;
};
constexpr Machine machines[] = {
    {on_double, "cpu", "double"}, {on_float, "cpu", "float"}, {on_gpu, "gpu", "float"}};

/// A step of about so many spacings that ends at the time of the comparison.
double fitting(double step, const ParetoScene& scene, int n) {
  if (scene.before_chaos == 0) return step / n;
  return scene.before_chaos / std::ceil(scene.before_chaos * n / step - 1e-9);
}

std::string stem_of(const ParetoScene& scene, const Curve& curve, double step, int n,
                    const Machine& machine) {
  return fmt::format("{}_{}_{}_{:.3g}h_{}", scene.name, curve.stem, n, step,
                     std::string(machine.backend) == "gpu" ? "gpu" : machine.precision);
}

Point point_of(const ParetoScene& scene, const Curve& curve, double step, int n, const Machine& machine) {
  const ValidationCase& known = scene.validation();
  Point point{.name = stem_of(scene, curve, step, n, machine),
              .scene = fmt::format("validation/{}", scene.name)};
  point.overrides = {fmt::format("particles.spacing={:.17g}", known.length / n)};
  point.overrides = with(point.overrides, curve.overrides);
  if (curve.state_equation) point.overrides = with(point.overrides, scene.calmed(n));
  point.overrides.push_back(fmt::format("time.dt={:.17g}", fitting(step, scene, n)));
  point.words = known.words;
  if (curve.family == converged)
    point.words.insert(point.words.end(), {"--time", fmt::format("{:g}", scene.before_chaos)});
  point.backend = machine.backend;
  point.precision = machine.precision;
  point.series = known.series;
  point.recording = known.recording;
  point.quick = n == coarse && step == curve.steps.front() && std::string(machine.backend) != "gpu";
  point.facts = {{"scene", scene.name},
                 {"family", curve.family},
                 {"curve", curve.label},
                 {"n", std::to_string(n)},
                 {"machine", machine.name},
                 {"dt", digits(fitting(step, scene, n), 4)},
                 {"compared_with", curve.converged}};
  return point;
}

bool compared_on_gpu(const Curve& curve) { return curve.stem == "bb_3" || curve.stem == "ssph_1"; }

}  // namespace

std::vector<Point> pareto_points() {
  std::vector<Point> points;
  for (const ParetoScene& scene : pareto_scenes()) {
    for (const Curve& curve : converged_runs(scene)) {
      for (const int n : {coarse, fine})
        points.push_back(point_of(scene, curve, curve.steps[0], n, machines[0]));
    }
    for (const Curve& curve : curves_of(scene)) {
      for (const double step : curve.steps) {
        points.push_back(point_of(scene, curve, step, fine, machines[0]));
        points.push_back(point_of(scene, curve, step, fine, machines[1]));
        if (!compared_on_gpu(curve)) continue;
        for (const Machine& machine : machines)
          points.push_back(point_of(scene, curve, step, coarse, machine));
      }
    }
  }
  return points;
}

}  // namespace sluice::study

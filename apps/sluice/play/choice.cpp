// A choice becomes overrides, as of --set.
#include "apps/sluice/play/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/scene/settings.hpp"
#include "core/text.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice::app {
namespace {

constexpr double largest_viscous_number = 0.4;  // nu dt/h^2, a little below what an explicit viscosity bears

void scale_counts(const nlohmann::ordered_json& settings, double refinement,
                  std::vector<std::string>& overrides) {
  for (const char* section : {"fluid", "boundary"}) {
    if (!settings.contains(section) || !settings[section].contains("rect")) continue;
    const auto& rects = settings[section]["rect"];
    for (size_t k = 0; k < rects.size(); ++k) {
      if (!rects[k].contains("count")) continue;
      const auto scaled = [&](size_t axis) {
        return std::max<int64_t>(1, std::llround(rects[k]["count"][axis].get<double>() / refinement));
      };
      overrides.push_back(fmt::format("{}.rect.{}.count=[{},{}]", section, k, scaled(0), scaled(1)));
    }
  }
}

bool sets_dt(const std::string& change) { return change.starts_with("time.dt="); }

}  // namespace

Scene load_choice(const Choice& choice) {
  std::vector<std::string> overrides = choice.overrides;
  if (choice.method) overrides.push_back(fmt::format("pressure.method={}", name_of(*choice.method)));
  Scene scene = load_scene(choice.scene, overrides);
  if (choice.refinement == 1 && choice.dt_factor == 1) return scene;
  const double spacing = scene.spacing * choice.refinement;
  double dt = scene.dt * choice.refinement;
  if (scene.viscosity_model == ViscosityModel::laplacian && choice.refinement < 1)
    dt = std::min(dt, largest_viscous_number * spacing * spacing / scene.viscosity);
  overrides.push_back(fmt::format("particles.spacing={:.17g}", spacing));
  if (scene.adaptive) {
    overrides.push_back(
        fmt::format("time.dt_min={:.17g}", std::min(scene.adaptive->dt_min * choice.refinement, dt)));
    overrides.push_back(fmt::format("time.dt_max={:.17g}", dt));
  } else {
    overrides.push_back(fmt::format("time.dt={:.17g}", dt * choice.dt_factor));
  }
  if (choice.refinement != 1) scale_counts(settings_of(scene), choice.refinement, overrides);
  return load_scene(choice.scene, overrides);
}

Choice with_method(Choice choice, PressureMethod method, const Scene& scene) {
  if ((method == PressureMethod::ssph && !scene.ssph) || (method == PressureMethod::wcsph && !scene.wcsph)) {
    throw InputError(fmt::format(
        "this scene has no [pressure.{}]; add that table with {} to its file to use {}", name_of(method),
        method == PressureMethod::ssph ? "a stiffness" : "a kappa", title_of(method)));
  }
  choice.method = method;
  choice.dt_factor = 1;
  std::erase_if(choice.overrides, sets_dt);
  return choice;
}

}  // namespace sluice::app

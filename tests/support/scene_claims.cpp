// The claims about scene files.
#include "tests/support/scene_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

#include "core/scene/settings.hpp"
#include "core/scene/shapes.hpp"
#include "core/solver/memory.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"
#include "sluice/sampling.hpp"

namespace sluice::test {
namespace {

/// Remembers the first number that is not finite.
class Finite {
 public:
  void operator()(std::string_view name, double number) {
    if (found.empty() && !std::isfinite(number)) found = fmt::format("{} is {}", name, number);
  }
  void operator()(std::string_view name, Vec2 pair) {
    (*this)(name, pair.x);
    (*this)(name, pair.y);
  }
  void operator()(std::string_view name, const std::vector<Vec2>& pairs) {
    for (const Vec2 pair : pairs) (*this)(name, pair);
  }
  void operator()(std::string_view key, const Rect& rect) { (*this)(key, rect.min); }
  void operator()(std::string_view key, const Disc& disc) {
    (*this)(key, disc.centre);
    (*this)(key, disc.radius);
  }
  void operator()(std::string_view key, const Polygon& polygon) { (*this)(key, polygon.points); }
  void operator()(std::string_view key, const Points& points) {
    (*this)(key, points.at);
    (*this)(key, points.velocity);
  }
  void operator()(std::string_view key, const Container& box) {
    (*this)(key, box.min);
    (*this)(key, box.max);
  }
  void operator()(std::string_view key, const Segment& wall) {
    (*this)(key, wall.from);
    (*this)(key, wall.to);
  }
  void operator()(std::string_view name, const nlohmann::ordered_json& json) {
    if (json.is_number_float()) (*this)(name, json.get<double>());
    if (json.is_null() && found.empty()) found = fmt::format("{} is not finite", name);  // so JSON writes it
    if (json.is_structured())
      for (const auto& [key, value] : json.items()) (*this)(key, value);
  }

  std::string found;
};

/// The claim about samples that does not hold, or nothing.
std::string broken_by_samples(const Scene& scene) {
  const Samples samples = sample(scene);
  Finite finite;
  finite("a particle", samples.fluid);
  finite("a boundary sample", samples.boundary);
  if (finite.found.empty() && samples.fluid.empty()) return "there is no particle";
  return finite.found;
}

}  // namespace

std::string not_finite(const Scene& scene) {
  Finite finite;
  finite("settings", settings_of(scene));  // all that goes from a key to a member as it is
  finite("mass", scene.mass());
  finite("domain", std::vector{scene.domain_min, scene.domain_max, scene.domain_max - scene.domain_min});
  finite("centre", scene.centre);
  for (const FluidShape& shape : scene.fluid) {
    std::visit([&](const auto& geometry) { finite(shape.key, geometry); }, shape.geometry);
    std::visit([&](const auto& geometry) { finite("a centre", centre_of(geometry, scene.spacing)); },
               shape.geometry);
    finite(shape.key, std::vector{shape.velocity, shape.velocity_gradient[0], shape.velocity_gradient[1]});
  }
  for (const BoundaryShape& shape : scene.boundary)
    std::visit([&](const auto& geometry) { finite(shape.key, geometry); }, shape.geometry);
  finite("dt", scene.dt);
  return finite.found;
}

bool is_refusal_of(std::string_view message, std::string_view beginning) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  return message.starts_with(beginning) && std::ranges::none_of(message, is_control);
}

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Judgement judge_scene(std::string_view text, std::span<const std::string> overrides, double memory,
                      double seconds) {
  Judgement judgement;
  const double start = thread_seconds();
  try {
    const Scene scene = parse_scene(text, "mutant.toml", overrides);
    judgement.loaded = true;
    judgement.broken = not_finite(scene);
    require_memory(scene, Precision::double_, memory);
    if (judgement.broken.empty()) judgement.broken = broken_by_samples(scene);
    judgement.sampled = true;
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    const bool of_override = !overrides.empty() && is_refusal_of(message, "--set ");
    if (!of_override && !is_refusal_of(message, "mutant.toml:"))
      judgement.broken = fmt::format("refused with \"{}\"", message);
  } catch (const std::exception& error) {
    judgement.broken = fmt::format("an error that is no InputError: {}", error.what());
  }
  judgement.seconds = thread_seconds() - start;
  if (judgement.broken.empty() && judgement.seconds > seconds)
    judgement.broken = fmt::format("it takes {:.1f} s", judgement.seconds);
  return judgement;
}

}  // namespace sluice::test

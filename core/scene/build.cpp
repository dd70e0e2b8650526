// The tree's values into the Scene, and the checks across keys.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/scene/keys.hpp"
#include "core/scene/passes.hpp"
#include "core/scene/settings.hpp"

namespace sluice {
namespace {

constexpr double max_steps = 9007199254740992.0;  // 2^53, as far as a double counts

void check_mass(const SceneValue& root, const Scene& scene) {
  const SceneValue &spacing = root.at("particles.spacing"), &density = root.at("particles.rest_density");
  if (!std::isnormal(scene.mass()))
    throw refusal({&spacing, &density},
                  fmt::format("{}, which makes the mass of a particle {}", describe(spacing), scene.mass()),
                  "a mass rest_density h² within the range of numbers");
}

void check_method(const SceneValue& root) {
  const SceneValue &table = root.at("pressure"), &method = table.at("method");
  if (!table.find(method.text))
    throw refusal(
        method.overridden ? method.where : table.where, "pressure." + method.text, "nothing",
        fmt::format("a table [pressure.{}], as pressure.method is {}", method.text, describe(method)));
}

void check_iterations(const SceneValue& least, const SceneValue& most) {
  if (least.integer <= most.integer) return;
  if (!least.defaulted && (least.overridden || !most.overridden))
    throw refusal({&least, &most}, describe(least), "at most max_iterations, which is " + describe(most));
  throw refusal({&most, &least}, describe(most), "at least min_iterations, which is " + describe(least));
}

void check_time(const SceneValue& table, const SceneValue* method_dt, const std::string& method_key) {
  const SceneValue *dt = table.find("dt"), *cfl = table.find("cfl");
  const SceneValue *least = table.find("dt_min"), *most = table.find("dt_max");
  if (const SceneValue* other = dt ? dt : method_dt; cfl && other)
    throw refusal({cfl, other}, fmt::format("{} together with {}", describe(*cfl), other->path),
                  "one of the two");
  for (auto [value, key] : {std::pair{least, "time.dt_min"}, std::pair{most, "time.dt_max"}}) {
    if (cfl && !value)
      throw refusal(cfl->overridden ? cfl->where : table.where, key, "nothing",
                    "a number greater than 0, as time.cfl is set");
    if (!cfl && value) throw refusal({value}, describe(*value) + " without time.cfl", "the two together");
  }
  if (cfl && least->number > most->number)
    throw refusal({least, most}, describe(*least), "at most time.dt_max, which is " + describe(*most));
  if (!cfl && !dt && !method_dt)
    throw refusal(table.where, "time.dt", "nothing",
                  fmt::format("a number greater than 0, here or as {}", method_key));
}

void read_time(const SceneValue& root, Scene& scene) {
  const SceneValue &table = root.at("time"), &duration = table.at("duration");
  const std::string method_key = fmt::format("pressure.{}.dt", root.at("pressure.method").text);
  const SceneValue* method_dt = root.find(method_key);
  check_time(table, method_dt, method_key);
  const SceneValue* dt = scene.adaptive ? table.find("dt_min") : method_dt ? method_dt : table.find("dt");
  scene.dt = scene.adaptive ? scene.adaptive->dt_max : dt->number;
  scene.dt_key = dt->path;
  if (!(scene.duration / dt->number <= max_steps))
    throw refusal({&duration, dt},
                  fmt::format("{}, which is {:.4g} steps of {}", describe(duration),
                              scene.duration / dt->number, describe(*dt)),
                  fmt::format("at most {:.0f} steps", max_steps));
}

glm::uvec2 image_size(const SceneValue& root, const Scene& scene) {
  if (const SceneValue* size = root.find("output.size")) return vector_of(*size);
  const Vec2 domain = scene.domain_max - scene.domain_min;
  return glm::max(glm::round(domain * (800 / std::max(domain.x, domain.y))), Vec2(16));
}

// ---- settings

nlohmann::ordered_json to_json(const SceneValue& value, std::string_view path, KeyType type) {
  if (value.kind == SceneValue::Kind::text) return value.text;
  if (type == KeyType::integer) return value.integer;
  if (value.is_number()) return value.number;
  if (value.kind == SceneValue::Kind::array) {
    auto array = nlohmann::ordered_json::array();
    for (const SceneValue& item : value.items) array.push_back(to_json(item, path, type_info(type).element));
    return array;
  }
  auto table = nlohmann::ordered_json::object();
  for (const SceneKey& row : scene_rows()) {
    if (row.section() != path) continue;
    if (const SceneValue* member = value.find(row.name()))
      table[row.name()] = to_json(*member, row.path, row.type);
    else if (row.path == "time.dt" || row.path == "output.size")
      table[row.name()] = nullptr;  // keeps the order
  }
  return table;
}

/// The scene as run, as JSON: every key of the tree in the order of the key table, defaults included; numbers
/// as numbers, length strings as written. `scene` gives what no key says by itself: the time step and the
/// picture's size.
std::string settings_text(const SceneValue& root, const Scene& scene) {
  nlohmann::ordered_json settings = to_json(root, "", KeyType::table);
  if (scene.adaptive)
    settings["time"].erase("dt");
  else
    settings["time"]["dt"] = scene.dt;
  settings["output"]["size"] = {scene.image_size.x, scene.image_size.y};
  return settings.dump();
}

}  // namespace

Scene build_scene(const SceneValue& root, const std::string& name, const std::string& file) {
  Scene scene;
  scene.name = name;
  scene.file = file;
  for (const SceneKey& key : scene_keys())
    if (const SceneValue* value = root.find(key.path); value && key.read) key.read(*value, scene);
  scene.spacing_where = root.at("particles.spacing").where;
  check_mass(root, scene);
  read_lengths(root, scene);
  check_method(root);
  check_iterations(root.at("pressure.iisph.min_iterations"), root.at("pressure.iisph.max_iterations"));
  read_time(root, scene);
  scene.image_size = image_size(root, scene);
  scene.record.settings = settings_text(root, scene);
  return scene;
}

nlohmann::ordered_json settings_of(const Scene& scene) {
  return nlohmann::ordered_json::parse(scene.record.settings);
}

}  // namespace sluice

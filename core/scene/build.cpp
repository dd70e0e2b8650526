// The tree's values into the Scene's fields, and the checks across keys.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/scene/keys.hpp"
#include "core/scene/passes.hpp"
#include "core/scene/read_shapes.hpp"
#include "core/scene/settings.hpp"

namespace sluice {
namespace {

constexpr double max_steps = 9007199254740992.0;  // 2^53, as far as a double counts

/// Reads a name that was checked.
template <class Enum>
void read_choice(const SceneValue& value, Enum& choice) {
  choice = value_named<Enum>(value.text).value();
}

uint32_t count(const SceneValue& value) { return static_cast<uint32_t>(value.integer); }

void read_particles(const SceneValue& table, Scene& scene) {
  const SceneValue& spacing = table.at("spacing");
  scene.spacing = spacing.number;
  scene.smoothing = table.at("smoothing").number;
  scene.rest_density = table.at("rest_density").number;
  scene.spacing_where = spacing.where;
  if (!std::isnormal(scene.mass()))
    throw refusal({&spacing, &table.at("rest_density")},
                  fmt::format("{}, which makes the mass of a particle {}", describe(spacing), scene.mass()),
                  "a mass rest_density h² within the range of numbers");
}

void read_fluid(const SceneValue& table, Scene& scene) {
  scene.gravity = numbers(table.at("gravity"));
  scene.central_force = table.at("central_force").number;
  scene.jitter = table.at("jitter").number;
  scene.seed = static_cast<uint64_t>(table.at("seed").integer);
  scene.relax = count(table.at("relax"));
}

void read_iisph(const SceneValue& table, Iisph& iisph) {
  const SceneValue& least = table.at("min_iterations");
  const SceneValue& most = table.at("max_iterations");
  if (least.integer > most.integer) {
    if (!least.defaulted && (least.overridden || !most.overridden))
      throw refusal({&least, &most}, describe(least), "at most max_iterations, which is " + describe(most));
    throw refusal({&most, &least}, describe(most), "at least min_iterations, which is " + describe(least));
  }
  iisph.tolerance = table.at("tolerance").number;
  iisph.min_iterations = count(least);
  iisph.max_iterations = count(most);
  iisph.omega = table.at("omega").number;
  iisph.warm_start = table.at("warm_start").number;
  iisph.source_weight = table.at("source_weight").number;
  read_choice(table.at("solver"), iisph.solver);
  read_choice(table.at("wall"), iisph.wall);
  read_choice(table.at("stop"), iisph.stop);
}

void read_pressure(const SceneValue& root, Scene& scene) {
  const SceneValue& table = root.at("pressure");
  const SceneValue& method = table.at("method");
  read_choice(method, scene.method);
  if (!table.find(method.text))
    throw refusal(
        method.overridden ? method.where : table.where, "pressure." + method.text, "nothing",
        fmt::format("a table [pressure.{}], as pressure.method is {}", method.text, describe(method)));
  read_iisph(table.at("iisph"), scene.iisph);
  if (const SceneValue* ssph = table.find("ssph")) scene.ssph = Ssph{ssph->at("stiffness").number};
  if (const SceneValue* wcsph = table.find("wcsph"))
    scene.wcsph = Wcsph{wcsph->at("kappa").number, wcsph->at("gamma").number};
}

void check_time(const SceneValue& root, const SceneValue* method_dt, const std::string& method_key) {
  const SceneValue& table = root.at("time");
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
  const SceneValue& table = root.at("time");
  const SceneValue& pressure = root.at("pressure");
  const std::string& method = pressure.at("method").text;
  const SceneValue* method_dt = pressure.at(method).find("dt");
  std::string method_key = fmt::format("pressure.{}.dt", method);
  check_time(root, method_dt, method_key);
  scene.duration = table.at("duration").number;
  const SceneValue* dt = method_dt ? method_dt : table.find("dt");
  if (const SceneValue* cfl = table.find("cfl")) {
    scene.adaptive = {cfl->number, table.at("dt_min").number, table.at("dt_max").number};
    dt = table.find("dt_min");
  }
  scene.dt = scene.adaptive ? scene.adaptive->dt_max : dt->number;
  scene.dt_key = dt->path;
  if (!(scene.duration / dt->number <= max_steps))
    throw refusal({&table.at("duration"), dt},
                  fmt::format("{}, which is {:.4g} steps of {}", describe(table.at("duration")),
                              scene.duration / dt->number, describe(*dt)),
                  fmt::format("at most {:.0f} steps", max_steps));
}

void read_output(const SceneValue& table, Scene& scene) {
  scene.fps = table.at("fps").number;
  read_choice(table.at("colour"), scene.colour);
  if (const SceneValue* size = table.find("size")) {
    scene.image_size = {count(size->items[0]), count(size->items[1])};
  } else {
    Vec2 domain = scene.domain_max - scene.domain_min;
    Vec2 pixels = glm::max(glm::round(domain * (800 / std::max(domain.x, domain.y))), Vec2(16));
    scene.image_size = {static_cast<uint32_t>(pixels.x), static_cast<uint32_t>(pixels.y)};
  }
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
  scene.title = root.at("scene").at("title").text;
  scene.source = root.at("scene").at("source").text;
  read_particles(root.at("particles"), scene);
  read_fluid(root.at("fluid"), scene);
  read_lengths(root, scene);
  if (const SceneValue* boundary = root.find("boundary"))
    read_choice(boundary->at("model"), scene.boundary_model);
  if (const SceneValue* viscosity = root.find("viscosity")) {
    read_choice(viscosity->at("model"), scene.viscosity_model);
    scene.viscosity = viscosity->at("coefficient").number;
  }
  read_pressure(root, scene);
  read_time(root, scene);
  read_output(root.at("output"), scene);
  scene.record.settings = settings_text(root, scene);
  return scene;
}

nlohmann::ordered_json settings_of(const Scene& scene) {
  return nlohmann::ordered_json::parse(scene.record.settings);
}

}  // namespace sluice

// TOML to Scene: the shipped scenes, lengths, defaults, the order of shapes, the settings, and how files are
// found.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/scene/keys.hpp"
#include "core/scene/length.hpp"
#include "core/scene/settings.hpp"
#include "sluice/load.hpp"

namespace sluice {
namespace {

namespace fs = std::filesystem;

const std::string head = R"([scene]
title = "Test"
[particles]
spacing = 10
rest_density = 2.5
[domain]
min = [-10, 0]
max = ["-10+20h", 400]
)";
const std::string tail = "[pressure]\nmethod = \"iisph\"\n[time]\ndt = 0.5\nduration = 3\n";
const std::string small =
    head + "[fluid]\ngravity = [1, -2]\n[[fluid.rect]]\nmin = [0, 0]\ncount = [2, 3]\n" + tail;

Scene scene_of(const std::string& shapes) { return parse_scene(head + shapes + tail, "folder/some.toml"); }

std::string refusal_of(const std::string& scene) {
  try {
    load_scene(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

TEST(SceneFile, BreakingDamHoldsWhatItSays) {
  Scene scene = load_scene("breaking_dam");
  EXPECT_EQ(scene.name, "breaking_dam");
  EXPECT_TRUE(scene.file.ends_with("scenes/breaking_dam.toml")) << scene.file;
  EXPECT_EQ(scene.title, "Breaking dam");
  EXPECT_EQ(scene.source, "Hunkler 2022, Fig. 6.1");
  EXPECT_EQ(scene.spacing, 8);
  EXPECT_EQ(scene.smoothing_length(), 8);
  EXPECT_EQ(scene.mass(), 64);
  EXPECT_EQ(scene.domain_max, Vec2(400, 600));
  EXPECT_EQ(scene.gravity, Vec2(0, -9.81));
  ASSERT_EQ(scene.fluid.size(), 1u);
  const Rect& fluid = std::get<Rect>(scene.fluid[0].geometry);
  EXPECT_EQ(fluid.min, Vec2(24, 24));
  EXPECT_EQ(fluid.count, glm::uvec2(22, 30));
  EXPECT_EQ(scene.boundary_model, BoundaryModel::mirror);
  ASSERT_EQ(scene.boundary.size(), 1u);
  const Container& box = std::get<Container>(scene.boundary[0].geometry);
  EXPECT_EQ(box.max, Vec2(400, 600));
  EXPECT_EQ(box.layers, 3u);
  EXPECT_TRUE(box.left && box.right && box.bottom && !box.top);
  EXPECT_EQ(scene.viscosity_model, ViscosityModel::laplacian);
  EXPECT_EQ(scene.viscosity, 200);
  EXPECT_EQ(scene.method, PressureMethod::iisph);
  EXPECT_EQ(scene.iisph.tolerance, 1e-3);
  ASSERT_TRUE(scene.ssph.has_value());
  EXPECT_EQ(scene.ssph->stiffness, 7e5);
  ASSERT_TRUE(scene.wcsph.has_value());
  EXPECT_EQ(scene.wcsph->kappa, 7e5);
  EXPECT_EQ(scene.wcsph->gamma, 7);
  EXPECT_EQ(scene.dt, 0.04);
  EXPECT_EQ(scene.duration, 50);
  EXPECT_EQ(scene.image_size, glm::uvec2(400, 600));
  EXPECT_TRUE(scene.spacing_where.ends_with("breaking_dam.toml:6:11")) << scene.spacing_where;
}

TEST(SceneFile, EveryShippedSceneLoadsWithEveryMethodAndAUnitOfTheThesisIsAPixel) {
  std::vector<std::string> names = shipped_scenes();
  EXPECT_TRUE(std::ranges::is_sorted(names));
  for (const char* name : {"breaking_dam", "falling_from_platform", "iisph_box", "inclined_plane",
                           "leaking_dam", "resting_fluid", "template", "wcsph_box"})
    EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    Scene scene;
    ASSERT_NO_THROW(scene = load_scene(name));
    EXPECT_EQ(scene.name, name);
    const bool of_the_thesis = !name.ends_with("_box");
    if (of_the_thesis) {
      EXPECT_EQ(Vec2(scene.image_size), scene.domain_max - scene.domain_min);
    }
    for (const std::string method : {"iisph", "ssph", "wcsph"}) {
      std::vector<std::string> overrides{"pressure.method=" + method};
      ASSERT_NO_THROW(scene = load_scene(name, overrides));
      EXPECT_EQ(settings_of(scene)["pressure"]["method"], method);
      if (method == "iisph" || (!of_the_thesis && method == "wcsph")) continue;
      EXPECT_EQ(scene.dt, settings_of(scene)["pressure"][method]["dt"].get<double>());
    }
  }
}

TEST(SceneFile, TheBoxesDifferInTheirMethodOnly) {
  Scene wcsph = load_scene("wcsph_box"), iisph = load_scene("iisph_box");
  EXPECT_EQ(wcsph.method, PressureMethod::wcsph);
  EXPECT_EQ(wcsph.wcsph->kappa, 245);
  EXPECT_EQ(wcsph.viscosity_model, ViscosityModel::xsph);
  EXPECT_EQ(wcsph.viscosity, 0.05);
  EXPECT_EQ(wcsph.boundary_model, BoundaryModel::akinci);
  EXPECT_EQ(iisph.method, PressureMethod::iisph);
  const auto rest_of = [](const Scene& scene) {
    nlohmann::ordered_json settings = settings_of(scene);
    settings.erase("scene");
    settings["pressure"].erase("method");
    return settings;
  };
  EXPECT_EQ(rest_of(wcsph), rest_of(iisph));
}

TEST(SceneFile, GeometryOfTheOtherScenes) {
  Scene leak = load_scene("leaking_dam");
  EXPECT_EQ(std::get<Rect>(leak.fluid.at(0).geometry).count, glm::uvec2(22, 200));
  const Rect& dam = std::get<Rect>(leak.boundary.at(1).geometry);
  EXPECT_EQ(dam.min, Vec2(100, 32));
  EXPECT_EQ(dam.count, glm::uvec2(6, 218));
  EXPECT_EQ(dam.layers, 0u);

  Scene platform = load_scene("falling_from_platform");
  EXPECT_EQ(std::get<Rect>(platform.fluid.at(0).geometry).count, glm::uvec2(21, 20));
  EXPECT_EQ(std::get<Rect>(platform.boundary.at(1).geometry).count, glm::uvec2(25, 17));
  EXPECT_EQ(std::get<Rect>(platform.boundary.at(1).geometry).layers, 3u);

  Scene plane = load_scene("inclined_plane");
  EXPECT_EQ(std::get<Rect>(plane.fluid.at(0).geometry).count, glm::uvec2(12, 11));
  const Segment& wall = std::get<Segment>(plane.boundary.at(1).geometry);
  EXPECT_EQ(wall.from, Vec2(24, 264));
  EXPECT_EQ(wall.to, Vec2(312, 24));
  EXPECT_EQ(wall.layers, 3u);

  EXPECT_EQ(std::get<Rect>(load_scene("resting_fluid").fluid.at(0).geometry).count, glm::uvec2(35, 30));
}

TEST(SceneFile, Lengths) {
  auto value = [](std::string_view text) {
    std::optional<LengthInSpacings> length = parse_length(text);
    return length ? length->value(8) : std::nan("");
  };
  EXPECT_EQ(value("240"), 240);
  EXPECT_EQ(value("-2.5"), -2.5);
  EXPECT_EQ(value("3h"), 24);
  EXPECT_EQ(value("-0.5h"), -4);
  EXPECT_EQ(value("240+3h"), 264);
  EXPECT_EQ(value("240-3h"), 216);
  EXPECT_EQ(value("-240-3h"), -264);
  EXPECT_EQ(value("1e2+1e-1h"), 100.8);
  EXPECT_EQ(value("1e+2h"), 800) << "the plus belongs to the exponent";
  EXPECT_TRUE(std::isnan(value("h")));
}

TEST(SceneFile, CountsOfRects) {
  auto count = [](const std::string& max) {
    Scene scene =
        scene_of("[fluid]\ngravity = [0, 0]\n[[fluid.rect]]\nmin = [0, \"1h\"]\nmax = " + max + "\n");
    return std::get<Rect>(scene.fluid[0].geometry).count;
  };
  EXPECT_EQ(count("[100, 110]"), glm::uvec2(10, 10)) << "max is excluded";
  EXPECT_EQ(count("[100.1, 110.1]"), glm::uvec2(11, 11));
  EXPECT_EQ(count("[100.000001, 110.000009]"), glm::uvec2(10, 10)) << "within 1e-6 h of max is at max";
  EXPECT_EQ(count("[0.1, 10.1]"), glm::uvec2(1, 1));
}

TEST(SceneFile, DefaultsOfWhatIsLeftOut) {
  Scene scene = parse_scene(small, "folder/some.toml");
  EXPECT_EQ(scene.name, "some");
  EXPECT_EQ(scene.source, "");
  EXPECT_EQ(scene.smoothing, 1);
  EXPECT_EQ(scene.central_force, 0);
  EXPECT_EQ(scene.centre, Vec2(0, 0));
  EXPECT_EQ(scene.jitter, 0);
  EXPECT_EQ(scene.seed, 0u);
  EXPECT_EQ(scene.relax, 0u);
  EXPECT_EQ(scene.boundary_model, BoundaryModel::none);
  EXPECT_TRUE(scene.boundary.empty());
  EXPECT_EQ(scene.viscosity_model, ViscosityModel::none);
  EXPECT_EQ(scene.iisph.tolerance, 1e-3);
  EXPECT_EQ(scene.iisph.min_iterations, 2u);
  EXPECT_EQ(scene.iisph.max_iterations, 1000u);
  EXPECT_EQ(scene.iisph.omega, 0.5);
  EXPECT_EQ(scene.iisph.warm_start, 0.5);
  EXPECT_EQ(scene.iisph.source_weight, 1);
  EXPECT_FALSE(scene.ssph.has_value());
  EXPECT_EQ(scene.fps, 25);
  EXPECT_EQ(scene.colour, Colour::speed);
  EXPECT_EQ(scene.image_size, glm::uvec2(400, 800)) << "a domain of 200 x 400";
}

TEST(SceneFile, ValuesThatAreGiven) {
  Scene scene = scene_of(R"([fluid]
gravity = [0, 0]
central_force = 1.5
centre = ["1h", -3]
jitter = 0.5
seed = 9223372036854775807
relax = 20
[[fluid.rect]]
min = [0, 0]
count = [2, 3]
velocity = [4, -5]
velocity_gradient = [[1, 2], [3, 4]]
[viscosity]
model = "laplacian"
coefficient = 0
[output]
fps = 12.5
size = [16, 16384]
colour = "pressure"
[pressure.wcsph]
kappa = 245
[pressure.iisph]
tolerance = 1e-4
min_iterations = 3
max_iterations = 4
omega = 0.4
warm_start = 1
source_weight = 0.2
dt = 0.25
)");
  EXPECT_EQ(scene.central_force, 1.5);
  EXPECT_EQ(scene.centre, Vec2(10, -3));
  EXPECT_EQ(scene.jitter, 0.5);
  EXPECT_EQ(scene.seed, 9223372036854775807u);
  EXPECT_EQ(scene.relax, 20u);
  EXPECT_EQ(scene.fluid[0].velocity, Vec2(4, -5));
  EXPECT_EQ(scene.fluid[0].velocity_gradient * Vec2(10, 100), Vec2(210, 430)) << "rows in the file";
  EXPECT_EQ(scene.viscosity_model, ViscosityModel::laplacian);
  EXPECT_EQ(scene.fps, 12.5);
  EXPECT_EQ(scene.image_size, glm::uvec2(16, 16384));
  EXPECT_EQ(scene.colour, Colour::pressure);
  ASSERT_TRUE(scene.wcsph.has_value());
  EXPECT_EQ(scene.wcsph->kappa, 245);
  EXPECT_EQ(scene.wcsph->gamma, 7);
  EXPECT_EQ(scene.iisph.tolerance, 1e-4);
  EXPECT_EQ(scene.iisph.min_iterations, 3u);
  EXPECT_EQ(scene.iisph.max_iterations, 4u);
  EXPECT_EQ(scene.iisph.omega, 0.4);
  EXPECT_EQ(scene.iisph.warm_start, 1);
  EXPECT_EQ(scene.iisph.source_weight, 0.2);
  EXPECT_EQ(scene.dt, 0.25) << "the chosen method's own";
}

TEST(SceneFile, ShapesComeInTheOrderOfTheFileWhateverTheirKind) {
  Scene scene = scene_of(R"([[boundary.segment]]
from = [0, 0]
to = [9, 9]
[[fluid.disc]]
centre = [50, 50]
radius = "2h"
[[fluid.rect]]
min = [0, 0]
count = [1, 1]
[boundary]
model = "mirror"
[[boundary.container]]
min = [0, 0]
max = [9, 9]
sides = ["top", "left"]
[[fluid.polygon]]
points = [[0, 100], [50, 100], ["5h", 150]]
[fluid]
gravity = [0, 0]
[[boundary.segment]]
from = [0, 5]
to = [9, 9]
layers = 1
[[fluid.rect]]
min = [90, 0]
count = [1, 1]
[[fluid.disc]]
centre = [150, 50]
radius = 20
)");
  std::vector<std::string> keys, places;
  for (const FluidShape& shape : scene.fluid) keys.push_back(shape.key), places.push_back(shape.where);
  EXPECT_EQ(keys, (std::vector<std::string>{"fluid.disc.0", "fluid.rect.0", "fluid.polygon.0", "fluid.rect.1",
                                            "fluid.disc.1"}));
  EXPECT_EQ(places.front(), "folder/some.toml:12:1");
  EXPECT_EQ(places.back(), "folder/some.toml:35:1");
  EXPECT_EQ(std::get<Disc>(scene.fluid[0].geometry).radius, 20);
  EXPECT_EQ(std::get<Polygon>(scene.fluid[2].geometry).points.at(2), Vec2(50, 150));

  keys.clear();
  for (const BoundaryShape& shape : scene.boundary) keys.push_back(shape.key);
  EXPECT_EQ(keys,
            (std::vector<std::string>{"boundary.segment.0", "boundary.container.0", "boundary.segment.1"}));
  const Container& box = std::get<Container>(scene.boundary[1].geometry);
  EXPECT_TRUE(box.top && box.left && !box.right && !box.bottom);
  EXPECT_EQ(std::get<Segment>(scene.boundary[2].geometry).layers, 1u);
}

TEST(SceneFile, ABoundaryOfEveryKind) {
  Scene scene = scene_of(R"([fluid]
gravity = [0, 0]
rect = [ { min = [0, 0], count = [1, 1] }, { min = [50, 0], count = [2, 1] } ]
[boundary]
model = "mirror"
[[boundary.rect]]
min = ["1h", 0]
max = [41, 20]
layers = 2
[[boundary.disc]]
centre = [1, 2]
radius = "10-0.5h"
[[boundary.polygon]]
points = [[0, 0], [2, 2], [2, 0], [0, 2]]
)");
  ASSERT_EQ(scene.fluid.size(), 2u) << "an array of inline tables is the same in TOML";
  EXPECT_EQ(std::get<Rect>(scene.fluid[1].geometry).count, glm::uvec2(2, 1));
  ASSERT_EQ(scene.boundary.size(), 3u);
  EXPECT_EQ(std::get<Rect>(scene.boundary[0].geometry).count, glm::uvec2(4, 2));
  EXPECT_EQ(std::get<Rect>(scene.boundary[0].geometry).layers, 2u);
  EXPECT_EQ(std::get<Disc>(scene.boundary[1].geometry).centre, Vec2(1, 2));
  EXPECT_EQ(std::get<Disc>(scene.boundary[1].geometry).radius, 5);
  EXPECT_EQ(std::get<Polygon>(scene.boundary[2].geometry).points.size(), 4u) << "crossed, yet with an area";
}

/// The tables of the settings that a section of the key table describes.
nlohmann::ordered_json* table_in(nlohmann::ordered_json& settings, std::string_view section) {
  nlohmann::ordered_json* table = &settings;
  while (!section.empty()) {
    const std::string part(section.substr(0, section.find('.')));
    const std::string name = part.substr(0, part.find('['));
    if (!table->contains(name)) return nullptr;
    table = &(*table)[name];
    if (part != name) table = &(*table)[0];
    section.remove_prefix(std::min(section.size(), part.size() + 1));
  }
  return table;
}

TEST(SceneFile, SettingsSayEverything) {
  nlohmann::ordered_json settings = settings_of(parse_scene(small, "some.toml"));
  int defaults = 0;
  for (const SceneKey& key : scene_keys()) {
    nlohmann::ordered_json* table = table_in(settings, key.section());
    if (!table || key.fallback.empty() || key.fallback == required_key || key.path == "fluid.seed") continue;
    const std::string name(key.name());
    EXPECT_EQ((*table)[name], nlohmann::ordered_json::parse(key.fallback)) << key.path;
    table->erase(name);
    ++defaults;
  }
  EXPECT_GT(defaults, 15);
  EXPECT_EQ(settings.dump(),
            R"({"scene":{"title":"Test"},"particles":{"spacing":10.0,"rest_density":2.5},)"
            R"("domain":{"min":[-10.0,0.0],"max":["-10+20h",400.0]},)"
            R"("fluid":{"gravity":[1.0,-2.0],"seed":0,"rect":[{"min":[0.0,0.0],"count":[2,3]}]},)"
            R"("pressure":{"method":"iisph","iisph":{}},)"
            R"("time":{"dt":0.5,"duration":3.0},"output":{"size":[400,800]}})")
      << "what has no default, in the order of the key table";
}

TEST(SceneFile, SettingsHoldTheTimeStepThatIsUsed) {
  std::vector<std::string> overrides{"pressure.method=ssph"};
  Scene scene = load_scene("breaking_dam", overrides);
  EXPECT_EQ(scene.dt, 0.01);
  EXPECT_EQ(settings_of(scene)["time"]["dt"], 0.01);
  std::vector<std::string> without{"pressure.ssph={stiffness=1,dt=0.25}", "pressure.method=ssph",
                                   "time={duration=1}"};
  EXPECT_EQ(settings_of(parse_scene(small, "some.toml", without))["time"].dump(),
            R"({"dt":0.25,"duration":1.0})");
}

/// JSON as a TOML value. A JSON string is a TOML basic string; tables become inline tables.
std::string to_toml(const nlohmann::ordered_json& json) {
  if (!json.is_structured()) return json.dump();
  std::string text;
  for (const auto& [key, value] : json.items())
    text += (text.empty() ? "" : ", ") + (json.is_object() ? key + " = " : std::string()) + to_toml(value);
  return json.is_object() ? "{ " + text + " }" : "[" + text + "]";
}

TEST(SceneFile, SettingsReadBackAreTheSameScene) {
  for (const std::string& name : shipped_scenes()) {
    SCOPED_TRACE(name);
    Scene scene = load_scene(name);
    std::string text;
    const auto settings = settings_of(scene);
    for (const auto& [key, value] : settings.items()) text += key + " = " + to_toml(value) + "\n";
    Scene again = parse_scene(text, "again.toml");
    EXPECT_EQ(settings_of(again).dump(), settings_of(scene).dump());
    EXPECT_EQ(again.fluid.size(), scene.fluid.size());
    EXPECT_EQ(again.boundary.size(), scene.boundary.size());
    EXPECT_EQ(again.dt, scene.dt);
  }
}

class SceneFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("sluice_scene_file_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  fs::path folder_;
};

TEST_F(SceneFolder, AFileIsReadAtItsPath) {
  std::string path = write("my scene.toml", "\xEF\xBB\xBF" + small);
  Scene scene = load_scene(path);
  EXPECT_EQ(scene.name, "my scene");
  EXPECT_EQ(scene.file, path);
  EXPECT_EQ(scene.fluid.at(0).where, path + ":11:1");
}

TEST_F(SceneFolder, WhatIsNoSceneFileIsRefused) {
  std::string folder = folder_.string();
  EXPECT_EQ(refusal_of(folder), folder + ": found a directory, expected a scene file");
  EXPECT_EQ(refusal_of("/dev/null"), "/dev/null: found a special file, expected a scene file");
  EXPECT_EQ(refusal_of(write("empty.toml", "")),
            folder + "/empty.toml:1:1: scene: found nothing, expected a table [scene]");
  EXPECT_EQ(refusal_of(write("big.toml", std::string(1 << 21, '\n'))),
            folder + "/big.toml: found more than 1048576 bytes, expected a scene file");
  EXPECT_EQ(refusal_of(write("image.toml", std::string("\x89PNG\r\n\x1a\n\0\0", 10))),
            folder + "/image.toml:1:1: found bytes that are not UTF-8, expected TOML text");
}

TEST(SceneFile, AFileThatCannotBeReadIsRefused) {
  // A regular file that opens, and whose first byte can't be read, by any user.
  EXPECT_EQ(refusal_of("/proc/self/mem"),
            "/proc/self/mem: found a file that can't be read, expected a scene file");
}

TEST(SceneFile, AnUnknownNameListsTheKnownOnes) {
  std::string message = refusal_of("braking_dam");
  EXPECT_TRUE(
      message.starts_with("braking_dam: found no such file, expected the path of a scene file or one of "))
      << message;
  for (const std::string& name : shipped_scenes()) EXPECT_NE(message.find(name), std::string::npos) << name;
  EXPECT_TRUE(refusal_of("").starts_with(": found no such file, expected the path")) << refusal_of("");
  EXPECT_TRUE(refusal_of("../scenes/breaking_dam").starts_with("../scenes/breaking_dam: found no such file"));
  EXPECT_TRUE(refusal_of(std::string(100000, 'x')).find("found no such file") != std::string::npos);
}

}  // namespace
}  // namespace sluice

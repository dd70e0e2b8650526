// The key table is sound, the documentation is made from it, and the template scene shows all of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/output/output_file.hpp"
#include "core/scene/keys.hpp"
#include "core/scene/settings.hpp"
#include "core/scene/tree.hpp"
#include "sluice/load.hpp"
#include "tests/support/run_program.hpp"

namespace sluice {
namespace {

std::string read_project_file(const std::string& path) {
  std::ifstream file(SLUICE_SOURCE_DIR "/" + path, std::ios::binary);
  EXPECT_TRUE(file.is_open()) << path << " can't be read";
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(SceneKeys, EveryKeyIsInAKnownSectionOnce) {
  std::set<std::string_view> sections, keys;
  for (const SceneKey& section : scene_tables()) {
    EXPECT_TRUE(section.section().empty() || sections.contains(section.section())) << section.path;
    EXPECT_TRUE(sections.insert(section.path).second) << section.path;
    EXPECT_FALSE(section.meaning.empty()) << section.path;
    EXPECT_FALSE(section.is_array_of_tables() && !section.fallback.empty()) << section.path;
  }
  for (const SceneKey& key : scene_keys()) {
    EXPECT_TRUE(sections.contains(key.section())) << key.path;
    EXPECT_TRUE(keys.insert(key.path).second) << key.path;
    EXPECT_FALSE(key.meaning.empty()) << key.path;
  }
  EXPECT_GT(keys.size(), 60u);
}

TEST(SceneKeys, ChoicesBelongToChoiceKeys) {
  for (const SceneKey& key : scene_keys()) {
    bool choice = key.type == KeyType::choice || key.type == KeyType::choices;
    EXPECT_EQ(choice, !key.choices.empty()) << key.path;
    EXPECT_EQ(choice, !join_choices(key.choices).empty()) << key.path << " has no choice";
  }
}

// A scene without optional keys loads with each default; the same scene with each default written out must
// too, and mean the same.
TEST(SceneKeys, DefaultsAreGoodValues) {
  const test::TemporaryFolder folder;
  write_file(folder / "points.csv", "x,y\n3,3\n");
  const std::string text =
      "[scene]\ntitle = \"a\"\n[particles]\nspacing = 1\nrest_density = 1\n[domain]\nmin = [0, 0]\nmax = [9, "
      "9]\n"
      "[fluid]\ngravity = [0, 0]\n[[fluid.rect]]\nmin = [0, 0]\ncount = [1, 1]\n[[fluid.disc]]\ncentre = [5, "
      "5]\n"
      "radius = 1\n[[fluid.particles]]\nfile = \"points.csv\"\n[[fluid.polygon]]\npoints = [[7, 7], [9, 7], "
      "[9, 9]]\n[boundary]\nmodel = \"mirror\"\n"
      "[[boundary.rect]]\nmin = [0, 0]\ncount = [1, 1]\n[[boundary.container]]\nmin = [0, 0]\nmax = [9, 9]\n"
      "[[boundary.segment]]\nfrom = [0, 0]\nto = [9, 0]\n[pressure]\nmethod = \"iisph\"\n[pressure.wcsph]\n"
      "kappa = 1\n[time]\ndt = 1\nduration = 1\n";
  const std::string file = folder / "t.toml";
  Scene plain = parse_scene(text, file);
  size_t defaults = 0;
  for (const SceneKey& key : scene_keys()) {
    if (key.fallback.empty() || key.fallback == required_key) continue;
    std::string path(key.path);
    if (size_t array = path.find("[]"); array != path.npos) path.replace(array, 2, ".0");
    std::vector<std::string> overrides{path + "=" + std::string(key.fallback)};
    EXPECT_EQ(settings_of(parse_scene(text, file, overrides)), settings_of(plain)) << overrides[0];
    ++defaults;
  }
  EXPECT_GT(defaults, 20u);
}

TEST(SceneKeys, TheDocumentIsTheReference) {
  std::string document = read_project_file("docs/scene_keys.md"), reference = key_reference();
  if (document == reference) return;
  auto [written, made] = std::ranges::mismatch(document, reference);
  auto line = std::count(document.begin(), written, '\n') + 1;
  FAIL() << "docs/scene_keys.md differs from the key table in line " << line
         << ". Write it again: build/release/sluice scenes --keys > docs/scene_keys.md";
}

TEST(SceneKeys, TheReferenceNamesEverySectionAndKey) {
  std::string reference = key_reference();
  for (const SceneKey& section : scene_tables()) {
    std::string path(section.path.substr(0, section.path.find("[]")));
    std::string header = section.is_array_of_tables() ? "## [[" + path + "]]\n" : "## [" + path + "]\n";
    EXPECT_NE(reference.find(header), std::string::npos) << header;
  }
  size_t rows = 0;
  std::istringstream lines(reference);
  for (std::string line; std::getline(lines, line);) rows += line.starts_with("| `");
  EXPECT_EQ(rows, scene_keys().size());
  EXPECT_NE(reference.find("| `omega` | number |  | `0.5` | greater than 0 and less than 2 | "),
            std::string::npos);
  EXPECT_NE(reference.find("| `seed` | integer |  | `0` | at least 0 | "), std::string::npos);
  EXPECT_NE(reference.find("`\"thesis\"`, `\"symmetric\"` |"), std::string::npos);
}

/// "section key" for every key that a scene file shows, written or commented out.
std::set<std::string> shown_keys(const std::string& text) {
  std::set<std::string> shown;
  std::string section;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# [")) line.erase(0, 2);
    if (line.starts_with('[')) {
      bool array = line.starts_with("[[");
      section = line.substr(array ? 2 : 1, line.find(']') - (array ? 2 : 1)) + (array ? "[]" : "");
    }
    if (line.starts_with("# ")) line.erase(0, 2);
    size_t end = line.find(" = ");
    if (end != line.npos && line.find(' ') == end) shown.insert(section + "." + line.substr(0, end));
  }
  return shown;
}

/// A value that is allowed for the key, and not its default; with another number, another value.
std::string good_value(const SceneKey& key, int number) {
  switch (key.type) {
    case KeyType::text: return fmt::format("\"text {}\"", number);
    case KeyType::choice: return fmt::format("\"{}\"", key.choices[size_t(number) % key.choices.size()].name);
    case KeyType::integer: return fmt::format("{}", 3 + number);
    case KeyType::number: {
      const double low = std::max(key.range.low, 0.0), high = std::min(key.range.high, low + 0.5);
      return fmt::format("{}", low + (high - low) * (0.25 + 0.5 * number));
    }
    default: return fmt::format("[{}, {}]", 1 + number, 2 + number);
  }
}

TEST(SceneKeys, AKeyFillsTheMemberOfItsRowAndNoOther) {
  const auto filled = [](const SceneKey& key, int number) {
    Scene scene;
    key.read(parse_override_value(good_value(key, number), "key", 1), scene);
    return scene;
  };
  // All that rows may fill, as text; scenes are not made to be compared.
  const auto members = [](const Scene& s) {
    const Ssph ssph = s.ssph.value_or(Ssph{});
    const Wcsph wcsph = s.wcsph.value_or(Wcsph{});
    const AdaptiveStep adaptive = s.adaptive.value_or(AdaptiveStep{});
    std::vector<std::string> all{s.title, s.source};
    for (const double value : {s.spacing,
                               s.smoothing,
                               s.rest_density,
                               s.gravity.x,
                               s.gravity.y,
                               s.central_force,
                               s.jitter,
                               double(s.seed),
                               double(s.relax),
                               double(s.boundary_model),
                               double(s.viscosity_model),
                               s.viscosity,
                               double(s.method),
                               ssph.stiffness,
                               wcsph.kappa,
                               wcsph.gamma,
                               s.iisph.tolerance,
                               double(s.iisph.min_iterations),
                               double(s.iisph.max_iterations),
                               s.iisph.omega,
                               s.iisph.warm_start,
                               s.iisph.source_weight,
                               double(s.iisph.solver),
                               double(s.iisph.wall),
                               double(s.iisph.stop),
                               s.duration,
                               adaptive.cfl,
                               adaptive.dt_min,
                               adaptive.dt_max,
                               s.fps,
                               double(s.colour)})
      all.push_back(fmt::format("{}", value));
    return all;
  };
  std::map<size_t, std::string_view> filled_by;
  for (const SceneKey& key : scene_keys()) {
    if (!key.read) continue;
    const auto one = members(filled(key, 0)), two = members(filled(key, 1));
    size_t changed = 0;
    for (size_t i = 0; i < one.size(); ++i) {
      if (one[i] == two[i]) continue;
      ++changed;
      EXPECT_TRUE(filled_by.emplace(i, key.path).second) << key.path << " and " << filled_by[i];
    }
    EXPECT_EQ(changed, key.type == KeyType::numbers ? 2u : 1u) << key.path;
  }
}

TEST(SceneKeys, TheTemplateShowsEveryKey) {
  const std::set<std::string> shown = shown_keys(read_project_file("scenes/template.toml"));
  for (const SceneKey& key : scene_keys()) EXPECT_TRUE(shown.contains(std::string(key.path))) << key.path;
}

TEST(SceneKeys, NearestKey) {
  EXPECT_EQ(nearest_key("particles", "spaceing"), "spacing");
  EXPECT_EQ(nearest_key("", "presure"), "pressure");
  EXPECT_EQ(nearest_key("fluid", "rects"), "rect");
  EXPECT_EQ(nearest_key("output", "kappa"), "pressure.wcsph.kappa")
      << "far from all of [output], known elsewhere";
  EXPECT_EQ(nearest_key("time", std::string(100000, 'q')), "dt") << "and quickly";
}

TEST(SceneKeys, Expectations) {
  auto with_range = [](KeyType type, KeyRange range) {
    return expectation(
        SceneKey{.path = "a.b", .type = type, .unit = "", .fallback = "", .meaning = "", .range = range});
  };
  EXPECT_EQ(with_range(KeyType::number, {}), "a number");
  EXPECT_EQ(with_range(KeyType::number, {.low = 0, .low_excluded = true}), "a number greater than 0");
  EXPECT_EQ(with_range(KeyType::integer, {.high = 7}), "an integer at most 7");
  EXPECT_EQ(with_range(KeyType::number, {.low = 1, .high = 2}), "a number from 1 to 2");
  EXPECT_EQ(with_range(KeyType::number, {.low = 1, .high = 2, .high_excluded = true}),
            "a number of at least 1 and less than 2");
  constexpr ChoiceInfo choices[]{{"a", "a", ""}, {"c", "c", ""}, {"d", "d", ""}};
  EXPECT_EQ(join_choices(choices), "\"a\", \"c\" or \"d\"");
}

}  // namespace
}  // namespace sluice

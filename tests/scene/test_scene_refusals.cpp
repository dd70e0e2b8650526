// Bad scenes are refused with one exact line that says where, what was found and what was expected.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sluice/load.hpp"
#include "tests/support/message_of.hpp"

namespace sluice {
namespace {

const std::vector<std::string> good_lines{
    "[scene]",                 // 1
    "title = \"Test\"",        // 2
    "[particles]",             // 3
    "spacing = 8",             // 4
    "rest_density = 1",        // 5
    "[domain]",                // 6
    "min = [0, 0]",            // 7
    "max = [400, 600]",        // 8
    "[fluid]",                 // 9
    "gravity = [0, -9.81]",    // 10
    "[[fluid.rect]]",          // 11
    "min = [\"3h\", \"3h\"]",  // 12
    "max = [200, 264]",        // 13
    "[boundary]",              // 14
    "model = \"mirror\"",      // 15
    "[[boundary.container]]",  // 16
    "min = [0, 0]",            // 17
    "max = [400, 600]",        // 18
    "[viscosity]",             // 19
    "model = \"laplacian\"",   // 20
    "coefficient = 200",       // 21
    "[pressure]",              // 22
    "method = \"iisph\"",      // 23
    "[pressure.iisph]",        // 24
    "tolerance = 1e-3",        // 25
    "[pressure.ssph]",         // 26
    "stiffness = 7e5",         // 27
    "dt = 0.01",               // 28
    "[pressure.wcsph]",        // 29
    "kappa = 245",             // 30
    "[time]",                  // 31
    "dt = 0.04",               // 32
    "duration = 50",           // 33
};

/// The good scene with one line (from 1) replaced by other text; line 0: nothing replaced.
std::string scene_with(size_t line, const std::string& text) {
  std::string scene;
  for (size_t i = 0; i < good_lines.size(); ++i) scene += (i + 1 == line ? text : good_lines[i]) + "\n";
  return scene;
}

std::string refusal_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_scene(text, "t.toml", overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

struct Case {
  size_t line;
  std::string text;
  std::string message;
};

void expect_refusals(const std::vector<Case>& cases) {
  for (const Case& c : cases) EXPECT_EQ(refusal_of(scene_with(c.line, c.text)), c.message) << c.text;
}

const std::string length_forms = R"((a number, "a", "bh", "a+bh" or "a-bh", with h the spacing))";

TEST(SceneRefusals, TheSceneTheyStartFromIsGood) { EXPECT_EQ(refusal_of(scene_with(0, "")), "no refusal"); }

TEST(SceneRefusals, WrongTypes) {
  expect_refusals({
      {2, "title = 3", "t.toml:2:9: scene.title: found 3, expected a string"},
      {4, "spacing = \"8\"", "t.toml:4:11: particles.spacing: found \"8\", expected a number greater than 0"},
      {4, "  spacing =  true",
       "t.toml:4:14: particles.spacing: found true, expected a number greater than 0"},
      {4, "spacing = 2020-01-01",
       "t.toml:4:11: particles.spacing: found a date or time, expected a number greater than 0"},
      {4, "spacing = { h = 8 }",
       "t.toml:4:11: particles.spacing: found a table, expected a number greater than 0"},
      {10, "gravity = 9.81", "t.toml:10:11: fluid.gravity: found 9.81, expected an array of two numbers"},
      {10, "gravity = [0, 0, -9.81]",
       "t.toml:10:11: fluid.gravity: found an array of 3, expected an array of two numbers"},
      {10, "gravity = [0, \"1h\"]", "t.toml:10:15: fluid.gravity.1: found \"1h\", expected a number"},
      {10, "gravity = [0, 0]\nseed = 1.0",
       "t.toml:11:8: fluid.seed: found 1.0, expected an integer of at least 0"},
      {13, "count = [3, 4.0]",
       "t.toml:13:13: fluid.rect.0.count.1: found 4.0, expected an integer of at least 1"},
      {13, "max = [9, 9]\nvelocity_gradient = [0, 0]",
       "t.toml:14:22: fluid.rect.0.velocity_gradient.0: found 0, expected an array of two numbers"},
      {13, "max = [9, 9]\nvelocity_gradient = [[0, 0], [0, false]]",
       "t.toml:14:34: fluid.rect.0.velocity_gradient.1.1: found false, expected a number"},
      {15, "model = \"solid\"",
       "t.toml:15:9: boundary.model: found \"solid\", expected \"mirror\" or \"akinci\""},
      {18, "max = [400, 600]\nsides = \"left\"",
       "t.toml:19:9: boundary.container.0.sides: found \"left\", expected an array of one or more of "
       "\"left\", "
       "\"right\", \"bottom\" and \"top\", each at most once"},
      {18, "max = [400, 600]\nsides = []",
       "t.toml:19:9: boundary.container.0.sides: found an array of 0, expected an array of one or more of "
       "\"left\", \"right\", \"bottom\" and \"top\", each at most once"},
      {18, "max = [400, 600]\nsides = [\"left\", \"front\"]",
       "t.toml:19:18: boundary.container.0.sides.1: found \"front\", expected \"left\", \"right\", "
       "\"bottom\" or "
       "\"top\""},
      {18, "max = [400, 600]\nsides = [\"left\", \"left\"]",
       "t.toml:19:18: boundary.container.0.sides.1: found \"left\" a second time, expected each name at most "
       "once"},
  });
}

TEST(SceneRefusals, TablesOfTheWrongKind) {
  std::string rest = "[particles]\nspacing = 8\nrest_density = 1\n";
  EXPECT_EQ(refusal_of("scene = 3"), "t.toml:1:9: scene: found 3, expected a table [scene]");
  EXPECT_EQ(refusal_of("[[scene]]\ntitle = \"a\""),
            "t.toml:1:1: scene: found an array of 1, expected a table [scene]");
  expect_refusals({
      {11, "[fluid.rect]",
       "t.toml:11:1: fluid.rect: found a table, expected an array of tables, [[fluid.rect]]"},
      {10, "gravity = [0, 0]\nrect = { min = [0, 0], max = [8, 8] }",
       "t.toml:12:1: Error while parsing table header: cannot redefine existing table 'fluid.rect' as "
       "array-of-tables"},
      {10, "gravity = [0, 0]\ndisc = { centre = [0, 0], radius = 8 }",
       "t.toml:11:8: fluid.disc: found a table, expected an array of tables, [[fluid.disc]]"},
      {10, "gravity = [0, 0]\ndisc = [3]",
       "t.toml:11:9: fluid.disc.0: found 3, expected a table [[fluid.disc]]"},
  });
}

TEST(SceneRefusals, OutOfRange) {
  expect_refusals({
      {4, "spacing = -8", "t.toml:4:11: particles.spacing: found -8, expected a number greater than 0"},
      {4, "spacing = 0.0", "t.toml:4:11: particles.spacing: found 0.0, expected a number greater than 0"},
      {4, "spacing = inf",
       "t.toml:4:11: particles.spacing: found inf, expected a finite number greater than 0"},
      {5, "rest_density = nan",
       "t.toml:5:16: particles.rest_density: found nan, expected a finite number greater than 0"},
      {5, "rest_density = 1\nsmoothing = 1.6",
       "t.toml:6:13: particles.smoothing: found 1.6, expected a number from 1 to 1.5"},
      {8, "max = [-inf, 0]",
       "t.toml:8:8: domain.max.0: found -inf, expected a finite length " + length_forms},
      {10, "gravity = [0, inf]", "t.toml:10:15: fluid.gravity.1: found inf, expected a finite number"},
      {10, "gravity = [0, 0]\njitter = 0.51",
       "t.toml:11:10: fluid.jitter: found 0.51, expected a number from 0 to 0.5"},
      {10, "gravity = [0, 0]\nrelax = 1001",
       "t.toml:11:9: fluid.relax: found 1001, expected an integer from 0 to 1000"},
      {13, "count = [0, 4]",
       "t.toml:13:10: fluid.rect.0.count.0: found 0, expected an integer of at least 1"},
      {18, "max = [400, 600]\nlayers = 0",
       "t.toml:19:10: boundary.container.0.layers: found 0, expected an integer from 1 to 1000"},
      {21, "coefficient = -1",
       "t.toml:21:15: viscosity.coefficient: found -1, expected a number of at least 0"},
      {25, "tolerance = 0",
       "t.toml:25:13: pressure.iisph.tolerance: found 0, expected a number greater than 0"},
      {25, "omega = 2.0",
       "t.toml:25:9: pressure.iisph.omega: found 2.0, expected a number greater than 0 and less than 2"},
      {25, "warm_start = 1.1",
       "t.toml:25:14: pressure.iisph.warm_start: found 1.1, expected a number from 0 to 1"},
      {25, "source_weight = 0",
       "t.toml:25:17: pressure.iisph.source_weight: found 0, expected a number greater than 0 and at most 1"},
      {25, "min_iterations = 0",
       "t.toml:25:18: pressure.iisph.min_iterations: found 0, expected an integer from 1 to 1000000000"},
      {32, "dt = 0", "t.toml:32:6: time.dt: found 0, expected a number greater than 0"},
      {33, "duration = -50", "t.toml:33:12: time.duration: found -50, expected a number greater than 0"},
      {33, "duration = 1e300",
       "t.toml:33:12: time.duration: found 1e+300, which is 2.5e+301 steps of 0.04, expected at most "
       "9007199254740992 steps"},
      {33, "duration = 5\n[output]\nfps = 0",
       "t.toml:35:7: output.fps: found 0, expected a number greater than 0"},
      {33, "duration = 5\n[output]\nsize = [800, 15]",
       "t.toml:35:14: output.size.1: found 15, expected an integer from 16 to 16384"},
      {33, "duration = 5\n[output]\ncolour = \"mauve\"",
       "t.toml:35:10: output.colour: found \"mauve\", expected \"speed\", \"density\" or \"pressure\""},
  });
}

TEST(SceneRefusals, TablesThatAreNotUsedAreCheckedToo) {
  expect_refusals({
      {27, "stiffness = 0",
       "t.toml:27:13: pressure.ssph.stiffness: found 0, expected a number greater than 0"},
      {28, "dt = \"x\"", "t.toml:28:6: pressure.ssph.dt: found \"x\", expected a number greater than 0"},
      {30, "kappa = 1\ngamma = 0.5",
       "t.toml:31:9: pressure.wcsph.gamma: found 0.5, expected a number from 1 to 1000000"},
      {30, "gamma = 7", "t.toml:29:1: pressure.wcsph.kappa: found nothing, expected a number greater than 0"},
      {27, "", "t.toml:26:1: pressure.ssph.stiffness: found nothing, expected a number greater than 0"},
  });
}

TEST(SceneRefusals, MissingKeysAndTables) {
  EXPECT_EQ(refusal_of(""), "t.toml:1:1: scene: found nothing, expected a table [scene]");
  EXPECT_EQ(refusal_of("# only a comment\n"), "t.toml:1:1: scene: found nothing, expected a table [scene]");
  EXPECT_EQ(refusal_of("[scene]\ntitle = \"a\"\n"),
            "t.toml:1:1: particles: found nothing, expected a table [particles]");
  expect_refusals({
      {2, "", "t.toml:1:1: scene.title: found nothing, expected a string"},
      {4, "", "t.toml:3:1: particles.spacing: found nothing, expected a number greater than 0"},
      {5, "", "t.toml:3:1: particles.rest_density: found nothing, expected a number greater than 0"},
      {7, "", "t.toml:6:1: domain.min: found nothing, expected an array of two lengths"},
      {10, "", "t.toml:9:1: fluid.gravity: found nothing, expected an array of two numbers"},
      {12, "", "t.toml:11:1: fluid.rect.0.min: found nothing, expected an array of two lengths"},
      {13, "",
       "t.toml:11:1: fluid.rect.0.max: found nothing, expected an array of two lengths, or count in its "
       "place"},
      {15, "", "t.toml:14:1: boundary.model: found nothing, expected \"mirror\" or \"akinci\""},
      {20, "", "t.toml:19:1: viscosity.model: found nothing, expected \"laplacian\" or \"xsph\""},
      {21, "", "t.toml:19:1: viscosity.coefficient: found nothing, expected a number of at least 0"},
      {23, "", "t.toml:22:1: pressure.method: found nothing, expected \"iisph\", \"ssph\" or \"wcsph\""},
      {32, "",
       "t.toml:31:1: time.dt: found nothing, expected a number greater than 0, here or as pressure.iisph.dt"},
      {33, "", "t.toml:31:1: time.duration: found nothing, expected a number greater than 0"},
  });
  std::string no_ssph =
      "\n[scene]\ntitle = \"a\"\n[particles]\nspacing = 1\nrest_density = 1\n[domain]\n"
      "min = [0, 0]\nmax = [9, 9]\n[fluid]\ngravity = [0, 0]\n[[fluid.rect]]\nmin = [0, 0]\n"
      "count = [2, 2]\n[pressure]\nmethod = \"ssph\"\n[time]\ndt = 1\nduration = 1\n";
  EXPECT_EQ(
      refusal_of(no_ssph),
      "t.toml:15:1: pressure.ssph: found nothing, expected a table [pressure.ssph], as pressure.method is "
      "\"ssph\"");
}

TEST(SceneRefusals, UnknownKeysNameTheNearestKnownOne) {
  auto unknown = [](const std::string& place, const std::string& nearest) {
    return place + ": found an unknown key, expected one of the known keys; did you mean \"" + nearest +
           "\"?";
  };
  expect_refusals({
      {4, "spacing = 8\nrest_densty = 1", unknown("t.toml:5:1: particles.rest_densty", "rest_density")},
      {4, " spaceing = 8", unknown("t.toml:4:2: particles.spaceing", "spacing")},
      {1, "[scenes]", unknown("t.toml:1:2: scenes", "scene")},
      {33, "duration = 5\n[outpt]\nfps = 25", unknown("t.toml:34:2: outpt", "output")},
      {11, "[[fluid.rectangle]]", unknown("t.toml:11:9: fluid.rectangle", "rect")},
      {24, "[pressure.isph]", unknown("t.toml:24:11: pressure.isph", "iisph")},
      {23, "method = \"iisph\"\nstiffness = 3",
       unknown("t.toml:24:1: pressure.stiffness", "pressure.ssph.stiffness")},
      {13, "max = [9, 9]\nlayers = 3", unknown("t.toml:14:1: fluid.rect.0.layers", "boundary.rect[].layers")},
      {10, "gravity = [0, 0]\ncenter = [0, 0]", unknown("t.toml:11:1: fluid.center", "centre")},
      {4, "spacing.x = 8", "t.toml:4:1: particles.spacing: found a table, expected a number greater than 0"},
      {4, "\"a\\nb\" = 8", unknown("t.toml:4:1: particles.a b", "spacing")},
  });
}

TEST(SceneRefusals, MalformedLengths) {
  for (const char* bad :
       {"h",   "",    "3hh",  "3 h",  "240 + 3h", "240+h",  "240+-3h", "+3h",  "3h+240", "240+3", "240-3",
        "inf", "nan", "infh", "0x10", "1e999",    "1e999h", "3H",      "--3h", "-",      "1,5",   "3h "})
    EXPECT_EQ(refusal_of(scene_with(13, "max = [\"" + std::string(bad) + "\", 264]")),
              "t.toml:13:8: fluid.rect.0.max.0: found \"" + std::string(bad) + "\", expected a length " +
                  length_forms);
  expect_refusals({
      {13, "max = [\"1e308+1e308h\", 264]",
       "t.toml:13:8: fluid.rect.0.max.0: found \"1e308+1e308h\", which is inf with h = 8, expected a finite "
       "length"},
      {13, "max = [1e999, 264]",
       "t.toml:13:13: Error while parsing floating-point: '1e999' could not be interpreted as a value"},
      {13, "count = [2, 2]\n[[fluid.disc]]\ncentre = [0, 0]\nradius = \"16-2h\"",
       "t.toml:16:10: fluid.disc.0.radius: found \"16-2h\", which is 0, expected a length greater than 0"},
      {13, "count = [2, 2]\n[[fluid.disc]]\ncentre = [0, 0]\nradius = \"r\"",
       "t.toml:16:10: fluid.disc.0.radius: found \"r\", expected a length greater than 0 " + length_forms},
  });
}

TEST(SceneRefusals, Contradictions) {
  expect_refusals({
      {13, "max = [200, 264]\ncount = [2, 2]",
       "t.toml:14:9: fluid.rect.0.count: found an array of 2 together with max, expected one of the two"},
      {13, "max = [24, 264]",
       "t.toml:13:7: fluid.rect.0.max: found (24, 264), expected more than min (24, 24) both ways"},
      {13, "max = [200, 24.000001]",
       "t.toml:13:7: fluid.rect.0.max: found (200, 24.000001), expected more than min (24, 24) both ways"},
      {8, "max = [400, 0]",
       "t.toml:8:7: domain.max: found (400, 0), expected more than min (0, 0) both ways, by a finite length"},
      {18, "max = [400, -600]",
       "t.toml:18:7: boundary.container.0.max: found (400, -600), expected more than min (0, 0) both ways"},
      {18, "max = [400, 600]\n[[boundary.segment]]\nfrom = [24, 3]\nto = [\"3h\", 3]",
       "t.toml:21:6: boundary.segment.0.to: found (24, 3), expected another point than from"},
      {18, "max = [400, 600]\n[[boundary.polygon]]\npoints = [[0, 0], [9, 9]]",
       "t.toml:20:10: boundary.polygon.0.points: found an array of 2, expected an array of three or more "
       "points "
       "[x, y]"},
      {18, "max = [400, 600]\n[[boundary.polygon]]\npoints = [[0, 0], [9, 9], [3]]",
       "t.toml:20:27: boundary.polygon.0.points.2: found an array of 1, expected an array of two lengths"},
      {18, "max = [400, 600]\n[[boundary.polygon]]\npoints = [[0, 0], [1, 1], [9, 9], [3, 3]]",
       "t.toml:20:10: boundary.polygon.0.points: found points on one line, expected corners that enclose an "
       "area"},
      {13, "max = [40, 40]\n[[fluid.polygon]]\npoints = [[64, 24], [99, 99], [99, 24], [64, 99]]",
       "t.toml:15:10: fluid.polygon.0.points: found corners with edges that cross, around nothing on "
       "balance, "
       "expected corners in order around an area"},
      {25, "min_iterations = 5\nmax_iterations = 4",
       "t.toml:25:18: pressure.iisph.min_iterations: found 5, expected at most max_iterations, which is 4"},
      {25, "max_iterations = 1",
       "t.toml:25:18: pressure.iisph.max_iterations: found 1, expected at least min_iterations, which is 2"},
      {32, "dt = 0.1\ncfl = 0.4",
       "t.toml:33:7: time.cfl: found 0.4 together with time.dt, expected one of the two"},
      {32, "dt = 0.1\ndt_max = 0.4",
       "t.toml:33:10: time.dt_max: found 0.4 without time.cfl, expected the two together"},
      {32, "cfl = 0.4\ndt_min = 0.2\ndt_max = 0.1",
       "t.toml:33:10: time.dt_min: found 0.2, expected at most time.dt_max, which is 0.1"},
      {11, "[[boundary.rect]]",
       "t.toml:9:1: fluid: found no fluid, expected at least one shape, such as [[fluid.rect]]"},
  });
  EXPECT_EQ(refusal_of(scene_with(32, "cfl = 0.4"), {"pressure.method=ssph"}),
            "t.toml:32:7: time.cfl: found 0.4 together with pressure.ssph.dt, expected one of the two");
}

TEST(SceneRefusals, TooManyToNumber) {
  const auto message = [](const std::string& number, const std::string& place) {
    return "t.toml:4:11: particles.spacing: found 8, which makes " + number + " samples up to " + place +
           ", expected at most 4294967295 in all shapes together; use a larger spacing or smaller shapes";
  };
  expect_refusals({
      {13, "count = [4294967295, 2]", message("8.59e+09", "fluid.rect.0")},
      {13, "max = [1e300, 1e300]", message("inf", "fluid.rect.0")},
      {13, "count = [65536, 65535]\n[[fluid.disc]]\ncentre = [0, 0]\nradius = \"200h\"",
       message("4.295e+09", "fluid.disc.0")},
      {18, "max = [1e300, 600]", message("3.75e+299", "boundary.container.0")},
      {18, "max = [400, 600]\n[[boundary.segment]]\nfrom = [0, 0]\nto = [1e200, 1e200]",
       message("inf", "boundary.segment.0")},
      {4, "spacing = 1e-200",
       "t.toml:4:11: particles.spacing: found 1e-200, which makes the mass of a particle 0, expected a mass "
       "rest_density h² within the range of numbers"},
  });
}

TEST(SceneRefusals, AdaptiveStepsNeedTheirBounds) {
  expect_refusals({
      {32, "cfl = 0.4\ndt_min = 1e-40\ndt_max = 0.1",
       "t.toml:35:12: time.duration: found 50, which is 5e+41 steps of 1e-40, expected at most "
       "9007199254740992 "
       "steps"},
      {32, "cfl = 0.4",
       "t.toml:31:1: time.dt_min: found nothing, expected a number greater than 0, as time.cfl is set"},
      {32, "cfl = 0.4\ndt_min = 0.1",
       "t.toml:31:1: time.dt_max: found nothing, expected a number greater than 0, as time.cfl is set"},
      {32, "cfl = 0\ndt_min = 0.1\ndt_max = 1",
       "t.toml:32:7: time.cfl: found 0, expected a number greater than 0"},
  });
}

TEST(SceneRefusals, TextThatIsNotToml) {
  EXPECT_EQ(refusal_of("[scene"), "t.toml:1:7: Error while parsing table header: encountered end-of-file");
  EXPECT_EQ(refusal_of("a = 99999999999999999999"),
            "t.toml:1:25: Error while parsing decimal integer: '99999999999999999999' is not representable "
            "in 64 bits");
  EXPECT_EQ(refusal_of("a = 1\na = 2"),
            "t.toml:2:5: Error while parsing key-value pair: cannot redefine existing integer 'a'");
}

// Each of these fails an assertion of the parser, which must not end the program.
TEST(SceneRefusals, TextThatTheParserAssertsNotToMeet) {
  EXPECT_EQ(refusal_of("[+"),
            "t.toml:1:2: Error while parsing key: expected bare key starting character or string delimiter, "
            "saw '+'");
  EXPECT_EQ(refusal_of("0x=[}]]+"), "t.toml:1:5: Error while parsing value: could not determine value type");
  EXPECT_EQ(refusal_of("a=1979-05-27true{+T07:32:00"),
            "t.toml:1:14: Error while parsing time: expected 2-digit hour, saw 'r'");
}

TEST(SceneRefusals, DeepNestingIsRefusedWithoutRecursingIntoIt) {
  constexpr size_t deep = 200'000;
  std::string dotted = "a", brackets, quoted = "\"a\"";
  for (size_t i = 0; i < deep; ++i) dotted += ".a", brackets += "[", quoted += " . 'a'";
  std::string expected = ": found a key of more than 16 parts, expected at most 16";
  EXPECT_EQ(refusal_of(dotted + " = 1"), "t.toml:1:32" + expected);
  EXPECT_EQ(refusal_of("x = 1.5\n[" + dotted + "]"), "t.toml:2:33" + expected);
  EXPECT_EQ(refusal_of("x = { " + dotted + " = 1 }"), "t.toml:1:38" + expected);
  EXPECT_EQ(refusal_of(quoted + " = 1"), "t.toml:1:95" + expected);
  EXPECT_EQ(refusal_of("x = [\"\"\"a\"\"\"\", { " + dotted + " = 1 }]"), "t.toml:1:49" + expected);
  EXPECT_NE(refusal_of("x = " + brackets).find("exceeded maximum nested value depth"), std::string::npos);
  std::string inline_tables;
  for (size_t i = 0; i < deep; ++i) inline_tables += "{a=";
  EXPECT_NE(refusal_of("x = " + inline_tables).find("exceeded maximum nested value depth"),
            std::string::npos);
}

// The parser has undefined behaviour for some of these, found with the undefined behaviour sanitizer.
TEST(SceneRefusals, CharactersBeyondAscii) {
  const std::string not_utf8 = "found bytes that are not UTF-8, expected TOML text";
  expect_refusals({
      {4, "spacing = 8 é",
       "t.toml:4:13: Error while parsing key-value pair: expected a comment or whitespace, saw 'é'"},
      {4, "größe = 8", "t.toml:4:3: Error while parsing key-value pair: expected '=', saw 'ö'"},
      {4, "spacing = 8²", "t.toml:4:12: Error while parsing decimal integer: expected digit, saw '²'"},
      {4, "spacing = -'²", "t.toml:4:11: Error while parsing value: could not determine value type"},
      {4, "spacing = 99[[\"\u2029\u00e9\n}[",
       "t.toml:4:13: Error while parsing decimal integer: expected digit, saw '['"},
      {4, "\"größe\" = 8",
       "t.toml:4:1: particles.größe: found an unknown key, expected one of the known keys; did "
       "you mean \"spacing\"?"},
      {15, "model = \"größe\u2028\"",
       "t.toml:15:9: boundary.model: found \"größe\u2028\", expected \"mirror\" or \"akinci\""},
      {2, "title = \"\xff\"", "t.toml:2:10: " + not_utf8},
      {2, "title = \"\xc3\"", "t.toml:2:10: " + not_utf8},
      {2, "title = \"\xed\xa0\x80\"", "t.toml:2:10: " + not_utf8},
      {2, "# ä \xe0\x80\x80", "t.toml:2:5: " + not_utf8},
      {4, "\xf4\x80\x80\x80 = 8", "t.toml:4:1: " + not_utf8},
  });
  EXPECT_EQ(refusal_of("\xEF\xBB\xBF[scene]\ntitle = 3"),
            "t.toml:2:9: scene.title: found 3, expected a string");
  auto title = [](const std::string& text) {
    return parse_scene(scene_with(2, "title = " + text), "t.toml").title;
  };
  EXPECT_EQ(title("'Dammbruch, größer: h² \u00a0\u3000\U0001F30A' # ö"),
            "Dammbruch, größer: h² \u00a0\u3000\U0001F30A");
  EXPECT_EQ(title("\"\"\"é \\n \\u00e9 \\\n  é\"\"\""), "é \n é é");
  EXPECT_EQ(title("\"\\U0010D800\\U00100041\\uFFFF\""), "\U0010D800\U00100041\uFFFF");
}

TEST(SceneRefusals, DotsInStringsAndCommentsAreNoDeepKeys) {
  std::string dots(40, '.');
  for (const std::string& title :
       {"\"" + dots + "\"", "'" + dots + "'", "\"\"\"" + dots + "\n\"" + dots + "\"\"\"",
        "'''" + dots + "\n'" + dots + "'''", "\"a\\\"" + dots + "\" # " + dots, "\"a\\\\\" # \"" + dots})
    EXPECT_EQ(refusal_of(scene_with(2, "title = " + title)), "no refusal") << title;
}

TEST(SceneRefusals, EveryMessageIsOneLine) {
  std::string message = refusal_of(scene_with(15, "model = \"a\\nb\\tc" + std::string(100, 'x') + "\""));
  EXPECT_EQ(message, "t.toml:15:9: boundary.model: found \"a b c" + std::string(55, 'x') +
                         "...\", expected \"mirror\" or \"akinci\"");
  const auto message_in = [](const std::string& text) {
    return test::message_of<InputError>([&] { parse_scene(text, "a\nb.toml"); });
  };
  EXPECT_EQ(message_in("x = \xff"), "a b.toml:1:5: found bytes that are not UTF-8, expected TOML text");
  EXPECT_TRUE(message_in("x = [").starts_with("a b.toml:1:6: ")) << message_in("x = [");
}

}  // namespace
}  // namespace sluice

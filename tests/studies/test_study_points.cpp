// Points of studies as command lines, what is read of them, and that every study's points are sound.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "sluice/error.hpp"
#include "sluice/load.hpp"
#include "studies/density.hpp"
#include "studies/study.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {

using namespace study;
namespace {

TEST(Points, AreWordsOfARun) {
  Point point{.name = "a_1", .scene = "breaking_dam", .overrides = {"fluid.rect.0.max=[200,\"300+3h\"]"}};
  point.words = {"--time", "2"};
  point.series = true;
  EXPECT_EQ(line_of(point, "my out"),
            "sluice run breaking_dam --backend cpu --precision double --threads 1 --quiet --set "
            "'fluid.rect.0.max=[200,\"300+3h\"]' --time 2 --summary 'my out/runs/a_1.json' --series "
            "'my out/runs/a_1.csv'");
  point.overrides = {"scene.title=it's"};
  EXPECT_NE(line_of(point, "o").find("--set 'scene.title=it'\\''s'"), std::string::npos);
}

class EveryStudy : public testing::TestWithParam<size_t> {
 protected:
  const Study& study() const { return studies()[GetParam()]; }
};

TEST_P(EveryStudy, HasPointsOfDifferentNamesAndTheSameColumns) {
  const std::vector<Point> points = study().points();
  std::set<std::string> names;
  size_t quick = 0;
  for (const Point& point : points) {
    EXPECT_TRUE(names.insert(point.name).second) << point.name;
    EXPECT_EQ(point.name.find_first_of(" /'\""), std::string::npos) << point.name;
    ASSERT_EQ(point.facts.size(), points.front().facts.size()) << point.name;
    for (size_t i = 0; i < point.facts.size(); ++i)
      EXPECT_EQ(point.facts[i].first, points.front().facts[i].first) << point.name;
    if (point.quick) ++quick;
  }
  EXPECT_GT(quick, 0u);
}

// A thousand points of a grid differ in numbers only: some of them stand for all.
TEST_P(EveryStudy, HasScenesThatLoad) {
  const std::vector<Point> points = study().points();
  const size_t stride = points.size() / 100 + 1;
  for (size_t i = 0; i < points.size(); i += stride)
    EXPECT_NO_THROW(load_scene(points[i].scene, points[i].overrides)) << points[i].name;
}

INSTANTIATE_TEST_SUITE_P(All, EveryStudy, testing::Range(size_t{0}, studies().size()),
                         [](const auto& place) { return std::string(studies()[place.param].name); });

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

/// A summary of a run to time 2 of 2.
nlohmann::json summary() {
  return {{"format", 1},
          {"valid", true},
          {"lost", 3},
          {"cfl_max", nullptr},
          {"time", 2.0},
          {"seconds", {{"total", 2.5}}},
          {"settings", {{"time", {{"duration", 2.0}, {"dt", 0.1}}}}}};
}

TEST(Results, AreThoseThatAreThere) {
  const TemporaryFolder folder;
  const std::vector<Point> points{{.name = "a", .scene = "s"}, {.name = "b", .scene = "s"}};
  EXPECT_TRUE(results_in(folder.path, points).whole.empty());
  write(folder.path / "runs" / "b.json", summary().dump());
  const auto [results, unusable] = results_in(folder.path, points);
  EXPECT_TRUE(unusable.empty());
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].point.name, "b");
  EXPECT_TRUE(results[0].valid());
  EXPECT_EQ(results[0].number("seconds/total"), 2.5);
  EXPECT_TRUE(std::isnan(results[0].number("cfl_max")));
  EXPECT_NE(message_of<InputError>([&] { results[0].number("seconds/none"); }).find("b.json"),
            std::string::npos);
}

/// Why the only result, of a point with a series, is no good; nothing if it is.
std::string reason(const nlohmann::json& json, const std::string& series = "step,time\n1,0.1\n") {
  const TemporaryFolder folder;
  Point point{.name = "a", .scene = "s", .overrides = {"time.dt=0.3", "time.dt=0.1", "scene.title=1 x"}};
  point.series = true;
  write(folder.path / "runs" / "a.json", json.is_string() ? json.get<std::string>() : json.dump());
  if (!series.empty()) write(folder.path / "runs" / "a.csv", series);
  const auto [results, unusable] = results_in(folder.path, {point});
  EXPECT_EQ(results.size() + unusable.size(), 1u);
  return unusable.empty() ? "" : unusable[0];
}

TEST(Results, ThatAreNoGoodAreNamed) {
  const auto named = [](const std::string& text, const std::string& part) {
    return text.find("runs/a.") != std::string::npos && text.find(part) != std::string::npos;
  };
  EXPECT_EQ(reason(summary()), "");
  EXPECT_TRUE(named(reason("{"), "no summary"));
  EXPECT_TRUE(named(reason({{"format", "1"}}), "no summary"));
  EXPECT_TRUE(named(reason({{"format", 2}}), "no summary"));
  EXPECT_TRUE(named(reason({{"format", 1}}), "valid"));
  auto other = summary();
  other["time"] = 1.5;
  EXPECT_TRUE(named(reason(other), "interrupted at time 1.5"));
  other["valid"] = false;
  EXPECT_EQ(reason(other), "") << "ended early, and says so";
  other = summary();
  other["settings"]["time"]["dt"] = 0.2;
  EXPECT_TRUE(named(reason(other), "without time.dt=0.1"));
  EXPECT_TRUE(named(reason(summary(), "step,time\n"), "no step"));
  EXPECT_TRUE(named(reason(summary(), ""), "a.csv"));
}

TEST(Csv, TablesThatAreNotWholeAreNamed) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text) {
    write(folder.path / "t.csv", text);
    return message_of<InputError>([&] { read_csv(folder.path / "t.csv").column("b"); });
  };
  EXPECT_NE(refusal("a,b\n1,2").find("within a line"), std::string::npos);
  EXPECT_NE(refusal("a,b\n1\n").find("2 cells"), std::string::npos);
  EXPECT_NE(refusal("a,c\n1,2\n").find("no column b"), std::string::npos);
  EXPECT_NE(refusal("a,b\n1,x\n").find("\"x\""), std::string::npos);
  write(folder.path / "t.csv", "# source\na,b\n1,2\n# more\n3,4\n");
  EXPECT_EQ(read_csv(folder.path / "t.csv").column("b"), (std::vector<double>{2, 4}));
  EXPECT_NE(message_of<InputError>([&] { read_csv(folder.path / "none.csv"); }).find("none.csv"),
            std::string::npos);
}

TEST(Csv, CellsThatWereQuotedReadAsTheyWere) {
  const TemporaryFolder folder;
  const TextTable table{{"a", "b"}, {{"x, \"y\"", "1"}, {"", "\"q\""}, {"plain", "2"}}};
  write(folder.path / "t.csv", table.csv());
  EXPECT_EQ(read_csv(folder.path / "t.csv").rows, table.rows);
}

std::string density_summary() {
  nlohmann::json json = summary();
  json["time"] = json["settings"]["time"]["duration"] = 40.0;
  json["settings"]["time"]["dt"] = 0.01;
  return json.dump();
}

// A sine about 1.01 has its amplitude in every window, whatever the phase.
TEST(DensityStudy, FindsTheAmplitudeOfEachWindow) {
  const TemporaryFolder folder;
  const Point point = density_points().front();
  write(folder.path / "runs" / (point.name + ".json"), density_summary());
  std::string series = "step,time,mean_density\n";
  for (int step = 1; step <= 4000; ++step) {
    const double time = 0.01 * step, amplitude = time > 20 ? 0.002 : 0.005;
    series += fmt::format("{},{},{:.12g}\n", step, time, 1.01 + amplitude * std::sin(2 * M_PI * time));
  }
  write(folder.path / "runs" / (point.name + ".csv"), series);
  const Report report = density_report(results_in(folder.path, {point}).whole);
  const TextTable windows = report.tables[1].second.only({"from", "to", "mean", "amplitude", "largest"});
  ASSERT_EQ(windows.rows.size(), 2u);
  const double wanted[2] = {0.005, 0.002};
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(windows.rows[i][0], i == 0 ? "0" : "20");
    EXPECT_NEAR(std::stod(windows.rows[i][2]), 1.01, 1e-6);
    EXPECT_NEAR(std::stod(windows.rows[i][3]), wanted[i], 1e-3 * wanted[i]);
    EXPECT_NEAR(std::stod(windows.rows[i][4]), wanted[i], 2e-3 * wanted[i]);
  }
}

}  // namespace
}  // namespace sluice::test

// `sluice agree`: its table, its JSON, its exit codes, and that a shader which is a little wrong is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>

#include "core/model/plan.hpp"
#include "gpu/context.hpp"
#include "sluice/load.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Words keys_of(const nlohmann::ordered_json& object) {
  Words keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

/// A folder with one shader of ours in which `from` is replaced by `to`.
void write_changed_shader(const TemporaryFolder& folder, const std::string& name, const std::string& from,
                          const std::string& to) {
  std::string text = read_file(std::filesystem::path(SLUICE_SOURCE_DIR) / "shaders" / name);
  const size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  std::ofstream(folder / name) << text;
}

TEST(CliAgree, WritesATableAndTheSameAsJson) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"agree", "breaking_dam", "--steps", "12", "--summary", "agree.json"}, folder.path);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(has(result.out, "they agree")) << result.out;
  const nlohmann::ordered_json json = read_json(folder / "agree.json");
  EXPECT_EQ(keys_of(json),
            (Words{"format", "scene", "device", "steps", "stages", "run", "gpu_with_itself", "pass"}));
  EXPECT_EQ(json["format"], 1);
  EXPECT_EQ(json["scene"], "breaking_dam");
  EXPECT_EQ(json["steps"], 12);
  EXPECT_EQ(json["pass"], true);
  for (const char* run : {"run", "gpu_with_itself"}) {
    EXPECT_EQ(keys_of(json[run]),
              (Words{"equal", "first_difference_step", "max_dx_over_h", "iterations_equal"}));
  }
  EXPECT_EQ(json["gpu_with_itself"]["equal"], true) << "on any device";
  EXPECT_TRUE(has(result.out, "the GPU's run with itself, stage by stage: equal to the last bit"))
      << result.out;
  std::set<std::string> planned;
  for (const Stage stage : make_plan(model_of(load_scene("breaking_dam"))).stages())
    planned.insert(std::string(info(stage).name));
  EXPECT_EQ(json["stages"].size(), planned.size());
  for (const auto& row : json["stages"]) {
    EXPECT_EQ(keys_of(row), (Words{"name", "max_abs", "max_ulp", "equal_share", "tolerance", "pass"}));
    EXPECT_TRUE(planned.contains(row["name"])) << row;
    EXPECT_TRUE(has(result.out, row["name"].get<std::string>() + " ")) << result.out;
    EXPECT_EQ(row["pass"], true) << row;
  }
  const gpu::Context context;
  EXPECT_EQ(json["device"], context.renderer());
  if (!context.software()) return;
  EXPECT_EQ(json["run"]["equal"], true);
  EXPECT_TRUE(json["run"]["first_difference_step"].is_null());
  EXPECT_TRUE(has(result.out, "run of 12 steps: equal to the last bit")) << result.out;
}

TEST(CliAgree, TakesTwoHundredStepsByDefault) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program({"agree", "breaking_dam", "--set", "pressure.method=ssph", "--summary", "a.json"},
                        folder.path)
                .code,
            0);
  EXPECT_EQ(read_json(folder / "a.json")["steps"], 200);
}

TEST(CliAgree, FindsAShaderThatIsALittleWrong) {
  const TemporaryFolder folder, shaders;
  write_changed_shader(shaders, "density.comp", "sum = params.m * sum", "sum = 1.001 * params.m * sum");
  const ProgramResult result = run_program(
      {"agree", "breaking_dam", "--steps", "5", "--shader-dir", shaders.path.string(), "--summary", "a.json"},
      folder.path);
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_TRUE(has(result.out, "THEY DISAGREE")) << result.out;
  EXPECT_TRUE(has(result.out, "rho[0]: ")) << "the first difference with both values\n" << result.out;
  const nlohmann::ordered_json json = read_json(folder / "a.json");
  EXPECT_EQ(json["pass"], false);
  EXPECT_EQ(json["run"]["equal"], false);
  EXPECT_EQ(json["run"]["first_difference_step"], 1);
  EXPECT_GT(json["run"]["max_dx_over_h"], 0);
  for (const auto& row : json["stages"]) {
    // The others get the CPU's density, so only the wrong stage fails.
    EXPECT_EQ(row["pass"], row["name"] != "density") << row;
    if (row["name"] == "density") {
      EXPECT_GT(row["max_ulp"], 1000) << row;
      EXPECT_LT(row["equal_share"], 0.96) << row;  // the kernel gradients are right
    }
  }
}

TEST(CliAgree, SplitTellsWhichSideOfAStageIsWrong) {
  const TemporaryFolder shaders;
  write_changed_shader(shaders, "density.comp", "sum = params.m * sum", "sum = 1.001 * params.m * sum");
  const auto run_differs = [&](const std::string& split) {
    const ProgramResult result = run_program(
        {"agree", "breaking_dam", "--steps", "5", "--shader-dir", shaders.path.string(), "--split", split});
    EXPECT_EQ(result.code, 1);  // the stage itself is wrong either way
    return !has(result.out, "run of 5 steps: equal to the last bit");
  };
  if (!gpu::Context().software()) GTEST_SKIP() << "runs are equal on llvmpipe only";
  EXPECT_TRUE(run_differs("neighbours")) << "density still runs on the GPU";
  EXPECT_FALSE(run_differs("density")) << "density runs on the CPU";
}

TEST(CliAgree, SaysThatARunBecameInvalid) {
  const ProgramResult result =
      run_program({"agree", "breaking_dam", "--set", "time.dt=0.5", "--steps", "50"});
  EXPECT_TRUE(has(result.out, "steps, 50 were asked for")) << result.out;
  EXPECT_TRUE(has(result.out, "the CPU's became invalid in step")) << result.out;
  EXPECT_TRUE(has(result.out, "the GPU's became invalid in step")) << result.out;
  const TemporaryFolder shaders;
  write_changed_shader(shaders, "density.comp", "rho[i] = sum", "rho[i] = sum / (sum - sum)");
  const ProgramResult alone =
      run_program({"agree", "breaking_dam", "--steps", "5", "--shader-dir", shaders.path.string()});
  EXPECT_EQ(alone.code, 1);
  EXPECT_FALSE(has(alone.out, "the CPU's became invalid")) << alone.out;
  EXPECT_TRUE(has(alone.out, "the GPU's became invalid in step 1")) << alone.out;
  EXPECT_TRUE(has(alone.out, "THEY DISAGREE: density and the run")) << alone.out;
}

TEST(CliAgree, OneStageAloneIsComparedAndDumped) {
  const TemporaryFolder shaders;
  write_changed_shader(shaders, "density.comp", "sum = params.m * sum", "sum = 1.001 * params.m * sum");
  const Words words{"agree", "breaking_dam", "--steps", "2", "--stage"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), words.begin(), words.end());
    return run_program(more);
  };
  const ProgramResult right = with({"density"});
  EXPECT_EQ(right.code, 0) << right.err;
  EXPECT_TRUE(has(right.out, "density ") && has(right.out, "they agree")) << right.out;
  EXPECT_FALSE(has(right.out, "integrate")) << "no other stage\n" << right.out;
  const ProgramResult wrong = with({"density", "--shader-dir", shaders.path.string(), "--dump", "rho,list"});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_TRUE(has(wrong.err, "THEY DISAGREE")) << wrong.err;
  EXPECT_TRUE(wrong.out.starts_with("field,place,cpu,gpu\nrho,0,1.0")) << wrong.out.substr(0, 80);
  EXPECT_EQ(std::ranges::count(wrong.out, '\n'), 1 + 2 * 660) << "a row per particle and field";
  double cpu = 0, gpu = 0;
  ASSERT_EQ(std::sscanf(wrong.out.c_str(), "field,place,cpu,gpu\nrho,0,%lf,%lf", &cpu, &gpu), 2);
  EXPECT_GT(gpu / cpu, 1.0001) << "the fluid's part of the density is larger";
  EXPECT_LT(gpu / cpu, 1.001) << "the wall's is not";
  EXPECT_EQ(with({"densty"}).code, 2);
  EXPECT_TRUE(has(with({"density", "--dump", "A_ii"}).err, "expected fields that density reads or writes"));
  EXPECT_EQ(run_program({"agree", "breaking_dam", "--dump", "rho"}).code, 2) << "of which stage?";
}

TEST(CliInfo, ShowsAShaderAsItIsCompiled) {
  const ProgramResult result = run_program({"info", "breaking_dam", "--shader", "diagonal"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(has(result.out, "const bool needs_thesis_wall = true;")) << result.out;
  EXPECT_TRUE(has(result.out, "diagonal.comp:")) << result.out;
  EXPECT_FALSE(has(result.out, "#include")) << result.out;
  EXPECT_TRUE(
      has(run_program({"info", "breaking_dam", "--shader", "stop_test"}).out, "// ---- stop_test, pass 1"));
  EXPECT_EQ(run_program({"info", "breaking_dam", "--shader", "tait"}).code, 2) << "not of this scene's plan";
}

TEST(CliAgree, RefusesWhatItCannotDo) {
  const auto refusal = [](const Words& words) {
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.code, 2) << result.out << result.err;
    return result.err;
  };
  EXPECT_TRUE(has(refusal({"agree", "breaking_dam", "--split", "densty"}), "--split: found \"densty\""));
  EXPECT_TRUE(has(
      refusal({"agree", "breaking_dam", "--split", "state_equation"}),
      "--split: found \"state_equation\", which is for: pressure from the state equation of SSPH, expected a "
      "stage of this scene's plan"));
  EXPECT_TRUE(has(refusal({"agree", "breaking_dam", "--steps", "0"}), "--steps: found \"0\""));
  EXPECT_TRUE(has(refusal({"agree", "no_such_scene"}), "no_such_scene"));
  EXPECT_TRUE(has(refusal({"agree", "breaking_dam", "--gl-device", "99"}), "no OpenGL device 99"));
  const TemporaryFolder empty;
  EXPECT_TRUE(has(refusal({"agree", "breaking_dam", "--shader-dir", empty.path.string()}), "--shader-dir"));
}

}  // namespace
}  // namespace sluice::test

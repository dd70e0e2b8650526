// The stage table, the files and the model agree; a plan has what a scene needs and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/model/plan.hpp"
#include "tests/support/needs.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

const std::filesystem::path source(SLUICE_SOURCE_DIR);

std::set<std::string> stage_names() {
  std::set<std::string> names;
  for (const StageInfo& stage : stage_table()) names.insert(std::string(stage.name));
  return names;
}

TEST(StageTable, RowsStandInTheOrderOfTheirNames) {
#define STAGE(row) EXPECT_EQ(info(Stage::row).name, #row);
  SLUICE_STAGES(STAGE)
#undef STAGE
  EXPECT_EQ(stage_names().size(), stage_count);
}

TEST(StageTable, EveryStageHasItsFileAndItsEquation) {
  const std::string model = read_file(source / "docs" / "model.md");
  for (const std::string& name : stage_names()) {
    EXPECT_TRUE(std::filesystem::exists(source / "cpu" / (name + ".cpp"))) << name;
    EXPECT_NE(model.find("`" + name + "`"), std::string::npos) << name << " has no entry in docs/model.md";
  }
}

TEST(StageTable, EveryFileInCpuIsAStageOrTheBackend) {
  std::set<std::string> known = stage_names();
  known.insert("backend");
  for (const auto& entry : std::filesystem::directory_iterator(source / "cpu")) {
    if (entry.path().extension() != ".cpp") continue;
    EXPECT_TRUE(known.contains(entry.path().stem().string())) << entry.path();
  }
}

/// What is there before the first stage of a step.
bool carried(Field field) {
  return std::set{Field::id_in, Field::x_in, Field::v_in, Field::p_in, Field::C_boundary, Field::x_boundary,
                  Field::sweeps,
                  // Of a solve: what its first sweep finds there does not count.
                  Field::solve, Field::q_best, Field::q_before, Field::Ap_before}
      .contains(field);
}

void expect_written_before_read(const Plan& plan) {
  FieldSet written;
  for (const Stage stage : plan.stages()) {
    for (uint32_t f = 0; f < field_count; ++f) {
      const Field field = static_cast<Field>(f);
      if (!reads_of(stage, plan.needs).has(field)) continue;
      EXPECT_TRUE(written.has(field) || carried(field)) << info(stage).name << " reads " << info(field).name;
    }
    written = written | writes_of(stage, plan.needs);
  }
}

TEST(StageTable, EveryStageHasItsShaderAndEveryComputeShaderIsKnown) {
  std::set<std::string> shaders;
  for (const auto& entry : std::filesystem::directory_iterator(source / "shaders")) {
    if (entry.path().extension() == ".comp") shaders.insert(entry.path().stem().string());
  }
  std::set<std::string> known = stage_names();
  for (const std::string& name : known) EXPECT_TRUE(shaders.contains(name)) << name;

  for (const std::string& name : shaders) EXPECT_TRUE(known.contains(name)) << name;
}

TEST(Plan, NothingIsReadBeforeItIsWritten) {
  for (const Needs& needs : all_needs()) {
    expect_written_before_read(make_plan(needs));
    expect_written_before_read(make_relax_plan(needs));
  }
}

TEST(Plan, HasEachModelExactlyWhenItIsNeeded) {
  const auto has = [](const Plan& plan, Stage stage) {
    const auto stages = plan.stages();
    return std::find(stages.begin(), stages.end(), stage) != stages.end();
  };
  for (const Needs& needs : all_needs()) {
    const Plan plan = make_plan(needs);
    EXPECT_EQ(has(plan, Stage::boundary), needs.boundary);
    EXPECT_EQ(has(plan, Stage::pseudo_mass), needs.pseudo_mass);
    EXPECT_EQ(has(plan, Stage::viscosity), needs.laplacian);
    EXPECT_EQ(has(plan, Stage::xsph), needs.xsph);
    EXPECT_EQ(has(plan, Stage::state_equation), needs.state_equation);
    EXPECT_EQ(has(plan, Stage::clamp_density), needs.tait);
    EXPECT_EQ(has(plan, Stage::tait), needs.tait);
    for (const Stage stage : {Stage::diagonal, Stage::source, Stage::warm_start, Stage::pressure_operator,
                              Stage::residual, Stage::stop_test, Stage::pressure_update, Stage::pressure}) {
      EXPECT_EQ(has(plan, stage), needs.linear_system) << info(stage).name;
    }
    for (const Stage stage : plan.stages()) {
      const bool once = std::find(plan.once.begin(), plan.once.end(), stage) != plan.once.end();
      EXPECT_EQ(runs_once(stage), once) << info(stage).name;
    }
    EXPECT_FALSE(has(plan, Stage::relax));
    EXPECT_EQ(plan.sweep.empty(), !needs.linear_system);
    const Plan relaxing = make_relax_plan(needs);
    EXPECT_TRUE(has(relaxing, Stage::relax));
    EXPECT_EQ(has(relaxing, Stage::pseudo_mass), needs.pseudo_mass);
    for (const Stage stage :
         {Stage::clamp_density, Stage::xsph, Stage::viscosity, Stage::tait, Stage::state_equation}) {
      EXPECT_FALSE(has(relaxing, stage)) << info(stage).name;
    }
  }
}

TEST(Plan, AllocatesNothingThatNoStageUses) {
  Needs bare;
  bare.state_equation = true;
  const FieldSet fields = make_plan(bare).fields();
  for (const Field field : {Field::C_boundary, Field::x_boundary, Field::Psi, Field::wall_density,
                            Field::wall_gradient, Field::wall_gradient_squares, Field::wall_viscosity,
                            Field::A_ii, Field::s, Field::Ap, Field::residual_sums, Field::solve}) {
    EXPECT_FALSE(fields.has(field)) << info(field).name;
  }
  Needs inviscid = bare;
  inviscid.boundary = true;
  EXPECT_TRUE(make_plan(inviscid).fields().has(Field::wall_gradient));
  EXPECT_FALSE(make_plan(inviscid).fields().has(Field::wall_viscosity));
  EXPECT_FALSE(make_plan(inviscid).fields().has(Field::wall_gradient_squares))
      << "only the diagonal reads it";
  EXPECT_FALSE(make_plan(inviscid).fields().has(Field::Psi)) << "mirror samples have the mass of the fluid's";
  Needs akinci = inviscid;
  akinci.pseudo_mass = akinci.linear_system = true;
  akinci.state_equation = false;
  EXPECT_FALSE(make_plan(akinci).fields().has(Field::q_before)) << "Jacobi looks no further back";
  EXPECT_FALSE(make_plan(akinci).fields().has(Field::Ap_before));
  Needs mirror = akinci;
  mirror.pseudo_mass = false;
  EXPECT_FALSE(make_plan(mirror).fields().has(Field::wall_gradient_squares)) << "of the thesis's wall only";
  mirror.thesis_wall = true;
  EXPECT_TRUE(make_plan(mirror).fields().has(Field::wall_gradient_squares));
  EXPECT_TRUE(make_plan(akinci).fields().has(Field::Psi));
  EXPECT_FALSE(make_plan(akinci).fields().has(Field::wall_gradient_squares)) << "of mirror samples only";
}

}  // namespace
}  // namespace sluice::test

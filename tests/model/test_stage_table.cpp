// The stage table, the files and the model agree; a plan has what a scene needs and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/model/plan.hpp"
#include "tests/support/models.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

const std::filesystem::path source(SLUICE_SOURCE_DIR);

std::set<std::string> stage_names() {
  std::set<std::string> names;
  for (const StageInfo& stage : stage_table()) names.insert(std::string(stage.name));
  return names;
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
  return std::set{Field::id_in, Field::x_in, Field::v_in, Field::p_in, Field::rho_in, Field::C_boundary,
                  Field::x_boundary, Field::sweeps,
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
  for (const Model& model : all_models()) {
    expect_written_before_read(make_plan(model));
    expect_written_before_read(make_plan(model, Task::relaxation));
  }
}

TEST(Plan, HasAStageExactlyWhenItsRowSaysSo) {
  for (const Model& model : all_models()) {
    for (const Task task : {Task::step, Task::relaxation}) {
      const Plan plan = make_plan(model, task);
      for (uint32_t s = 0; s < stage_count; ++s) {
        const StageInfo& row = stage_table()[s];
        for (const PhaseInfo& phase : phase_table) {
          const bool wanted = row.phases.has(phase.phase) && row.tasks.has(task) && plan.needs.*row.need &&
                              plan.needs.*phase.need;
          EXPECT_EQ(std::ranges::count(plan[phase.phase], static_cast<Stage>(s)), wanted ? 1 : 0) << row.name;
        }
      }
    }
  }
}

TEST(Plan, AStepComputesPressureInOneWay) {
  for (const Model& model : all_models()) {
    const Plan plan = make_plan(model);
    const std::vector<Stage> stages = plan.stages();
    const auto has = [&](Stage stage) { return std::ranges::find(stages, stage) != stages.end(); };
    EXPECT_EQ(has(Stage::state_equation) + has(Stage::tait) + has(Stage::pressure), 1);
    EXPECT_EQ(has(Stage::clamp_density), has(Stage::tait));
    EXPECT_EQ(plan.sweeps(), has(Stage::pressure));
    EXPECT_TRUE(has(Stage::integrate));
    EXPECT_FALSE(has(Stage::relax));
  }
}

TEST(Plan, ARelaxationIsOfAnInviscidFluidWithALinearSystem) {
  for (const Model& model : all_models()) {
    const Plan plan = make_plan(model, Task::relaxation);
    EXPECT_TRUE(plan.sweeps());
    EXPECT_EQ(plan[Phase::finish].back(), Stage::relax);
    EXPECT_FALSE(plan.fields().has(Field::wall_viscosity));
    EXPECT_EQ(plan.needs.pseudo_mass, model.boundary == BoundaryModel::akinci);
  }
}

TEST(StageTable, EveryFieldIsWrittenBySomeStageOrIsThereBefore) {
  FieldSet written;
  for (const StageInfo& row : stage_table()) written = written | row.writes;
  for (uint32_t f = 0; f < field_count; ++f) {
    const Field field = static_cast<Field>(f);
    EXPECT_TRUE(written.has(field) || carried(field)) << info(field).name;
  }
}

TEST(Plan, AllocatesNothingThatNoStageUses) {
  Model model{.method = PressureMethod::ssph};
  const FieldSet bare = make_plan(model).fields();
  for (const Field field : {Field::C_boundary, Field::x_boundary, Field::Psi, Field::wall_density,
                            Field::wall_gradient, Field::wall_gradient_squares, Field::wall_viscosity,
                            Field::A_ii, Field::s, Field::Ap, Field::residual_sums, Field::solve}) {
    EXPECT_FALSE(bare.has(field)) << info(field).name;
  }
  model.boundary = BoundaryModel::mirror;
  const FieldSet inviscid = make_plan(model).fields();
  EXPECT_TRUE(inviscid.has(Field::wall_gradient));
  EXPECT_FALSE(inviscid.has(Field::wall_viscosity));
  EXPECT_FALSE(inviscid.has(Field::wall_gradient_squares)) << "only the diagonal reads it";
  EXPECT_FALSE(inviscid.has(Field::Psi)) << "mirror samples have the mass of the fluid's";
  model.viscosity = ViscosityModel::laplacian;
  EXPECT_TRUE(make_plan(model).fields().has(Field::wall_viscosity));
  model.method = PressureMethod::iisph;
  const FieldSet thesis = make_plan(model).fields();
  EXPECT_TRUE(thesis.has(Field::wall_gradient_squares));
  EXPECT_FALSE(thesis.has(Field::q_before)) << "Jacobi looks no further back";
  EXPECT_FALSE(thesis.has(Field::Ap_before));
  model.wall = Wall::symmetric;
  model.solver = Solver::barzilai_borwein;
  const FieldSet symmetric = make_plan(model).fields();
  EXPECT_FALSE(symmetric.has(Field::wall_gradient_squares)) << "of the thesis's wall only";
  EXPECT_TRUE(symmetric.has(Field::q_before));
  model.boundary = BoundaryModel::akinci;
  model.wall = Wall::thesis;
  const FieldSet akinci = make_plan(model).fields();
  EXPECT_TRUE(akinci.has(Field::Psi));
  EXPECT_FALSE(akinci.has(Field::wall_gradient_squares)) << "of mirror samples only";
}

}  // namespace
}  // namespace sluice::test

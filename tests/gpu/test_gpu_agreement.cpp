// Every stage of every scene, on the GPU against the CPU in float, from identical input: at the start, on the
// way and after some time. On llvmpipe to the last bit. And that each of these comparisons can fail.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "core/agree/agree.hpp"
#include "gpu/backend.hpp"
#include "gpu/context.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// On hardware, in units in the last place of a field's largest value.
double tolerance(const gpu::Context& context) { return context.software() ? 0 : hardware_tolerance; }

/// Looks behind the end of every field after each stage.
class Guarded final : public ForwardingBackend {
 public:
  explicit Guarded(gpu::GpuBackend& gpu) : ForwardingBackend(gpu), gpu_(gpu) {}

  void allocate(FieldSet fields, const Sizes& sizes) override {
    fields_ = fields;
    ForwardingBackend::allocate(fields, sizes);
  }

  void run(Stage stage) override {
    ForwardingBackend::run(stage);
    for (uint32_t i = 0; i < field_count; ++i) {
      const Field field = static_cast<Field>(i);
      if (fields_.has(field)) {
        EXPECT_TRUE(gpu_.guard_is_intact(field)) << info(stage).name << " writes behind " << info(field).name;
        ++looks;
      }
    }
  }

  uint64_t looks = 0;

 private:
  gpu::GpuBackend& gpu_;
  FieldSet fields_;
};

/// Changes every constant by a part in a thousand.
class Perturbed final : public ForwardingBackend {
 public:
  explicit Perturbed(Backend& backend) : ForwardingBackend(backend) {}

  void configure(const Params& params, const Needs& needs) override {
    Params changed = params;
#define CHANGE(name, value, meaning) changed.name *= 1.001;
#define KEEP(name, value, meaning)
    SLUICE_PARAMS(CHANGE, CHANGE, KEEP)
#undef CHANGE
#undef KEEP
    ForwardingBackend::configure(changed, needs);
  }
};

/// A backend for the scene with h larger by a part in a thousand in all that follows from it.
class LargerSpacing final : public ForwardingBackend {
 public:
  LargerSpacing(Backend& backend, Scene scene) : ForwardingBackend(backend), scene_(std::move(scene)) {
    scene_.spacing *= 1.001;
  }

  void configure(const Params& params, const Needs& needs) override {
    Params changed = make_params(scene_, params.n);
    changed.columns = params.columns;
    changed.rows = params.rows;
    ForwardingBackend::configure(changed, needs);
  }

 private:
  Scene scene_;
};

struct Bench {
  Scene scene;
  gpu::BackendOptions options{.guard = 64};
  Samples samples = sample(scene);
  gpu::Context context{};
  std::unique_ptr<Backend> cpu = cpu::make_backend(Precision::single_, 2);
  std::unique_ptr<gpu::GpuBackend> stages = gpu::make_backend(context, options);
  std::unique_ptr<gpu::GpuBackend> run = gpu::make_backend(context), again = gpu::make_backend(context);
};

class StageAgreementOf : public testing::TestWithParam<ShippedRun> {};

void expect_every_stage_agrees(Bench bench) {
  Guarded guarded(*bench.stages);
  const Agreement found =
      agree(bench.scene, bench.samples, {*bench.cpu, guarded, *bench.run, bench.again.get()}, 40,
            tolerance(bench.context));
  std::set<Stage> compared;
  for (const StageAgreement& row : found.stages) {
    compared.insert(row.stage);
    const Difference& difference = row.difference;
    EXPECT_TRUE(difference.agrees(found.tolerance))
        << info(row.stage).name << ": largest difference " << difference.max_abs << ", " << difference.max_ulp
        << " ulp, " << difference.equal << " of " << difference.values << " equal, first in "
        << (difference.first ? info(difference.first->field).name : "nothing") << ", all zero "
        << difference.all_zero;
  }
  const std::vector<Stage> planned = make_plan(model_of(bench.scene)).stages();
  EXPECT_EQ(compared, std::set<Stage>(planned.begin(), planned.end()))
      << "not every planned stage was compared";
  EXPECT_GT(guarded.looks, 100u);
  EXPECT_EQ(found.run.steps, 40u);
  EXPECT_TRUE(found.pass);
}

// A jittered start, so that no comparison rests on the symmetry of a lattice.
Scene jittered(const ShippedRun& run) { return run.load({"fluid.jitter=0.05"}); }

TEST_P(StageAgreementOf, EveryStageFromIdenticalInput) { expect_every_stage_agrees({jittered(GetParam())}); }

// Larger groups, and fields read from storage blocks instead of texels.
TEST_P(StageAgreementOf, EveryStageInTheWayOfGraphicsCards) {
  expect_every_stage_agrees({jittered(GetParam()), {.group_size = 128, .guard = 64, .most_texels = 1}});
}

INSTANTIATE_TEST_SUITE_P(Scenes, StageAgreementOf, testing::ValuesIn(shipped_runs()),
                         [](const auto& test) { return test.param.name(); });

// Models in other company than in the shipped scenes.
TEST(StageAgreement, OfOtherCombinationsOfModels) {
  const std::vector<std::string> laplacian{"viscosity={model=\"laplacian\",coefficient=0.1}"};
  const std::vector<std::string> xsph{"viscosity={model=\"xsph\",coefficient=0.05}"};
  const std::vector<std::string> sound{"pressure.iisph.solver=barzilai-borwein",
                                       "pressure.iisph.wall=symmetric"};
  const std::vector<std::string> pressure_quality{
      "pressure.iisph.solver=barzilai-borwein", "pressure.iisph.wall=symmetric",
      "pressure.iisph.stop=residual",           "pressure.iisph.tolerance=1e-2",
      "pressure.iisph.source_weight=0.2",       "pressure.iisph.warm_start=1"};
  const auto gamma = [](const char* exponent) {
    return std::vector<std::string>{std::string("pressure.wcsph.gamma=") + exponent};
  };
  const std::vector<std::tuple<ShippedRun, std::vector<std::string>>> combinations = {
      {{"wcsph_box", "wcsph"}, laplacian},
      {{"wcsph_box", "ssph"}, laplacian},
      {{"iisph_box", "iisph"}, laplacian},
      {{"breaking_dam", "iisph"}, xsph},
      {{"breaking_dam", "ssph"}, {"boundary.model=akinci"}},
      {{"breaking_dam", "wcsph"}, xsph},
      {{"wcsph_box", "wcsph"}, gamma("1")},
      {{"wcsph_box", "wcsph"}, gamma("1.5")},
      {{"wcsph_box", "wcsph"}, gamma("6.3")},
      {{"breaking_dam", "iisph"}, {"pressure.iisph.solver=barzilai-borwein"}},
      {{"breaking_dam", "iisph"}, sound},
      {{"resting_fluid", "iisph"}, pressure_quality},
      {{"iisph_box", "iisph"}, {"pressure.iisph.solver=barzilai-borwein", "pressure.iisph.stop=residual"}},
      {{"breaking_dam", "iisph"}, {"pressure.iisph.max_iterations=3", "pressure.iisph.tolerance=1e-9"}},
  };
  for (auto [run, overrides] : combinations) {
    SCOPED_TRACE(run.name() + " " + overrides.front());
    overrides.push_back("fluid.jitter=0.05");
    expect_every_stage_agrees({run.load(overrides)});
  }
}

TEST(StageAgreement, OfARelaxation) {
  for (const ShippedRun& run : {ShippedRun{"breaking_dam", "iisph"}, ShippedRun{"wcsph_box", "wcsph"}}) {
    Bench bench{run.load({"fluid.jitter=0.2", "fluid.relax=3"})};
    ComparingBackend comparing(*bench.cpu, *bench.stages);
    comparing.compare_from_now_on(true);
    const Simulator simulator(bench.scene, bench.samples, comparing);
    for (const Stage stage : make_plan(model_of(bench.scene), Task::relaxation).stages())
      EXPECT_TRUE(comparing.difference(stage).values > 0 &&
                  comparing.difference(stage).within(tolerance(bench.context)))
          << run.name() << ", " << info(stage).name;
    for (const Stage stage : {Stage::relax, Stage::pressure_update})
      EXPECT_TRUE(comparing.difference(stage).agrees(tolerance(bench.context))) << run.name();
  }
}

/// Stages that agree although every constant is changed: they only move values.
const std::set<Stage> without_constants = {Stage::grid_scan,       Stage::grid_scatter, Stage::grid_order,
                                           Stage::reorder,         Stage::totals,       Stage::residual,
                                           Stage::pressure_update, Stage::pressure};

TEST(StageAgreement, IsRefusedToEveryStageWhoseConstantsAreChanged) {
  for (const ShippedRun& run : {ShippedRun{"breaking_dam", "iisph"}, ShippedRun{"breaking_dam", "ssph"},
                                ShippedRun{"wcsph_box", "wcsph"}, ShippedRun{"iisph_box", "iisph"}}) {
    Bench bench{jittered(run)};
    Perturbed perturbed(*bench.stages);
    const Agreement found =
        agree(bench.scene, bench.samples, {*bench.cpu, perturbed, *bench.run}, 40, hardware_tolerance);
    for (const StageAgreement& row : found.stages) {
      // Another tolerance ends another solve now and then, or none.
      if (row.stage == Stage::stop_test) continue;
      EXPECT_EQ(row.pass, without_constants.contains(row.stage))
          << run.name() << ", " << info(row.stage).name;
    }
    EXPECT_FALSE(found.pass);
  }
}

TEST(RunAgreement, IsRefusedToASpacingThatIsOffByAThousandth) {
  Bench bench{shipped("breaking_dam")};
  LargerSpacing larger(*bench.run, bench.scene), stages(*bench.stages, bench.scene);
  const Agreement found = agree(bench.scene, bench.samples, {*bench.cpu, stages, larger}, 10, 0);
  EXPECT_FALSE(found.pass);
  EXPECT_FALSE(found.run.equal);
  EXPECT_EQ(found.run.first_difference_step, 1u);
  EXPECT_GT(found.run.max_dx_over_h, 0);
  std::set<Stage> failed;
  for (const StageAgreement& row : found.stages) {
    if (row.difference.max_ulp > hardware_tolerance) failed.insert(row.stage);
  }
  for (const Stage stage : {Stage::neighbours, Stage::boundary, Stage::density, Stage::viscosity}) {
    EXPECT_TRUE(failed.contains(stage)) << info(stage).name;
  }
}

// One particle of all is one unit in the last place off, in one step of forty.
class OneBitOff final : public ForwardingBackend {
 public:
  OneBitOff(Backend& backend, uint32_t n) : ForwardingBackend(backend), n_(n) {}

  void run(Stage stage) override {
    ForwardingBackend::run(stage);
    if (stage != Stage::integrate || ++steps_ != 20) return;
    std::vector<double> x(2 * n_);
    download(Field::x_in, x);
    x[n_] = double(std::nextafter(float(x[n_]), 0.0f));
    upload(Field::x_in, x);
  }

 private:
  uint32_t n_;
  int steps_ = 0;
};

TEST(RunAgreement, SeesOneBitOfOneParticle) {
  Bench bench{shipped("breaking_dam")};
  OneBitOff off(*bench.run, static_cast<uint32_t>(bench.samples.fluid.size()));
  const Agreement found =
      agree(bench.scene, bench.samples, {*bench.cpu, *bench.stages, off, bench.again.get()}, 40, 0);
  EXPECT_FALSE(found.pass);
  EXPECT_EQ(found.stepped->first_difference_step, 20u);
  if (bench.context.software()) {
    EXPECT_EQ(found.run.first_difference_step, 20u);
  }
}

/// Leaves out the update of the last sweep: every stage is right, and the run is not.
class WithoutTheLastUpdate final : public ForwardingBackend {
 public:
  using ForwardingBackend::ForwardingBackend;

  void run(Stage stage) override {
    if (stage == Stage::pressure_update) {
      std::array<uint32_t, 2> sweeps{};
      download(Field::sweeps, sweeps);
      if (static_cast<Solve>(sweeps[1]) != Solve::unfinished) return;
    }
    ForwardingBackend::run(stage);
  }
};

// With a tolerance, a run on another device only has to end like the CPU's. With itself it has to agree.
TEST(RunAgreement, AFaultOfTheWholeRunIsSeenWhateverTheTolerance) {
  int scenes = 0;
  for (const char* name : {"breaking_dam", "leaking_dam", "iisph_box"}) {
    Bench bench{shipped(name)};
    WithoutTheLastUpdate faulty(*bench.run);
    const Agreement found =
        agree(bench.scene, bench.samples, {*bench.cpu, *bench.stages, faulty, bench.again.get()}, 10,
              hardware_tolerance);
    EXPECT_TRUE(found.run.passes(hardware_tolerance)) << name << ": it is the other comparison's to find";
    EXPECT_FALSE(found.stepped->passes(0)) << name;
    EXPECT_FALSE(found.pass) << name;
    ++scenes;
  }
  EXPECT_EQ(scenes, 3);
}

void expect_split_steps_agree(const Scene& scene, const std::vector<Stage>& splits) {
  for (const Stage split : splits) {
    SCOPED_TRACE(info(split).name);
    Bench bench{scene};
    const auto first_half = cpu::make_backend(Precision::single_, 1);
    SplitBackend halves(*first_half, *bench.run, split);
    const Agreement found = agree(bench.scene, bench.samples, {*bench.cpu, *bench.stages, halves}, 30, 0);
    EXPECT_TRUE(found.pass);
    EXPECT_EQ(bench.run->seconds(Stage::integrate) > 0, split < Stage::integrate) << "on the other backend";
    EXPECT_EQ(first_half->seconds(Stage::grid_count) > 0, !runs_once(split)) << "on the first backend";
  }
}

class CountingRuns final : public ForwardingBackend {
 public:
  using ForwardingBackend::ForwardingBackend;
  void run(Stage stage) override {
    ++runs[stage];
    ForwardingBackend::run(stage);
  }
  std::map<Stage, int> runs;
};

// A relaxed start is set up twice, and every time begins on the first backend.
TEST(RunAgreement, ASplitBeforeTheStepComputesOnTheFirstBackendWhatRunsOnce) {
  const Scene scene = shipped("wcsph_box", {"fluid.jitter=0.1", "fluid.relax=1"});
  const Samples samples = sample(scene);
  const auto first = cpu::make_backend(Precision::single_, 1),
             second = cpu::make_backend(Precision::single_, 1);
  CountingRuns before(*first), after(*second);
  SplitBackend halves(before, after, Stage::pseudo_mass);
  Simulator(scene, samples, halves).step();
  EXPECT_EQ(before.runs, (std::map<Stage, int>{{Stage::pseudo_mass, 2}}));
  EXPECT_FALSE(after.runs.contains(Stage::pseudo_mass));
  EXPECT_EQ(after.runs[Stage::tait], 1);
}

TEST(RunAgreement, OfAStepThatIsSplitBetweenTheBackends) {
  if (!gpu::Context().software()) GTEST_SKIP() << "runs are equal on llvmpipe only";
  expect_split_steps_agree(shipped("breaking_dam"), {Stage::grid_count, Stage::neighbours, Stage::density,
                                                     Stage::source, Stage::pressure_operator, Stage::totals});
  const std::vector<Stage> of_wcsph = {Stage::pseudo_mass, Stage::clamp_density, Stage::xsph, Stage::tait};
  expect_split_steps_agree(shipped("wcsph_box"), of_wcsph);
  expect_split_steps_agree(shipped("wcsph_box", {"fluid.jitter=0.1", "fluid.relax=2"}), of_wcsph);
}

}  // namespace
}  // namespace sluice::test

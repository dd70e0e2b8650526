// What work on solvers needs: convergence sweep by sweep, probes, forces on shapes, fields at the end, and
// another solver started from the same moment. None of it changes a bit of the run.
#include "tests/support/checkpointed.hpp"

namespace sluice::test {
namespace {

const std::string three_probes = R"(probe=[{name="P1",at=[40,40]},{name="right",x=370},{name="front",y=30}])";

class CliResearch : public CheckpointFolder {
 protected:
  Table table(const std::string& name) const { return read_table(folder / name); }
};

TEST_F(CliResearch, OutputsChangeNoBitOfTheRun) {
  for (const Words& machine : {Words{"--backend", "cpu"}, Words{"--backend", "gpu"}}) {
    run(Words{"breaking_dam", "--steps", "20", "--state", "plain.csv", "--series", "plain.rows"} + machine);
    run(Words{"breaking_dam", "--steps", "20", "--set", three_probes, "--sweeps", "s.csv", "--probes",
              "p.csv", "--wall-forces", "f.csv", "--state", "more.csv", "--series", "more.rows"} +
        machine);
    EXPECT_EQ(bytes("plain.csv"), bytes("more.csv"));
    EXPECT_EQ(bytes("plain.rows"), bytes("more.rows"));
  }
}

TEST_F(CliResearch, SweepsAreThoseOfTheSeries) {
  for (const char* solver : {"jacobi", "barzilai-borwein"}) {
    for (const char* backend : {"cpu", "gpu"}) {
      run({"breaking_dam", "--steps", "30", "--backend", backend, "--set",
           std::string("pressure.iisph.solver=") + solver, "--sweeps", "s.csv", "--series", "rows.csv"});
      const Table sweeps = table("s.csv"), series = table("rows.csv");
      EXPECT_EQ(sweeps.header, "step,sweep,mean_compression,residual,step_length");
      size_t row = 0;
      for (size_t step = 0; step < series.size(); ++step) {
        const auto count = static_cast<size_t>(series.at(step, "iterations"));
        for (size_t sweep = 1; sweep <= count; ++sweep, ++row) {
          ASSERT_EQ(sweeps.at(row, "step"), double(step + 1));
          ASSERT_EQ(sweeps.at(row, "sweep"), double(sweep));
          ASSERT_GT(sweeps.at(row, "step_length"), 0);
        }
        // The stop test compares the error of the last sweep, summed in float.
        EXPECT_NEAR(sweeps.at(row - 1, "mean_compression"), series.at(step, "residual"), 1e-6);
      }
      EXPECT_EQ(row, sweeps.size());
    }
  }
}

TEST_F(CliResearch, ResidualsOfSweepsAreThoseOfItsStopTest) {
  run({"breaking_dam", "--steps", "10", "--precision", "double", "--set", "pressure.iisph.stop=residual",
       "--set", "pressure.iisph.tolerance=1e-2", "--sweeps", "s.csv", "--series", "rows.csv"});
  const Table sweeps = table("s.csv"), series = table("rows.csv");
  size_t row = 0;
  for (size_t step = 0; step < series.size(); ++step) {
    row += static_cast<size_t>(series.at(step, "iterations"));
    EXPECT_NEAR(sweeps.at(row - 1, "residual"), series.at(step, "residual"), 1e-10);
  }
}

TEST_F(CliResearch, OfAStateEquationThereAreNoSweeps) {
  run({"breaking_dam", "--steps", "3", "--set", "pressure.method=ssph", "--sweeps", "s.csv"});
  EXPECT_EQ(table("s.csv").size(), 0u);
}

TEST_F(CliResearch, AnAdaptiveStepThatIsRepeatedHasItsLastSweeps) {
  run({"breaking_dam", "--time", "2", "--set", "time.cfl=0.1", "--set", "time.dt_min=1e-5", "--set",
       "time.dt_max=0.2", "--sweeps", "s.csv", "--series", "rows.csv", "--summary", "run.json"});
  double total = 0;
  for (const double count : table("rows.csv").column("iterations")) total += count;
  EXPECT_EQ(double(table("s.csv").size()), total);
}

TEST_F(CliResearch, ProbesHaveAColumnForEachOfTheirNumbers) {
  run({"breaking_dam", "--time", "6", "--set", three_probes, "--probes", "p.csv", "--series", "rows.csv"});
  const Table probes = table("p.csv");
  EXPECT_EQ(probes.header, "step,time,P1.pressure,P1.density,P1.vx,P1.vy,right.level,front.front");
  EXPECT_EQ(probes.column("step"), table("rows.csv").column("step"));
  const size_t last = probes.size() - 1;
  EXPECT_GT(probes.at(last, "P1.pressure"), 100);
  EXPECT_EQ(probes.text(0, "right.level"), "") << "the water is not there yet";
  EXPECT_GT(probes.at(last, "right.level"), 20);
  EXPECT_GT(probes.at(last, "front.front"), probes.at(0, "front.front") + 100);
}

TEST_F(CliResearch, WallForcesAddUpToThoseOfTheSeries) {
  run({"template", "--steps", "40", "--set", "boundary.disc.0.name=pile", "--wall-forces", "f.csv",
       "--series", "rows.csv", "--precision", "double"});
  const Table forces = table("f.csv"), series = table("rows.csv");
  EXPECT_TRUE(has(forces.header, "pile.fx,pile.fy,pile.torque")) << forces.header;
  for (size_t row = 0; row < series.size(); ++row) {
    double sum = 0;
    for (const std::string& name : forces.names)
      if (name.ends_with(".fy")) sum += forces.at(row, name);
    EXPECT_NEAR(sum, series.at(row, "wall_force_y"), 1e-6 * std::abs(series.at(row, "wall_force_y")) + 1e-3);
  }
}

TEST_F(CliResearch, FieldsAreFurtherColumnsOfTheState) {
  run({"breaking_dam", "--steps", "9", "--state", "plain.csv"});
  run({"breaking_dam", "--steps", "9", "--state", "more.csv", "--dump", "rho,a_p,A_ii", "--dump", "v"});
  const Table plain = table("plain.csv"), more = table("more.csv");
  EXPECT_EQ(more.header, "id,x,y,vx,vy,density,pressure,rho,a_p_x,a_p_y,A_ii,v_x,v_y");
  EXPECT_EQ(more.column("x"), plain.column("x"));
  run({"--steps", "9", "--state", "last.csv", "--dump", "rho", "breaking_dam"});  // which is no field
  EXPECT_EQ(table("last.csv").column("rho"), more.column("rho"));
  EXPECT_EQ(more.column("rho"), more.column("density"));
  for (const double A_ii : more.column("A_ii")) EXPECT_LE(A_ii, 0);
}

TEST_F(CliResearch, WhatIsNotThereIsRefusedAndNothingIsWritten) {
  EXPECT_TRUE(has(run({"breaking_dam", "--steps", "1", "--state", "s.csv", "--dump", "foo"}, 2),
                  "--dump: found \"foo\""));
  EXPECT_TRUE(has(run({"breaking_dam", "--steps", "1", "--state", "s.csv", "--dump", "list"}, 2), "A_ii"));
  EXPECT_EQ(run_program({"run", "breaking_dam", "--dump", "rho"}).code, 2) << "there is no --state";
  EXPECT_TRUE(has(run({"breaking_dam", "--steps", "1", "--probes", "p.csv"}, 2), "probe: found none"));
  EXPECT_TRUE(has(
      run({"breaking_dam", "--steps", "1", "--set", "boundary.container=[]", "--wall-forces", "f.csv"}, 2),
      "expected walls for --wall-forces"));
  EXPECT_TRUE(names_in(folder.path).empty());
}

TEST_F(CliResearch, AStartFromACheckpointIsThatMomentAtTimeZero) {
  for (const Words& machine : {Words{"--precision", "double"}, Words{"--backend", "gpu"}}) {
    run(Words{"breaking_dam", "--steps", "20", "--checkpoint", "twenty.ckp"} + machine);
    run(Words{"--resume", "twenty.ckp", "--steps", "25", "--state", "resumed.csv"} + machine);
    run(Words{"--start-from", "twenty.ckp", "--steps", "5", "--state", "started.csv", "--series", "rows.csv",
              "--summary", "run.json"} +
        machine);
    EXPECT_EQ(bytes("resumed.csv"), bytes("started.csv"));
    EXPECT_EQ(table("rows.csv").at(0, "step"), 1);
    EXPECT_EQ(read_json(folder / "run.json")["start_from"], "twenty.ckp");
    EXPECT_EQ(read_json(folder / "run.json")["steps"], 5);
  }
}

TEST_F(CliResearch, AStartFromACheckpointTakesAnySettings) {
  run({"breaking_dam", "--steps", "20", "--checkpoint", "twenty.ckp", "--state", "twenty.csv"});
  run({"breaking_dam", "--start-from", "twenty.ckp", "--steps", "0", "--state", "zero.csv", "--precision",
       "double", "--set", "time.dt=0.001", "--set", "pressure.method=ssph", "--set",
       "domain.min=[-80, -16]"});
  for (size_t i = 0; i < 660; ++i)
    ASSERT_NEAR(table("zero.csv").at(i, "x"), table("twenty.csv").at(i, "x"), 1e-5);
  run({"--start-from", "twenty.ckp", "--time", "0.5", "--set", "time.cfl=0.2", "--set", "time.dt_min=1e-5",
       "--set", "time.dt_max=0.3", "--series", "rows.csv"});
  EXPECT_LT(table("rows.csv").at(0, "dt"), 0.3) << "the first step follows the speeds of the start";
  EXPECT_TRUE(has(run({"breaking_dam", "--start-from", "twenty.ckp", "--set", "particles.spacing=16"}, 2),
                  "twenty.ckp: found 660 particles, expected the"));
  EXPECT_EQ(run_program({"run", "--start-from", "a", "--resume", "b"}).code, 2);
}

TEST_F(CliResearch, ParticlesOfAStateAreAStart) {
  run({"breaking_dam", "--steps", "30", "--state", "thirty.csv"});
  run({"breaking_dam", "--set", "fluid.rect=[]", "--set",
       "fluid.particles=[{file=\"" + (folder / "thirty.csv").string() + "\"}]", "--steps", "0", "--state",
       "again.csv"});
  for (const char* column : {"x", "y", "vx", "vy"})
    EXPECT_EQ(table("again.csv").column(column), table("thirty.csv").column(column));
}

}  // namespace
}  // namespace sluice::test

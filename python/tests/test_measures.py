"""Measures: the numbers of the program's files."""

import pytest
import sluice

PROBES = 'probe=[{name="P1",at=[40,40]},{name="right",x=370},{name="front",y=30}]'


def test_probes_and_wall_forces_are_those_of_the_program(run, tmp_path):
    run("run", "breaking_dam", "--steps", 40, "--quiet", "--backend", "cpu", "--set", PROBES, "--probes", "p.csv",
        "--wall-forces", "f.csv")
    simulation = sluice.Simulation(sluice.load("breaking_dam", [PROBES]))
    simulation.run(steps=40)
    there = sluice.read_series(tmp_path / "p.csv").iloc[-1]
    here = simulation.probes()
    assert list(here) == list(there.index[1:])
    assert here["right.level"] is None and there.isna()["right.level"]
    assert here["P1.pressure"] == pytest.approx(there["P1.pressure"], rel=1e-6)
    assert here["P1.pressure"] == simulation.values_at((40, 40))["pressure"]
    forces = sluice.read_series(tmp_path / "f.csv").iloc[-1]
    assert simulation.wall_forces()["container.0"]["force"][1] == pytest.approx(forces["container.0.fy"], rel=1e-6)
    assert simulation.wall_forces()["container.0"]["torque"] == pytest.approx(forces["container.0.torque"], rel=1e-6)


def test_sweeps_are_reported_when_asked_for():
    simulation = sluice.Simulation("breaking_dam")
    assert simulation.step().sweeps == []
    simulation.report_sweeps()
    report = simulation.step()
    assert len(report.sweeps) == report.iterations
    assert report.sweeps[-1]["mean_compression"] == pytest.approx(report.residual, rel=1e-4)

"""Readers of the program's files, and scenes."""

import numpy as np
import pytest
import sluice


def test_the_series_and_the_state_read_back_exactly(run, tmp_path):
    run("run", "breaking_dam", "--steps", 12, "--quiet", "--backend", "cpu", "--precision", "double", "--series", "series.csv",
        "--state", "state.csv")
    series, state = sluice.read_series(tmp_path / "series.csv"), sluice.read_state(tmp_path / "state.csv")
    simulation = sluice.Simulation("breaking_dam", precision="double")
    reports = simulation.run(steps=12)
    assert series.kinetic_energy.to_list() == [report.kinetic_energy for report in reports]
    assert np.array_equal(state[["x", "y"]], simulation.field("position"))
    assert series.index.to_list() == list(range(1, 13)) and state.index.name == "id"


def test_summaries_are_rows_of_one_frame(run, tmp_path):
    for name in ("a", "b"):
        run("run", "breaking_dam", "--steps", 3, "--quiet", "--backend", "cpu", "--summary", f"{name}.json")
    frame = sluice.read_summary(tmp_path / "a.json", tmp_path / "b.json")
    assert frame["steps"].to_list() == [3, 3] and frame["settings.time.dt"].iloc[0] > 0
    here = sluice.Simulation("breaking_dam")
    here.run(steps=3)
    there, here = frame.iloc[0].to_dict(), here.summary()
    assert there["settings.time.dt"] == here["settings"]["time"]["dt"] and there["steps"] == here["steps"]


def test_a_recording_is_a_sequence_of_moments(run, tmp_path):
    run("run", "breaking_dam", "--steps", 30, "--quiet", "--backend", "cpu", "--record", "dam.rec")
    recording = sluice.read_recording(tmp_path / "dam.rec")
    simulation = sluice.Simulation("breaking_dam")
    assert recording.scene.name == "breaking_dam" and recording.precision == "float" and len(recording) > 10
    assert recording[0].step == 0 and recording[0].time == 0
    last = recording[-1]
    simulation.run(steps=last.step)
    assert np.array_equal(last.position, simulation.field("position"))
    assert np.array_equal(last.table()[["vx", "vy"]], simulation.field("velocity"))
    assert last.report.time == simulation.time and len(recording[2:5]) == 3
    assert np.array_equal(recording.picture(-1, size=(200, 150)), simulation.picture(size=(200, 150)))
    with pytest.raises(IndexError):
        recording[len(recording)]
    assert len(list(recording)) == len(recording)


def test_files_that_are_none_are_refused_with_their_name(tmp_path):
    (tmp_path / "no.rec").write_text("nothing")
    for read in (sluice.read_recording, sluice.Simulation.resume):
        with pytest.raises(sluice.InputError, match="no.rec"):
            read(tmp_path / "no.rec")


def test_settings_are_values_of_python_and_numpy():
    scene = sluice.load(
        "breaking_dam",
        {"time.dt": np.float64(0.02), "pressure.method": "ssph", "pressure.ssph.stiffness": 1e5, "fluid.seed": np.int64(3), "fluid.jitter": np.float32(0.25),
         "fluid.gravity": (0, -5)},
    )
    settings = scene.settings
    assert settings["time"]["dt"] == 0.02 and settings["fluid"]["jitter"] == 0.25 and scene.gravity == (0, -5)
    assert scene.changed({"time.dt": 0.01}).dt == 0.01 and scene.changed(["time.dt=0.03"]).dt == 0.03
    assert scene.changed({"time.dt": 0.01}).settings["fluid"]["seed"] == 3


def test_a_mistake_is_said_with_place_key_and_expectation(tmp_path):
    with pytest.raises(sluice.InputError, match='did you mean "dt"'):
        sluice.load("breaking_dam", {"time.dtt": 1})
    with pytest.raises(ValueError, match="no_such_scene"):
        sluice.load("no_such_scene")
    with pytest.raises(sluice.InputError, match="mine.toml:1:"):
        sluice.parse("title = 3", file="mine.toml")


def test_shipped_scenes_are_known_by_name():
    assert {"breaking_dam", "template"} <= set(sluice.scenes())
    assert repr(sluice.load("breaking_dam")).startswith("<sluice.Scene breaking_dam")

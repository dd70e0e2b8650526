"""Simulations: the bits of the program, fields as arrays, what is refused."""

import gc
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import sluice


@pytest.mark.parametrize("scene, backend", [("breaking_dam", "cpu"), ("breaking_dam", "gpu"), ("wcsph_box", "cpu")])
def test_a_thousand_steps_have_the_bytes_of_the_program(scene, backend, run, tmp_path):
    simulation = sluice.Simulation(scene, backend=backend)
    simulation.run(steps=1000)
    simulation.write_state(tmp_path / "here.csv")
    run("run", scene, "--steps", 1000, "--backend", backend, "--quiet", "--state", "there.csv")
    assert (tmp_path / "here.csv").read_bytes() == (tmp_path / "there.csv").read_bytes()


def test_fields_are_those_of_the_state_file(small, tmp_path):
    simulation = sluice.Simulation(small, precision="double")
    simulation.run(steps=7)
    simulation.write_state(tmp_path / "state.csv")
    state = sluice.read_state(tmp_path / "state.csv")
    for name, columns in {"position": ["x", "y"], "velocity": ["vx", "vy"], "density": "density", "pressure": "pressure"}.items():
        assert np.array_equal(simulation.field(name), state[columns].to_numpy()), name


def test_every_field_there_is_can_be_read_in_both_orders(small):
    simulation = sluice.Simulation(small)
    simulation.step()
    assert {"position", "a_p", "A_ii", "s", "list"} <= set(simulation.fields)
    for name in simulation.fields:
        assert len(simulation.field(name)) > 0
        if name not in ("position", "velocity", "density", "pressure"):
            assert simulation.field(name, order="memory").shape == simulation.field(name).shape


def test_the_order_in_memory_is_that_of_the_field_id(small):
    simulation = sluice.Simulation(small)
    simulation.run(steps=30)
    ids = simulation.field("id", order="memory")
    assert not np.array_equal(ids, np.arange(len(ids)))
    for name in ("rho", "a_p", "v", "x_in"):
        assert np.array_equal(simulation.field(name)[ids], simulation.field(name, order="memory")), name
    corner = np.array(simulation.scene.domain[0])
    assert np.allclose(simulation.field("x_in") + corner, simulation.field("position"))
    assert np.array_equal(simulation.field("rho"), simulation.field("density"))


def test_what_the_step_before_left_is_in_the_order_of_ids_too(small):
    simulation = sluice.Simulation(small)
    simulation.run(steps=30)
    before = simulation.field("density")
    simulation.step()
    assert np.array_equal(simulation.field("rho_in"), before)


def test_a_view_is_no_copy_cannot_be_written_and_keeps_its_simulation(small):
    simulation = sluice.Simulation(small)
    view = simulation.field("rho", order="memory")
    assert view.dtype == np.float32 and not view.flags.owndata and not view.flags.writeable
    assert sluice.Simulation(small, precision="double").field("rho", order="memory").dtype == np.float64
    simulation.step()
    now = simulation.field("rho", order="memory")
    assert np.shares_memory(view, now) or np.shares_memory(view, simulation.field("rho_in", order="memory"))
    expected = now.copy()
    del simulation
    gc.collect()
    assert np.array_equal(now, expected)


def test_a_list_that_may_grow_is_copied(small):
    simulation = sluice.Simulation(small)
    for name in ("index", "gradient"):
        assert simulation.field(name, order="memory").flags.owndata


def test_an_array_in_the_order_of_ids_is_a_copy(small):
    simulation = sluice.Simulation(small)
    before = simulation.field("position")
    kept = before.copy()
    simulation.run(steps=5)
    assert np.array_equal(before, kept) and not np.array_equal(before, simulation.field("position"))


def test_velocities_that_are_set_are_what_the_next_step_starts_from(small):
    still, kicked = sluice.Simulation(small), sluice.Simulation(small)
    for simulation in (still, kicked):
        simulation.run(steps=3)
    v = kicked.field("velocity")
    kicked.set_field("velocity", v + np.array([3.0, 0.0]))
    assert np.allclose(kicked.field("velocity"), v + np.array([3.0, 0.0]), rtol=1e-6)
    assert np.array_equal(kicked.field("position"), still.field("position"))
    a, b = still.step(), kicked.step()
    moved = b.centre_of_mass[0] - a.centre_of_mass[0]
    assert 0.85 * 3 * kicked.dt < moved < 3 * kicked.dt  # walls and viscosity take a little


def test_setting_what_is_there_changes_no_bit(small, tmp_path):
    plain, touched = (sluice.Simulation(small, precision="double") for _ in range(2))
    for simulation in (plain, touched):
        simulation.run(steps=10)
    touched.set_field("velocity", touched.field("velocity"))
    for simulation in (plain, touched):
        simulation.run(steps=10)
    assert np.array_equal(plain.field("position"), touched.field("position"))


def test_positions_that_are_set_are_moved_to(small):
    simulation = sluice.Simulation(small)
    simulation.run(steps=3)
    x = simulation.field("position")
    simulation.set_field("position", x + np.array([0.25, 0.0]))
    assert np.allclose(simulation.field("position"), x + np.array([0.25, 0.0]), atol=1e-3)
    simulation.step()
    assert simulation.failure is None


@pytest.mark.parametrize(
    "name, change, text",
    [
        ("velocity", lambda v: v[:-1], "particles"),
        ("velocity", lambda v: v[:, 0], "shape"),
        ("velocity", lambda v: v * np.nan, "finite"),
        ("position", lambda v: v + 1e39, "finite"),
        ("density", lambda v: v, "position or velocity"),
    ],
)
def test_values_that_cannot_be_set_are_refused_and_nothing_changes(name, change, text, small):
    simulation = sluice.Simulation(small)
    simulation.step()
    before = simulation.field("velocity")
    with pytest.raises(sluice.InputError, match=text):
        simulation.set_field(name, change(before))
    assert np.array_equal(simulation.field("velocity"), before)


def test_an_adaptive_step_follows_velocities_that_are_set():
    scene = sluice.load("breaking_dam", {"time.cfl": 0.4, "time.dt_min": 1e-4, "time.dt_max": 0.1})
    simulation = sluice.Simulation(scene)
    simulation.run(steps=3)
    simulation.set_field("velocity", simulation.field("velocity") + np.array([200.0, 0.0]))
    assert simulation.step().dt <= 0.4 * scene.spacing / 200 * 1.01


def test_runs_end_where_the_program_ends_them(run, tmp_path):
    scene = {"breaking_dam": {}, "wcsph_box": {"time.cfl": 0.3, "time.dt_min": 1e-5, "time.dt_max": 0.02}}
    for name, settings in scene.items():
        simulation = sluice.Simulation(sluice.load(name, settings))
        reports = simulation.run(time=0.7)
        sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        run("run", name, *sets, "--time", 0.7, "--quiet", "--backend", "cpu", "--series", f"{name}.csv")
        there, here = sluice.read_series(tmp_path / f"{name}.csv"), sluice.table(reports).set_index("step")
        assert list(there.columns) == list(here.columns)
        assert np.allclose(there.to_numpy(), here.to_numpy(), rtol=1e-7, atol=1e-12), name
    assert simulation.time == pytest.approx(0.7)


def test_a_checkpoint_goes_on_here_and_there(small, run, tmp_path):
    whole, first = sluice.Simulation(small), sluice.Simulation(small)
    whole.run(steps=20)
    whole.write_state(tmp_path / "whole.csv")
    first.run(steps=10)
    first.write_checkpoint(tmp_path / "ten.ckp")
    second = sluice.Simulation.resume(tmp_path / "ten.ckp")
    assert second.steps == 10
    second.run(steps=10)
    second.write_state(tmp_path / "second.csv")
    run("run", "--resume", "ten.ckp", "--steps", 20, "--quiet", "--backend", "cpu", "--state", "there.csv")
    assert (tmp_path / "second.csv").read_bytes() == (tmp_path / "whole.csv").read_bytes()
    assert (tmp_path / "there.csv").read_bytes() == (tmp_path / "whole.csv").read_bytes()
    with pytest.raises(sluice.InputError, match="checkpoint in float, expected one in double"):
        sluice.Simulation.resume(tmp_path / "ten.ckp", precision="double")
    assert second.summary()["steps"] == 20


def test_a_run_that_becomes_invalid_says_so_and_can_be_read():
    simulation = sluice.Simulation(sluice.load("breaking_dam", {"time.dt": 5}))
    with pytest.raises(sluice.InvalidRun, match="breaking_dam.*step"):
        simulation.run(steps=100)
    assert simulation.failure.step == simulation.steps and simulation.failure.reason
    assert np.isfinite(simulation.field("position")).all()
    with pytest.raises(sluice.InputError, match="became invalid"):
        simulation.step()
    with pytest.raises(sluice.InputError, match="invalid"):
        simulation.write_checkpoint("never.ckp")


@pytest.mark.parametrize(
    "arguments, text",
    [
        ({"backend": "tpu"}, "backend: found tpu, expected cpu or gpu"),
        ({"precision": "half"}, "precision: found half, expected one of float, double"),
        ({"precision": "double", "backend": "gpu"}, "double"),
        ({"threads": -1}, "threads: found -1"),
        ({"backend": "gpu", "gl_device": 99}, "99"),
        ({"backend": "gpu", "shader_dir": "/nowhere"}, "/nowhere"),
    ],
)
def test_arguments_that_make_no_sense_are_refused(arguments, text, small):
    with pytest.raises(sluice.InputError, match=text):
        sluice.Simulation(small, **arguments)


def test_what_tends_to_go_wrong_is_a_warning():
    with pytest.warns(UserWarning, match="viscosity"):
        sluice.Simulation(sluice.load("breaking_dam", {"viscosity.coefficient": 1e6}))


def test_a_field_that_is_not_there_is_named_with_those_that_are(small):
    with pytest.raises(sluice.InputError, match="found no field colour, expected one of position, velocity.*a_p"):
        sluice.Simulation(small).field("colour")
    with pytest.raises(sluice.InputError, match="order: found random"):
        sluice.Simulation(small).field("rho", order="random")


def test_each_sees_every_report_and_may_end_the_run(small):
    seen = []
    reports = sluice.Simulation(small).run(steps=10, each=lambda report: seen.append(report.step) or len(seen) < 4)
    assert seen == [1, 2, 3, 4] and len(reports) == 4


def test_control_c_ends_a_run_between_steps():
    program = (
        "import sluice, sys\n"
        "s = sluice.Simulation(sluice.load('breaking_dam', {'time.duration': 1e6}))\n"
        "print('ready', flush=True)\n"
        "try: s.run()\n"
        "except KeyboardInterrupt: print(s.steps, flush=True); s.step(); print(s.steps)\n"
    )
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "ready\n"
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    steps, one_more = map(int, child.communicate(timeout=30)[0].split())
    assert steps > 0 and one_more == steps + 1 and child.returncode == 0


def test_other_threads_of_python_run_while_it_computes():
    # Over half a second of computing, in steps that hold Python's lock the counter could count a handful of times.
    simulation = sluice.Simulation(sluice.load("breaking_dam", {"particles.spacing": 1, "viscosity.coefficient": 1}), threads=1)
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    simulation.run(steps=3)
    stop.set()
    thread.join()
    assert counted[0] > 10


def test_pictures_are_arrays_of_bytes(small):
    simulation = sluice.Simulation(small)
    simulation.step()
    picture = simulation.picture(size=(200, 100), colour="pressure")
    assert picture.shape == (100, 200, 3) and picture.dtype == np.uint8 and len(np.unique(picture)) > 10
    with pytest.raises(sluice.InputError, match="colour: found red, expected one of speed, density, pressure"):
        simulation.picture(colour="red")

"""Simulations."""

import json
import warnings
from pathlib import Path

from . import _sluice
from .scenes import Scene, load


def pictures_of(scene, size, colour):
    """What draws states of a scene."""
    if not hasattr(_sluice, "_Pictures"):
        raise _sluice.EnvironmentError("pictures: this module was built without OpenGL; build it with -DSLUICE_GPU=ON")
    return _sluice._Pictures(scene, size and tuple(size), colour)


class Simulation(_sluice.Simulation):
    """A scene and what computes it.

    `scene`: a Scene, or what load() takes. `backend`: "cpu", or "gpu" for OpenGL compute shaders. `precision`: "float"
    or "double". `threads`: all processors if None; results do not depend on it. What tends to go wrong with the scene
    and is known before the first step is a warning. Raises InputError and EnvironmentError.
    """

    def __init__(self, scene, backend="cpu", precision="float", threads=None, gl_device=None, shader_dir=None):
        scene = scene if isinstance(scene, Scene) else load(scene)
        super().__init__(scene, backend, precision, threads or 0, gl_device, shader_dir)
        self._pictures = {}
        for text in self.warnings:
            warnings.warn(text, stacklevel=2)

    @classmethod
    def resume(cls, checkpoint, backend="cpu", precision="float", threads=None, gl_device=None, shader_dir=None):
        """Goes on from a file of `sluice run --checkpoint` or write_checkpoint(), as if the run had never stopped."""
        simulation = cls.__new__(cls)
        _sluice.Simulation.__init__(
            simulation, Path(checkpoint), backend, precision, threads or 0, gl_device, shader_dir
        )
        simulation._pictures = {}
        return simulation

    def run(self, time=None, steps=None, each=None):
        """Runs up to a time, by default the scene's duration, or so many steps; returns the report of every step.

        `each` is called with every report; the run ends when it returns False. Ctrl-C ends it after the step that is
        under way. Raises InvalidRun when the run becomes invalid: what was reached can still be read.
        """
        if time is not None and steps is not None:
            raise _sluice.InputError("run: found a time and a number of steps, expected one of them")
        if steps is None:
            return self._run(self.scene.duration if time is None else time, each)
        reports = []
        while len(reports) < steps:
            reports.append(self.step())
            if each is not None and each(reports[-1]) is False:
                break
        return reports

    def field(self, name, order="id"):
        """Values of a field as an array with a row per particle (boundary sample, cell, list entry, ...).

        The names are in `fields`: position, velocity, density and pressure of the state that the last step led to, and
        every array that its stages worked with. With order="id" reals are float64, particles in the order of their
        ids, and the array is a copy. With order="memory" it is an array of the stages as it lies in memory, in the
        precision that is computed in; on the CPU this is no copy but a view, which can't be written and changes with
        the next step.
        """
        if order == "id":
            return self._field(name)
        if order == "memory":
            return self._field_in_memory(name)
        raise _sluice.InputError(f"order: found {order}, expected id or memory")

    def picture(self, size=None, colour=None):
        """A picture as an array of bytes (height, width, 3): `size` in pixels and `colour` (speed, density, pressure)
        are those of the scene if None."""
        key = (size and tuple(size), colour)
        if key not in self._pictures:
            self._pictures[key] = pictures_of(self.scene, *key)
        return self._pictures[key].draw(self._snapshot(), self.dt)

    def summary(self):
        """What `sluice run --summary` writes, as a dictionary."""
        return json.loads(self._summary())


def table(reports):
    """Reports of steps as a pandas frame, with the columns of `sluice run --series`."""
    import pandas

    return pandas.DataFrame([report.row() for report in reports])

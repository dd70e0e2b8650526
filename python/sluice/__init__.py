"""Fluids in two dimensions with smoothed particle hydrodynamics: scenes, simulations as numpy arrays, and readers of
the files that the program `sluice` writes.

    scene = sluice.load("breaking_dam", {"time.dt": 0.02})
    simulation = sluice.Simulation(scene)
    simulation.run(time=10)
    density = simulation.field("density")
"""

import os as _os

# Threads that wait for each other should not spin for long. The OpenMP runtime reads this when it is loaded.
_os.environ.setdefault("GOMP_SPINCOUNT", "5000")

from ._sluice import (  # noqa: E402
    EnvironmentError,
    Error,
    Failure,
    InputError,
    InvalidRun,
    Scene,
    StepReport,
    __version__,
    commit,
)
from .files import Moment, Recording, read_recording, read_series, read_state, read_summary  # noqa: E402
from .scenes import load, parse, scenes  # noqa: E402
from .simulation import Simulation, table  # noqa: E402

__all__ = [
    "EnvironmentError",
    "Error",
    "Failure",
    "InputError",
    "InvalidRun",
    "Moment",
    "Recording",
    "Scene",
    "Simulation",
    "StepReport",
    "__version__",
    "commit",
    "load",
    "parse",
    "read_recording",
    "read_series",
    "read_state",
    "read_summary",
    "scenes",
    "table",
]

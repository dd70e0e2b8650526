"""Types of the module sluice. What things do is said in their docstrings and in docs/python.md."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from os import PathLike
from typing import Any, Literal, overload

import numpy as np
import numpy.typing as npt
import pandas as pd

_Path = str | PathLike[str]
_Settings = Mapping[str, Any] | Iterable[str] | str | None
_Pair = tuple[float, float]
_Floats = npt.NDArray[np.float64]

__version__: str
commit: str

class Error(RuntimeError): ...
class InputError(Error, ValueError): ...
class EnvironmentError(Error): ...
class InvalidRun(Error): ...

class Scene:
    name: str
    file: str
    title: str
    spacing: float
    smoothing_length: float
    rest_density: float
    mass: float
    dt: float
    duration: float
    gravity: _Pair
    domain: tuple[_Pair, _Pair]
    settings: dict[str, Any]
    def changed(self, settings: _Settings) -> Scene: ...

class StepReport:
    step: int
    time: float
    dt: float
    repeats: int
    iterations: int
    residual: float
    converged: bool
    mean_density: float
    mean_compression: float
    max_compression: float
    kinetic_energy: float
    potential_energy: float
    centre_of_mass: _Pair
    max_speed: float
    cfl: float
    wall_force: _Pair
    lost: int
    sweeps: list[dict[str, float]]
    def row(self) -> dict[str, float]: ...

class Failure:
    step: int
    time: float
    id: int
    position: _Pair
    reason: str

class Simulation:
    scene: Scene
    particles: int
    boundary: _Floats
    steps: int
    time: float
    dt: float
    failure: Failure | None
    backend: str
    device: str
    precision: str
    threads: int
    warnings: list[str]
    fields: dict[str, str]
    def __init__(
        self,
        scene: Scene | _Path,
        backend: Literal["cpu", "gpu"] = "cpu",
        precision: Literal["float", "double"] = "float",
        threads: int | None = None,
        gl_device: int | None = None,
        shader_dir: _Path | None = None,
    ) -> None: ...
    @classmethod
    def resume(
        cls,
        checkpoint: _Path,
        backend: Literal["cpu", "gpu"] = "cpu",
        precision: Literal["float", "double"] = "float",
        threads: int | None = None,
        gl_device: int | None = None,
        shader_dir: _Path | None = None,
    ) -> Simulation: ...
    def step(self, end: float | None = None) -> StepReport: ...
    def run(
        self,
        time: float | None = None,
        steps: int | None = None,
        each: Callable[[StepReport], Any] | None = None,
    ) -> list[StepReport]: ...
    @overload
    def field(self, name: Literal["position", "velocity", "density", "pressure"], order: Literal["id"] = "id") -> _Floats: ...
    @overload
    def field(self, name: str, order: Literal["id", "memory"] = "id") -> npt.NDArray[Any]: ...
    def values_at(self, point: _Pair) -> dict[str, Any]: ...
    def probes(self) -> dict[str, float | None]: ...
    def wall_forces(self) -> dict[str, dict[str, Any]]: ...
    def report_sweeps(self) -> None: ...
    def set_field(self, name: Literal["position", "velocity"], values: npt.ArrayLike) -> None: ...
    def picture(
        self, size: tuple[int, int] | None = None, colour: Literal["speed", "density", "pressure"] | None = None
    ) -> npt.NDArray[np.uint8]: ...
    def write_state(self, path: _Path) -> None: ...
    def write_checkpoint(self, path: _Path) -> None: ...
    def summary(self) -> dict[str, Any]: ...

class Moment:
    report: StepReport
    step: int
    time: float
    position: _Floats
    velocity: _Floats
    density: _Floats
    pressure: _Floats
    def table(self) -> pd.DataFrame: ...

class Recording:
    scene: Scene
    precision: str
    boundary: _Floats
    def __init__(self, path: _Path) -> None: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Moment]: ...
    @overload
    def __getitem__(self, frame: int) -> Moment: ...
    @overload
    def __getitem__(self, frame: slice) -> list[Moment]: ...
    def picture(
        self,
        frame: int,
        size: tuple[int, int] | None = None,
        colour: Literal["speed", "density", "pressure"] | None = None,
    ) -> npt.NDArray[np.uint8]: ...

def load(scene: _Path, settings: _Settings = None) -> Scene: ...
def parse(text: str, settings: _Settings = None, file: _Path = "scene.toml") -> Scene: ...
def scenes() -> list[str]: ...
def table(reports: Iterable[StepReport]) -> pd.DataFrame: ...
def read_recording(path: _Path) -> Recording: ...
def read_series(path: _Path) -> pd.DataFrame: ...
def read_state(path: _Path) -> pd.DataFrame: ...
def read_summary(*paths: _Path) -> pd.DataFrame: ...

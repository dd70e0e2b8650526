"""Readers of what `sluice run` writes."""

import json
from pathlib import Path

from . import _sluice
from .simulation import pictures_of

Moment = _sluice.Moment


class Recording(_sluice.Recording):
    """A recording, as a sequence of moments."""

    def __getitem__(self, frame):
        if isinstance(frame, slice):
            return [self._moment(k) for k in range(*frame.indices(len(self)))]
        if not -len(self) <= frame < len(self):
            raise IndexError(f"frame {frame} of {len(self)}")
        return self._moment(frame % len(self))

    def __iter__(self):
        return (self._moment(k) for k in range(len(self)))

    def picture(self, frame, size=None, colour=None):
        """The picture of a moment, as Simulation.picture() draws it."""
        moment = self[frame]
        return pictures_of(self.scene, size, colour).draw(moment._snapshot, moment.report.dt)


def _table(self):
    """The particles of a moment as a pandas frame, with the columns of read_state()."""
    import pandas

    x, v = self.position, self.velocity
    columns = {"x": x[:, 0], "y": x[:, 1], "vx": v[:, 0], "vy": v[:, 1]}
    frame = pandas.DataFrame({**columns, "density": self.density, "pressure": self.pressure})
    frame.index.name = "id"
    return frame


Moment.table = _table


def read_recording(path):
    """Opens a file of `sluice run --record`: len(recording) moments, of which recording[k] is one."""
    return Recording(Path(path))


def _read_csv(path, index):
    import pandas

    return pandas.read_csv(path, index_col=index, float_precision="round_trip")


def read_series(path):
    """Reads a file of `sluice run --series`: a pandas frame with a row per step."""
    return _read_csv(path, "step")


def read_state(path):
    """Reads a file of `sluice run --state`: a pandas frame with a row per particle."""
    return _read_csv(path, "id")


def read_summary(*paths):
    """Reads files of `sluice run --summary`: a pandas frame with a row per file and a column per entry; those of
    sections are joined by points, such as seconds.total and settings.time.dt."""
    import pandas

    return pandas.json_normalize([json.loads(Path(path).read_text()) for path in paths])

"""Scenes, and the settings that are changed in them."""

import json
from collections.abc import Mapping
from pathlib import Path

from . import _sluice

Scene = _sluice.Scene


def _value(value):
    """A value as scene files have it."""
    if hasattr(value, "tolist"):  # numpy's
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(each) for each in value) + "]"
    return str(value) if isinstance(value, str) else repr(value)


def _overrides(settings):
    """Settings as the texts KEY=VALUE that the program takes with --set."""
    if settings is None:
        return []
    if isinstance(settings, Mapping):
        return [f"{key}={_value(value)}" for key, value in settings.items()]
    if isinstance(settings, str):
        return [settings]
    return list(settings)


def _folder():
    """The folder of the shipped scenes, if they were installed with this module."""
    here = Path(__file__).resolve()
    for folder in (here.parent / "scenes", *(above / "share/sluice/scenes" for above in here.parents)):
        if folder.is_dir():
            return folder
    return None


def load(scene, settings=None):
    """Loads a scene from a file, or by the name of one that ships with Sluice.

    `settings` change keys of it, as --set does: {"time.dt": 0.02, "pressure.method": "ssph"}, or ["time.dt=0.02"].
    Raises InputError with file, line, column, key and what was expected.
    """
    name = str(scene)
    folder = _folder()
    if folder and not Path(name).is_file() and (folder / f"{name}.toml").is_file():
        name = str(folder / f"{name}.toml")
    return _sluice._load(name, _overrides(settings))


def parse(text, settings=None, file="scene.toml"):
    """Loads a scene from the text of a scene file; `file` stands in messages."""
    return _sluice._parse(text, str(file), _overrides(settings))


def scenes():
    """Names of the scenes that ship with Sluice."""
    folder = _folder()
    installed = [file.stem for file in folder.glob("*.toml")] if folder else []
    return sorted({*_sluice._shipped_scenes(), *installed})


Scene.settings = property(lambda self: json.loads(self._settings), doc="Every key as run, sections as dictionaries.")
Scene.changed = lambda self, settings: self._changed(_overrides(settings))
Scene.changed.__doc__ = "The scene with more settings, after those that it was loaded with."

"""What the tests share: the program beside the module, and runs of it."""

import os
import subprocess
from pathlib import Path

import pytest
import sluice

PROGRAM = Path(os.environ.get("SLUICE_PROGRAM", Path(sluice.__file__).parents[2] / "sluice"))


@pytest.fixture
def run(tmp_path):
    """Runs the program in a folder of the test's own."""

    def run(*arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=tmp_path, check=True, capture_output=True, text=True)

    return run


@pytest.fixture
def small():
    """A scene of few particles."""
    return sluice.load("breaking_dam", {"time.duration": 1})

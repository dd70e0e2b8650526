"""The programs of docs/python.md run as they stand there."""

import re
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[2]
PROGRAMS = re.findall(r"^```python\n(.*?)^```", (SOURCE / "docs/python.md").read_text(), re.M | re.S)


@pytest.mark.parametrize("number", range(len(PROGRAMS)))
def test_a_program_of_the_page_runs(number, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scenes").symlink_to(SOURCE / "scenes")
    exec(compile(PROGRAMS[number], f"program {number + 1} of docs/python.md", "exec"), {"__name__": "__main__"})
    if "savefig" in PROGRAMS[number]:
        assert (tmp_path / "compression.png").stat().st_size > 10_000
    else:
        assert capsys.readouterr().out


def test_the_page_has_three_of_them():
    assert len(PROGRAMS) == 3
    assert all(len(program.strip().splitlines()) <= 10 for program in PROGRAMS[:2])

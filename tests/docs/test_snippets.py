"""The lines of docs/data-set.md for other languages: run where the language is, held to the schema anyway."""

import re
import shutil
import subprocess
from pathlib import Path

import h5py
import numpy as np
import pytest

from sailnet.dataset import open_dataset
from sailnet.mission.mission import Mission
from tests.paths import ROOT
from tests.small_datasets import undisturbed
from tests.tools import missing, needs

TRAJECTORY = 41
"""The one that the snippets read, counted from 0."""

TOLD = "".join(f"printf('%.17g ', {name}), printf('\\n')\n" for name in ("tau", "alpha", "jumps"))
"""What Octave is to print of that which it has read."""


def snippet(language: str) -> str:
    text = (ROOT / "docs" / "data-set.md").read_text("utf-8")
    (found,) = re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    return str(found)


@pytest.fixture
def folder(mission: Mission, tmp_path: Path) -> Path:
    """With the file that the page makes, of invented numbers."""
    undisturbed(mission, tmp_path / "small.h5", 50)
    return tmp_path


@pytest.mark.parametrize("language", ["matlab", "octave", "julia"])
def test_what_is_read_is_there(language: str, folder: Path) -> None:
    text = snippet(language)
    named = set(re.findall(r"\b(?:samples|trajectories)[/.]\w+", text))
    assert len(named) >= 4
    with h5py.File(folder / "small.h5") as file:
        for name in named:
            assert name.replace(".", "/") in file
        for name in re.findall(r"(?:'/', '|\(file, \")(\w+)", text):
            assert name in file.attrs
        assert "schema" not in text or file.attrs["schema"].decode() in text


@needs("docs", missing("octave"), "octave")
def test_octave_reads_what_was_written(folder: Path) -> None:
    done = subprocess.run(
        ["octave", "--norc", "--quiet", "--no-gui", "--eval", snippet("octave") + TOLD],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    tau, alpha, jumps = (np.array(line.split(), float) for line in done.stdout.strip().splitlines())
    with open_dataset(folder / "small.h5") as written:
        first, after = written.first_sample[[TRAJECTORY, TRAJECTORY + 1]]
        samples = written.read(["tau", "alpha"], first, after)
        flags = written.read_trajectories(["flags"])["flags"]
    assert np.array_equal(tau, samples["tau"])
    assert np.array_equal(alpha, samples["alpha"])
    assert np.array_equal(jumps, flags % 2)


if JULIA := shutil.which("julia"):  # Debian has none, so that without it there is nothing to skip or install

    def test_julia_runs_where_it_is(folder: Path) -> None:
        done = subprocess.run(
            [str(JULIA), "-e", snippet("julia")], cwd=folder, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr

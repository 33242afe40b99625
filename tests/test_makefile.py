"""Which steps ``make`` does again when a file has changed, in a copy where every step was done.

Which campaigns are flown again the campaigns know: tests/campaign.
"""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.paths import ROOT

DONE = (
    ".venv/.ready",
    "build/earth_mars/wide.h5",
    "build/earth_mars/wide/networks/trained",
    "build/earth_mars/wide/export/exported",
    "build/earth_mars/wide/bench.json",
)
"""What the steps leave, in order."""

STEPS = {
    "setup": "pip install",
    "dataset": "sailnet data ",
    "train": "sailnet select ",
    "export": "sailnet export ",
    "bench": "-m c_runtime.verification.bench ",
}
"""What tells each step among the commands that ``make`` says it would run."""


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All that the steps depend on, old, and what they leave, of one later moment."""
    folder = tmp_path_factory.mktemp("checkout")
    for name in ("sailnet", "data", "training", "export", "c_runtime"):
        left_out = shutil.ignore_patterns("__pycache__", "*.so", "*.safetensors", "*.onnx")
        shutil.copytree(ROOT / name, folder / name, ignore=left_out)
    for name in ("Makefile", "pyproject.toml", "constraints.txt", "setup.py"):
        shutil.copy(ROOT / name, folder)
    for path in folder.rglob("*"):
        os.utime(path, (1e9, 1e9))
    for name in DONE:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
        os.utime(folder / name, (1.1e9, 1.1e9))
    return folder


def again(copy: Path, *goals: str) -> set[str]:
    """The steps that would be done."""
    # A make that runs the tests passes its own options and variables on.
    plain = {name: value for name, value in os.environ.items() if not name.startswith(("MAKE", "MFLAGS"))}
    command = ["make", "--dry-run", *goals]
    done = subprocess.run(command, cwd=copy, env=plain, capture_output=True, text=True, check=True)
    return {step for step, told in STEPS.items() if told in done.stdout}


ALL = set(STEPS) - {"setup"}


@pytest.mark.parametrize(
    ("changed", "expected"),
    [
        ("sailnet/ocp/README.md", set()),
        ("sailnet/cli/command_line.py", set()),
        ("sailnet/report/page.py", set()),
        ("sailnet/artefacts/files.py", set()),
        ("sailnet/flight/closed_loop.py", set()),
        ("sailnet/guidance/steering.py", set()),
        ("c_runtime/simulation/plant/motion.c", {"setup"}),
        ("c_runtime/flight/sigmoid.inc", ALL - {"dataset"}),
        ("c_runtime/simulation/host/lanes.inc", ALL - {"dataset"}),
        ("export/to_c.py", ALL - {"dataset"}),
        ("c_runtime/verification/bench/timing.c", {"bench"}),
        ("training/layers.py", ALL - {"dataset"}),
        ("sailnet/networks/network.py", ALL - {"dataset"}),
        ("sailnet/physics/dynamics.py", ALL),
        ("sailnet/expert/shooting.py", ALL),
        ("sailnet/mission/mission.py", ALL),
        ("sailnet/mission/missions/earth_mars.toml", ALL),
        ("sailnet/mission/missions/earth_venus.toml", set()),
        ("sailnet/dataset/schema.py", ALL),
        ("data/domain.py", ALL),
    ],
)
def test_a_change_does_again_what_depends_on_it(copy: Path, changed: str, expected: set[str]) -> None:
    path = copy / changed
    assert path.exists()
    path.touch()
    try:
        assert again(copy, "bench") == expected
    finally:
        os.utime(path, (1e9, 1e9))


def test_a_mission_file_of_one_s_own_is_tracked_and_built_under_its_name(copy: Path, tmp_path: Path) -> None:
    mine = tmp_path / "mine.toml"
    mine.touch()
    os.utime(mine, (1e9, 1e9))
    done = [copy / name.replace("earth_mars", "mine") for name in DONE if "earth_mars" in name]
    for path in done:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
        os.utime(path, (1.1e9, 1.1e9))
    assert again(copy, "bench", f"MISSION={mine}") == set()
    os.utime(mine, (1.2e9, 1.2e9))
    assert again(copy, "bench", f"MISSION={mine}") == ALL
    # A quick one has a folder of its own.
    os.utime(mine, (1e9, 1e9))
    assert again(copy, "bench", f"MISSION={mine}", "SIZE=quick") == ALL

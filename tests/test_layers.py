"""Imports run down the floors that pyproject.toml lists, and one that runs up or aside is found."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.paths import ROOT

PACKAGES = ("sailnet", "data", "training", "export", "c_runtime", "benchmarks", "tests")


def lint_imports(folder: Path) -> subprocess.CompletedProcess[str]:
    program = Path(sys.executable).with_name("lint-imports")
    return subprocess.run(
        [program, "--no-cache", "--no-logo"], cwd=folder, capture_output=True, text=True, check=False
    )


def test_imports_run_down() -> None:
    done = lint_imports(ROOT)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The Python of the house, that tests may spoil and mend again."""
    folder = tmp_path_factory.mktemp("house")
    for package in PACKAGES:
        for source in (ROOT / package).rglob("*.py"):
            target = folder / source.relative_to(ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)
    shutil.copy(ROOT / "pyproject.toml", folder)
    return folder


@pytest.mark.slow
@pytest.mark.parametrize(
    ("module", "imported", "told"),
    [
        ("sailnet/physics/dynamics.py", "sailnet.cli", "sailnet.physics.dynamics -> sailnet.cli"),
        ("sailnet/expert/index.py", "sailnet.networks", "sailnet.expert.index -> sailnet.networks"),
        ("sailnet/errors.py", "export", "sailnet.errors -> export"),
        ("data/box.py", "training", "data.box -> training"),
        ("training/layers.py", "benchmarks", "training.layers -> benchmarks"),
        ("benchmarks/expert.py", "tests.reference", "benchmarks.expert -> tests.reference"),
    ],
)
def test_an_import_up_or_aside_is_found(copy: Path, module: str, imported: str, told: str) -> None:
    spoiled = copy / module
    before = spoiled.read_text()
    spoiled.write_text(f"{before}\nimport {imported}\n")
    try:
        done = lint_imports(copy)
    finally:
        spoiled.write_text(before)
    assert done.returncode == 1
    assert told in done.stdout


def test_a_folder_beside_the_floors_is_found(copy: Path) -> None:
    beside = copy / "sailnet" / "utils.py"
    beside.touch()
    try:
        done = lint_imports(copy)
    finally:
        beside.unlink()
    assert done.returncode == 1
    assert "sailnet.utils" in done.stdout

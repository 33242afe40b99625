"""Every example's README, run as it is written: a first output after at most five commands."""

import json
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from c_runtime.shared_library import find_compiler
from sailnet.cli.api.flight import fly
from sailnet.guidance.backends import exported_folder
from sailnet.mission.mission import load_mission
from tests.paths import ROOT
from tests.tools import missing, needs

EXAMPLES = ROOT / "examples"
START = (1.05, 0.15, 1.03)
"""Of every flight there."""

FLYING = (
    "bare_metal",
    "cfs_app",
    pytest.param("cpp", marks=needs("analyser", missing("g++"), "g++")),
)
APART = "basilisk"
"""Of other versions of packages than those of the tests: an environment of its own."""

NAMES = (
    *FLYING,
    "onnxruntime",
    "simulink",
    pytest.param("rust", marks=needs("analyser", missing("rustc"), "rustc")),
)


def commands(name: str) -> list[str]:
    """The commands of an example's README, in order."""
    text = (EXAMPLES / name / "README.md").read_text("utf-8")
    (block,) = re.findall(r"```sh\n(.*?)```", text, re.S)
    return [line for line in block.splitlines() if line.strip()]


def run(lines: list[str], folder: Path, path: str) -> str:
    """What a shell prints for the commands of a README, one after the other, in the root of a checkout."""
    environment = {
        name: value for name, value in os.environ.items() if name not in ("VIRTUAL_ENV", "PYTHONPATH")
    }
    environment["PATH"] = os.pathsep.join([path, environment["PATH"]])
    done = subprocess.run(
        ["bash", "-ec", "\n".join(lines)],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A copy of the examples, for what they build, beside the networks that one of them reads."""
    shutil.copytree(EXAMPLES, tmp_path / "examples")
    (tmp_path / "sailnet").mkdir()
    (tmp_path / "sailnet" / "shipped").symlink_to(ROOT / "sailnet" / "shipped")
    return tmp_path


def test_every_example_has_a_readme_that_leads_to_an_output_soon() -> None:
    folders = {path.name for path in EXAMPLES.iterdir() if path.is_dir()}
    assert folders == {name if isinstance(name, str) else str(name.values[0]) for name in (*NAMES, APART)}
    for name in folders:
        lines = commands(name)
        assert lines[0].startswith("pip install")
        assert len(lines) <= 5
        assert f"]({name}/README.md)" in (EXAMPLES / "README.md").read_text("utf-8")


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_the_readme_s_commands_run_as_written(name: str, checkout: Path) -> None:
    printed = run(commands(name)[1:], checkout, str(Path(sys.executable).parent))  # the package is installed
    assert printed.strip()


@pytest.mark.slow
@pytest.mark.parametrize("name", FLYING)
def test_the_flights_of_examples_are_the_plant_s(name: str, checkout: Path) -> None:
    last = run(commands(name)[1:], checkout, str(Path(sys.executable).parent)).splitlines()[-1]
    found = re.fullmatch(r"arrived after (\S+) TU: r (\S+) AU, u (\S+), v (\S+) AU/TU", last)
    assert found is not None, last
    flight = fly("earth_mars", START)
    expected = [flight.time_of_flight, *flight.flights.ends[0]]
    assert [float(number) for number in found.groups()] == pytest.approx(expected, abs=2e-4)


@pytest.mark.slow
def test_the_graph_s_command_is_that_of_sailnet(checkout: Path) -> None:
    path = str(Path(sys.executable).parent)
    printed = run(commands("onnxruntime")[1:], checkout, path)
    told = run(["sailnet guide 1.05 0.15 1.03 --law"], checkout, path)
    ours, theirs = (
        float(re.findall(r"(-?\d+\.\d+) (?:deg)", text)[0]) for text in (printed.replace("+", ""), told)
    )
    assert ours == pytest.approx(theirs, abs=1e-4)
    graph = "sailnet/shipped/earth_mars/guidance_f64.onnx"
    refused = subprocess.run(
        [sys.executable, "examples/onnxruntime/guide.py", graph, "1", "nan", "1"],
        cwd=checkout, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert refused.returncode == 1
    assert "three finite numbers" in refused.stderr


@pytest.mark.parametrize("flag", ["-DSAILNET_FLOAT64", "-USAILNET_FLOAT64"])
def test_what_only_matlab_can_build_is_read_by_a_compiler(flag: str) -> None:
    source = EXAMPLES / "simulink" / "sfun_sailnet.c"
    assert "Not built" in source.read_text("utf-8").splitlines()[0]
    # The last lines include MATLAB's own source; the functions that it calls are static and unused without.
    read = source.read_text("utf-8").split("#ifdef MATLAB_MEX_FILE")[0]
    folders = [f"-I{Path(__file__).parent}", f"-I{exported_folder(load_mission('earth_mars'))}"]
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function", "-fsyntax-only", flag]
    done = subprocess.run(
        [*find_compiler(), *flags, *folders, "-x", "c", "-"],
        input=read,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def bare_checkout(folder: Path, name: str) -> str:
    """Copies what is tracked into a folder, makes an environment with nothing in it, and returns its path."""
    tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True)
    for file in filter(None, tracked.stdout.split("\0")):
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / file, folder / file)
    environment = folder / f"environment-{name}"
    subprocess.run([sys.executable, "-m", "venv", str(environment)], check=True)
    return str(environment / "bin")


def names_by_install_line() -> dict[str, list[str]]:
    """Examples that need neither a further compiler nor other versions of packages."""
    lines: dict[str, list[str]] = {}
    for name in ("bare_metal", "cfs_app", "simulink", "onnxruntime"):
        lines.setdefault(commands(name)[0], []).append(name)
    return lines


@pytest.mark.long
@pytest.mark.install
@pytest.mark.parametrize("names", names_by_install_line().values(), ids=" ".join)
def test_from_nothing_to_a_first_output(names: list[str], tmp_path: Path) -> None:
    """In a clean checkout and an environment with nothing in it, `pip install` and all."""
    path = bare_checkout(tmp_path, "of-examples")
    run(commands(names[0])[:1], tmp_path, path)
    for name in names:
        assert run(commands(name)[1:], tmp_path, path).strip()


@pytest.fixture(scope="module")
def basilisk(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """A clean checkout, and the path of an environment with Basilisk."""
    folder = tmp_path_factory.mktemp(APART)
    path = bare_checkout(folder, APART)
    run(commands(APART)[:1], folder, path)
    return folder, path


@pytest.mark.long
@pytest.mark.install
def test_basilisk_flies_what_the_plant_does(basilisk: tuple[Path, str]) -> None:
    """Its commands end with an error unless every verdict is the plant's, and every end within 1e-6."""
    folder, path = basilisk
    assert run(commands(APART)[1:], folder, path).strip()


@pytest.mark.long
@pytest.mark.install
def test_a_sail_on_wheels_follows_the_guidance_in_basilisk(basilisk: tuple[Path, str]) -> None:
    folder, path = basilisk
    (command,) = (line for line in commands(APART) if "fly_attitude.py" in line)
    found = json.loads(run([f"{command} --json"], folder, path))
    point, wheels, planets, trimmed = list(found.values())[:4]
    for axis in "ruv":
        assert wheels[axis] == pytest.approx(point[axis], abs=3e-5)
        assert trimmed[axis] == pytest.approx(planets[axis], abs=1e-6)
    # It departs facing the Sun; until it has turned, light does not push along its way.
    assert wheels["v"] - point["v"] < -3e-6
    # The Earth, 3 degrees ahead, pulls for 0.1 TU, and is farther away at the end.
    pull = 0.1 * 3.0e-6 / math.radians(3.0) ** 2
    assert 0.5 * pull < planets["v"] - wheels["v"] < pull
    for flight in (wheels, planets, trimmed):
        assert flight["largest"] == pytest.approx(22.0, abs=0.1)
        assert flight["median"] < 0.03
        assert flight["calm"] < 0.3
        assert not flight["full"]
    # As much as the slew takes at its largest rate, 120 degrees in three hours, and no more.
    assert wheels["momentum"] == pytest.approx(1944.0 * math.radians(120.0) / 10_800.0, rel=0.1)
    assert trimmed["shift"] == pytest.approx(0.07, rel=0.3)
    assert 0.1 < found["untrimmed"]["full after [h]"] < 0.5

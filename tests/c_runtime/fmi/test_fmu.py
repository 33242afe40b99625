"""The FMU: valid, the shared library's flights bit for bit, saved and restored, and calm about misuse."""

import json
import subprocess
import zipfile
from dataclasses import fields
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.validation import validate_fmu

from c_runtime.fmi.write import headers, write_fmu
from c_runtime.shared_library import find_compiler
from sailnet.cli.command_line import main
from sailnet.errors import GuidanceError
from sailnet.flight.closed_loop import fly_recorded
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import exported_folder, load_guidance
from sailnet.guidance.interface import GuidanceStatus, Precision
from sailnet.mission.disturbances import disturbance_from
from sailnet.mission.mission import load_mission
from sailnet.physics.units import AU, AU_PER_TU, TU
from sailnet.workers.stages import NEEDS
from tests.c_runtime.fmi.flown import FmuGuidance, Unpacked

SHIPPED = ("earth_mars", "earth_mars_jpl", "earth_mars_nasa")
STATE = (1.05, 0.15, 1.03)


@pytest.fixture(scope="session")
def fmu(tmp_path_factory: pytest.TempPathFactory) -> Unpacked:
    return unpacked("earth_mars", "float64", tmp_path_factory.mktemp("fmu"))


def unpacked(name: str, precision: Precision, folder: Path) -> Unpacked:
    mission = load_mission(name)
    file = folder / f"{name}.fmu"
    write_fmu(mission, exported_folder(mission), precision, file)
    return Unpacked(file, folder / "unpacked")


@pytest.mark.slow
@pytest.mark.parametrize("precision", ["float64", "float32"])
@pytest.mark.parametrize("name", SHIPPED)
def test_fmpy_finds_no_fault(name: str, precision: Precision, tmp_path: Path) -> None:
    made = unpacked(name, precision, tmp_path)
    assert validate_fmu(str(tmp_path / f"{name}.fmu")) == []
    assert made.description.coSimulation.canGetAndSetFMUstate
    assert made.description.coSimulation.canSerializeFMUstate
    assert {made.variables[one].unit for one in ("r", "r_si", "u", "u_si")} == {"AU", "m", "AU/TU", "m/s"}
    assert not list((made.folder / "sources").glob("fmi3*.h"))  # they are the importing tool's


def test_units_say_what_they_are_in_si(fmu: Unpacked) -> None:
    factors = {unit.name: unit.baseUnit.factor for unit in fmu.description.unitDefinitions}
    assert (factors["AU"], factors["TU"], factors["AU/TU"], factors["m"]) == (AU, TU, AU_PER_TU, 1.0)
    for unit in fmu.description.unitDefinitions:
        for shown in unit.displayUnits:
            if shown.name in factors:
                np.testing.assert_allclose(
                    shown.factor * factors[shown.name], unit.baseUnit.factor, rtol=1e-14
                )


def flights_are_equal(name: str, precision: Precision, count: int, folder: Path) -> None:
    """The plant flown by the FMU and by the shared library: unknown sails, bad navigation, outages."""
    mission = load_mission(name)
    guidance = load_guidance(mission, precision=precision)
    given = {"beta_spread": 0.1, "r_noise": 1e-5, "outage_probability": 1e-3, "outage_duration": 0.03}
    disturbance = disturbance_from(given, mission.disturbance)
    starts = random_starts(mission, count, 7)
    by_fmu = FmuGuidance(unpacked(name, precision, folder), mission, guidance.beta_range)
    ours, history = fly_recorded(mission, guidance, starts, disturbance=disturbance)
    theirs, replay = fly_recorded(mission, by_fmu, starts, disturbance=disturbance)
    for field in fields(ours):
        np.testing.assert_array_equal(getattr(ours, field.name), getattr(theirs, field.name))
    for mine, other in zip(history, replay, strict=True):
        for field in fields(mine):
            np.testing.assert_array_equal(getattr(mine, field.name), getattr(other, field.name))
    assert ours.reckoned.sum() > 0


@pytest.mark.slow
@pytest.mark.parametrize(("name", "precision"), [("earth_mars", "float64"), ("earth_mars_jpl", "float32")])
def test_flights_are_those_of_the_shared_library(name: str, precision: Precision, tmp_path: Path) -> None:
    flights_are_equal(name, precision, 8, tmp_path)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", SHIPPED)
def test_a_hundred_flights_are_those_of_the_shared_library(name: str, tmp_path: Path) -> None:
    flights_are_equal(name, "float64", 100, tmp_path)


def outputs(fmu: Unpacked, one: fmpy.fmi3.FMU3Slave, states: np.ndarray, first: int) -> list[list[float]]:
    """What an instance makes of states, a period each."""
    names = fmu.references
    told = [names[name] for name in ("cone_angle", "beta_estimate", "time_to_go", "hold")]
    step = fmu.variables["period"].start
    rows = []
    for place, state in enumerate(states, first):
        one.setFloat64([names[name] for name in "ruv"], list(state))
        one.doStep(place * float(step) * TU, float(step) * TU)
        rows.append([*one.getFloat64(told), *one.getInt64([names["status"]])])
    return rows


def test_save_and_restore_in_mid_flight_change_nothing(fmu: Unpacked) -> None:
    mission = load_mission("earth_mars")
    disturbance = disturbance_from({"beta_bias": -0.1, "r_noise": 1e-5}, mission.disturbance)
    _, (history,) = fly_recorded(mission, load_guidance(mission), [STATE], disturbance=disturbance)
    states = history.seen[:200]
    one = fmu.flying()
    expected = outputs(fmu, fmu.flying("whole"), states, 0)
    assert outputs(fmu, one, states[:120], 0) == expected[:120]
    saved = one.getFMUState()
    stored = one.serializeFMUState(saved)
    for _ in range(2):
        assert outputs(fmu, one, states[120:], 120) == expected[120:]
        one.setFMUState(saved)
    other = fmu.instance("other")  # not initialised: the state says that it was
    restored = other.deserializeFMUState(stored)
    other.setFMUState(restored)
    assert outputs(fmu, other, states[120:], 120) == expected[120:]
    assert other.serializeFMUState(restored) == stored
    for state, owner in ((saved, one), (restored, other)):
        owner.freeFMUState(state)


def test_si_inputs_are_the_same_state(fmu: Unpacked) -> None:
    names = fmu.references
    in_au, in_si = fmu.flying("au"), fmu.instance("si")
    in_si.setBoolean([names["si"]], [True])
    in_si.enterInitializationMode()
    in_si.exitInitializationMode()
    in_au.setFloat64([names[name] for name in "ruv"], list(STATE))
    in_si.setFloat64(
        [names[f"{name}_si"] for name in "ruv"], [STATE[0] * AU, *np.multiply(STATE[1:], AU_PER_TU)]
    )
    told = [names[name] for name in ("cone_angle", "time_to_go", "time_to_go_si", "hold", "hold_si")]
    for one in (in_au, in_si):
        one.doStep(0.0, 0.005 * TU)
    found = [one.getFloat64(told) for one in (in_au, in_si)]
    np.testing.assert_allclose(found[0], found[1], rtol=1e-12)
    assert found[0][2] == pytest.approx(found[0][1] * TU, rel=1e-15)


def test_a_command_is_held_from_period_to_period(fmu: Unpacked) -> None:
    """Shorter steps lead to no more commands, and a step past the next one is not taken."""
    names = fmu.references
    one, period = fmu.flying(), 0.005 * TU
    states = [names[name] for name in "ruv"]
    one.setFloat64(states, list(STATE))
    one.doStep(0.0, period / 2)
    first = one.getFloat64([names["cone_angle"]])
    one.setFloat64(states, [1.3, 0.1, 0.9])
    one.doStep(period / 2, period / 2)
    assert one.getFloat64([names["cone_angle"]]) == first
    assert one.getFloat64([names["time"]]) == [period]
    with pytest.raises(FMICallException) as refused:
        one.doStep(period, 1.5 * period)
    assert refused.value.status == 2  # fmi3Discard: a shorter one will do
    one.doStep(period, period)
    assert one.getFloat64([names["cone_angle"]]) != first


def test_before_the_first_command_the_outputs_are_safe(fmu: Unpacked) -> None:
    names, one = fmu.references, fmu.flying()
    assert one.getInt64([names["status"]]) == [-1]
    assert one.getFloat64([names["cone_angle"], names["hold"]]) == [0.0, 0.0]
    assert one.getFloat64([names["time_to_go"]])[0] > 60.0


@pytest.mark.slow
def test_fmpy_simulates_it(tmp_path: Path) -> None:
    file = tmp_path / "again.fmu"
    mission = load_mission("earth_mars")
    write_fmu(mission, exported_folder(mission), "float64", file)
    found = fmpy.simulate_fmu(
        str(file), stop_time=0.02 * TU, output_interval=0.005 * TU, output=["cone_angle", "status"]
    )
    assert found["status"][0] == -1
    assert found["status"][1] == GuidanceStatus.OK
    # Its state was not moved: a sail of no force, for all that guidance can see.
    assert found["status"][-1] == GuidanceStatus.AT_LIMIT
    # The same files make the same archive.
    again = tmp_path / "third.fmu"
    write_fmu(mission, exported_folder(mission), "float64", again)
    assert file.read_bytes() == again.read_bytes()


def test_misuse_gets_a_status_and_touches_no_foreign_memory(fmu: Unpacked, tmp_path: Path) -> None:
    sources = fmu.folder / "sources"
    program = tmp_path / "misuse"
    flags = ["-std=c99", "-g", "-Wall", "-Wextra", "-Werror", "-Wno-unused-parameter", "-DSAILNET_FLOAT64"]
    sanitizers = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-fno-omit-frame-pointer"]
    command = [*find_compiler(), *flags, *sanitizers, f"-I{headers()}", f"-I{sources}", "-o", str(program)]
    inputs = [str(Path(__file__).with_name("misuse.c")), *map(str, sorted(sources.glob("*.c"))), "-lm"]
    compiled = subprocess.run([*command, *inputs], capture_output=True, text=True, check=False)
    assert compiled.returncode == 0, compiled.stderr
    done = subprocess.run([str(program)], capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.endswith("all as they should be\n")


@pytest.mark.slow
def test_the_command_writes_json_and_overwrites_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "mine.fmu"
    assert main(["fmu", str(file), "--mission", "earth_mars_jpl", "--precision", "float32", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["mission"], told["precision"]) == ("earth_mars_jpl", "float32")
    with zipfile.ZipFile(file) as archive:
        names = archive.namelist()
        assert {
            "modelDescription.xml",
            told["binary"],
            *(f"sources/{name}" for name in told["sources"]),
        } <= set(names)
        flown = archive.read("sources/sailnet_guidance.c")
    assert flown == (exported_folder(load_mission("earth_mars_jpl")) / "sailnet_guidance.c").read_bytes()
    before = file.read_bytes()
    assert main(["fmu", str(file)]) == 1
    assert "--overwrite" in capsys.readouterr().err
    assert file.read_bytes() == before
    assert main(["fmu", str(file), "--overwrite"]) == 0
    assert file.read_bytes() != before


def test_what_cannot_be_is_said_before_any_work(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    (own := tmp_path / "folder" / "own.toml").parent.mkdir()
    own.write_text("[sail]\nbeta = 0.12\n[transfer]\ntarget_radius = 0.9\n")
    elsewhere = str(exported_folder(load_mission("earth_mars_jpl")))
    for arguments, says in (
        ([str(tmp_path / "mine.zip")], "OUT.fmu"),
        ([str(tmp_path / "no" / "mine.fmu")], "a folder that is there"),
        ([str(tmp_path / "mine.fmu"), "--networks", elsewhere], "another mission than 'earth_mars'"),
        ([str(tmp_path / "mine.fmu"), "--mission", str(own)], "no networks are shipped"),
    ):
        assert main(["fmu", *arguments]) == 1
        assert says in capsys.readouterr().err
    monkeypatch.setitem(NEEDS, "fmi", ("no_such_package",))
    assert main(["fmu", str(tmp_path / "mine.fmu")]) == 1
    assert "no no_such_package here: pip install 'sailnet[fmi]'" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == [own.parent]


def test_a_damaged_flight_file_is_refused(tmp_path: Path) -> None:
    mission = load_mission("earth_mars")
    shipped = exported_folder(mission)
    for name in ("sailnet_guidance.c", "sailnet_guidance.h", "SHA256SUMS"):
        (tmp_path / name).write_bytes((shipped / name).read_bytes())
    with (tmp_path / "sailnet_guidance.c").open("a") as file:
        file.write("/* changed */\n")
    with pytest.raises(GuidanceError, match="damaged or was changed"):
        write_fmu(mission, tmp_path, "float64", tmp_path / "mine.fmu")
    assert not (tmp_path / "mine.fmu").exists()

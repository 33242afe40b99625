"""Processors in the loop in three dimensions, by an export that does not ship."""

import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest

from c_runtime.builds import BUILDS
from c_runtime.verification.targets import __main__ as command
from c_runtime.verification.targets.console import FlightComputer
from c_runtime.verification.targets.flown import Range, Sail
from c_runtime.verification.targets.machines import HOST
from c_runtime.verification.targets.measure import compile_plugin
from c_runtime.verification.targets.table import STACK_OF_STEERING
from sailnet.flight.closed_loop import fly_recorded
from sailnet.flight.starts import random_starts
from sailnet.guidance.exported_c import COMMAND_FIELDS
from sailnet.mission.disturbances import Disturbance
from tests.c_runtime.verification.test_flights import MISSION as IN_THE_PLANE
from tests.c_runtime.verification.test_targets import ANY_TARGET, needs_any_target
from tests.guidance.space_export import MISSION, CInSpace, export_c
from tests.pilots_in_space import lasting
from tests.random_networks import random_guidance_in_space

pytestmark = [pytest.mark.slow, needs_any_target]

PRECISION = next(iter(ANY_TARGET.precisions))
SHORT = (20, 80)
"""Periods of a flight that takes no long time over a console."""


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> CInSpace:
    return export_c(random_guidance_in_space(seed=3, mission=MISSION), tmp_path_factory.mktemp("space"))


@pytest.fixture(scope="module")
def start(exported: CInSpace) -> tuple[float, ...]:
    """From where random networks end a flight soon, if not at the target."""
    guidance = exported.guidance(BUILDS["f32" if PRECISION == "float32" else "f64"])
    starts = random_starts(MISSION, 400, 2)
    flights, _ = fly_recorded(lasting(0.5), guidance, starts)
    low, high = SHORT
    short = flights.stopped & (flights.periods > low) & (flights.periods < high)
    return tuple(starts[np.flatnonzero(short)[0]].tolist())


def test_a_processor_steers_by_the_host_s_bits(
    exported: CInSpace, start: tuple[float, ...], tmp_path: Path
) -> None:
    at = Range(Sail(start, Disturbance()), tmp_path, compile_plugin(tmp_path), exported.folder)
    one = at.fly(MISSION, ANY_TARGET, PRECISION, False)
    assert one.same_bits
    assert SHORT[0] < one.flown.flights.periods[0] == len(one.flown.bits) < SHORT[1]
    # Status and the members of a command: random networks turn the sail off the plane.
    told = np.array([bits[1:] for bits in one.flown.bits])
    assert told.shape[1] == len(COMMAND_FIELDS[5])
    assert (told[:, COMMAND_FIELDS[5].index("clock_angle")] != 0).any()
    assert one.flown.most is not None
    assert one.flown.mean is not None
    assert 2700 < one.flown.mean <= one.flown.most
    assert one.flown.stack is not None
    assert 100 < one.flown.stack <= STACK_OF_STEERING


def test_over_the_console_the_host_flies_as_the_shared_library(
    exported: CInSpace, start: tuple[float, ...], tmp_path: Path
) -> None:
    at = Range(Sail(start, Disturbance()), tmp_path, compile_plugin(tmp_path), exported.folder)
    flown = at._steered(MISSION, HOST, "float64", False)
    assert flown.most is None
    ours, _ = fly_recorded(MISSION, exported.guidance(BUILDS["f64"]), [start], disturbance=Disturbance())
    np.testing.assert_allclose(flown.flights.ends, ours.ends, rtol=0, atol=1e-12)
    assert flown.flights.periods == ours.periods


def test_the_command_counts_an_export(
    exported: CInSpace, start: tuple[float, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = ["--target", ANY_TARGET.name, "--mission", MISSION.name, "--exported", str(exported.folder)]
    where = ["--start", *map(repr, start), "--beta-bias", "0", "--build", str(tmp_path)]
    assert command.main(["fly", *options, *where]) == 1  # random networks do not arrive
    told = capsys.readouterr().out
    assert "bytes of stack reserved" in told
    assert "bit for bit the host's" in told
    rows = json.loads((tmp_path / "flights.json").read_text())["rows"]
    assert all(len(row["end"]) == 5 and row["stack"] > 100 and row["instructions"]["most"] for row in rows)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--mission", "nowhere"], "none of"),
        (["--exported", "there"], "name it with --mission"),
        (["--exported", "there", "--mission", "a", "--mission", "b"], "of one mission"),
        (["--exported", "there", "--mission", "a", "--table", "text.md"], "missions that ship"),
    ],
)
def test_what_has_no_flight_file_is_refused(
    options: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        command.main(["fly", *options])
    assert message in capsys.readouterr().err


def test_a_computer_answers_as_many_numbers_as_its_mission_has(tmp_path: Path) -> None:
    for mission, count in ((IN_THE_PLANE, 5), (MISSION, 7)):
        numbers = " ".join(["0"] * count)
        script = tmp_path / mission.name
        script.write_text(f"echo ready; read line; echo steering 0 {numbers}; read line; echo done")
        by_hand = dataclasses.replace(ANY_TARGET, emulator=("sh",))
        with FlightComputer(by_hand, script, "float64", None, mission.components) as computer:
            status, told = computer.steer([1.0] * mission.components, 0.005)
            computer.end()
        assert (status, len(told)) == (0, count)

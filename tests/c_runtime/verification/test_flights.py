"""Processors in the loop: the end of a flight by each, whole flights, and computers that misbehave."""

import dataclasses
import json
import re
from pathlib import Path

import numpy as np
import pytest

from c_runtime.verification.targets import __main__ as command
from c_runtime.verification.targets import console, fly
from c_runtime.verification.targets.build import TargetError
from c_runtime.verification.targets.console import FlightComputer
from c_runtime.verification.targets.flown import Flown, Range, Sail, Steered
from c_runtime.verification.targets.machines import HOST, TARGETS, Target
from c_runtime.verification.targets.measure import compile_plugin
from sailnet.flight.closed_loop import fly_recorded
from sailnet.guidance.backends import load_guidance
from sailnet.mission.disturbances import disturbance_from
from sailnet.mission.mission import load_mission
from tests.c_runtime.verification.test_targets import (
    ANY_TARGET,
    every_target,
    needs_any_target,
    needs_tools_of,
)

MISSION = load_mission("earth_mars")
WEAKER = disturbance_from({"beta_bias": fly.BETA_BIAS}, MISSION.disturbance)
LAST = 100
"""Periods of a flight that short ones consist of."""


@pytest.fixture(scope="module")
def late() -> Sail:
    """The state so many periods before the arrival."""
    _, (history,) = fly_recorded(
        MISSION, load_guidance(MISSION), [MISSION.departure_state], disturbance=WEAKER
    )
    r, u, v = history.ruv[-LAST].tolist()
    return Sail((r, u, v), WEAKER)


@pytest.fixture(scope="module")
def at(late: Sail, tmp_path_factory: pytest.TempPathFactory) -> Range:
    folder = tmp_path_factory.mktemp("flights")
    return Range(late, folder, compile_plugin(folder))


@every_target
def test_each_processor_flies_to_the_host_s_end(at: Range, target: Target) -> None:
    for precision in target.precisions:
        for contract in (False, True) if target.fuses else (False,):
            one = at.fly(MISSION, target, precision, contract)
            assert one.wrong == []
            assert one.same_bits or contract
            assert LAST - 5 < one.flown.flights.periods[0] == len(one.flown.bits) < LAST + 50
            assert one.flown.mean is not None
            assert one.flown.most is not None
            assert 2700 < one.flown.mean <= one.flown.most


@needs_tools_of(HOST)
def test_over_the_console_the_host_flies_as_the_shared_library(late: Sail, at: Range) -> None:
    flown = at._steered(MISSION, HOST, "float64", False)
    assert flown.most is None
    assert late.start is not None
    ours, _ = fly_recorded(MISSION, load_guidance(MISSION), [late.start], disturbance=WEAKER)
    np.testing.assert_allclose(flown.flights.ends, ours.ends, atol=1e-12)
    assert flown.flights.periods == ours.periods


@pytest.mark.exhaustive
@needs_any_target
def test_a_whole_flight_and_its_row(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = tmp_path / "text.md"
    text.write_text("before\n<!-- flights -->\nstale\n<!-- /flights -->\nafter\n")
    options = ["--target", ANY_TARGET.name, "--mission", "earth_mars_jpl", "--build", str(tmp_path)]
    assert command.main(["fly", *options, "--table", str(text)]) == 0
    rows = json.loads((tmp_path / "flights.json").read_text())["rows"]
    assert all(row["arrived"] and row["same_bits"] != row["fused"] for row in rows)
    written = [line for line in text.read_text().splitlines() if line.startswith(f"| {ANY_TARGET.title} |")]
    assert len(written) == len(rows)
    assert f"{rows[0]['instructions']['most']:,}" in written[0]
    assert "bit for bit" in written[0]
    flown = text.read_text()
    text.write_text("before\n<!-- flights -->\n<!-- /flights -->\nafter\n")
    assert command.main(["fly", "--build", str(tmp_path), "--reported", "--table", str(text)]) == 0
    assert text.read_text() == flown
    assert re.search(r"Written by `make targets-flights` on .*, \d{4}-", flown)
    assert "instructions a command" in capsys.readouterr().out


def test_a_flight_that_is_not_the_host_s_is_wrong(late: Sail) -> None:
    assert late.start is not None
    flights, _ = fly_recorded(MISSION, load_guidance(MISSION), [late.start], disturbance=WEAKER)
    host = Steered(flights, [[0, 1, 2]], None, None)
    same = Flown("earth_mars", HOST, "float64", False, host, host)
    assert same.wrong == []
    other = dataclasses.replace(same, flown=Steered(flights, [[0, 1, 3]], 1, 1.0))
    assert "bit for bit" in other.wrong[0]
    assert dataclasses.replace(other, contract=True).wrong == []
    moved = dataclasses.replace(flights, ends=flights.ends + 1e-6, arrived=np.array([False]))
    lost = dataclasses.replace(same, contract=True, flown=Steered(moved, host.bits, 1, 1.0))
    assert [text.split()[0] for text in lost.wrong] == ["does", "ends"]


@pytest.mark.parametrize(
    ("script", "message"),
    [
        ("exec sleep 20", "answered nothing within"),
        ("echo ready; echo fault; exit", "ended"),
        ("echo ready; read line; echo steering 0 12 nonsense; cat", "answered"),
        ("echo ready; read line; echo steering 0 1 2 3; cat", "answered"),
    ],
)
def test_a_computer_that_misbehaves_has_failed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str, message: str
) -> None:
    monkeypatch.setattr(console, "LONGEST", 0.5)
    target = dataclasses.replace(TARGETS[0], emulator=("sh", "-c", script))
    with pytest.raises(TargetError, match=message):
        steer_once(target, tmp_path / "program")


def steer_once(target: Target, program: Path) -> None:
    with FlightComputer(target, program, "float64", None) as computer:
        computer.steer((1.0, 0.0, 1.0), 0.005)
        computer.end()


def test_what_is_missing_is_named_and_a_text_without_marks_is_told_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    absent = dataclasses.replace(TARGETS[0], compiler="no-such-gcc", emulator=("sh",))
    monkeypatch.setattr(fly, "TARGETS", (absent,))
    assert command.main(["fly", "--build", str(tmp_path / "a"), "--require"]) == 1
    assert "no-such-gcc not found: apt-get install gcc-arm" in capsys.readouterr().out
    (tmp_path / "text.md").write_text("no marks")
    assert command.main(["fly", "--build", str(tmp_path / "b"), "--table", str(tmp_path / "text.md")]) == 1
    assert "<!-- flights -->" in capsys.readouterr().err
    assert not (tmp_path / "b").exists()

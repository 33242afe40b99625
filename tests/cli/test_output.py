"""What people are shown: every line with a name, every number with its unit."""

import json
import math
import subprocess
import sys
from pathlib import Path

import pytest

from sailnet.cli import evaluate, fly, guide, info, solve
from sailnet.cli.command_line import main
from sailnet.cli.output import NAME_WIDTH, Line, counted, over_flights, percent, printed, time


def shown(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, str]:
    """Names and values of the lines that a command prints."""
    assert main(arguments) == 0
    lines = [line for line in capsys.readouterr().out.splitlines() if not line.startswith("  ")]
    parts = [line.partition("  ") for line in lines]
    return {name: value.strip() for name, _, value in parts}


def test_a_command_is_told_in_degrees_and_days(capsys: pytest.CaptureFixture[str]) -> None:
    said = shown(capsys, "guide", "1.05", "0.15", "1.03")
    main(["guide", "1.05", "0.15", "1.03", "--json"])
    exact = json.loads(capsys.readouterr().out)
    assert said["cone angle"] == f"{math.degrees(exact['cone_angle']):.8g} deg"
    time_to_go, unit, days, word = said["time of flight still to go, as predicted"].split()
    assert (unit, word) == ("TU", "days)")
    assert float(time_to_go) == pytest.approx(exact["time_of_flight"], rel=1e-7)
    assert float(days[1:]) == pytest.approx(58.1324 * exact["time_of_flight"], rel=1e-5)


def test_an_optimum_is_told_with_its_units(capsys: pytest.CaptureFixture[str]) -> None:
    said = shown(capsys, "solve", "1", "0", "1")
    assert said["shortest time of flight"].startswith("7.01838")
    assert said["costates"].startswith("lambda_r -7.23")
    assert said["costates"].count("TU") == 3
    assert said["next fastest extremal that was found"] == "none"
    assert said["everything faster was looked for"] == "yes"


@pytest.mark.slow
def test_a_flight_says_why_it_is_shorter_than_the_shortest(capsys: pytest.CaptureFixture[str]) -> None:
    start = ("fly", "1.5241", "0", "0.81003")
    assert main(start) == 0
    told = capsys.readouterr()
    assert "of the sail assumed" in told.out
    assert "of the sail that flew" in told.out
    assert "ends on the target and not within 0.001 of it" in told.err


@pytest.mark.parametrize("command", [evaluate, fly, guide, info, solve])
def test_no_two_lines_have_the_same_name(command: object) -> None:
    names = [line.name for line in command.LINES.values()]  # type: ignore[attr-defined]
    assert len(set(names)) == len(names)
    assert max(map(len, names)) < NAME_WIDTH - 1


def test_spreads_are_tables_and_what_is_not_known_is_said() -> None:
    lines = {"late": Line("late", over_flights(percent)), "best": Line("best", time, "none")}
    text = printed({"late": {"mean": 0.01, "0.5": 0.002, "0.99": 0.03, "1": 0.5}, "best": None}, lines)
    assert [line.split() for line in text.splitlines()] == [
        ["late"],
        ["mean", "1", "%"],
        ["median", "0.2", "%"],
        ["of", "99", "%", "at", "most", "3", "%"],
        ["worst", "50", "%"],
        ["best", "none"],
    ]


@pytest.mark.slow
def test_a_reader_who_leaves_is_no_error(tmp_path: Path) -> None:
    """As of ``sailnet guide 1.05 0.15 1.03 | head -0``."""
    command = [sys.executable, "-m", "sailnet.cli", "guide", "1.05", "0.15", "1.03"]
    with (tmp_path / "said").open("w+") as said:
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=said) as process:
            assert process.stdout is not None
            process.stdout.close()
        said.seek(0)
        assert (process.returncode, said.read()) == (141, "")


def test_one_thing_is_told_in_the_singular() -> None:
    assert [counted("period")(number) for number in (0, 1, 2)] == ["0 periods", "1 period", "2 periods"]

"""The sailnet command: results, exit status, and nothing but JSON on stdout."""

import io
import json
import re
import subprocess
import sys
import warnings
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import asdict
from importlib import resources
from pathlib import Path
from typing import Any

import pytest

import sailnet.expert.fastest
import sailnet.expert.index
from sailnet.cli.command_line import main
from sailnet.physics.optics import OPTICS


def _run(*arguments: str) -> subprocess.CompletedProcess[str]:
    """As a process of its own would, but for the seconds that its imports take; it may raise nothing."""
    stdout, stderr = io.StringIO(), io.StringIO()
    with redirect_stdout(stdout), redirect_stderr(stderr):
        try:
            status = main(arguments)
        except SystemExit as stop:
            status = int(stop.code or 0)
    return subprocess.CompletedProcess(arguments, status, stdout.getvalue(), stderr.getvalue())


def _process(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "sailnet.cli", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)


@pytest.mark.slow
def test_a_process_prints_the_same_and_nothing_else() -> None:
    case = ("fly", "1.05", "0.15", "1.03", "--period", "0.02", "--json")
    here, there = _run(*case), _process(*case)
    assert (there.returncode, there.stdout, there.stderr) == (here.returncode, here.stdout, here.stderr)
    assert json.loads(there.stdout)["arrived"] is True


@pytest.mark.slow
def test_a_process_ends_with_the_status_and_the_reason() -> None:
    here, there = (run("fly", "1", "0", "1", "--period", "0") for run in (_run, _process))
    assert there.returncode == here.returncode == 1
    assert there.stdout == here.stdout == ""
    assert there.stderr == here.stderr
    assert "Traceback" not in there.stderr


def _json(*arguments: str) -> dict[str, Any]:
    done = _run(*arguments, "--json")
    assert done.returncode == 0, done.stderr
    parsed = json.loads(done.stdout)
    assert isinstance(parsed, dict)
    return parsed


def test_solve_prints_the_optimum() -> None:
    result = _json("solve", "1", "0", "1")
    assert set(result) == {
        "time_of_flight", "cone_angle", "costates", "jumps", "residual", "complete", "next_time_of_flight",
    }  # fmt: skip
    assert result["complete"] is True
    assert result["next_time_of_flight"] is None
    assert result["time_of_flight"] == pytest.approx(7.01838, abs=1e-5)
    assert result["costates"] == pytest.approx([-7.23123, -4.31783, -7.73808], abs=1e-4)
    assert result["jumps"] == 0
    assert result["residual"] <= 1e-9


@pytest.mark.slow
def test_solve_takes_another_sail_and_target() -> None:
    changes = ("--phi-max", "45", "--smoothing", "0")
    assert _json("solve", "1", "0", "1", *changes)["time_of_flight"] == pytest.approx(7.138440, abs=1e-6)
    both = ("--beta", "0.4", "--target-radius", "0.723", "--phi-max", "30", "--smoothing", "0")
    assert _json("solve", "1", "0", "1", *both)["time_of_flight"] == pytest.approx(3.908616, abs=1e-6)


@pytest.mark.slow
def test_solve_without_a_state_prints_the_nominal() -> None:
    result = _json("solve", "--mission", "earth_venus")
    assert result["state"] == [1.0, 0.0, 1.0]
    times = [result[f"{name}time_of_flight"] for name in ("unconstrained_", "constrained_", "")]
    assert times == pytest.approx([3.521272, 3.528815, 3.528958], abs=1e-6)


@pytest.mark.slow
def test_beyond_the_tested_range_solve_says_so_on_stderr() -> None:
    done = _run("solve", "1", "0", "1", "--phi-max", "90", "--smoothing", "0", "--beta", "0.45", "--json")
    assert done.stderr == "note: beta = 0.45 is outside the tested range, 0.05 to 0.4\n"
    assert json.loads(done.stdout)["residual"] <= 1e-9


GOLDEN = {("jpl", "60"): 7.43973307, ("nasa", "60"): 7.45629601, ("jpl", "89"): 7.43517375}
"""Optics, bound [deg] and time of flight [TU]: by DOP853 in Cartesian coordinates, the control minimised."""


@pytest.mark.slow
@pytest.mark.parametrize(("optics", "degrees"), GOLDEN)
def test_solve_takes_a_sail_that_is_not_ideal(optics: str, degrees: str) -> None:
    result = _json("solve", "1", "0", "1", "--optics", optics, "--phi-max", degrees)
    assert result["time_of_flight"] == pytest.approx(GOLDEN[optics, degrees], abs=1e-7)
    assert result["residual"] <= 1e-9
    assert result["complete"] is True


@pytest.mark.slow
@pytest.mark.parametrize("said", ['"nasa"', str(asdict(OPTICS["nasa"])).replace("'", "").replace(":", " =")])
def test_solve_takes_the_optics_of_a_mission_file(said: str, tmp_path: Path) -> None:
    path = _of_another_sail(said, tmp_path)
    found = _json("solve", "1", "0", "1", "--mission", str(path))
    assert found["time_of_flight"] == pytest.approx(GOLDEN["nasa", "60"], abs=1e-7)


def _of_another_sail(optics: str, folder: Path) -> Path:
    """A mission file, Earth to Mars but for its sail."""
    text = (resources.files("sailnet") / "mission" / "missions" / "earth_mars.toml").read_text()
    sail = re.sub(r"(?m)^smoothing = .*$", f"smoothing = 0.0\noptics = {optics}", text)
    assert sail != text
    path = folder / "another_sail.toml"
    path.write_text(sail)
    return path


@pytest.mark.parametrize(
    ("optics", "says"),
    [
        ('"mylar"', "optics must be one of ideal, jpl, nasa or a table, not 'mylar'"),
        ("{ reflectivity = 1.01 }", "reflectivity must be from 0 to 1, not 1.01"),
        ("{ front_emissivity = 0, back_emissivity = 0 }", "one of the emissivities must be above 0"),
        (
            "{ reflectivity = 0, front_emissivity = 0, back_lambertian = 1 }",
            "such a sail is not pushed away from the Sun",
        ),
        ("{ reflectivity = 0 }", "no law for such a sail: the heat that its back radiates"),
    ],
)
def test_optics_that_cannot_be_are_refused_before_any_work(
    optics: str, says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = _of_another_sail(optics, tmp_path)

    def work(*_: object, **__: object) -> None:
        raise AssertionError("there is nothing to solve")

    monkeypatch.setattr(sailnet.expert.fastest, "solve_states", work)
    done = _run("solve", "1", "0", "1", "--mission", str(path))
    assert (done.returncode, done.stdout) == (1, "")
    assert str(path) in done.stderr
    assert says in done.stderr


def test_the_smoothed_law_is_an_ideal_sail_s() -> None:
    done = _run("solve", "1", "0", "1", "--optics", "jpl", "--smoothing", "1e-3")
    assert done.returncode == 1
    assert "with other optics smoothing is 0" in done.stderr


@pytest.mark.slow
def test_solve_says_when_its_search_ended_early(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sailnet.expert.fastest, "build_index", sailnet.expert.index.build_index.__wrapped__)
    monkeypatch.setattr(sailnet.expert.index, "MOST", 2600)
    monkeypatch.setattr(sailnet.expert.fastest, "EFFORT", 1)
    done = _run("solve", "1.049", "0.0987", "0.9275", "--json")
    assert json.loads(done.stdout)["complete"] is False
    assert "may not be the fastest" in done.stderr


@pytest.mark.slow
def test_solve_reads_a_mission_file(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    shipped = (resources.files("sailnet") / "mission" / "missions" / "earth_mars.toml").read_text("utf-8")
    path.write_text(shipped.replace('"earth_mars"', '"mine"').replace("60.0", "45.0"))
    result = _json("solve", "1", "0", "1", "--mission", str(path), "--smoothing", "0")
    assert result["time_of_flight"] == pytest.approx(7.138440, abs=1e-6)


@pytest.mark.parametrize(
    ("state", "optimum"), [(("1", "0", "1"), 7.0181794), (("1.05", "0.15", "1.03"), 6.1552)]
)
def test_guide_prints_the_command_of_an_extremal(state: tuple[str, str, str], optimum: float) -> None:
    result = _json("guide", *state)
    assert set(result) == {"cone_angle", "time_of_flight", "status", "source"}
    assert (result["status"], result["source"]) == ("ok", "plan")
    assert result["time_of_flight"] == pytest.approx(optimum, abs=1e-3)
    assert abs(result["cone_angle"]) <= 1.0471975512


def test_guide_prints_the_command_of_the_networks_alone() -> None:
    result = _json("guide", "1.05", "0.15", "1.03", "--law")
    assert (result["status"], result["source"]) == ("ok", "networks")
    # Case 2 begins beside the starts that were learnt.
    assert result["time_of_flight"] == pytest.approx(6.1552, abs=0.1)
    assert abs(result["cone_angle"]) <= 1.0471975512


def test_where_no_extremal_passes_through_the_state_guide_prints_the_command_of_the_networks() -> None:
    """Nothing is known of a state without end."""
    plan, law = (_json("guide", "1e300", "0", "1", *options) for options in ((), ("--law",)))
    assert plan == law
    assert plan["source"] == "networks"


@pytest.mark.parametrize("deleted", ["tracker", "look-ahead", "look-ahead-home"])
def test_deleted_guidances_are_refused_with_those_that_there_are(
    deleted: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        main(["fly", "1", "0", "1", "--guidance", deleted])
    said = capsys.readouterr().err
    assert all(choice in said for choice in (deleted, "'networks'", "'expert'", "'expert-without-reserve'"))


def test_guide_looks_at_the_sail() -> None:
    times = [_json("guide", "1", "0", "1", "--beta", beta)["time_of_flight"] for beta in ("0.15", "0.19")]
    assert times[0] > times[1] + 0.3  # a stronger sail is there sooner


@pytest.mark.parametrize("number", ["-1e-3", "-0.05", "-5e-2"])
def test_negative_numbers_are_numbers(number: str) -> None:
    assert _json("guide", "1.2", number, "0.95")["status"] == "ok"


@pytest.mark.slow
def test_fly_reaches_the_target_with_every_back_end_and_layout() -> None:
    keys = {"arrived", "time_of_flight", "terminal_error", "max_cone_angle", "optimal_time_of_flight"}
    keys |= {"beta_error", "beta_estimate", "ending", "nearest_error", "terminal_error_km_mps"}
    keys |= {"max_attitude", "reversals", "command_slew_deg", "own_optimal_time_of_flight", "statuses"}
    ends = []
    for options in (("--backend", "onnx"), ("--layout", "host"), ()):
        result = _json("fly", "1", "0", "1", *options)
        assert set(result) == keys
        assert result["arrived"] is True
        assert result["ending"] == "stopped"
        assert set(result["statuses"]) == {"ok", "arrived"}
        assert max(result["terminal_error"]) < 1e-5
        assert result["beta_estimate"] == pytest.approx(0.16892, rel=1e-6)
        assert result["optimal_time_of_flight"] == pytest.approx(7.01838, abs=1e-5)
        assert result["own_optimal_time_of_flight"] == pytest.approx(7.01838, abs=1e-5)
        ends.append([*result["terminal_error"], result["time_of_flight"]])
    for other in ends[:2]:
        assert ends[2] == pytest.approx(other, abs=1e-9)
        assert ends[2] != other


def test_fly_counts_what_the_guidance_said() -> None:
    outages = ("--outage-probability", "0.01", "--seed", "3", "--period", "0.01")
    counts = _json("fly", "1", "0", "1", *outages)["statuses"]
    assert (counts["arrived"], counts["reckoned"] > 10, counts["ok"] > 500) == (1, True, True)
    assert _json("fly", "1", "0", "1", "--beta-bias", "-0.21")["statuses"]["at_limit"] > 500
    lines = _run("fly", "1", "0", "1", *outages).stdout.splitlines()
    assert ["reckoned", str(counts["reckoned"]), "periods"] in [line.split() for line in lines]


@pytest.mark.slow
def test_guide_asks_the_expert() -> None:
    command = _json("guide", "1.05", "0.15", "1.03", "--guidance", "expert")
    assert command["time_of_flight"] == pytest.approx(6.15517, abs=1e-5)
    assert (command["status"], command["source"]) == ("ok", "expert")


@pytest.mark.parametrize("option", [("--backend", "onnx"), ("--precision", "float32"), ("--networks", ".")])
def test_the_expert_takes_no_options_of_networks(
    option: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["guide", "1", "0", "1", "--guidance", "expert", *option]) == 1
    assert "needs no networks" in capsys.readouterr().err


@pytest.mark.slow
def test_evaluate_counts_arrivals_and_all_flights_against_the_optimum() -> None:
    """Of three whose optima are soon found."""
    result = _json("evaluate", "--flights", "3", "--seed", "34", "--period", "0.02")
    assert {
        "flights", "arrived", "success_share", "attitude_violations", "confidence_interval",
        "error_quantiles", "error_quantiles_km_mps", "time_above_own_optimum", "days_above_own_optimum",
        "first_approach", "reversals", "command_slew_deg", "command_rate_deg_per_hour",
        "attitude_beyond_bound", "arrived_attitude_kept", "outside_domain_periods", "beta_at_limit_periods",
    } <= set(result)  # fmt: skip
    assert result["flights"] == result["arrived"] == result["first_approach"] == 3
    assert result["own_optimum_unknown"] == 0
    above, days = result["time_above_own_optimum"], result["days_above_own_optimum"]
    assert 0.0 < above["0.5"] <= above["0.99"] <= above["1"] < 0.02
    assert 5.5 * 58.13 < days["mean"] / above["mean"] < 60.0 * 58.13
    raw, si = result["error_quantiles"]["1"], result["error_quantiles_km_mps"]["1"]
    assert si == pytest.approx([raw[0] * 149597870.7, raw[1] * 29784.69, raw[2] * 29784.69], rel=1e-6)
    assert result["attitude_violations"] == 0


def test_evaluate_can_leave_the_expert_alone() -> None:
    result = _json("evaluate", "--flights", "60", "--seed", "6", "--period", "0.05", "--without-optima")
    assert result["time_above_own_optimum"] is None
    assert result["reversals"]["1"] >= result["reversals"]["0.5"] >= 0.0
    assert result["flights"] == 60
    assert result["success_share"] == result["arrived"] / 60


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("solve", "nan", "0", "1"), "finite"),
        (("guide", "inf", "0", "1"), "finite"),
        (("guide", "-1", "0", "1"), "R > 0"),
        (("guide", "1", "0", "1", "--beta", "nan"), "beta from 0.135136 to 0.202704"),
        (("guide", "1", "0", "1", "--beta", "0.3"), "beta from 0.135136 to 0.202704"),
        (("fly", "1", "-inf", "1"), "finite"),
        (("solve", "1", "0", "1", "--mission", "earth_pluto"), "earth_mars"),
        (("solve", "1", "0"), "all of R U V"),
        (("solve", "1", "0", "1", "--phi-max", "95"), "sail.max_cone_angle = 95.0"),
        (("solve", "1", "0", "1", "--phi-max", "nan"), "sail.max_cone_angle = nan"),
        (("solve", "--beta", "-0.1"), "sail.beta = -0.1"),
        (("solve", "1", "0", "1", "--smoothing", "-1e-3"), "sail.smoothing = -0.001"),
        (("solve", "1", "0", "1", "--target-radius", "inf"), "transfer.target_radius = inf"),
        (("solve", "--target-radius", "1"), "on the target orbit already"),
        (("solve", "1", "0", "1", "--optics", "mirror"), "invalid choice: 'mirror' (choose from"),
        (("guide", "1", "0", "1", "--networks", "no/such/folder"), "no/such/folder"),
        (("fly", "1", "0", "1", "--beta-bias", "-2"), "bias"),
        (("fly", "1", "0", "1", "--period", "0"), "period"),
        (("fly", "1", "0", "1", "--period", "86400"), "the longest is 0.5 TU, 29 days"),
        (("evaluate", "--flights", "2", "--period", "0.51"), "Periods are in TU, of 5,022,643 s"),
        (("fly", "1", "0", "1", "--rate-limit", "-1"), "rate_limit must be from 0"),
        (("fly", "1", "0", "1", "--delay", "nan"), "delay must be a finite number"),
        (("fly", "1", "0", "1", "--optics", "mirror"), "jpl"),
        (
            ("evaluate", "--campaign", "law", "--guidance", "expert", "--precision", "both"),
            "computes in float64 alone",
        ),
        (("fly", "1", "0", "1", "--plot", "no/such/folder/x.html"), "no/such/folder is not"),
        (("optics", "ideal", "--output", "no/such/folder/x.html"), "no/such/folder is not"),
        (("info", "no.h5"), "cannot open data set no.h5: no such file or directory\n"),
        (("evaluate", "--workers", "0"), "0 is not a positive number"),
        (("evaluate", "--workers", "-1"), ": -1 is not a positive number"),
        (("evaluate", "--workers", "x"), "invalid count value: 'x'"),
        (("evaluate", "--flights", "2", "--output", "out"), "--output is for campaigns"),
        (("evaluate", "--restart", "--overwrite", "--optima", "x.h5"), "--restart, --overwrite, --optima is"),
        (("evaluate", "--campaign", "law", "--without-optima"), "put optima = 0 into the campaign's file"),
        (("evaluate", "--flights", "0"), "flights"),
        (("evaluate", "--flights", "-3"), "flights"),
    ],
)
def test_bad_input_is_explained(arguments: tuple[str, ...], says: str) -> None:
    done = _run(*arguments, "--json")
    assert done.returncode != 0
    assert done.stdout == ""
    assert says in done.stderr


@pytest.mark.slow
def test_a_state_too_far_off_to_compute_with_is_refused_in_words() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        done = _run("solve", "1e30", "0", "1")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("error: no extremal")


@pytest.mark.parametrize("state", [("1e300", "0", "1"), ("5", "3", "-7")])
def test_absurd_states_get_a_safe_command_and_say_so(state: tuple[str, str, str]) -> None:
    result = _json("guide", *state)
    assert result["status"] == "outside_domain"
    assert abs(result["cone_angle"]) <= 1.0471975512


def test_a_mission_file_with_an_unknown_key_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('schema = 1\nname = "mine"\ncolour = "red"\n')
    done = _run("solve", "1", "0", "1", "--mission", str(path))
    assert done.returncode != 0
    assert "colour" in done.stderr


@pytest.mark.parametrize("command", ["solve", "guide", "fly", "evaluate", "papers"])
def test_help_has_an_example(command: str) -> None:
    done = _run(command, "--help")
    assert done.returncode == 0
    assert f"sailnet {command}" in done.stdout
    assert "example" in done.stdout

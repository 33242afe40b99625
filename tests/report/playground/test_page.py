"""The page that flies, driven by mouse, finger and keys: what it says is what ``sailnet fly`` says."""

import json
import math
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from benchmarks.driven_browser import Tab, opened
from sailnet.cli import main
from sailnet.expert.fastest import solve
from sailnet.expert.optima import sample
from sailnet.mission.mission import Mission
from sailnet.physics.units import AU, DAY, TU
from sailnet.report.playground.page import playground_page, write_playground
from tests.in_a_page import guidance, many_states, native_library
from tests.tools import needs_browser

READY = 'document.getElementById("flight")?.dataset.ready === "yes"'
DRAWN = 2e-3
"""By how much the optimum that is drawn may be off [AU, rad]: a third of a pixel."""

MISSED = 4e-6
"""Of a plan that counts as solved, at most [AU, AU/TU]; of times [TU] likewise."""

INTERPOLATED = 2e-3
"""Of a shortest time between the stored values of beta, relative."""


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("page") / "playground.html"
    write_playground(path)
    return path


@pytest.fixture(scope="module")
def desk(written: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Tab]:
    """On a desktop; each test begins it anew."""
    with opened(written, tmp_path_factory.mktemp("profile")) as tab:
        yield tab


def anew(tab: Tab) -> Tab:
    """With everything as it was assumed."""
    tab.wait_for(READY)
    tab.click("#reset")
    tab.wait_for('document.getElementById("command").textContent === "sailnet fly 1 0 1"')
    return tab


def told(tab: Tab) -> dict[str, Any]:
    """What the page says of its flight."""
    tab.frame()
    said: dict[str, Any] = tab.evaluate('({...document.getElementById("flight").dataset})')
    return said


def flown_by_command(tab: Tab, capsys: pytest.CaptureFixture[str]) -> tuple[list[str], dict[str, Any]]:
    """The command that the page says repeats its flight, and what it prints."""
    command = shlex.split(tab.evaluate('document.getElementById("command").textContent'))
    assert command[:2] == ["sailnet", "fly"]
    capsys.readouterr()
    assert main([*command[1:], "--json"]) == 0
    result: dict[str, Any] = json.loads(capsys.readouterr().out)
    return command, result


def assert_same(said: dict[str, Any], result: dict[str, Any]) -> None:
    """The same flight, but for what a plan may miss: in a browser no multiply-add is fused."""
    assert (said["arrived"] == "yes") == result["arrived"]
    assert float(said["time"]) == pytest.approx(result["time_of_flight"], abs=MISSED)
    errors = [float(error) for error in said["errors"].split()]
    assert errors == pytest.approx(result["terminal_error"], abs=MISSED)
    assert int(said["reversals"]) == result["reversals"]
    assert float(said["estimate"]) == pytest.approx(result["beta_estimate"], abs=MISSED)
    assert int(said["periods"]) == sum(result["statuses"].values())


def test_it_is_one_file_with_nothing_from_elsewhere(written: Path) -> None:
    text = written.read_text("utf-8")
    assert "://" not in text.replace("http://www.w3.org/2000/svg", "")
    assert written.stat().st_size < 1_500_000
    assert playground_page() == text


@needs_browser()
@pytest.mark.slow
def test_dragged_and_disturbed_it_flies_as_the_command_does(
    desk: Tab, capsys: pytest.CaptureFixture[str]
) -> None:
    """The start by mouse, the noise by keys, another seed by its button."""
    tab = anew(desk)
    first = told(tab)
    tab.drag("#velocity", 4.0, -4.0)
    tab.drag("#position", 8.0, 0.0)
    tab.evaluate('document.getElementById("set-noise").focus()')
    tab.press("ArrowRight", 15)
    tab.evaluate('document.getElementById("set-bias").focus()')
    tab.press("ArrowLeft", 12)
    tab.click("#another")
    tab.click("#another")
    said = told(tab)
    command, result = flown_by_command(tab, capsys)
    r, u, v = map(float, command[2:5])
    assert r > 1.0
    assert u > 0.0
    assert v > 1.0
    assert command[5:] == ["--beta-bias", "-0.12", "--beta-noise", "0.15", "--seed", "2"]
    assert_same(said, result)
    assert said["time"] != first["time"]
    assert float(said["best"]) == pytest.approx(result["own_optimal_time_of_flight"], rel=INTERPOLATED)
    shown = tab.evaluate('document.getElementById("flown-time").textContent')
    days = result["time_of_flight"] * TU / DAY
    assert shown == f"{result['time_of_flight']:.3f} TU, {days:.0f} days"
    kilometres = tab.evaluate('document.getElementById("error-r").textContent').removesuffix(" km")
    assert float(kilometres.replace(",", "")) == pytest.approx(
        result["terminal_error"][0] * AU / 1e3, rel=5e-3
    )


@needs_browser()
@pytest.mark.slow
def test_keys_alone_do_everything(written: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """From the first Tab on; optics, delay and period too."""
    with opened(written, tmp_path) as tab:
        tab.wait_for(READY)
        said = told_by_keys(tab)
        command, result = flown_by_command(tab, capsys)
    assert command[2:] == ["1.07", "0.04", "1.02", "--optics", "jpl", "--delay", "0.006", "--period", "0.01"]
    assert_same(said, result)


def told_by_keys(tab: Tab) -> dict[str, Any]:
    """Another start, another sail and another guidance, without a mouse."""
    tab.press("Tab")
    assert tab.evaluate("document.activeElement.id") == "position"
    tab.press("ArrowUp", 1, shift=True)
    tab.press("ArrowRight", 2)
    tab.press("Tab")
    assert tab.evaluate("document.activeElement.id") == "velocity"
    tab.press("ArrowUp", 3)
    tab.press("ArrowRight", 4)
    tab.press("Tab", 3)
    assert tab.evaluate("document.activeElement.id") == "set-v"
    tab.press("ArrowLeft", 1)
    tab.evaluate('document.getElementById("set-optics").focus()')
    tab.press("ArrowDown")
    tab.evaluate('document.getElementById("set-delay").focus()')
    tab.press("ArrowRight", 3)
    tab.press("Tab")
    assert tab.evaluate("document.activeElement.id") == "set-period"
    tab.press("ArrowRight", 1)
    return told(tab)


@needs_browser()
@pytest.mark.slow
def test_a_finger_drags_on_a_phone_and_everything_fits(
    written: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with opened(written, tmp_path, width=390, height=844, phone=True, dark=True) as tab:
        tab.wait_for(READY)
        tab.drag("#velocity", 4.0, 6.0, finger=True)
        said = told(tab)
        _, result = flown_by_command(tab, capsys)
        assert float(tab.evaluate('document.getElementById("set-v").value')) < 1.0
        assert_same(said, result)
        assert tab.evaluate("document.documentElement.scrollWidth") == 390
        assert tab.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(18, 24, 29)"


@needs_browser()
@pytest.mark.slow
def test_commands_in_the_browser_are_the_native_ones_to_the_bit(
    desk: Tab, mission: Mission, tmp_path: Path
) -> None:
    native, states = native_library(tmp_path), many_states(mission)
    desk.wait_for(READY)
    text = json.dumps([[str(number) for number in state] for state in states.tolist()])
    text = text.replace('"inf"', '"Infinity"').replace('"-inf"', '"-Infinity"').replace('"nan"', '"NaN"')
    desk.evaluate(f"globalThis.asked = {text}, 0")
    said = desk.evaluate(
        """(async () => {
          const text = document.getElementById("module").textContent;
          const machine = await startMachine(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)));
          const bits = (number) => new BigUint64Array(new Float64Array([number]).buffer)[0].toString(16);
          return asked.map((state) => {
            const { status, ...command } = machine.guidance(...state.map(Number));
            return Object.values(command).map(bits).join(" ");
          });
        })()"""
    )
    expected = []
    for state in states:
        command, _ = guidance(native, state)
        expected.append(" ".join(f"{bits:x}" for bits in np.frombuffer(command, np.uint64)))
    assert len(said) == 10_000
    assert said == expected


@needs_browser()
@pytest.mark.slow
@pytest.mark.parametrize(
    "start", [(1.0, 0.0, 1.0), (1.05, 0.15, 1.03), (1.1, 0.18, 0.93), (1.13, 0.07, 0.84)]
)
def test_the_optimum_that_is_drawn_is_the_experts(
    desk: Tab, mission: Mission, start: tuple[float, float, float]
) -> None:
    desk.wait_for(READY)
    drawn = desk.evaluate(
        f"""(async () => {{
          const stored = JSON.parse(document.getElementById("content").textContent).optima;
          const optima = await openOptima(stored, extremal);
          return {{ ...optima.trajectory({list(start)}), best: optima.time({list(start)}, 1) }};
        }})()"""
    )
    optimum = solve(mission.problem, start)
    assert drawn["best"] == pytest.approx(optimum.time_of_flight, rel=3e-5)
    times, columns = sample(mission.problem, optimum, 2001)
    r = np.interp(drawn["time"], times, columns[:, 0])
    np.testing.assert_allclose(drawn["r"], r, rtol=0, atol=DRAWN)
    angle = np.concatenate([[0.0], np.cumsum(np.diff(times) * (columns[:, 2] / columns[:, 0])[:-1])])
    np.testing.assert_allclose(drawn["theta"], np.interp(drawn["time"], times, angle), rtol=0, atol=3 * DRAWN)
    cone = np.interp(drawn["time"], times, columns[:, 6])
    off = np.abs(np.array(drawn["cone_angle"]) - cone)
    assert np.mean(off > math.radians(1.0)) < 0.01  # but for the jump itself


@needs_browser()
def test_a_link_opens_what_it_says(written: Path, tmp_path: Path) -> None:
    linked = tmp_path / "linked.html"
    text = written.read_text("utf-8")
    place = '<script type="application/json" id="content">'
    linked.write_text(
        text.replace(place, f'<script>location.hash = "r=1.1&noise=0.2&seed=7&u=x"</script>{place}')
    )
    with opened(linked, tmp_path / "profile") as tab:
        tab.wait_for(READY)
        said = tab.evaluate('document.getElementById("command").textContent')
        assert said == "sailnet fly 1.1 0 1 --beta-noise 0.2 --seed 7"

"""The flight file as WebAssembly: commands of the native build to the bit, flights to what libm rounds."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from c_runtime.builds import BATCH
from c_runtime.shared_library import CompilerError
from c_runtime.web_assembly import BUILD, compile_module, main, sources_digest
from sailnet.flight.closed_loop import fly
from sailnet.flight.plant import rules
from sailnet.guidance.backends import load_guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.optics import OPTICS
from sailnet.report.playground.module import MODULE, module
from tests.in_a_page import (
    EXPORTED,
    InWasmtime,
    Machine,
    flown,
    guidance,
    layout,
    many_states,
    native_library,
    text_at,
)
from tests.tools import needs_playground

STARTS = [(1.0, 0.0, 1.0), (1.05, 0.15, 1.03), (1.1, 0.18, 0.93), (1.12, 0.04, 0.86)]
NEAR = 10
"""Guidance periods before the end."""
ROUNDED = 1e-5
"""In each number of a whole flight: what elementary functions are rounded differently by, grown."""
OF_ANGLES = 0.02
"""In cone angles [rad]: towards arrival that of a plan depends more and more on what is left."""


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Machine:
    return native_library(tmp_path_factory.mktemp("native"))


@pytest.fixture(scope="module")
def page() -> Machine:
    return InWasmtime(module())


def test_what_ships_is_of_these_sources() -> None:
    """Needs no compiler: the module carries the digest of what it was made of."""
    digest = sources_digest(EXPORTED)
    assert digest.encode() in MODULE.read_bytes(), "python -m c_runtime.web_assembly"
    assert (EXPORTED / BATCH).is_file()


@pytest.mark.slow
def test_the_library_beside_it_is_flown_like_the_plant(native: Machine, mission: Mission) -> None:
    """Natively the functions of a page add nothing: the flights are those of ``sailnet fly``."""
    law = load_guidance(mission)
    disturbance = Disturbance(beta_bias=-0.12, beta_noise=0.15, delay=0.013, seed=3)
    given = rules(mission, disturbance, 0.005, law.beta_range)
    for start in STARTS:
        sail, records = flown(native, given, start)
        flight = fly(mission, law, [start], disturbance=disturbance)
        np.testing.assert_allclose(sail["time"], flight.time_of_flight[0], rtol=0, atol=ROUNDED)
        ends = [sail["state"][name] for name in "ruv"]
        np.testing.assert_allclose(ends, flight.ends[0], rtol=0, atol=ROUNDED)
        assert len(records) == flight.periods[0]


@pytest.mark.slow
def test_a_delay_that_does_not_fit_is_refused(native: Machine, mission: Mission) -> None:
    law = load_guidance(mission)
    given = rules(mission, Disturbance(delay=5.0), 0.001, law.beta_range)
    native.put(native.call("rules"), given.tobytes())
    assert native.call("depart", 1.0, 0.0, 1.0) == 0


@needs_playground()
def test_what_ships_is_what_the_compiler_makes(tmp_path: Path) -> None:
    assert compile_module(EXPORTED) == MODULE.read_bytes(), "python -m c_runtime.web_assembly"
    broken = tmp_path / "exported"
    broken.mkdir()
    for name in (BUILD.source, BATCH, "sailnet_batch.h", "sailnet_guidance.h"):
        (broken / name).write_bytes((EXPORTED / name).read_bytes())
    (broken / BUILD.source).write_text("#error on purpose\n")
    with pytest.raises(CompilerError, match="on purpose"):
        compile_module(broken)


@pytest.mark.slow
@needs_playground()
def test_structures_look_as_they_do_here(page: Machine, native: Machine) -> None:
    assert layout(page) == layout(native)
    assert all(layout(page).values())
    assert text_at(page, "sources_digest") == sources_digest(EXPORTED)


@pytest.mark.slow
@needs_playground()
def test_commands_are_the_native_ones_to_the_bit(page: Machine, native: Machine, mission: Mission) -> None:
    """From inside and outside the trained domain, at the target, and from what are no states."""
    states = many_states(mission)
    assert len(states) == 10_000
    different = [state.tolist() for state in states if guidance(page, state) != guidance(native, state)]
    assert different == []
    statuses = {guidance(page, state)[1] for state in states}
    assert statuses == {0, 1, 2, 3}


@pytest.mark.slow
@needs_playground()
@pytest.mark.parametrize(
    "disturbance",
    [
        Disturbance(),
        Disturbance(beta_bias=-0.12, beta_noise=0.15, seed=3),
        Disturbance(beta_bias=0.1, delay=0.023, seed=2**40 + 1),
        Disturbance(r_noise=1e-5, u_noise=1e-5, v_noise=1e-5, beta_wander=0.03, seed=5),
    ],
    ids=["nominal", "noise", "late", "navigation"],
)
@pytest.mark.parametrize("optics", ["ideal", "nasa"])
def test_flights_are_the_native_ones(
    page: Machine, native: Machine, mission: Mission, disturbance: Disturbance, optics: str
) -> None:
    law = load_guidance(mission)
    given = rules(mission, replace(disturbance, optics=OPTICS[optics]), 0.005, law.beta_range)
    drawn = np.random.default_rng(1).uniform(*mission.generalisation.corners, (6, 3))
    for start in [*STARTS, *map(tuple, drawn.tolist())]:
        sail, records = flown(page, given, start)
        expected, recorded = flown(native, given, start)
        # Near the target rounding decides whether a new plan converges in a period.
        alike = slice(min(len(records), len(recorded)) - NEAR)
        assert abs(len(records) - len(recorded)) <= NEAR
        np.testing.assert_array_equal(records["status"][alike], recorded["status"][alike])
        for name in ("time", "r", "theta", "u", "v", "beta_estimate", "cone_angle"):
            atol = OF_ANGLES if name == "cone_angle" else ROUNDED
            of_page, of_native = records[name][alike], recorded[name][alike]
            np.testing.assert_allclose(of_page, of_native, rtol=0, atol=atol, err_msg=name)
        assert abs(int(sail["reversals"]) - int(expected["reversals"])) <= 1
        if not disturbance.beta_wander:  # the uniform draws are exact
            np.testing.assert_array_equal(records["beta"][alike], recorded["beta"][alike])


def test_the_command_says_what_is_missing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("c_runtime.web_assembly.find_spec", lambda _name: None)
    monkeypatch.setattr("sys.argv", ["web_assembly"])
    assert main() == 1
    assert "pip install 'sailnet[playground]'" in capsys.readouterr().err

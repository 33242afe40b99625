"""What steering learns of a sail: its beta, and the force along its surface; and when it learns nothing."""

from collections.abc import Callable
from typing import Any, get_args

import numpy as np
import pytest

from sailnet.errors import GuidanceError
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.interface import Precision, Steering
from sailnet.guidance.rules import RULES
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.sections import Degradation
from sailnet.physics.dynamics import runge_kutta_step
from sailnet.physics.optics import OPTICS, Optics
from tests.conftest import Exported
from tests.guidance.pilots import ONE, PERIOD, Told, departed, with_slew_rate
from tests.held_angle import hold_angle
from tests.held_command import hold_command
from tests.lockstep import memory_type
from tests.pilots import MISSION

BETA = MISSION.sail.beta


@pytest.mark.parametrize("angle", [0.9, 0.5, -0.5, -0.9])
@pytest.mark.parametrize("tangential", [0.1, -0.05])
def test_a_force_along_the_surface_is_found_on_either_side(angle: float, tangential: float) -> None:
    told = Told(cone_angle=angle)
    steering, state = ReferenceSteering(told, 1), departed()
    for _ in range(600):
        steered = steering.steer(state[[0, 2, 3]].T, PERIOD, ONE)
        state = runge_kutta_step(state, steered.cone_angle, 1.05 * BETA, PERIOD, tangential)
    assert steering._memory.tangential[0] == pytest.approx(tangential, rel=0.03)
    assert steered.beta[0] == pytest.approx(1.05 * BETA, rel=2e-3)
    # The networks are asked for a weaker sail where that force weakens it, and for no stronger one.
    lost = RULES.tangential_loss * max(tangential, 0.0)
    assert told.asked[-1] / steered.beta[0] == pytest.approx(1.0 - lost, abs=5e-3)


@pytest.mark.parametrize("precision", get_args(Precision))
def test_the_shipped_c_finds_the_force_along_the_surface(precision: Precision) -> None:
    guidance = load_guidance(MISSION, "c", precision)
    assert isinstance(guidance, CGuidance)
    steering, state = guidance.steering(1), departed()
    for _ in range(1000):
        steered = steering.steer(state[[0, 2, 3]].T, 0.005, ONE)
        state = runge_kutta_step(state, steered.cone_angle, 0.97 * BETA, 0.005, 0.08)
    found = steering.memories.view(memory_type(precision, MISSION))["estimate"]["tangential"].item()
    assert found == pytest.approx(0.08, rel=0.03)
    assert steered.beta[0] == pytest.approx(0.97 * BETA, rel=2e-3)


def estimates_of(steering: Steering, memory: Callable[[], Any], sail: str, periods: int) -> Any:
    """What is learnt of a sail of the mission's beta with these optics, flown undisturbed by the plant's C.

    Its attitude is measured: however fast its commands change, it is known.
    """
    state, attitude = departed(), None
    for _ in range(periods):
        steered = steering.steer(state[[0, 2, 3]].T, 0.005, ONE, attitude)
        attitude = steered.cone_angle
        state = hold_angle(state, BETA, attitude, 0.005, OPTICS[sail].force)[:4]
    return memory()


@pytest.mark.parametrize(("angle", "sail"), [(0.9, "jpl"), (-0.6, "jpl"), (0.9, "nasa"), (0.3, "ideal")])
def test_what_a_sail_does_by_its_mission_s_optics_is_no_surprise(angle: float, sail: str) -> None:
    told = Told(cone_angle=angle)
    told.mission = MISSION.with_optics(OPTICS[sail])
    steering = ReferenceSteering(told, 1)
    known = estimates_of(steering, lambda: steering._memory, sail, 300)
    assert known.beta[0] == pytest.approx(BETA, rel=1e-9)
    assert known.tangential[0] == pytest.approx(0.0, abs=1e-8)
    assert known.variance[0] < 1e-15


@pytest.mark.parametrize("optics", [OPTICS["ideal"], OPTICS["jpl"], Optics(0.8, 0.3, front_lambertian=0.9)])
@pytest.mark.parametrize("angle", [0.4, -1.0])
def test_a_period_says_what_beta_is_whatever_the_optics(optics: Optics, angle: float) -> None:
    told = Told(cone_angle=angle)
    told.mission = MISSION.with_optics(optics)
    steering, state = ReferenceSteering(told, 1), departed()
    steering.steer(state[[0, 2, 3]].T, 1e-3, ONE)
    state = hold_angle(state, 1.06 * BETA, angle, 1e-3, optics.force)[:4]
    steered = steering.steer(state[[0, 2, 3]].T, 1e-3, ONE)
    assert steered.beta[0] / BETA == pytest.approx(1.06, abs=4e-5)


def test_what_a_sail_does_by_other_optics_surprises() -> None:
    """To an ideal sail's constants JPL's are a force along the surface, and a little less of beta."""
    steering = ReferenceSteering(Told(cone_angle=0.9), 1)
    unknown = estimates_of(steering, lambda: steering._memory, "jpl", 600)
    square, linear, across = OPTICS["jpl"].force
    weaker = square + linear / np.cos(0.9)
    assert unknown.beta[0] / BETA == pytest.approx(weaker, rel=1e-5)
    assert unknown.beta[0] / BETA < 0.998
    assert unknown.tangential[0] == pytest.approx(across / weaker, rel=0.03)


@pytest.mark.parametrize("precision", get_args(Precision))
def test_the_exported_c_knows_the_optics_of_its_mission(
    jpl_exported: Exported, approach_exported: Exported, precision: Precision
) -> None:
    """In float the surprise is what rounding leaves of a change of speed in a period."""
    found = []
    for made in (jpl_exported, approach_exported):
        guidance = load_guidance(made.networks.mission, "c", precision, made.folder)
        assert isinstance(guidance, CGuidance)
        steering = guidance.steering(1)
        packed = memory_type(precision, guidance.mission)
        if guidance.mission.degradation.loss > 0.0:
            steering.memories.view(packed)["estimate"]["worn"] = 1.0  # it will not age any more
        memory = estimates_of(steering, lambda: steering.memories.view(packed)["estimate"][0], "jpl", 300)  # noqa: B023
        found.append((abs(memory["beta"].item() / BETA - 1.0), abs(memory["tangential"].item())))
    (beta, tangential), (_, unknown) = found
    assert beta < (1e-9 if precision == "float64" else 2e-5)
    assert tangential < (1e-9 if precision == "float64" else 1e-4)
    assert unknown > 0.02


@pytest.mark.parametrize(("slew_rate", "waits"), [(MISSION.flight.slew_rate, False), (1.0, True)])
def test_nothing_is_learnt_while_the_sail_turns(slew_rate: float, waits: bool) -> None:
    """The command steps every ten periods; a slow sail is still turning in the first of them."""
    told = Told()
    told.mission = with_slew_rate(slew_rate)
    turn, rate = 0.35, told.mission.flight.turn_rate
    steering, state = ReferenceSteering(told, 1), departed()
    learnt, expected, estimate = [], [], BETA
    for k in range(60):
        told.cone_angle = 0.3 + turn * (k // 10 % 2)
        steered = steering.steer(state[[0, 2, 3]].T, PERIOD, ONE)
        learnt.append(bool(steered.beta[0] != estimate))
        estimate = steered.beta[0]
        # The period that ended began so many after the step: for so long the sail still turned then.
        left = max(turn / rate - (k - 1) % 10 * PERIOD, 0.0) if k > 10 else 0.0
        expected.append(k > 0 and rate * left**2 <= RULES.slew_blur * PERIOD)
        state = hold_command(state, steered.cone_angle, 1.1 * BETA, PERIOD)
    assert learnt == expected
    assert (sum(learnt) < 55) == waits


def test_an_edge_on_sail_says_nothing() -> None:
    told = Told(cone_angle=1.5)
    steering, state = ReferenceSteering(told, 1), departed()
    for _ in range(10):
        assert steering.steer(state[[0, 2, 3]].T, PERIOD, ONE).beta[0] == BETA
        state = hold_command(state, 1.5, 1.1 * BETA, PERIOD)


@pytest.mark.parametrize("kind", ["reference", "c"])
def test_a_sail_that_is_measured_to_be_askew_is_made_right(kind: str) -> None:
    guidance = load_guidance(MISSION, "c")
    assert isinstance(guidance, CGuidance)
    askew, state = 0.08, departed()
    steering = guidance.steering(1) if kind == "c" else ReferenceSteering(guidance, 1)
    blind = ReferenceSteering(guidance, 1)
    attitude = np.full(1, np.nan)
    for _ in range(60):
        shown = state[[0, 2, 3]].T
        steered = steering.steer(shown, PERIOD, ONE, attitude)
        unaware = blind.steer(shown, PERIOD, ONE)
        attitude = steered.cone_angle + askew
        state = hold_command(state, attitude, BETA, PERIOD)
    if isinstance(steering, ReferenceSteering):
        memory = steering._memory
        found, wanted = memory.offset[0], memory.cone_angle[0]
    else:
        estimate = steering.memories.view(memory_type("float64", MISSION))["estimate"][0, 0]
        found, wanted = estimate["offset"], estimate["cone_angle"]
    assert found == pytest.approx(askew, rel=1e-6)
    assert attitude[0] == pytest.approx(wanted, abs=1e-6)
    assert steered.beta[0] == pytest.approx(BETA, rel=1e-6)
    assert abs(unaware.beta[0] / BETA - 1.0) > 1e-5


def test_a_sail_that_lags_is_neither_askew_nor_of_another_force() -> None:
    """It turns from bound to bound and back, for ten periods each."""
    told, state, turn = Told(), departed(), 0.12
    steering, blind = ReferenceSteering(told, 1), ReferenceSteering(told, 1)
    attitude = measured = None
    for k in range(200):
        told.cone_angle = 0.9 if k // 50 % 2 else -0.9
        shown = state[[0, 2, 3]].T
        steered = steering.steer(shown, PERIOD, ONE, measured)
        unaware = blind.steer(shown, PERIOD, ONE)
        attitude = told.cone_angle if attitude is None else attitude
        after = attitude + np.clip(told.cone_angle - attitude, -turn, turn)
        measured = np.array([0.5 * (attitude + after)])
        state, attitude = hold_command(state, measured, BETA, PERIOD), after
    assert steered.beta[0] == pytest.approx(BETA, rel=1e-4)
    assert abs(unaware.beta[0] / BETA - 1.0) > 0.02
    assert abs(steered.cone_angle[0] - 0.9) < 0.01


@pytest.mark.parametrize("attitudes", [[0.1, 0.2], [[0.1]], ["askew"]])
def test_attitudes_of_another_shape_are_refused(attitudes: object) -> None:
    guidance = load_guidance(MISSION, "c")
    for steering in (guidance.steering(1), ReferenceSteering(guidance, 1)):
        with pytest.raises(GuidanceError, match="attitudes"):
            steering.steer(departed()[[0, 2, 3]].T, PERIOD, ONE, attitudes)  # type: ignore[arg-type]


def test_what_is_known_of_a_sail_s_age_is_what_sunlight_took() -> None:
    """Half of what it takes in the end by each dose; so the estimate falls, where nothing else is learnt."""
    told, radius, periods = Told(cone_angle=0.5), 1.2, 400
    loss, dose = 0.2, 1.5
    told.mission = MISSION.model_copy(update={"degradation": Degradation(loss=loss, dose=dose)})
    steering = ReferenceSteering(told, 1)
    for _ in range(periods):
        # Between what is seen there are gaps, so that nothing is learnt.
        steering._memory.unseen[:] = PERIOD
        steered = steering.steer([(radius, 0.0, 0.9)], PERIOD, ONE)
    halvings = (periods - 1) * PERIOD / radius**2 / dose
    worn = 1.0 - 0.5**halvings
    assert 0.3 < worn < 0.8
    assert steering._memory.worn[0] == pytest.approx(worn, rel=1e-3)
    assert steered.beta[0] == pytest.approx(BETA * (1.0 - loss * worn), rel=1e-3)
    # It is planned with a sail that is older by a part of the time to go.
    ahead = RULES.foresight * told.time_of_flight / (radius * MISSION.problem.target_radius) / dose
    later = 1.0 - 0.5 ** (halvings + ahead)
    assert told.asked[-1] == pytest.approx(BETA * (1.0 - loss * later), rel=1e-3)
    assert told.asked[-1] < steered.beta[0] * 0.998

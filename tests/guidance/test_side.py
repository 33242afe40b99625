"""Where both signs of the cone angle are almost equally fast the sail keeps its side."""

import numpy as np
import pytest

from sailnet.campaign.printed import CASES
from sailnet.expert.optima import Extremal, sample
from sailnet.flight.closed_loop import fly
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.rules import EXPERT_RULES, LOOK_AHEAD_RULES, PLAIN, RULES
from sailnet.guidance.steering import ReferenceSteering
from sailnet.physics.optics import OPTICS
from sailnet.physics.transfer import Transfer
from tests.guidance.pilots import ONE, PERIOD, Told
from tests.held_angle import hold_angle
from tests.pilots import MISSION

ANGLE, RADIUS = 0.8, 1.2
PATIENCE = RULES.patience(MISSION.problem.phi_max, MISSION.flight.turn_rate)


@pytest.mark.parametrize("period", [0.001, 0.002, 0.005, 0.01, 0.02])
def test_the_papers_case_2_reverses_at_most_twice(
    jumping: Extremal, problem: Transfer, period: float
) -> None:
    flight = fly(MISSION, load_guidance(MISSION), [CASES["Case 2"]], period=period)
    assert flight.arrived[0]
    # The optimum jumps once; this start lies beside the training data, where networks may reverse once more.
    assert flight.reversals[0] in (1, 2)
    assert flight.command_slew[0] <= 1.2 * optimal_slew(problem, jumping)


def optimal_slew(problem: Transfer, extremal: Extremal) -> float:
    """By how much the optimum turns the sail, its jump and all [rad]."""
    _, columns = sample(problem, extremal, 4001)
    return float(abs(np.diff(columns[-1])).sum())


def signs(
    wanted: list[float], lambda_v: float, optics: str = "ideal", patience: float | None = None
) -> list[float]:
    """Of the commands of a sail that stands still, told to have its cone angle on these sides.

    ``patience``: the largest, as its mission says it.
    """
    told = Told(lambda_v=lambda_v)
    flight = MISSION.flight.model_copy(update={"largest_patience": patience})
    told.mission = MISSION.with_optics(OPTICS[optics]).model_copy(update={"flight": flight})
    steering = ReferenceSteering(told, 1)
    flown = []
    for sign in wanted:
        told.cone_angle = sign * ANGLE
        steered = steering.steer([(RADIUS, 0.0, 0.9)], PERIOD, ONE)
        assert abs(steered.cone_angle[0]) == ANGLE
        flown.append(float(np.sign(steered.cone_angle[0])))
    return flown


def loss_of(lambda_v: float, optics: str = "ideal") -> float:
    """Time that a period on the other side costs [TU]: the difference of the Hamiltonian.

    By how much the plant, held on one side and on the other, differs after a moment in v.
    """
    moment, beta = 1e-6, MISSION.sail.beta
    state = np.array([[RADIUS], [0.0], [0.0], [0.9]])
    force = OPTICS[optics].force
    ends = [hold_angle(state, beta, side * ANGLE, moment, force)[3, 0] for side in (1.0, -1.0)]
    costate = lambda_v * MISSION.problem.target_radius**2 / beta
    return float(PERIOD * costate * (ends[0] - ends[1]) / moment)


def test_the_loss_of_an_ideal_sail_is_the_formula() -> None:
    ratio = MISSION.problem.target_radius / RADIUS
    expected = PERIOD * 2.0 * ratio**2 * np.cos(ANGLE) ** 2 * np.sin(ANGLE)
    assert loss_of(1.0) == pytest.approx(expected, rel=1e-6)
    # Of what pushes a real sail across the Sun line less is left.
    assert loss_of(1.0, "jpl") < 0.92 * expected


def test_a_sign_that_flips_where_it_costs_nothing_never_reverses() -> None:
    assert signs([(-1.0) ** k for k in range(200)], lambda_v=1e-3) == [1.0] * 200


@pytest.mark.parametrize("optics", ["ideal", "jpl", "nasa"])
@pytest.mark.parametrize("periods", [1, 3, 20])
def test_a_sail_reverses_when_staying_has_cost_what_patience_allows(periods: int, optics: str) -> None:
    # So large that in as many periods it is reached, and in one fewer is not.
    lambda_v = PATIENCE / (periods - 0.5) / loss_of(1.0, optics)
    flown = signs([1.0] * 5 + [-1.0] * 40, lambda_v, optics)
    assert flown == [1.0] * (5 + periods) + [-1.0] * (40 - periods)


@pytest.mark.parametrize(("said", "allowed"), [(None, PATIENCE), (1e-3, 1e-3), (0.09, 0.09)])
def test_a_mission_may_say_how_patient_the_law_is(said: float | None, allowed: float) -> None:
    """But it never waits for more than a reversal takes, which is less than the third."""
    takes = 2.0 * MISSION.problem.phi_max / MISSION.flight.turn_rate
    patience = min(allowed, takes)
    for periods in (3, 20):
        lambda_v = patience / (periods - 0.5) / loss_of(1.0)
        flown = signs([1.0] * 5 + [-1.0] * 40, lambda_v, patience=said)
        assert flown == [1.0] * (5 + periods) + [-1.0] * (40 - periods)


def test_what_staying_cost_is_forgotten_as_the_networks_come_round() -> None:
    """A period on the wanted side makes good for one on the other."""
    lambda_v = PATIENCE / 2.5 / loss_of(1.0)
    assert signs([1.0, -1.0, -1.0, 1.0, 1.0] * 10, lambda_v) == [1.0] * 50
    assert signs([1.0, -1.0, -1.0, -1.0, -1.0], lambda_v)[-1] == -1.0


def test_a_guidance_that_does_not_know_what_the_other_side_costs_gets_its_way() -> None:
    wanted = [(-1.0) ** (k // 3) for k in range(30)]
    assert signs(wanted, np.inf) == wanted


def test_a_small_step_across_zero_is_no_reversal() -> None:
    told = Told(lambda_v=1e-3)
    steering = ReferenceSteering(told, 1)
    for angle in (0.3 * RULES.reversal, -0.3 * RULES.reversal, 0.3 * RULES.reversal):
        told.cone_angle = angle
        assert steering.steer([(RADIUS, 0.0, 0.9)], PERIOD, ONE).cone_angle[0] == angle


def of_a_late_sail(reversals: int, tau: list[float], **said: float) -> list[int]:
    """Periods between reversals, asked for in every period, of a sail whose time to go is this, then this.

    ``said``: of the flight, by its mission.
    """
    told = Told(lambda_v=1e3)
    flight = MISSION.flight.model_copy(update=said)
    told.mission = MISSION.model_copy(update={"flight": flight})
    steering, turned = ReferenceSteering(told, 1), []
    before = told.cone_angle
    for period in range(4000):
        told.cone_angle, told.time_of_flight = -before, tau[period % len(tau)]
        angle = steering.steer([(RADIUS, 0.0, 0.9)], PERIOD, ONE).cone_angle[0]
        if angle * before < 0.0:
            turned.append(period)
            before = angle
        if len(turned) > reversals:
            return np.diff(turned).tolist()
    raise AssertionError(f"reversed {len(turned)} times only")


def test_a_sail_that_is_not_late_reverses_as_often_as_it_is_worth_it() -> None:
    falls = [20.0 - PERIOD * k for k in range(4000)]
    assert of_a_late_sail(100, falls) == [2] * 100


@pytest.mark.slow
def test_a_sail_that_is_late_waits_after_every_other_reversal() -> None:
    # The time to go never falls: late by the period each, less what is forgotten.
    waits = of_a_late_sail(60, [1.0])
    first = next(i for i, wait in enumerate(waits) if wait > 2)
    assert sum(waits[:first]) * PERIOD <= RULES.late_tolerated * 1.2
    assert waits[first] * PERIOD >= 0.9 * RULES.wait * RULES.late_tolerated
    longest = round(RULES.largest_wait / PERIOD)
    assert sorted(waits[-20:]) == pytest.approx([2] * 10 + [longest] * 10, abs=1)
    assert all(min(pair) == 2 for pair in zip(waits[-20:], waits[-19:], strict=False))


@pytest.mark.slow
def test_a_wait_is_some_times_as_long_as_the_sail_is_late() -> None:
    """It falls by half of what passes: late is half the time over which that is forgotten, in the end."""
    late = 0.5 * RULES.late_memory
    alternating = [20.0 - 0.5 * PERIOD * k for k in range(4000)]
    waits = of_a_late_sail(60, alternating)
    assert max(waits[-20:]) * PERIOD == pytest.approx(min(RULES.wait * late, RULES.largest_wait), rel=0.02)


@pytest.mark.slow
@pytest.mark.parametrize(("time_to_go", "waits"), [(3.0, True), (4.1, False)])
def test_who_lost_less_than_a_share_of_his_time_to_go_does_not_wait(time_to_go: float, waits: bool) -> None:
    """The time to go never falls: late is the time over which that is forgotten, in the end, 0.5 TU."""
    assert RULES.late_memory == 0.5
    turned = of_a_late_sail(80, [time_to_go], late_share=0.125)
    assert (max(turned) > 2) == waits


@pytest.mark.parametrize("missed", [40, 41, 47])
def test_after_a_miss_the_next_reversal_waits_for_a_share_of_an_orbit(missed: int) -> None:
    """The time to go falls as time passes, but for one leap, by which the sail is late."""
    tau = [20.0 + (period >= missed) - PERIOD * period for period in range(4000)]
    share = 0.6180339887498949 * missed % 1.0
    wait = share * 0.5 * 2.0 * np.pi * MISSION.transfer.target_radius**1.5
    turned = of_a_late_sail(missed // 2 + 3, tau, missed_wait=0.5)
    waits = [(first, time) for first, time in enumerate(turned) if time > 2]
    assert waits[0][0] == pytest.approx(missed / 2, abs=1)
    assert waits[0][1] * PERIOD == pytest.approx(wait, abs=2 * PERIOD)
    assert turned[waits[0][0] + 1] == 2  # the reversal after it has no wait
    without = [time for time in of_a_late_sail(missed // 2 + 3, tau) if time > 2]
    assert without[0] * PERIOD == pytest.approx(RULES.largest_wait, abs=4 * PERIOD)


def test_who_gets_no_nearer_beside_a_far_target_has_missed_it() -> None:
    """The time to go never falls: the sail grows late little by little, and once by more than the share."""
    turned = of_a_late_sail(80, [3.0], late_share=0.125, missed_wait=0.5)
    assert sum(time * PERIOD > 1.2 * RULES.largest_wait for time in turned) == 1
    turned = of_a_late_sail(80, [4.1], late_share=0.125, missed_wait=0.5)
    assert max(turned) == 2


def test_who_was_late_before_has_missed_nothing_anew() -> None:
    """The time to go never falls, so that the sail grows late once and stays so."""
    turned = of_a_late_sail(40, [1.0], missed_wait=0.5)
    longest = round(RULES.largest_wait / PERIOD)
    assert sorted(turned[-20:]) == pytest.approx([2] * 10 + [longest] * 10, abs=1)


def test_rules_without_a_wait_never_wait() -> None:
    """The plain law, the look-ahead and the expert without a reserve take every turn at once."""
    for rules in (PLAIN, *LOOK_AHEAD_RULES.values(), EXPERT_RULES["expert-without-reserve"]):
        assert (rules.largest_patience, rules.largest_wait) == (0.0, 0.0)

"""The expert's optima against two methods that share nothing with it but the problem.

A direct method (tests.direct), started from crude guesses, says which transfer is fastest, to its
discretisation; its multipliers start forward indirect shooting (tests.forward_shooting), which makes
that transfer exact. Neither ever sees an answer of sailnet.
"""

import math
from functools import cache

import numpy as np
import pytest

from sailnet.expert.fastest import solve
from sailnet.expert.nominal import solve_nominal
from sailnet.expert.optima import Extremal
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.transfer import Transfer
from tests.direct import Direct, State, minimise
from tests.forward_shooting import Forward, shoot_forward

NOMINALS: dict[str, tuple[str, dict[str, float], float]] = {
    "venus": ("earth_venus", {}, 3.528815054),
    "mercury": ("earth_mercury", {}, 4.566856799),
    "ceres": ("earth_ceres", {}, 22.646304622),
    "mars at 45 degrees": ("earth_mars", {"max_cone_angle": 45.0}, 7.138440399),
    "mars at 75 degrees": ("earth_mars", {"max_cone_angle": 75.0}, 7.012041176),
    "mars with beta 0.1": ("earth_mars", {"beta": 0.1}, 8.689062184),
    # The homotopy's branch ends in a fold at 33.09 degrees; at 33.1 another one is faster already.
    "mercury at 33.1 degrees": ("earth_mercury", {"max_cone_angle": 33.1}, 5.106781012),
    "mercury at 30 degrees": ("earth_mercury", {"max_cone_angle": 30.0}, 5.391831473),
}
"""Mission, its changes, and the time of flight for delta = 0 that both methods agreed on."""

STATES = {
    # Far out and back, past 2 AU: the expert's longest flights are the ones to doubt.
    (1.0, 0.0, 1.2): 11.084313435,
    (1.1, 0.05, 0.81): 9.106860262,
    (1.02, 0.03, 1.1): 6.538290033,
}


@cache
def direct(transfer: Transfer, state: State) -> Direct:
    return minimise(transfer, state)


@cache
def forward(transfer: Transfer, state: State) -> Forward:
    crude = direct(transfer, state)
    return shoot_forward(transfer, state, crude.costates, crude.time_of_flight)


def exact(name: str, **changes: float) -> Mission:
    return load_mission(name).with_overrides(smoothing=0.0, **changes)


def confirm(transfer: Transfer, found: Extremal, golden: float) -> None:
    state = (float(found.state[0]), float(found.state[1]), float(found.state[2]))
    crude, refined = direct(transfer, state), forward(transfer, state)
    # The fastest of all, from above; and several starts of the direct method agree on it.
    assert 0.0 < crude.time_of_flight / found.time_of_flight - 1.0 < 1e-3
    assert crude.agreeing >= 3
    # The same transfer, not only the same time.
    assert refined.error < 1e-10
    assert refined.time_of_flight == pytest.approx(golden, abs=1e-8)
    assert found.time_of_flight == pytest.approx(refined.time_of_flight, abs=1e-8)
    np.testing.assert_allclose(found.costates, refined.costates, rtol=1e-6, atol=1e-6)


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.long) if name == "ceres" else name for name in NOMINALS]
)
def test_the_nominal_is_the_fastest_transfer(name: str) -> None:
    title, changes, golden = NOMINALS[name]
    mission = exact(title, **changes)
    nominal = solve_nominal(mission)
    assert nominal.constrained.residual < 1e-9
    confirm(mission.problem, nominal.constrained, golden)


@pytest.mark.exhaustive
@pytest.mark.parametrize("state", STATES)
def test_the_expert_s_transfer_is_the_fastest(state: State) -> None:
    transfer = exact("earth_mars").problem
    confirm(transfer, solve(transfer, state), STATES[state])


@pytest.mark.exhaustive
def test_the_longest_flights_are_the_fastest_too() -> None:
    """Too long for forward shooting from a direct solution's multipliers."""
    transfer, state = exact("earth_mars").problem, (1.12, 0.09, 1.15)
    crude = direct(transfer, state)
    assert crude.agreeing >= 3
    assert 0.0 < crude.time_of_flight / solve(transfer, state).time_of_flight - 1.0 < 1e-3


@pytest.mark.exhaustive
def test_the_direct_method_hardly_uses_what_the_relaxation_allows() -> None:
    """The best flight is one a sail can make: no side between -1 and 1 but where the angle jumps."""
    found = direct(exact("earth_mars").problem, (1.0, 0.0, 1.2))
    lost = (1.0 - np.abs(found.side)) * np.sin(found.alpha) * np.cos(found.alpha) ** 2
    assert (lost > 0.01).sum() <= 2


@pytest.mark.exhaustive
@pytest.mark.parametrize("state", [(1.0, 0.0, 1.0), (1.0, 0.0, 1.2)])
def test_the_independent_methods_can_disagree(state: State) -> None:
    """A problem that is off by half a percent in beta is told apart, so that agreement means something."""
    transfer = Transfer(0.16892, math.pi / 3, 0.0, 1.524)
    other = Transfer(0.16892 * 1.005, math.pi / 3, 0.0, 1.524)
    assert not 0.0 < direct(other, state).time_of_flight / solve(transfer, state).time_of_flight - 1.0 < 1e-3

"""The expert's optima in three dimensions against a direct method that shares the problem alone."""

import dataclasses
import math

import numpy as np
import pytest

from sailnet.expert.fastest_in_space import solve
from sailnet.physics.optics import OPTICS
from sailnet.physics.transfer import Transfer
from tests.direct_in_space import minimise

EXACT = Transfer(0.16892, math.radians(60.0), 0.0, 1.524)
NODE = (1.0, 0.0, 0.0, math.cos(math.radians(1.85)), math.sin(math.radians(1.85)))
STARTS = [NODE, (1.08, 0.05, 0.06, 0.92, -0.03), (1.02, -0.03, 0.03, 1.1, -0.045)]


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    "state", [STARTS[0], *(pytest.param(state, marks=pytest.mark.long) for state in STARTS[1:])]
)
def test_the_expert_s_transfer_is_the_fastest(state: tuple[float, ...]) -> None:
    found, crude = solve(EXACT, state), minimise(EXACT, np.array(state))
    # Constant controls in every interval are a little slower.
    assert 0.0 < crude.time_of_flight / found.time_of_flight - 1.0 < 1e-3
    assert crude.agreeing >= 2


@pytest.mark.long
def test_of_a_sail_that_is_not_ideal_too() -> None:
    real = dataclasses.replace(EXACT, optics=OPTICS["jpl"])
    found, crude = solve(real, NODE), minimise(real, np.array(NODE))
    assert 0.0 < crude.time_of_flight / found.time_of_flight - 1.0 < 1e-3


@pytest.mark.long
def test_the_methods_can_disagree() -> None:
    """Half a percent of beta, or a tenth of the inclination, is told apart: agreement means something."""
    found = solve(EXACT, NODE).time_of_flight
    other = dataclasses.replace(EXACT, beta=EXACT.beta * 1.005)
    assert not 0.0 < minimise(other, np.array(NODE)).time_of_flight / found - 1.0 < 1e-3
    flat = np.array([1.0, 0.0, 0.0, 1.0, 0.0])
    assert not 0.0 < minimise(EXACT, flat).time_of_flight / found - 1.0 < 1e-3

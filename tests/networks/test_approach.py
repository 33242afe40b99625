"""Approach coordinates: what they leave unchanged, and the physics they are chosen for."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sailnet.mission.mission import load_mission
from sailnet.networks.approach import SMALLEST_SCALE, approach_coordinates
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.transfer import Transfer

PROBLEM = load_mission("earth_mars").problem


def _off_target(dr: float, du: float, dv: float) -> Array:
    """One state so far from the target."""
    return np.asarray(np.array([PROBLEM.target_state]) + np.array([dr, du, dv]))


deviation = st.floats(-0.5, 0.5).filter(lambda x: abs(x) > 1e-3)


@given(dr=deviation, du=deviation, dv=deviation, beta=st.floats(0.05, 0.4))
def test_the_direction_lies_on_one_surface(dr: float, du: float, dv: float, beta: float) -> None:
    state = _off_target(dr, du, dv)
    x_r, x_u, x_v, s, sail = approach_coordinates(PROBLEM, state, beta)[0]
    assert (x_u**2 + x_v**2) ** 2 + (2.0 * x_r) ** 2 == pytest.approx(1.0)
    assert s > 0.0
    assert sail == beta
    # Back to where it came from.
    a = beta / PROBLEM.target_radius**2
    assert [x_r * a * s**2, x_u * a * s, x_v * a * s] == pytest.approx([dr, du, dv])


@given(dr=deviation, du=deviation, dv=deviation, k=st.floats(0.01, 1.0), beta=st.floats(0.05, 0.4))
def test_a_shrinking_deviation_keeps_its_direction(
    dr: float, du: float, dv: float, k: float, beta: float
) -> None:
    whole = approach_coordinates(PROBLEM, _off_target(dr, du, dv), beta)[0]
    shrunk = approach_coordinates(PROBLEM, _off_target(k**2 * dr, k * du, k * dv), beta)[0]
    assert shrunk[:3] == pytest.approx(whole[:3], abs=1e-9)
    assert shrunk[3] == pytest.approx(k * whole[3])


def test_the_target_itself_has_finite_coordinates() -> None:
    at = approach_coordinates(PROBLEM, [PROBLEM.target_state], PROBLEM.beta)[0]
    assert at.tolist() == [0.0, 0.0, 0.0, SMALLEST_SCALE, PROBLEM.beta]


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.8, 1.0, 1.2])
def test_near_arrival_the_direction_alone_decides_whatever_the_sail(share: float) -> None:
    """The claim behind the coordinates: one arrival angle, one limit of time over s and command."""
    sail = replace(PROBLEM, beta=share * PROBLEM.beta)
    seen = []
    for problem in (PROBLEM, sail):
        costates = np.array([[0.0, -math.cos(angle), -math.sin(angle)] for angle in (-1.5, -0.4, 0.3, 1.2)])
        costates /= -arrival_gain(problem, costates)[:, None]
        tau = np.array([0.0, 0.001, 0.01])
        extremals = propagate_extremals(problem, costates, tau)
        inputs = np.array(
            [approach_coordinates(problem, states[1:, :3], problem.beta) for states in extremals.states]
        )
        alpha = guidance_law(problem, extremals.states[:, 1:, 4], extremals.states[:, 1:, 5])
        seen.append(np.dstack([inputs[:, :, :3], tau[1:] / inputs[:, :, 3], alpha]))
    late, early = seen[0][:, 0], seen[0][:, 1]
    np.testing.assert_allclose(late, early, atol=0.01)  # a tenfold scale apart
    np.testing.assert_allclose(seen[0][:, 0], seen[1][:, 0], atol=1e-3)  # another sail
    assert np.ptp(late[:, 4]) > 1.0  # and the four are quite different approaches


def test_raw_deviations_differ_a_hundredfold_where_directions_agree() -> None:
    states = np.concatenate([_off_target(1e-6, -1e-3, 5e-4), _off_target(1e-2, -0.1, 0.05)])
    inputs = approach_coordinates(Transfer(0.1, 1.0, 0.0, PROBLEM.target_radius), states, 0.1)
    np.testing.assert_allclose(inputs[0, :3], inputs[1, :3], rtol=1e-9)
    assert inputs[1, 3] == pytest.approx(100.0 * inputs[0, 3])

"""Eq. (1) against a copy written by hand, and its Runge-Kutta steps against conservation laws and DOP853."""

import heyoka as hy
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from sailnet.physics.dynamics import alpha, beta, motion, r, theta, u, v
from tests.held_command import hold_command
from tests.reference import Array, sail_motion

NAMES = ("r", "theta", "u", "v")


def some_states(count: int, seed: int) -> Array:
    rng = np.random.default_rng(seed)
    low, high = [0.5, -3.0, -0.4, 0.4], [3.0, 3.0, 0.4, 1.4]
    return rng.uniform(low, high, (count, 4)).T.copy()


def test_motion_is_eq_1() -> None:
    slopes = motion(beta, alpha)
    compiled = hy.cfunc([slopes[name] for name in NAMES], vars=[r, theta, u, v, alpha, beta])
    rng = np.random.default_rng(1)
    states, angle = some_states(1000, 2), rng.uniform(-np.pi / 2, np.pi / 2, 1000)
    strength = rng.uniform(0.0, 1.0, 1000)
    found = compiled(np.vstack([states, angle, strength]))
    np.testing.assert_allclose(found, sail_motion(states, angle, strength), rtol=1e-13, atol=1e-14)


def test_without_a_sail_energy_and_angular_momentum_are_kept() -> None:
    states = some_states(50, 3)
    states[0] = np.linspace(0.8, 1.6, 50)
    states[3] = np.clip(states[3], 0.8, 1.1) / np.sqrt(states[0])
    flown = hold_command(states, np.full(50, 0.3), np.zeros(50), 7.0)

    def invariants(x: Array) -> Array:
        return np.array([(x[2] ** 2 + x[3] ** 2) / 2 - 1 / x[0], x[0] * x[3]])

    assert np.abs(flown[1] - states[1]).min() > 0.5  # it did move
    np.testing.assert_allclose(invariants(flown), invariants(states), rtol=0, atol=2e-9)


def test_a_circular_orbit_returns_after_its_period() -> None:
    radius = np.array([1.0, 1.524])
    circular = np.array([radius, 0 * radius, 0 * radius, radius**-0.5])
    for i in range(2):
        flown = hold_command(circular[:, [i]], 0.0, 0.0, 2 * np.pi * float(radius[i]) ** 1.5)
        np.testing.assert_allclose(flown[:, 0] - circular[:, i], [0, 2 * np.pi, 0, 0], atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("period", [0.005, 0.013, 0.1])
def test_a_whole_flight_agrees_with_dop853(period: float) -> None:
    strength, steps = 0.16892, round(7.0 / period)
    held = np.pi / 3 * np.sin(np.arange(steps) * 0.37)
    plant = np.array([[1.0], [0.0], [0.0], [1.0]])
    reference = plant[:, 0].copy()
    for angle in held:
        plant = hold_command(plant, angle, strength, period)
        flown = solve_ivp(
            lambda _, x, a=angle: sail_motion(x, a, strength),
            (0.0, period),
            reference,
            "DOP853",
            first_step=period,
            rtol=1e-12,
            atol=1e-13,
        )
        reference = flown.y[:, -1]
    np.testing.assert_allclose(plant[:, 0], reference, rtol=0, atol=1e-10)


def test_every_sail_flies_for_itself() -> None:
    states = some_states(9, 4)
    angle, strength = np.linspace(-1, 1, 9), np.linspace(0.0, 0.3, 9)
    together = hold_command(states, angle, strength, 0.02)
    for i in range(9):
        alone = hold_command(states[:, [i]], angle[i], strength[i], 0.02)
        np.testing.assert_allclose(alone[:, 0], together[:, i], rtol=1e-15, atol=1e-15)


def test_the_input_is_left_alone() -> None:
    states = some_states(3, 5)
    before = states.copy()
    hold_command(states, 0.1, 0.1, 0.05)
    np.testing.assert_array_equal(states, before)


@settings(max_examples=50, deadline=None)
@given(st.floats(-1.5, 1.5), st.floats(0.0, 0.5), st.floats(1e-4, 0.2))
def test_two_halves_make_a_whole(angle: float, strength: float, duration: float) -> None:
    states = some_states(4, 6)
    whole = hold_command(states, angle, strength, duration)
    half = hold_command(states, angle, strength, duration / 2)
    np.testing.assert_allclose(hold_command(half, angle, strength, duration / 2), whole, atol=1e-9)

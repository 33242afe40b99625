"""The guidance law, the costate equations and the Hamiltonian against the paper's formulas."""

import dataclasses
import math

import heyoka as hy
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sailnet.physics.dynamics import alpha, r, u, v
from sailnet.physics.pontryagin import (
    evaluate_hamiltonian,
    extremal_motion,
    guidance_law,
    hamiltonian,
    lambda_r,
    lambda_u,
    lambda_v,
    unconstrained_law,
)
from sailnet.physics.transfer import Transfer
from tests.reference import (
    Array,
    backward_motion,
    costate_motion,
    sail_motion,
    smoothed,
    unconstrained_angle,
)
from tests.reference import hamiltonian as hamiltonian_by_hand

finite = st.floats(allow_nan=False, allow_infinity=False)
degrees = st.floats(0.5, 89.9)
smoothings = st.sampled_from([0.0, 1e-9, 1e-5, 1e-3, 0.1])


def transfer(phi_max: float = math.pi / 3, delta: float = 1e-3) -> Transfer:
    return Transfer(0.16892, phi_max, delta, 1.524)


def directions(count: int) -> tuple[Array, Array]:
    angle = np.linspace(-np.pi, np.pi, count + 2)[1:-1]
    return 7.0 * np.cos(angle), 7.0 * np.sin(angle)


def test_the_law_is_eq_16_as_printed() -> None:
    a, b = directions(20_001)
    # As printed: exact in long double where cancellation leaves it enough digits.
    a, b = a[np.abs(b) > 0.07], b[np.abs(b) > 0.07]
    x, y = a.astype(np.longdouble), b.astype(np.longdouble)
    bar = np.arctan((-3 * x - np.sqrt(9 * x**2 + 8 * y**2)) / (4 * y))
    phi_max, delta = np.longdouble(math.pi / 3), np.longdouble(1e-3)
    printed = (np.sqrt((bar + phi_max) ** 2 + delta) - np.sqrt((bar - phi_max) ** 2 + delta)) / 2
    np.testing.assert_allclose(guidance_law(transfer(), a, b), printed.astype(float), rtol=0, atol=1e-12)
    np.testing.assert_allclose(unconstrained_law(a, b), bar.astype(float), rtol=0, atol=1e-12)


@pytest.mark.slow
@settings(max_examples=300, deadline=None)
@given(st.floats(1e-3, 1e3), st.floats(-300, 0), st.booleans(), st.booleans())
def test_the_law_near_lambda_v_zero(size: float, exponent: float, averted: bool, negative: bool) -> None:
    a = size if averted else -size
    b = (-1.0 if negative else 1.0) * size * 10.0**exponent
    branch = 1.0 if negative else -1.0
    bar = unconstrained_angle(a, b, branch)
    assert unconstrained_law(a, b) == pytest.approx(float(bar), rel=1e-13, abs=1e-300)
    expected = smoothed(bar, math.pi / 3, 1e-3)
    assert guidance_law(transfer(), a, b) == pytest.approx(float(expected), rel=0, abs=1e-12)


def test_the_exact_law_minimises_the_hamiltonian() -> None:
    problem = transfer(delta=0.0)
    grid = np.linspace(-problem.phi_max, problem.phi_max, 6001)
    rng = np.random.default_rng(0)
    for x in rng.uniform([0.6, -0.3, 0.5, -20, -10, -10], [2.0, 0.3, 1.2, 20, 10, 10], (200, 6)):
        at_law = guidance_law(problem, x[4], x[5])
        candidates = hamiltonian_by_hand(np.tile(x[:, None], 6001), grid, problem.beta)
        least = hamiltonian_by_hand(x, at_law, problem.beta)
        assert least <= candidates.min() + 1e-13
        assert abs(at_law - grid[candidates.argmin()]) <= grid[1] - grid[0]


@pytest.mark.slow
@settings(max_examples=500, deadline=None)
@given(finite, finite, degrees, smoothings)
def test_the_command_is_finite_and_within_the_bound(a: float, b: float, phi: float, delta: float) -> None:
    phi_max = math.radians(phi)
    command = guidance_law(transfer(phi_max, delta), a, b)
    assert np.isfinite(command)
    assert abs(command) <= phi_max


def test_every_special_value_gives_a_command_within_the_bound() -> None:
    special = [0.0, 5e-324, 1e-310, 2.2e-308, 1e-200, 1e-16, 1.0, 1e16, 1e200, 1.7e308]
    values = np.array([s * x for x in special for s in (1, -1)])
    a, b = np.meshgrid(values, values)
    for delta in (0.0, 1e-3):
        command = guidance_law(transfer(delta=delta), a, b)
        assert np.isfinite(command).all()
        assert np.abs(command).max() <= math.pi / 3
    assert guidance_law(transfer(), 0.0, 0.0) == 0.0
    assert guidance_law(transfer(), -0.0, -0.0) == 0.0
    assert guidance_law(transfer(), -1.0, 0.0) == 0.0


@settings(max_examples=200, deadline=None)
@given(finite, finite, smoothings)
def test_the_law_is_odd_in_lambda_v(a: float, b: float, delta: float) -> None:
    problem = transfer(delta=delta)
    there, back = guidance_law(problem, a, b), guidance_law(problem, a, -b)
    assert back == pytest.approx(-float(there), rel=0, abs=1e-15)
    if a != 0.0 or b != 0.0:
        assert np.sign(there) * np.sign(b) <= 0.0  # Eq. (24)


@settings(max_examples=200, deadline=None)
@given(st.floats(-np.pi, np.pi), st.floats(-300, 300), smoothings)
def test_only_the_direction_of_the_costates_counts(angle: float, exponent: float, delta: float) -> None:
    a, b = math.cos(angle), math.sin(angle)
    scale = 10.0**exponent
    problem = transfer(delta=delta)
    assert guidance_law(problem, scale * a, scale * b) == pytest.approx(
        float(guidance_law(problem, a, b)), rel=0, abs=1e-9 if abs(b) < 1e-8 else 1e-13
    )


def test_the_command_jumps_only_where_lambda_u_is_positive() -> None:
    for delta in (0.0, 1e-3):
        problem = transfer(delta=delta)
        above, below = guidance_law(problem, 1.0, 1e-12), guidance_law(problem, 1.0, -1e-12)
        assert below - above > 2 * math.pi / 3 - 2e-3
        assert abs(guidance_law(problem, -1.0, 1e-12) - guidance_law(problem, -1.0, -1e-12)) < 1e-11


def test_shapes_broadcast() -> None:
    a, b = np.ones((4, 1)), np.linspace(1, 2, 3)
    command = guidance_law(transfer(), a, b)
    assert command.shape == (4, 3)
    assert command[2, 1] == guidance_law(transfer(), 1.0, 1.5)


def random_extremal_points(count: int) -> tuple[Array, Array]:
    rng = np.random.default_rng(5)
    low, high = [0.5, -0.5, 0.4, -30, -10, -50], [3.0, 0.5, 1.4, 30, 10, 50]
    return rng.uniform(low, high, (count, 6)).T.copy(), rng.uniform(-1.4, 1.4, count)


def test_the_equations_of_an_extremal_are_eqs_1_8_and_15() -> None:
    points, angle = random_extremal_points(500)
    variables = [r, u, v, lambda_r, lambda_u, lambda_v]
    system = extremal_motion(alpha)
    assert [x for x, _ in system] == variables
    compiled = hy.cfunc([dx for _, dx in system], vars=[*variables, alpha])
    found = compiled(np.vstack([points, angle]), pars=np.full((1, 500), 0.16892))
    state = np.vstack([points[0], 0 * points[0], points[1:3]])
    motion_by_hand = sail_motion(state, angle, 0.16892)[[0, 2, 3]]
    np.testing.assert_allclose(found[:3], motion_by_hand, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(found[3:], costate_motion(points, angle, 0.16892), rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(-found, backward_motion(points, angle, 0.16892), rtol=1e-11, atol=1e-11)


def test_the_hamiltonian_is_eq_7() -> None:
    points, angle = random_extremal_points(500)
    found = evaluate_hamiltonian(transfer(), points[:3].T, points[3:].T, angle)
    np.testing.assert_allclose(found, hamiltonian_by_hand(points, angle, 0.16892), rtol=1e-12, atol=1e-12)


def test_the_hamiltonian_s_derivatives_are_the_motion_and_the_costate_equations() -> None:
    """Hamilton's equations by central differences of H: no derivative is written anywhere here."""
    points, angle = random_extremal_points(200)
    step = 1e-5
    slopes = []
    for i in range(6):
        ahead, behind = points.copy(), points.copy()
        ahead[i] += step
        behind[i] -= step
        h = [evaluate_hamiltonian(transfer(), x[:3].T, x[3:].T, angle) for x in (ahead, behind)]
        slopes.append((h[0] - h[1]) / (2 * step))
    forth = -backward_motion(points, angle, 0.16892)
    np.testing.assert_allclose(slopes[3:], forth[:3], rtol=0, atol=1e-7)
    np.testing.assert_allclose([-s for s in slopes[:3]], forth[3:], rtol=1e-7, atol=1e-5)


def test_the_law_is_stationary_inside_the_bound() -> None:
    """Eq. (A2): dH/dalpha = 0 at alpha_bar, with H rising on both sides."""
    variables = [r, u, v, lambda_r, lambda_u, lambda_v, alpha]
    slope = hy.cfunc([hy.diff(hamiltonian(), alpha)], vars=variables)
    points, _ = random_extremal_points(500)
    bar = unconstrained_law(points[4], points[5])
    at = slope(np.vstack([points, bar]), pars=np.full((1, 500), 0.16892))[0]
    np.testing.assert_allclose(at, 0.0, atol=1e-12)
    for shift, sign in ((1e-3, 1), (-1e-3, -1)):
        near = slope(np.vstack([points, bar + shift]), pars=np.full((1, 500), 0.16892))[0]
        interior = np.abs(bar) < 1.5
        assert interior.mean() > 0.5
        assert (sign * near[interior] > 0).all()


def test_the_smoothing_vanishes_with_delta() -> None:
    a, b = directions(100_001)
    exact = guidance_law(transfer(delta=0.0), a, b)
    distances = [np.abs(guidance_law(transfer(delta=d), a, b) - exact).max() for d in (1e-2, 1e-4, 1e-6)]
    assert distances[0] > distances[1] > distances[2]
    for d, distance in zip((1e-2, 1e-4, 1e-6), distances, strict=True):
        assert distance == pytest.approx(math.sqrt(d) / 2, rel=0.1)
    wide = dataclasses.replace(transfer(delta=0.0), phi_max=math.pi / 2)
    np.testing.assert_allclose(guidance_law(wide, a, b), unconstrained_law(a, b), atol=1e-15)

"""Undoing the jump of the cone angle, Eq. (23), and redoing it, Eq. (25)."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sailnet.physics.extremals import arrival_lambda_v, propagate_extremals
from sailnet.physics.jumps import preprocess, restore
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.transfer import Transfer
from tests.reference import Array

angles = st.floats(-1.0, 1.0)


@pytest.fixture(scope="module")
def box(problem: Transfer) -> tuple[Array, Array, Array, Array]:
    """tau, alpha, lambda_v and jump times of 60 extremals of the paper's box with at most one jump."""
    rng = np.random.default_rng(8)
    lu = rng.uniform(5, 11, 60)
    costates = np.column_stack(
        [rng.uniform(-23, -20, 60), lu, [arrival_lambda_v(problem, x, 1.0) for x in lu]]
    )
    tau = np.linspace(0.0, 10.0, 4001)
    found = propagate_extremals(problem, costates, tau)
    kept = found.jumps <= 1
    states = found.states[kept]
    return tau, guidance_law(problem, states[..., 4], states[..., 5]), states[..., 5], found.jump_times[kept]


def test_restoring_gives_the_command_back(box: tuple[Array, Array, Array, Array]) -> None:
    tau, alpha, lambda_v, jump_times = box
    assert np.isfinite(jump_times).sum() > 5
    assert np.isnan(jump_times).sum() > 5
    alpha_pre = preprocess(alpha, tau, jump_times[:, None])
    np.testing.assert_array_equal(restore(alpha_pre, lambda_v), alpha)
    np.testing.assert_array_equal(restore(-alpha_pre, lambda_v), alpha)  # either sign will do


def test_the_jump_is_gone(box: tuple[Array, Array, Array, Array]) -> None:
    tau, alpha, _, jump_times = box
    jumps = np.isfinite(jump_times)
    assert min(jumps.sum(), (~jumps).sum()) > 5
    alpha_pre = preprocess(alpha, tau, jump_times[:, None])
    before = np.flatnonzero(jumps)
    column = np.searchsorted(tau, jump_times[jumps])
    leap = np.abs(alpha[before, column] - alpha[before, column - 1])
    left = np.abs(alpha_pre[before, column] - alpha_pre[before, column - 1])
    assert (leap > 2 * np.radians(50.0)).all()
    assert (left < 0.01).all()
    # Nowhere else does the command jump, so nothing was missed.
    steps = np.abs(np.diff(alpha[~jumps], axis=1))
    assert np.median(steps.max(axis=1)) < 0.05


def test_before_the_jump_only(box: tuple[Array, Array, Array, Array]) -> None:
    tau, alpha, _, jump_times = box
    alpha_pre = preprocess(alpha, tau, jump_times[:, None])
    for row, at in enumerate(jump_times):
        early = tau > at if np.isfinite(at) else np.zeros(len(tau), bool)
        np.testing.assert_array_equal(alpha_pre[row, early], -alpha[row, early])
        np.testing.assert_array_equal(alpha_pre[row, ~early], alpha[row, ~early])


@given(angles, st.floats(-100, 100))
def test_the_restored_command_opposes_lambda_v(alpha_pre: float, lambda_v: float) -> None:
    restored = float(restore(alpha_pre, lambda_v))
    assert abs(restored) == abs(alpha_pre)
    assert not restored * lambda_v > 0.0  # Eq. (24)
    assert restore(restored, lambda_v) == restored


@given(angles, st.floats(0, 10), st.floats(0, 10))
def test_without_a_jump_nothing_changes(alpha: float, tau: float, at: float) -> None:
    assert preprocess(alpha, tau, np.nan) == alpha
    assert preprocess(alpha, tau, at) == (-alpha if tau > at else alpha)

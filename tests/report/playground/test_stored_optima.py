"""The stored answers are the expert's, and survive being packed."""

import base64
import json
import zlib
from typing import Any

import numpy as np
import pytest

from sailnet.expert.fastest import solve_states
from sailnet.expert.optima import sample
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.report.playground.stored_optima import (
    AXES,
    MISSING,
    OPTIMA,
    SHARES,
    Axis,
    coded,
    packed,
    solve_grid,
    starts,
)


def unpacked(text: str, kind: str) -> Any:
    planes = np.frombuffer(zlib.decompress(base64.b64decode(text)), np.uint8)
    return planes.reshape(np.dtype(kind).itemsize, -1).T.copy().view(kind).ravel()


def times_of(stored: dict[str, Any]) -> Array:
    """(shares, starts) in TU; NaN where the expert had none."""
    levels = unpacked(stored["times"], "<u2").reshape(len(stored["shares"]), -1)
    times = stored["shortest"] * np.exp(stored["step"] * levels.astype(float))
    return np.asarray(np.where(levels == MISSING, np.nan, times))


def test_times_survive_being_packed() -> None:
    times = np.array([[5.0, np.nan, 61.7], [7.3, 7.3001, 5.0]])
    shortest, step, levels = coded(times)
    assert levels[0, 1] == MISSING
    stored = {"times": packed(levels), "shares": [1, 2], "shortest": shortest, "step": step}
    np.testing.assert_allclose(times_of(stored), times, rtol=3e-5)
    exact = np.array([[1.0, -2.5, 1e-9]], "<f4")
    np.testing.assert_array_equal(unpacked(packed(exact), "<f4"), exact.ravel())


@pytest.mark.slow
def test_a_small_grid_is_what_the_expert_says_of_each_sail(mission: Mission) -> None:
    """With an extremal from its stored costates that arrives."""
    axes = {"r": Axis(104, 105), "u": Axis(14, 15), "v": Axis(103, 103)}
    stored = solve_grid(mission, axes, quiet=True)
    times = times_of(stored)
    assert times.shape == (len(SHARES), 4)
    assert np.all(np.diff(times, axis=0) < 0.0)  # the stronger, the faster
    case = int(np.flatnonzero((starts(axes) == [1.05, 0.15, 1.03]).all(axis=1))[0])
    optimum = solve_states(mission.problem, [[1.05, 0.15, 1.03]]).extremal(0)
    assert times[SHARES.index(1.0), case] == pytest.approx(optimum.time_of_flight, rel=3e-5)
    costates = unpacked(stored["costates"], "<f4").reshape(-1, 3)[case]
    np.testing.assert_allclose(
        costates, optimum.costates / np.linalg.norm(optimum.costates), rtol=0, atol=1e-6
    )
    assert sample(mission.problem, optimum, 3)[0][-1] == pytest.approx(optimum.time_of_flight)


@pytest.mark.slow
def test_what_ships_is_the_experts(mission: Mission) -> None:
    """Of the sail as assumed, at starts drawn from all of them."""
    stored = json.loads(OPTIMA.read_text("utf-8"))
    assert stored["axes"] == {name: [axis.first, axis.last] for name, axis in AXES.items()}
    assert stored["shares"] == list(SHARES)
    assert stored["mission"] == mission.digest("sail", "transfer")
    times = times_of(stored)
    assert np.isfinite(times).mean() > 0.99
    states = starts()
    fast = np.flatnonzero(times[SHARES.index(1.0)] < 9.0)
    chosen = np.random.default_rng(5).choice(fast, 12, replace=False)
    optima = solve_states(mission.problem, states[chosen])
    np.testing.assert_allclose(times[SHARES.index(1.0), chosen], optima.time_of_flight, rtol=3e-5)

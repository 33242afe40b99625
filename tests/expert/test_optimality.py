"""What the expert finds is the fastest: tests that need no second solver, and a much finer index."""

import dataclasses

import numpy as np
import pytest

import sailnet.expert.fastest
import sailnet.expert.index
from sailnet.expert.fastest import solve, solve_states
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.transfer import Transfer
from tests.conftest import Solved
from tests.reference import Array, sail_motion

HIDDEN = {
    # Few extremals pass here: a pinch, and folds that an even mesh of extremals missed.
    (1.1048, 0.0449, 1.1196): (11.153944663763, 11.155303567104),
    (1.0155, 0.0502, 1.1788): (10.809912035901, 10.811400683192),
    (1.0333, 0.0769, 1.1358): (8.809688066256, 8.811001863475),
    (1.0218, 0.0323, 1.1482): (8.540986346649, 8.542287234735),
}
"""Times of flight for delta = 0 and 1e-3.

The first were found to 1.3e-4 by the direct method of tests.direct, from all of its six starts. The
second, and the first but for the last state, were confirmed to 1e-10 by tests.forward_shooting.
"""


@pytest.mark.exhaustive
@pytest.mark.parametrize("state", HIDDEN)
def test_states_that_an_even_mesh_missed(problem: Transfer, state: tuple[float, float, float]) -> None:
    exact, smoothed = HIDDEN[state]
    assert solve(problem, state).time_of_flight == pytest.approx(smoothed, abs=1e-8)
    law = dataclasses.replace(problem, delta=0.0)
    assert solve(law, state).time_of_flight == pytest.approx(exact, abs=1e-8)


@pytest.mark.slow
def test_the_costates_are_the_gradient_of_the_time_of_flight(problem: Transfer) -> None:
    """An extremal that is stationary but not the fastest one of its field fails this sooner or later."""
    exact, step = dataclasses.replace(problem, delta=0.0), 2e-5
    states = np.array([[1.08, 0.1, 0.97], [1.02, 0.01, 0.9], [1.12, 0.07, 1.07], [1.06, 0.04, 1.16]])
    shifts = np.concatenate([np.zeros((1, 3)), step * np.eye(3), -step * np.eye(3)])
    optima = solve_states(exact, (states[:, None] + shifts).reshape(-1, 3))
    assert optima.found.all()
    times = optima.time_of_flight.reshape(4, 7)
    gradient = (times[:, 1:4] - times[:, 4:]) / (2 * step)
    costates = optima.costates.reshape(4, 7, 3)[:, 0]
    np.testing.assert_allclose(gradient, costates, rtol=2e-5, atol=1e-4)


def test_no_extremal_is_faster(problem: Transfer, solved: Solved) -> None:
    """Random extremals, drawn with no regard to the index, pass through states at some time to go."""
    low, high = solved.region
    directions = np.random.default_rng(77).normal(size=(1500, 3)) * [1.0, 1.88, 1.88]
    directions = directions[arrival_gain(problem, directions) < 0.0]
    tau = np.linspace(0.0, 20.0, 401)
    paths = propagate_extremals(problem, directions, tau).states[:, :, :3]
    extremal, sample = np.nonzero(((paths > low) & (paths < high)).all(axis=2))
    assert len(extremal) > 150
    optima = solve_states(problem, paths[extremal, sample], solved.region)
    assert (optima.time_of_flight <= tau[sample] + 1e-7).all()


@pytest.mark.parametrize("degrees", [-60.0, 0.0, 45.0])
def test_no_detour_is_faster(problem: Transfer, solved: Solved, degrees: float) -> None:
    """Bellman: a while with any other cone angle, and the best way on from there, takes no less."""
    low, high = solved.region
    duration, steps = 0.1, 4
    after = solved.states
    for _ in range(steps):
        after = runge_kutta(after, np.radians(degrees), problem.beta, duration / steps)
    kept = np.flatnonzero(((after > low) & (after < high)).all(axis=1))[:250]
    onward = solve_states(problem, after[kept], solved.region).time_of_flight
    gain = solved.optima.time_of_flight[kept] - (duration + onward)
    assert gain.max() < 1e-3 * duration  # the smoothed law's extremals are fastest but for so much
    assert len(kept) > 200


def runge_kutta(states: Array, alpha: float, beta: float, step: float) -> Array:
    def slope(x: Array) -> Array:
        rows = np.array([x[:, 0], np.zeros(len(x)), x[:, 1], x[:, 2]])
        return sail_motion(rows, np.full(len(x), alpha), beta)[[0, 2, 3]].T

    k1 = slope(states)
    k2 = slope(states + step / 2 * k1)
    k3 = slope(states + step / 2 * k2)
    k4 = slope(states + step * k3)
    return np.asarray(states + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4))


@pytest.mark.exhaustive
def test_a_much_finer_index_finds_nothing_faster(
    problem: Transfer, solved_everywhere: Solved, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its states crowd around a pinch, so that a fine index of them is soon made."""
    states = np.array([1.1048, 0.0449, 1.1196]) + np.random.default_rng(6).uniform(-0.01, 0.01, (100, 3))
    expected = solve_states(problem, states, solved_everywhere.region)
    for name, value in {"PRISM": 0.04, "RIM": 0.008, "BULGE": 0.6, "MOST": 10**6}.items():
        monkeypatch.setattr(sailnet.expert.index, name, value)
    # By default what surrounds the states is indexed: no index that was made before serves.
    optima = solve_states(problem, states)
    assert optima.found.all()
    np.testing.assert_allclose(expected.time_of_flight, optima.time_of_flight, rtol=0, atol=1e-8)


def test_half_the_prism_finds_nothing_faster_anywhere(
    problem: Transfer, solved: Solved, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Random states of the generalisation set; the slowest are left to those who have minutes."""
    everywhere = solved.region[1][2] > 1.15
    rows = np.flatnonzero(solved.optima.time_of_flight < (12.0 if everywhere else 8.0))[
        : 6 if everywhere else 3
    ]
    monkeypatch.setattr(sailnet.expert.index, "PRISM", 0.5 * sailnet.expert.index.PRISM)
    monkeypatch.setattr(sailnet.expert.fastest, "build_index", sailnet.expert.index.build_index.__wrapped__)
    finer = solve_states(problem, solved.states[rows])
    assert finer.complete.all()
    assert solved.optima.complete.all()
    np.testing.assert_allclose(finer.time_of_flight, solved.optima.time_of_flight[rows], rtol=0, atol=1e-8)

"""The expert: golden values, honest residuals, the shortest of several extremals, clear refusals."""

import dataclasses
import math
from typing import Any

import numpy as np
import pytest

import sailnet.expert
from sailnet.errors import SolveError
from sailnet.expert import Extremal, solve
from sailnet.extremals import arrival_lambda_v, propagate_extremals
from sailnet.mission import Mission, Transfer
from sailnet.pontryagin import evaluate_hamiltonian, guidance_law
from sailnet.shooting import Shots, shoot
from tests.reference import fly


def arrives(transfer: Transfer, found: Extremal) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Distance from the target orbit after flying forward with DOP853 from the state and costates."""
    start = np.concatenate([found.state, found.costates])
    flown = fly(transfer, start, [0.0, found.time_of_flight], backward=False)
    return np.abs(flown.states[-1, :3] - transfer.target_state)


@pytest.mark.parametrize(
    ("state", "time", "jumps"),
    [
        ((1.0, 0.0, 1.0), 7.018384, 0),
        ((1.05, 0.15, 1.03), 6.15517, 1),  # Case 2
        ((1.1, 0.18, 0.93), 5.91538, None),  # Section 5.2
    ],
)
def test_the_golden_times_of_flight(
    problem: Transfer, state: tuple[float, float, float], time: float, jumps: int | None
) -> None:
    found = solve(problem, state)
    assert found.time_of_flight == pytest.approx(time, abs=1e-5)
    assert found.residual <= 1e-9
    assert jumps is None or found.jumps == jumps
    np.testing.assert_allclose(arrives(problem, found), 0.0, atol=1e-6)


def test_states_along_an_extremal_take_at_most_its_time(problem: Transfer) -> None:
    rng = np.random.default_rng(11)
    for _ in range(4):
        lu = rng.uniform(5, 11)
        costates = [rng.uniform(-23, -20), lu, float(arrival_lambda_v(problem, lu, 1.0))]
        tau = np.array([0.0, *rng.uniform(0.3, 9.0, 2)])
        tau.sort()
        states = propagate_extremals(problem, costates, tau).states[0]
        for t, x in zip(tau[1:], states[1:], strict=True):
            found = solve(problem, x[:3])
            assert found.time_of_flight <= t + 1e-8
            assert found.residual <= 1e-9
            np.testing.assert_allclose(arrives(problem, found), 0.0, atol=1e-6)


def test_random_states_of_the_generalisation_set(mission: Mission) -> None:
    region, problem = mission.generalisation, mission.problem
    rng = np.random.default_rng(3)
    for _ in range(6):
        state = [rng.uniform(*region.r), rng.uniform(*region.u), rng.uniform(0.8, 1.1)]
        found = solve(problem, state)
        assert found.residual <= 1e-9
        assert 5.8 < found.time_of_flight < 22.0
        assert abs(found.cone_angle) <= problem.phi_max
        assert found.jumps <= 1
        np.testing.assert_allclose(arrives(problem, found), 0.0, atol=1e-6)


def test_the_reported_quantities_belong_together(problem: Transfer, jumping: Extremal) -> None:
    tau = [0.0, jumping.time_of_flight]
    flown = propagate_extremals(problem, jumping.arrival_costates, tau)
    np.testing.assert_allclose(flown.states[0, 1, :3], jumping.state, atol=1e-9)
    np.testing.assert_allclose(flown.states[0, 1, 3:], jumping.costates, atol=1e-8)
    assert flown.jump_times[0] == pytest.approx(jumping.jump_time, abs=1e-9)
    alpha = guidance_law(problem, jumping.costates[1], jumping.costates[2])
    assert jumping.cone_angle == float(alpha)
    h = evaluate_hamiltonian(problem, jumping.state[None], jumping.costates[None], np.atleast_1d(alpha))
    assert abs(h[0]) < 2.5e-3  # what delta = 1e-3 allows
    h = evaluate_hamiltonian(
        problem,
        np.array([problem.target_state]),
        jumping.arrival_costates[None],
        np.atleast_1d(guidance_law(problem, *jumping.arrival_costates[1:])),
    )
    assert abs(h[0]) < 1e-12


def test_the_costates_are_the_gradient_of_the_time_of_flight(problem: Transfer) -> None:
    exact = dataclasses.replace(problem, delta=0.0)
    state, step = np.array([1.08, 0.1, 0.97]), 1e-5
    costates = solve(exact, state).costates
    for i in range(3):
        shift = np.eye(3)[i] * step
        ahead = solve(exact, state + shift).time_of_flight
        behind = solve(exact, state - shift).time_of_flight
        assert (ahead - behind) / (2 * step) == pytest.approx(costates[i], rel=1e-4, abs=1e-4)


def test_the_shortest_of_the_extremals_found_wins(problem: Transfer, monkeypatch: pytest.MonkeyPatch) -> None:
    """Newton's results are doctored: a second extremal that takes twice as long is put before the first."""
    state = (1.05, 0.15, 1.03)
    genuine = shoot

    def doctored(*arguments: Any) -> Shots:
        found = genuine(*arguments)
        columns = vars(found).items()
        twice = {name: np.concatenate([column, column]) for name, column in columns}
        twice["tau"] = np.concatenate([2 * found.tau, found.tau])
        return Shots(**twice)

    monkeypatch.setattr(sailnet.expert, "shoot", doctored)
    assert solve(problem, state).time_of_flight == pytest.approx(6.15517, abs=1e-5)


@pytest.mark.parametrize(
    "state",
    [
        (math.nan, 0.0, 1.0),
        (1.0, math.inf, 1.0),
        (1.0, 0.0, -math.inf),
        (0.0, 0.0, 1.0),
        (-1.0, 0.0, 1.0),
        (1.0, 0.0),
        ((1.0, 0.0, 1.0),),
    ],
)
def test_a_state_that_is_none_is_refused(problem: Transfer, state: tuple[float, ...]) -> None:
    with pytest.raises(SolveError, match="three finite numbers with r > 0"):
        solve(problem, state)


def test_a_state_on_the_target_orbit_is_refused(problem: Transfer) -> None:
    with pytest.raises(SolveError, match="on the target orbit already"):
        solve(problem, problem.target_state)


@pytest.mark.parametrize("state", [(100.0, 0.0, 0.1), (0.01, 0.0, 3.0)])
def test_a_state_out_of_reach_is_refused(
    problem: Transfer, state: tuple[float, float, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sailnet.expert, "ZOOMS", 0)  # the refinements only cost time here
    with pytest.raises(SolveError, match=f"no extremal found from r = {state[0]:g} AU"):
        solve(problem, state)

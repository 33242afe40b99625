"""The expert: golden values, honest residuals, the shortest of several extremals, clear refusals."""

import dataclasses
import math
from typing import Any

import numpy as np
import pytest

import sailnet.expert.fastest
import sailnet.expert.index
from sailnet.errors import SolveError
from sailnet.expert.fastest import solve, solve_families, solve_states
from sailnet.expert.index import INNERMOST, Guesses, Index
from sailnet.expert.optima import Extremal
from sailnet.expert.shooting import Shots, shoot
from sailnet.physics.extremals import arrival_lambda_v, propagate_extremals
from sailnet.physics.pontryagin import evaluate_hamiltonian, guidance_law
from sailnet.physics.transfer import Transfer
from tests.reference import fly


def arrives(transfer: Transfer, found: Extremal) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Distance from the target orbit after flying forward with DOP853 from the state and costates."""
    start = np.concatenate([found.state, found.costates])
    flown = fly(transfer, start, [0.0, found.time_of_flight], backward=False)
    return np.abs(flown.states[-1, :3] - transfer.target_state)


@pytest.mark.slow
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


@pytest.mark.slow
def test_the_way_from_a_state_whose_orbit_leads_near_the_sun_is_found(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Beside that way the usual search, cut short here, ends its extremals."""
    monkeypatch.setattr(sailnet.expert.fastest, "build_index", sailnet.expert.index.build_index.__wrapped__)
    monkeypatch.setattr(sailnet.expert.index, "HORIZONS", (7.0,))
    transfer = Transfer(0.12, math.radians(55.0), 1e-3, 0.9)
    found = solve_states(transfer, [(0.945, -0.079, 0.823)]).extremal(0)
    assert found.time_of_flight == pytest.approx(4.926710, abs=1e-6)
    assert found.residual <= 1e-9
    np.testing.assert_allclose(arrives(transfer, found), 0.0, atol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize(("v", "followed"), [(0.6, False), (0.8, True)])
def test_what_falls_into_the_sun_is_not_followed_there(
    problem: Transfer, v: float, followed: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Bad input would wait for that long; of what comes near, extremals are followed beyond the usual."""
    asked: list[float] = []

    def built(*given: Any, innermost: float = math.inf) -> Index:
        asked.append(innermost)
        return sailnet.expert.index.build_index.__wrapped__(*given, innermost=innermost)

    monkeypatch.setattr(sailnet.expert.fastest, "build_index", built)
    monkeypatch.setattr(sailnet.expert.index, "HORIZONS", (1.0,))  # in which nothing is found
    optima = solve_states(problem, [(1.0, -0.1, v)])
    assert not optima.found[0]
    assert (min(asked) < 0.5 * INNERMOST) == followed


@pytest.mark.slow
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


@pytest.mark.parametrize("slower_first", [True, False])
def test_the_shortest_of_the_extremals_found_wins(
    problem: Transfer, monkeypatch: pytest.MonkeyPatch, slower_first: bool
) -> None:
    """Guess and refinement are doctored: a second extremal seems to take a little longer than the first."""
    state, longer = (1.05, 0.15, 1.03), 1e-3
    genuine_shoot, genuine_distinct = shoot, sailnet.expert.fastest._distinct

    def twice(guesses: Guesses) -> Guesses:
        found = genuine_distinct(guesses)
        row = np.argmin(np.abs(found.tau * problem.target_radius**1.5 - 6.15517))
        return Guesses(*(column[[row, row]] for column in vars(found).values()))

    calls: list[float] = []

    def doctored(*arguments: Any) -> Shots:
        found = genuine_shoot(*arguments)
        if slower_first == (not calls):
            found.tau += longer
        calls.append(float(found.tau[0]))
        return found

    monkeypatch.setattr(sailnet.expert.fastest, "_distinct", twice)
    monkeypatch.setattr(sailnet.expert.fastest, "shoot", doctored)
    found = solve(problem, state)
    assert len(calls) == 2
    assert found.time_of_flight == pytest.approx(6.15517, abs=1e-5)
    assert found.rival_time == pytest.approx(found.time_of_flight + longer, abs=1e-9)
    calls.clear()
    best, second = solve_families(problem, np.array([state]), None, 1.0 + longer)
    assert best.time_of_flight[0] == found.time_of_flight
    assert second.time_of_flight[0] == found.rival_time
    np.testing.assert_allclose(second.arrival_costates, best.arrival_costates, rtol=1e-9)


@pytest.mark.parametrize("spoil", ["residual", "costates"])
def test_what_is_no_extremal_through_the_state_is_no_answer(
    problem: Transfer, monkeypatch: pytest.MonkeyPatch, spoil: str
) -> None:
    genuine = shoot

    def doctored(*arguments: Any) -> Shots:
        found = genuine(*arguments)
        if spoil == "residual":
            found.residual[:] = 1e-8
        else:
            found.states[:, 3] *= 2.0  # H is not 0
        return found

    assert np.isfinite(solve(problem, (1.05, 0.15, 1.03)).time_of_flight)
    monkeypatch.setattr(sailnet.expert.fastest, "shoot", doctored)
    with pytest.raises(SolveError, match=r"no extremal found from r = 1\.05 AU"):
        solve(problem, (1.05, 0.15, 1.03))


def test_the_problem_scales_with_the_target_orbit(problem: Transfer) -> None:
    """tau ~ r_f^1.5, and the costates are derivatives of tau."""
    state, size = np.array([1.05, 0.15, 1.03]), 0.387 / 1.524
    here = solve(problem, state)
    small = dataclasses.replace(problem, target_radius=0.387)
    there = solve(small, state * [size, size**-0.5, size**-0.5])
    assert there.time_of_flight == pytest.approx(here.time_of_flight * size**1.5, rel=1e-10)
    assert there.jumps == here.jumps
    assert there.jump_time == pytest.approx(here.jump_time * size**1.5, rel=1e-8)
    assert there.cone_angle == pytest.approx(here.cone_angle, rel=1e-8)
    factors = [size**0.5, size**2, size**2]
    np.testing.assert_allclose(there.costates, here.costates * factors, rtol=1e-8)
    np.testing.assert_allclose(there.arrival_costates, here.arrival_costates * factors, rtol=1e-8)


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


@pytest.mark.slow
@pytest.mark.parametrize("state", [(100.0, 0.0, 0.1), (1.0, 0.0, 2.0)])
def test_a_state_out_of_reach_is_refused(
    problem: Transfer, state: tuple[float, float, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sailnet.expert.index, "HORIZONS", (7.0,))  # the rest only costs time here
    with pytest.raises(SolveError, match=f"no extremal found from r = {state[0]:g} AU"):
        solve(problem, state)


def limit_search(monkeypatch: pytest.MonkeyPatch, most: int, effort: int) -> None:
    monkeypatch.setattr(sailnet.expert.fastest, "build_index", sailnet.expert.index.build_index.__wrapped__)
    monkeypatch.setattr(sailnet.expert.index, "MOST", most)
    monkeypatch.setattr(sailnet.expert.fastest, "EFFORT", effort)


@pytest.mark.slow
def test_an_exhausted_search_says_so_and_one_with_more_effort_does_not(
    problem: Transfer, monkeypatch: pytest.MonkeyPatch
) -> None:
    state = (1.049, 0.0987, 0.9275)
    limit_search(monkeypatch, most=2600, effort=1)
    short = solve(problem, state)
    assert not short.complete
    assert short.searched < short.time_of_flight
    limit_search(monkeypatch, most=2600, effort=2)
    longer = solve(problem, state)
    assert longer.complete
    assert short.searched < longer.time_of_flight <= longer.searched
    assert longer.time_of_flight <= short.time_of_flight + 1e-9

"""Many states at once: the answers they get one by one, whatever else is in the batch, and no wrong ones."""

import numpy as np
import pytest

import sailnet.expert.fastest
import sailnet.expert.index
from sailnet.errors import SolveError
from sailnet.expert.fastest import solve, solve_states
from sailnet.expert.optima import Optima
from sailnet.expert.shooting import shoot
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.transfer import Transfer
from tests.conftest import Solved
from tests.reference import Array, fly, hamiltonian

FEW = 6


def agree(found: Optima, expected: Optima) -> None:
    np.testing.assert_array_equal(found.state, expected.state)
    np.testing.assert_array_equal(found.found, expected.found)
    np.testing.assert_allclose(found.time_of_flight, expected.time_of_flight, rtol=0, atol=1e-8)
    for name in ("costates", "arrival_costates", "cone_angle", "jump_time"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), rtol=1e-5, atol=1e-5)
    np.testing.assert_array_equal(found.jumps, expected.jumps)


def part(optima: Optima, rows: object) -> Optima:
    return Optima(*(column[rows] for column in vars(optima).values()))


def test_every_state_of_the_generalisation_set_is_solved(problem: Transfer, solved: Solved) -> None:
    optima = solved.optima
    assert optima.found.all()
    np.testing.assert_array_equal(optima.state, solved.states)
    assert optima.residual.max() <= 1e-9
    h = hamiltonian(np.column_stack([optima.state, optima.costates]).T, optima.cone_angle, problem.beta)
    assert np.abs(h).max() <= 60.0 * problem.delta
    assert np.abs(optima.cone_angle).max() <= problem.phi_max
    assert optima.time_of_flight.min() > 5.8
    assert optima.time_of_flight.max() < 35.0
    assert (optima.jumps >= 1).sum() > 100
    late = optima.jump_time[optima.jumps > 0] <= optima.time_of_flight[optima.jumps > 0]
    assert late.all()
    np.testing.assert_array_equal(np.isnan(optima.jump_time), optima.jumps == 0)


def test_the_residuals_are_honest(problem: Transfer, solved: Solved) -> None:
    grid = np.column_stack([np.zeros(len(solved.states)), solved.optima.time_of_flight])
    flown = propagate_extremals(problem, solved.optima.arrival_costates, grid)
    error = np.abs(flown.states[:, 1, :3] - solved.states).max(axis=1)
    assert error.max() <= 1e-9
    np.testing.assert_allclose(flown.states[:, 1, 3:], solved.optima.costates, rtol=1e-6, atol=1e-6)
    np.testing.assert_array_equal(flown.jumps, solved.optima.jumps)


def test_they_arrive_when_flown_forward(problem: Transfer, solved: Solved) -> None:
    shortest = np.argsort(solved.optima.time_of_flight)
    for row in shortest[[0, 100, 300, 500, 700]]:
        found = solved.optima.extremal(row)
        start = np.concatenate([found.state, found.costates])
        flown = fly(problem, start, [0.0, found.time_of_flight], backward=False)
        np.testing.assert_allclose(flown.states[-1, :3], problem.target_state, atol=1e-6)


def test_one_by_one_or_together_with_or_without_a_region(problem: Transfer, solved: Solved) -> None:
    states, expected = solved.states[:FEW], part(solved.optima, slice(FEW))
    agree(solve_states(problem, states), expected)
    for row in range(3):
        alone = solve(problem, states[row])
        assert alone.time_of_flight == pytest.approx(expected.time_of_flight[row], abs=1e-8)
        np.testing.assert_allclose(alone.costates, expected.costates[row], rtol=1e-5, atol=1e-5)


def test_the_order_and_the_number_of_states_do_not_matter(problem: Transfer, solved: Solved) -> None:
    order = np.random.default_rng(1).permutation(len(solved.states))
    agree(solve_states(problem, solved.states[order], solved.region), part(solved.optima, order))
    few = np.repeat(order[:5], 3)
    agree(solve_states(problem, solved.states[few], solved.region), part(solved.optima, few))


def test_no_states_no_optima(problem: Transfer) -> None:
    optima = solve_states(problem, np.empty((0, 3)))
    assert optima.state.shape == optima.costates.shape == (0, 3)
    assert optima.found.shape == (0,)


@pytest.mark.slow
def test_states_out_of_reach_are_not_found_and_spoil_no_others(
    problem: Transfer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sailnet.expert.index, "HORIZONS", (7.0,))  # the rest only costs time here
    reachable = (1.05, 0.15, 1.03)
    optima = solve_states(problem, [(1.0, 0.0, 2.0), reachable, (0.9, 0.0, 2.0)])
    np.testing.assert_array_equal(optima.found, [False, True, False])
    assert optima.time_of_flight[1] == pytest.approx(6.15517, abs=1e-5)
    for name, column in vars(part(optima, [0, 2])).items():
        if name == "jumps":
            assert not column.any()
        elif name == "searched":
            assert (column >= 7.0 * problem.target_radius**1.5).all()
        elif name != "state":
            assert np.isnan(column).all()


@pytest.mark.slow
def test_what_is_found_anywhere_is_no_wrong_answer(problem: Transfer) -> None:
    """States from all over: many cannot be reached, and what is found holds."""
    states = np.random.default_rng(7).uniform((0.9, -0.1, 0.8), (1.4, 0.2, 1.1), (3, 3))
    optima = solve_states(problem, states)
    found = np.flatnonzero(optima.found)
    assert len(found) >= 2
    for row in found[np.argsort(optima.time_of_flight[found])][:2]:
        start = np.concatenate([problem.target_state, optima.arrival_costates[row]])
        back = fly(problem, start, [0.0, optima.time_of_flight[row]]).states[-1]
        np.testing.assert_allclose(back[:3], states[row], atol=1e-6)
        h = hamiltonian(back, optima.cone_angle[row], problem.beta)
        assert abs(h) <= 60.0 * problem.delta


@pytest.mark.parametrize(
    ("state", "message"),
    [
        ((np.nan, 0.0, 1.0), r"three finite numbers with r > 0, not \[nan, 0.0, 1.0\]"),
        ((1.0, np.inf, 1.0), r"not \[1.0, inf, 1.0\]"),
        ((-1.0, 0.0, 1.0), r"not \[-1.0, 0.0, 1.0\]"),
        ((1.524, 0.0, 1.524**-0.5), "on the target orbit already"),
        ((1.3, 0.05, 1.0), "outside the region"),
        ((1.1, -0.1, 1.0), "outside the region"),
        ((1.1, 0.05, 1.4), "outside the region"),
    ],
)
def test_one_bad_state_refuses_the_batch(
    problem: Transfer, solved: Solved, state: tuple[float, float, float], message: str
) -> None:
    with pytest.raises(SolveError, match=message):
        solve_states(problem, [*solved.states[:3], state], solved.region)


def test_the_corners_of_the_region_belong_to_it(problem: Transfer, solved: Solved) -> None:
    optima = solve_states(problem, np.array(solved.region), solved.region)
    assert optima.found.all()


@pytest.mark.exhaustive
def test_rivals_are_slower_and_do_exist(problem: Transfer, solved_everywhere: Solved) -> None:
    solved = solved_everywhere
    optima = solved.optima
    rows = np.flatnonzero(np.isfinite(optima.rival_time))
    assert len(rows) >= 3
    assert (optima.rival_time[rows] > optima.time_of_flight[rows] + 1e-6).all()
    for row in rows[np.argsort(optima.rival_time[rows])][:3]:
        other = extremal_with_time(problem, solved, row, optima.rival_time[row])
        away = other / np.linalg.norm(other)
        mine = optima.arrival_costates[row] / np.linalg.norm(optima.arrival_costates[row])
        assert np.linalg.norm(away - mine) > 1e-4
        start = np.concatenate([problem.target_state, other])
        flown = fly(problem, start, [0.0, optima.rival_time[row]]).states[-1]
        np.testing.assert_allclose(flown[:3], solved.states[row], atol=1e-6)


def extremal_with_time(problem: Transfer, solved: Solved, row: int, time: float) -> Array:
    """Arrival direction of the extremal that Newton's method finds from a guess with this time of flight."""
    size, state = problem.target_radius, solved.states[row]
    scaled = state[None] * [1 / size, size**0.5, size**0.5]
    guesses = sailnet.expert.fastest._index(problem, scaled, solved.region, 1.0, None).look_up(scaled)
    near = np.abs(guesses.tau * size**1.5 - time) < 0.2
    directions = guesses.directions[near] * [size**0.5, size**2, size**2]
    tau = guesses.tau[near] * size**1.5
    shots = shoot(problem, np.tile(state, (len(tau), 1)), directions, tau)
    best = np.argmin(np.where(shots.residual < 1e-9, np.abs(shots.tau - time), np.inf))
    assert shots.tau[best] == pytest.approx(time, abs=1e-8)
    return np.asarray(shots.directions[best])


def test_without_rivals_the_optima_are_the_same(problem: Transfer, solved: Solved) -> None:
    agree(solve_states(problem, solved.states[:200], solved.region), part(solved.optima, slice(200)))

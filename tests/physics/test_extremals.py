"""Extremals propagated by sailnet against DOP853 on equations written by hand, and against golden values."""

import dataclasses
import math

import numpy as np
import pytest

from sailnet.errors import SolveError
from sailnet.expert.nominal import Nominal
from sailnet.expert.optima import Extremal
from sailnet.expert.shooting import shoot
from sailnet.physics.extremals import Extremals, arrival_gain, arrival_lambda_v, propagate_extremals
from sailnet.physics.pontryagin import evaluate_hamiltonian, guidance_law, hamiltonian_bound
from sailnet.physics.propagation import propagator
from sailnet.physics.transfer import Transfer, Transfers
from tests.reference import Array, fly, smoothed, unconstrained_angle

NOMINAL_ARRIVAL = (-21.5117, 8.5435, -46.6171)


def law_of(problem: Transfer, kind: str) -> Transfer:
    """The same transfer with another form of the saturation."""
    forms = {
        "smooth": problem,
        "sharp": dataclasses.replace(problem, delta=1e-5),
        "exact": dataclasses.replace(problem, delta=0.0),
        "unconstrained": dataclasses.replace(problem, delta=0.0, phi_max=math.pi / 2),
    }
    return forms[kind]


def arrival(problem: Transfer, direction: Array) -> Array:
    """(6,) target state and the costates along ``direction`` that make H = 0 there."""
    costates = direction / -float(arrival_gain(problem, direction[None])[0])
    return np.array([*problem.target_state, *costates])


def energy(problem: Transfer, states: Array) -> Array:
    alpha = guidance_law(problem, states[:, 4], states[:, 5])
    return evaluate_hamiltonian(problem, states[:, :3], states[:, 3:], alpha)


@pytest.mark.slow
@pytest.mark.parametrize(("delta", "bound"), [(1e-3, 2.31e-3), (1e-5, 3.6e-5), (0.0, 1e-9)])
def test_the_hamiltonian_stays_within_the_bound_delta_allows(
    problem: Transfer, nominal: Nominal, delta: float, bound: float
) -> None:
    transfer = dataclasses.replace(problem, delta=delta)
    start = np.array([[1.0, 0.0, 1.0]])
    guess = nominal.constrained
    shots = shoot(transfer, start, guess.arrival_costates[None], np.array([guess.time_of_flight]))
    assert shots.residual[0] < 1e-10
    x = arrival(transfer, shots.directions[0])
    tau = np.linspace(0.0, shots.tau[0], 2001)
    states = propagate_extremals(transfer, x[None, 3:], tau).states[0]
    largest = np.abs(energy(transfer, states)).max()
    assert largest < bound
    if delta > 0.0:
        assert largest > 0.9 * bound  # the bound is the paper's law's, not slack


@pytest.mark.slow
def test_the_nominal_s_arrival_costates(nominal: Nominal) -> None:
    np.testing.assert_allclose(nominal.smoothed.arrival_costates, NOMINAL_ARRIVAL, rtol=0, atol=6e-5)


def test_the_nominal_flown_back_meets_the_departure_orbit(problem: Transfer, nominal: Nominal) -> None:
    found = propagate_extremals(
        problem, nominal.smoothed.arrival_costates, [0.0, nominal.smoothed.time_of_flight]
    )
    np.testing.assert_allclose(found.states[0, 0, :3], problem.target_state, atol=1e-15)
    np.testing.assert_allclose(found.states[0, 1, :3], (1.0, 0.0, 1.0), atol=1e-10)
    # The printed digits alone, without anything solved here:
    printed = propagate_extremals(problem, NOMINAL_ARRIVAL, [0.0, 7.01838])
    np.testing.assert_allclose(printed.states[0, 1, :3], (1.0, 0.0, 1.0), atol=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["smooth", "sharp", "exact", "unconstrained"])
@pytest.mark.parametrize(
    "direction",
    [
        (-20.81666, 7.31994, -45.17494),  # Case 2, one jump
        (-22.5, 10.0, -49.0),
        (-20.5, 5.5, 42.0),  # the other root of Eq. (19)
    ],
)
def test_an_extremal_agrees_with_dop853(
    problem: Transfer, kind: str, direction: tuple[float, float, float]
) -> None:
    transfer = law_of(problem, kind)
    start = arrival(transfer, np.array(direction))
    tau = np.linspace(0.0, 10.0, 101)
    found = propagate_extremals(transfer, start[3:], tau)
    reference = fly(transfer, start, tau)
    assert found.jumps[0] == len(reference.jump_times)
    last = reference.jump_times[-1] if reference.jump_times else math.nan
    assert found.jump_times[0] == pytest.approx(last, abs=1e-7, nan_ok=True)
    error = np.abs(found.states[0] - reference.states) / np.maximum(1.0, np.abs(reference.states))
    assert np.nanmax(error) < 1e-7
    assert not np.isnan(found.states).any()


def test_the_directions_above_do_jump(problem: Transfer) -> None:
    found = case_2(problem, np.array([0.0, 10.0]))
    assert found.jumps[0] == 1


def case_2(problem: Transfer, tau: Array) -> Extremals:
    return propagate_extremals(problem, arrival(problem, np.array([-20.81666, 7.31994, -45.17494]))[3:], tau)


@pytest.mark.slow
def test_the_jump_is_where_lambda_v_vanishes_with_lambda_u_positive(
    problem: Transfer, jumping: Extremal
) -> None:
    at = jumping.jump_time
    hair = 1e-7
    tau = [0.0, at - hair, at, at + hair]
    found = propagate_extremals(problem, jumping.arrival_costates, tau)
    later, jump, earlier = found.states[0, 1:]
    assert found.jumps[0] == 1
    assert abs(jump[5]) < 1e-11
    assert jump[4] > 0.01
    assert later[5] * earlier[5] < 0.0
    alpha = guidance_law(problem, found.states[0, 1:, 4], found.states[0, 1:, 5])
    assert abs(alpha[2] - alpha[0]) > 2 * math.radians(59.0)
    np.testing.assert_allclose(later[:5], earlier[:5], atol=1e-5)  # states and costates do not jump


def test_a_crossing_with_lambda_u_negative_is_no_jump(problem: Transfer) -> None:
    angle = np.linspace(0.0, 2 * np.pi, 64, endpoint=False)
    directions = np.column_stack([0.4 * np.ones(64), np.cos(angle), np.sin(angle)])
    directions = directions[arrival_gain(problem, directions) < 0.0]
    found = propagate_extremals(problem, directions, np.linspace(0.0, 6.0, 601))
    rows, columns = np.nonzero(np.diff(np.sign(found.states[:, :, 5])))
    smooth = found.states[rows, columns, 4] < 0.0
    assert smooth.sum() > 10
    assert (~smooth).sum() > 10
    jumps = np.bincount(rows[~smooth], minlength=len(directions))
    np.testing.assert_array_equal(found.jumps, jumps)
    np.testing.assert_array_equal(np.isnan(found.jump_times), jumps == 0)


@pytest.mark.slow
def test_a_branch_that_is_not_flipped_ends_elsewhere(problem: Transfer, jumping: Extremal) -> None:
    start = np.array([*problem.target_state, *jumping.arrival_costates])
    tau = np.array([0.0, jumping.jump_time - 0.01, jumping.time_of_flight])
    found = propagate_extremals(problem, start[3:], tau).states[0]
    fixed = fly(problem, start, tau, flip=False).states
    flipped = fly(problem, start, tau).states
    np.testing.assert_allclose(found[1], fixed[1], atol=1e-8)
    np.testing.assert_allclose(found[2], flipped[2], atol=1e-8)
    assert np.abs(found[2, :3] - fixed[2, :3]).max() > 0.01


@pytest.mark.parametrize("kind", ["smooth", "sharp", "exact", "unconstrained"])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_eq_19_has_a_root_of_each_sign(problem: Transfer, kind: str, sign: float) -> None:
    transfer = law_of(problem, kind)
    for lu in (-10.0, 0.0, 5.0, 8.5435, 11.0, 40.0):
        lv = arrival_lambda_v(transfer, lu, sign)
        assert np.sign(lv) == -sign
        alpha = float(smoothed(unconstrained_angle(lu, lv, sign), transfer.phi_max, transfer.delta))
        assert np.sign(alpha) == sign
        pressure = transfer.beta / transfer.target_radius**2
        eq_19 = 1 + pressure * np.cos(alpha) ** 2 * (lu * np.cos(alpha) + lv * np.sin(alpha))
        assert abs(eq_19) < 1e-11
        assert arrival_lambda_v(transfer, lu, -sign) == pytest.approx(-lv, rel=1e-12)


def test_earth_mars_takes_the_negative_root(problem: Transfer) -> None:
    assert arrival_lambda_v(problem, 8.5435, 1.0) == pytest.approx(-46.6171, abs=1e-3)


@pytest.mark.slow
def test_eq_19_without_a_root_is_an_error(problem: Transfer) -> None:
    limit = -(problem.target_radius**2) / problem.beta  # below it the sail gains too much facing the Sun
    with pytest.raises(SolveError, match="lambda_U0 = -20"):
        arrival_lambda_v(problem, -20.0, 1.0)
    with pytest.raises(SolveError, match="no root"):
        arrival_lambda_v(problem, limit * 1.001, -1.0)
    assert arrival_lambda_v(problem, limit * 0.999, -1.0) > 0.0


def test_the_arrival_gain_is_homogeneous(problem: Transfer) -> None:
    directions = np.random.default_rng(2).normal(size=(100, 3))
    gain = arrival_gain(problem, directions)
    np.testing.assert_allclose(arrival_gain(problem, 7.0 * directions), 7.0 * gain, rtol=1e-13)
    directions[:, 0] = 1e3  # lambda_R drops out
    np.testing.assert_array_equal(arrival_gain(problem, directions), gain)


def test_extremals_do_not_depend_on_their_neighbours(problem: Transfer) -> None:
    rng = np.random.default_rng(4)
    costates = np.column_stack([rng.uniform(-23, -20, 21), rng.uniform(5, 11, 21), np.zeros(21)])
    costates[:, 2] = [arrival_lambda_v(problem, lu, 1.0) for lu in costates[:, 1]]
    tau = np.linspace(0, 10, 11)
    together = propagate_extremals(problem, costates, tau)
    alone = propagate_extremals(problem, costates[13], tau)
    np.testing.assert_allclose(alone.states[0], together.states[13], rtol=1e-9, atol=1e-9)
    assert alone.jumps[0] == together.jumps[13]
    order = rng.permutation(21)
    shuffled = propagate_extremals(problem, costates[order], tau)
    np.testing.assert_allclose(shuffled.states, together.states[order], rtol=1e-9, atol=1e-9)
    np.testing.assert_array_equal(shuffled.jumps, together.jumps[order])


def test_a_failure_is_nan_and_stays_in_its_row(problem: Transfer, nominal: Nominal) -> None:
    good = nominal.smoothed.arrival_costates
    found = propagate_extremals(problem, np.array([good, [np.nan, 1.0, 1.0], good]), np.linspace(0, 7, 5))
    assert np.isnan(found.states[1]).all()
    assert np.isfinite(found.states[[0, 2]]).all()


def test_every_row_may_have_a_grid_of_its_own(problem: Transfer) -> None:
    costates = np.array([arrival(problem, np.array([-20.8, lu, -45.0]))[3:] for lu in np.linspace(5, 11, 11)])
    ends = np.linspace(4.0, 9.0, 11)
    grids = ends[:, None] * np.linspace(0.0, 1.0, 6) ** 2
    found = propagate_extremals(problem, costates, grids)
    np.testing.assert_array_equal(found.tau, grids)
    assert found.states.shape == (11, 6, 6)
    for row in (0, 4, 10):
        reference = fly(problem, arrival(problem, costates[row]), grids[row])
        error = np.abs(found.states[row] - reference.states) / np.maximum(1.0, np.abs(reference.states))
        assert np.max(error) < 1e-7
    # A jump later than a row's last time is not that row's.
    assert set(found.jumps) == {0, 1}
    assert (found.jump_times[found.jumps == 1] <= ends[found.jumps == 1]).all()


def test_one_grid_for_all_rows(problem: Transfer) -> None:
    costates = np.array([arrival(problem, np.array([-20.8, lu, -45.0]))[3:] for lu in (6.0, 7.0, 8.0)])
    grid = np.linspace(0.0, 8.0, 5)
    shared = propagate_extremals(problem, costates, grid)
    np.testing.assert_array_equal(shared.tau, np.tile(grid, (3, 1)))
    own = propagate_extremals(problem, costates, np.tile(grid, (3, 1)))
    np.testing.assert_array_equal(own.states, shared.states)


def test_a_fall_into_the_sun_ends_and_spoils_no_neighbour() -> None:
    """Direction 281 hangs without a limit to the number of steps, and others share its batch."""
    weak = Transfer(beta=0.1, phi_max=math.radians(60.0), delta=0.0, target_radius=1.524)
    directions = np.random.default_rng(4).normal(size=(400, 3))
    directions = directions[arrival_gain(weak, directions) < 0.0]
    tau = np.linspace(0.0, 25.0, 251)
    found = propagate_extremals(weak, directions, tau)
    fell = np.isnan(found.states[:, -1, 0])
    assert np.isnan(found.states[fell]).all()
    assert np.isfinite(found.states[~fell]).all()
    assert fell[281]
    assert 2 <= fell.sum() < 0.1 * len(fell)
    on_its_way = propagate_extremals(weak, directions[281], [0.0, 23.9]).states[0, 1]
    assert 0.0 < on_its_way[0] < 0.05
    beside = [278, 279, 280, 282, 283, 284, 285, 286]
    assert not fell[beside].any()
    alone = propagate_extremals(weak, directions[beside], tau)
    np.testing.assert_allclose(found.states[beside], alone.states, rtol=1e-7, atol=1e-7)


@pytest.mark.parametrize("kind", ["smooth", "sharp", "exact", "unconstrained"])
@pytest.mark.parametrize("duration", [4.0, 6.15517])
def test_the_tangents_are_derivatives_across_the_jump_too(
    problem: Transfer, kind: str, duration: float
) -> None:
    transfer = law_of(problem, kind)
    start = arrival(transfer, np.array([-20.81666, 7.31994, -45.17494]))
    engine = propagator(transfer, variational=True)
    along = np.random.default_rng(5).normal(size=(3, 2))
    tangents = np.zeros((6, 2, engine.lanes))
    tangents[3:] = along[:, :, None]
    for _ in range(2):  # twice: nothing of the last flight may be left
        engine.start(transfer, np.tile(start[:, None], engine.lanes), tangents)
        np.testing.assert_array_equal(engine.tangents(), tangents)
        engine.integrator.propagate_until([duration] * engine.lanes)
        found = engine.tangents()
    assert engine.jumps[0] == (1 if duration > 5.4 else 0)
    step = 2e-5
    moved = np.concatenate([start[3:] + step * along.T, start[3:] - step * along.T])
    ends = propagate_extremals(transfer, moved, [0.0, duration]).states[:, 1]
    expected = (ends[:2] - ends[2:]).T / (2 * step)
    scale = np.abs(expected).max(axis=1, keepdims=True)
    for lane in range(engine.lanes):
        np.testing.assert_allclose(found[:, :, lane] / scale, expected / scale, rtol=0, atol=2e-5)


def test_the_slopes_are_the_derivative_by_time_to_go(problem: Transfer, jumping: Extremal) -> None:
    engine = propagator(problem)
    start = np.array([*problem.target_state, *jumping.arrival_costates])
    for at in (0.0, 3.0, 6.0):
        engine.start(problem, np.tile(start[:, None], engine.lanes))
        engine.integrator.propagate_until([at] * engine.lanes)
        slope, here = engine.slopes()[:, 0], engine.integrator.state[:6, 0].copy()
        grid = [0.0, at + 1e-4, at + 2e-4]
        ahead = propagate_extremals(problem, start[3:], grid).states[0]
        estimate = (4 * ahead[1] - ahead[2] - 3 * here) / 2e-4
        np.testing.assert_allclose(slope, estimate, rtol=1e-5, atol=1e-5)


def test_every_row_may_have_a_sail_of_its_own(problem: Transfer) -> None:
    beta = problem.beta * np.linspace(0.8, 1.2, 7)
    sails = Transfers(problem, beta)
    direction = np.tile([-20.81666, 7.31994, -45.17494], (7, 1))
    costates = direction / -arrival_gain(sails, direction)[:, None]
    found = propagate_extremals(sails, costates, [0.0, 6.5])
    targets = found.states[:, 1, :3]
    shots = shoot(sails, targets, direction + 0.05, np.full(7, 6.45))
    assert shots.residual.max() <= 1e-10
    alpha = guidance_law(problem, found.states[:, 1, 4], found.states[:, 1, 5])
    bound = hamiltonian_bound(sails, found.states[..., :3], found.states[..., 3:])
    h = evaluate_hamiltonian(sails, targets, found.states[:, 1, 3:], alpha)
    assert (np.abs(h) <= bound).all()
    for row in (0, 3, 6):
        own = dataclasses.replace(problem, beta=float(beta[row]))
        alone = propagate_extremals(own, costates[row], [0.0, 6.5])
        np.testing.assert_allclose(alone.states[0], found.states[row], rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(shots.tau[row], 6.5, rtol=0, atol=1e-8)
    assert sails.rows(np.array([2])).beta == beta[2]

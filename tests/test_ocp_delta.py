"""The delta method: its series, flights, criteria and heuristics, against closed forms and shooting."""

import math
from dataclasses import replace

import heyoka as hy
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sailnet.errors import SailnetError
from sailnet.ocp import (
    Bounded,
    ConvergenceError,
    Direction,
    Exact,
    FreeTime,
    L2Norm,
    Problem,
    Schedule,
    Solution,
    delta,
    shooting,
    symbols,
)
from sailnet.ocp.delta.controls import Controls
from sailnet.ocp.delta.flight import Flyer
from sailnet.ocp.delta.heuristics import Heuristic, Search
from sailnet.ocp.delta.polish import Polished, minimising
from sailnet.ocp.delta.sensitivity import aligned, linearised, switches
from sailnet.ocp.delta.series import zeros
from sailnet.ocp.delta.solver import Delta
from sailnet.ocp.problems import asteroid_rendezvous, leo_geo, lunar_landing
from sailnet.physics.arrays import Array
from tests.test_ocp_problem import differences

BASES = [delta.Fourier(), delta.Chebyshev(), delta.Legendre()]
HEURISTICS: list[Heuristic] = [
    delta.GaPso(population=50, flights=10),
    delta.Imperialist(countries=50, imperialists=5),
    delta.CmaEs(population=20),
]


def double_integrator(end: float = 0.0) -> Problem:
    """From rest at 1 to rest at the end, fastest: 2 sqrt(1 - end), the switch half way."""
    x, v, u = symbols("x v u")
    return Problem(
        name="double-integrator",
        source="Pontryagin et al.",
        dynamics={x: v, v: u},
        controls=[Bounded(u, -1.0, 1.0)],
        final_time=FreeTime(1.7),
        initial={x: 1.0, v: 0.0},
        final={x: end, v: 0.0},
        running_cost=hy.expression(1.0),
    )


@pytest.fixture(scope="module")
def rendezvous() -> Solution:
    smooth = shooting.solve(asteroid_rendezvous.problem(), L2Norm(), Schedule(1.0, 1e-2))
    return shooting.solve(asteroid_rendezvous.problem(), Exact(), guess=smooth, samples=400)


@pytest.fixture(scope="module")
def landing() -> Solution:
    return shooting.solve(lunar_landing.problem(), Exact(), samples=400)


def fitted(found: Delta, solution: Solution) -> Array:
    """The point z whose series are nearest to a solution's switching functions and angles."""
    controls, s = found.controls, solution.time / solution.final_time
    wanted = np.empty((len(s), controls.channels))
    for switched in controls.switched:
        wanted[:, switched.channel] = solution.switching[:, switched.index]
    for pointed in controls.pointed:
        a = solution.control[:, pointed.columns]
        wanted[:, pointed.channels[0]] = np.unwrap(np.arctan2(a[:, 0], a[:, 1]))
    values = controls.basis.values(s, controls.terms)
    z = np.linalg.lstsq(values, wanted, rcond=None)[0].T.ravel()
    time = [solution.final_time / found.problem.time_guess] if found.problem.time_is_free else []
    return np.concatenate([z, time])


@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_slopes_are_those_of_the_values(basis: delta.Basis) -> None:
    s = np.linspace(0.05, 0.95, 7)
    for row, when in zip(basis.slopes(s, 9), s, strict=True):
        expected = differences(lambda t: basis.values(t, 9)[0], np.array([when]))[:, 0]
        np.testing.assert_allclose(row, expected, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_series_are_orthogonal(basis: delta.Basis) -> None:
    if basis.name == "Fourier":
        s, weights = np.linspace(-1.0, 1.0, 65)[:-1], np.full(64, 1.0 / 32.0)
    else:
        rule = {"Chebyshev": np.polynomial.chebyshev.chebgauss, "Legendre": np.polynomial.legendre.leggauss}
        x, weights = rule[basis.name](40)
        s = 0.5 * (x + 1.0)
    values = basis.values(s, 9)
    gram = values.T @ (weights[:, None] * values)
    np.testing.assert_allclose(gram, np.diag(np.diag(gram)), atol=1e-13)
    assert np.all(np.diag(gram) > 0.05)


@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_zeros_are_all_found(basis: delta.Basis) -> None:
    s = np.linspace(0.0, 1.0, 200)
    wanted = np.array([0.2, 0.21, 0.7])
    f = np.prod(s[:, None] - wanted, axis=1)
    coefficients = np.linalg.lstsq(basis.values(s, 20), f, rcond=None)[0]
    found = zeros(basis, coefficients)
    np.testing.assert_allclose(found, wanted, atol=1e-4)
    np.testing.assert_allclose(basis.values(found, 20) @ coefficients, 0.0, atol=1e-14)


@pytest.mark.parametrize("size", [2, 3])
def test_angles_make_unit_vectors_and_their_tangents(size: int) -> None:
    x = symbols(" ".join(f"x{i}" for i in range(size)))
    a = symbols(" ".join(f"a{i}" for i in range(size)))
    problem = Problem(
        name="steering",
        source="none",
        dynamics=dict(zip(x, a, strict=True)),
        controls=[Direction(tuple(a))],
        final_time=1.0,
        initial=dict.fromkeys(x, 0.0),
        terminal_cost=x[0],
    )
    controls = Controls(problem, delta.Legendre(), 1)
    rng = np.random.default_rng(0)
    angles = rng.uniform(-3.0, 3.0, size - 1)
    weights = rng.standard_normal(size)

    def unit(values: Array) -> Array:
        return np.asarray(controls.controls(values.reshape(1, 1, -1), np.zeros((1, 1, 0)))[0, 0])

    assert np.linalg.norm(unit(angles)) == pytest.approx(1.0, abs=1e-15)
    turned = controls.turned(angles.reshape(1, 1, -1), weights.reshape(1, 1, -1))[0, 0]
    np.testing.assert_allclose(turned, weights @ differences(unit, angles), atol=1e-7)


def test_a_switch_within_an_interval_is_flown_as_if_at_a_node() -> None:
    # The mean of the throttle alone would leave an error of second order in the position.
    problem = double_integrator()
    controls = Controls(problem, delta.Legendre(), 2)
    flyer = Flyer(problem, controls)
    errors = []
    for share in (0.37, 0.61):
        # f_s falls through zero: first u = -1, then +1, from a series that begins negative.
        z = np.array([[1.0 - 2.0 * share, 1.0, 1.0]])
        time, switch = 1.7, share * 1.7
        left = time - switch
        exact = [1.0 + 0.5 * switch**2 + switch * left - 0.5 * left**2, switch - left]
        for count in (10, 20, 23):
            state = flyer.fly(z, np.linspace(0.0, 1.0, count + 1)).final_state[0]
            errors.append(np.abs(state - exact).max())
    assert max(errors) < 1e-12


@pytest.mark.parametrize(
    ("basis", "terms", "end"),
    [(delta.Fourier(), 16, 5e-6), (delta.Chebyshev(), 16, 1e-5), (delta.Legendre(), 16, 1e-5)],
)
def test_criteria_vanish_on_the_extremal_alone(
    rendezvous: Solution, basis: delta.Basis, terms: int, end: float
) -> None:
    found = Delta(asteroid_rendezvous.problem(), basis, terms, 60)
    z = fitted(found, rendezvous)
    s = aligned(found.controls, z, 400)
    true = found.evaluate(z[None], s)[1]
    assert true.worst_end[0] < end
    assert 0.0 <= true.delta_s_h[0] + 1e-12 < 1e-10
    assert true.delta_s_i[0] < 1e-4
    assert true.delta_u[0] < 2e-6
    assert true.cost[0] == pytest.approx(rendezvous.cost, rel=1e-4)
    # The costates that fit are those of shooting, which were not asked for.
    first = true.costate[0, 0, 0]
    np.testing.assert_allclose(first, rendezvous.costate[0], rtol=1e-3)
    rng = np.random.default_rng(1)
    moved = found.evaluate(z[None] + 0.03 * rng.standard_normal((20, len(z))), np.linspace(0, 1, 201))[1]
    for kind, factor in (("worst_end", 100), ("delta_s_h", 1000), ("delta_s_i", 100), ("delta_u", 100)):
        assert np.all(getattr(moved, kind) > factor * getattr(true, kind)[0]), kind


def test_criteria_of_the_landing(landing: Solution) -> None:
    found = Delta(lunar_landing.problem(), delta.Legendre(), 12, 60)
    z = fitted(found, landing)
    true = found.evaluate(z[None], aligned(found.controls, z, 400))[1]
    assert true.worst_end[0] < 1e-5
    assert true.delta_h[0] < 1e-5
    assert abs(true.delta_s_h[0]) < 1e-12
    # No switching function of this problem has three zeros, so no costates can excuse three switches.
    other = np.zeros_like(z)
    other[3], other[-1] = 1.5, z[-1]
    wrong = found.evaluate(other[None], aligned(found.controls, other, 400))[1]
    assert wrong.delta_h[0] + wrong.delta_s_h[0] > 1e-2
    assert wrong.delta_s_i[0] > 0.1
    assert wrong.worst_end[0] > 1e-2
    assert wrong.total(delta.Weights())[0] > true.total(delta.Weights())[0] + 1.0


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**31))
def test_no_control_has_less_than_the_least_hamiltonian(seed: int) -> None:
    found = Delta(asteroid_rendezvous.problem(), delta.Fourier(), 5, 20)
    lower, upper = found.controls.bounds
    z = np.random.default_rng(seed).uniform(lower, upper, (5, len(lower)))
    s = np.linspace(0.0, 1.0, 21)
    criteria = found.evaluate(z, s)[1]
    finite = np.isfinite(criteria.delta_s_h)
    assert finite.any()
    assert np.all(
        criteria.delta_s_h[finite] >= -1e-9 * (1.0 + np.abs(criteria.hamiltonian[finite]).sum(axis=1))
    )
    for name in ("ends", "delta_s_i", "delta_u"):
        assert np.all(getattr(criteria, name)[finite] >= 0.0)


def test_final_values_and_final_equations_are_the_same() -> None:
    plain = double_integrator(0.25)
    x, v = plain.states
    said = replace(plain, final={v: 0.0}, final_equations=[x - 0.25])
    z = np.random.default_rng(2).uniform(-1.0, 1.0, (6, 4))
    z[:, -1] = 1.0
    s = np.linspace(0.0, 1.0, 31)
    totals = [
        Delta(problem, delta.Chebyshev(), 3, 30).evaluate(z, s)[1].total(delta.Weights())
        for problem in (plain, said)
    ]
    np.testing.assert_allclose(totals[0], totals[1], rtol=1e-9)


def test_a_running_cost_of_the_state_drives_the_costate() -> None:
    x, u = symbols("x u")
    problem = Problem(
        name="ramp",
        source="x = t, so lambda' = -x gives (4 - t^2) / 2 + 3",
        dynamics={x: u},
        controls=[Bounded(u, -1.0, 1.0)],
        final_time=2.0,
        initial={x: 0.0},
        running_cost=0.5 * x**2,
        terminal_cost=3.0 * x,
    )
    flyer = Flyer(problem, Controls(problem, delta.Legendre(), 1))
    flights = flyer.fly(np.array([[-1.0]]), np.linspace(0.0, 1.0, 6))
    last, _ = flyer.final_costates(flights)
    costate = flyer.costates(flights, last)[0, :, :, 0, 0]
    np.testing.assert_allclose(costate, 5.0 - 0.5 * flights.time[0] ** 2, atol=1e-13)


def rosenbrock(points: Array) -> Array:
    return np.asarray(100.0 * (points[:, 1] - points[:, 0] ** 2) ** 2 + (1.0 - points[:, 0]) ** 2)


@pytest.mark.parametrize("heuristic", HEURISTICS, ids=lambda heuristic: str(heuristic.name))
def test_heuristics_use_their_budget_within_the_box_and_repeat(heuristic: Heuristic) -> None:
    lower, upper = np.array([-2.0, -1.0]), np.array([2.0, 3.0])
    met: list[Array] = []

    def cost(points: Array) -> Array:
        met.append(points.copy())
        return rosenbrock(points)

    runs = []
    for seed in (7, 7, 8):
        search = Search(cost, lower, upper, 3001)
        heuristic.run(search, seed)
        runs.append(search)
    first, again, other = runs
    assert first.used == again.used <= 3001
    assert first.used > 2800
    assert np.all(np.vstack(met) >= lower)
    assert np.all(np.vstack(met) <= upper)
    np.testing.assert_array_equal(first.best, again.best)
    assert first.history == again.history
    assert not np.array_equal(first.best, other.best)
    costs = [cost for _, cost in first.history]
    assert costs == sorted(costs, reverse=True)
    assert first.least < 1e-2
    assert first.least == rosenbrock(first.best[None])[0]


@pytest.mark.parametrize("heuristic", HEURISTICS, ids=lambda heuristic: str(heuristic.name))
@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_double_integrator_by_every_basis_and_heuristic(basis: delta.Basis, heuristic: Heuristic) -> None:
    solution = delta.solve(double_integrator(), basis, heuristic, 3000, seed=3, terms=3, nodes=20, goal=1e-2)
    assert solution.final_time == pytest.approx(2.0, abs=3e-2)
    (switch,) = solution.switches
    assert switch.time == pytest.approx(1.0, abs=3e-2)
    assert switch.rising
    assert solution["u"][0] == -1.0
    assert solution["u"][-1] == 1.0
    assert solution.residuals["boundary"] <= 1e-2
    assert np.abs(solution.hamiltonian).max() < 0.2
    assert solution.time[0] == 0.0
    assert np.all(np.diff(solution.time) >= 0.0)


def test_a_control_that_is_not_switched_is_a_series_itself() -> None:
    heuristic = delta.GaPso(population=50, flights=10)
    found = delta.solve(least_effort(), delta.Legendre(), heuristic, 3000, terms=3, nodes=10)
    assert 0.499 < found.cost < 0.51
    np.testing.assert_allclose(found["u"], 1.0, atol=0.5)
    assert found.residuals["delta_u"] < 0.15
    # H = u^2 / 2 + lambda u with lambda = -1.
    np.testing.assert_allclose(found.costate, -1.0, atol=0.05)
    np.testing.assert_allclose(found.hamiltonian, 0.5 * found["u"] ** 2 - found["u"], atol=0.1)


def test_a_flight_that_misses_its_end_is_no_solution() -> None:
    with pytest.raises(ConvergenceError, match="misses the end") as caught:
        delta.solve(asteroid_rendezvous.problem(), evaluations=60)
    assert caught.value.residuals["boundary"] > 1e-3
    assert caught.value.history[-1].iterations == 60
    solution = delta.solve(asteroid_rendezvous.problem(), evaluations=60, goal=math.inf)
    assert solution.residuals["boundary"] == caught.value.residuals["boundary"]


def test_problems_that_are_none_for_the_method() -> None:
    plain = double_integrator()
    x = plain.states[0]
    with pytest.raises(SailnetError, match="give all of it"):
        delta.solve(replace(plain, initial={x: 1.0}), evaluations=10)
    u = plain.control_variables[0]
    with pytest.raises(SailnetError, match="needs bounds of u"):
        delta.solve(replace(plain, controls=[Bounded(u)], running_cost=0.5 * u**2), evaluations=10)
    with pytest.raises(SailnetError, match="give more"):
        delta.solve(plain, evaluations=0)


def least_effort() -> Problem:
    """From 0 to 1 in one second: u = 1, between bounds that random series reach."""
    x, u = symbols("x u")
    return Problem(
        name="least-effort",
        source="closed form",
        dynamics={x: u},
        controls=[Bounded(u, -2.0, 3.0)],
        final_time=1.0,
        initial={x: 0.0},
        final={x: 1.0},
        running_cost=0.5 * u**2,
    )


@pytest.mark.parametrize("softness", [0.0, 0.4])
@pytest.mark.parametrize(
    ("problem", "basis", "rtol"),
    [
        (lunar_landing.problem(), delta.Chebyshev(), 1e-7),
        (asteroid_rendezvous.problem(), delta.Fourier(), 1e-5),
        (leo_geo.minimum_fuel(), delta.Legendre(), 1e-3),
        (least_effort(), delta.Legendre(), 1e-3),
    ],
    ids=lambda value: getattr(value, "name", None),
)
def test_sensitivities_are_those_of_flights(
    problem: Problem, basis: delta.Basis, rtol: float, softness: float
) -> None:
    controls = Controls(problem, basis, 5)
    flyer = Flyer(problem, controls)
    z = 0.3 * np.random.default_rng(4).uniform(*controls.bounds)
    for switched in controls.switched:
        z[5 * switched.channel : 5 * switched.channel + 5] = 0.1, 1.0, 0.3, 0.0, 0.0
    if problem.time_is_free:
        z[-1] = 1.0

    def values(z: Array) -> Array:
        linear = linearised(flyer, z, 100, softness)
        return np.concatenate([[linear.cost], linear.errors])

    linear = linearised(flyer, z, 100, softness)
    assert bool(switches(controls, z)) == bool(controls.switched)
    expected = np.array([(values(z + h) - values(z - h)) / 2e-5 for h in 1e-5 * np.eye(len(z))]).T
    found = np.vstack([linear.cost_slope, linear.error_slopes])
    for row, wanted in zip(found, expected, strict=True):
        np.testing.assert_allclose(row, wanted, atol=rtol * np.abs(wanted).max())
    # What SLSQP makes of others is wrong, and says nothing.
    assert linear.error_slopes.flags.c_contiguous


def test_soft_switches_become_sharp() -> None:
    controls = Controls(double_integrator(), delta.Legendre(), 2)
    flyer = Flyer(double_integrator(), controls)
    z, s = np.array([[0.2, 1.0, 1.0]]), np.linspace(0.0, 1.0, 401)
    sharp = flyer.fly(z, s).final_state
    gaps = [np.abs(flyer.fly(z, s, softness).final_state - sharp).max() for softness in (0.5, 0.1, 0.02)]
    assert gaps == sorted(gaps, reverse=True)
    assert gaps[0] > 0.05
    assert gaps[-1] < 2e-3


def test_minimising_keeps_the_extremal(rendezvous: Solution) -> None:
    found = Delta(asteroid_rendezvous.problem(), delta.Legendre(), 16, 60)
    z = fitted(found, rendezvous)
    again = minimising(found.judge, z, 200)
    s = np.linspace(0.0, 1.0, 50)
    before, after = (found.controls.series(each[None], s)[0] for each in (z, again))
    (switched,), (pointed,) = found.controls.switched, found.controls.pointed
    angle = pointed.channels[0]
    np.testing.assert_allclose(after[:, angle], before[:, angle], atol=2e-3)
    sizes = [np.abs(rows[:, switched.channel]).max() for rows in (before, after)]
    unit = [rows[:, switched.channel] / size for rows, size in zip((before, after), sizes, strict=True)]
    np.testing.assert_allclose(unit[1], unit[0], atol=2e-3)
    # An angle that makes the Hamiltonian greatest is no extremal: it turns round.
    turned = z.copy()
    turned[angle * 16] += math.pi
    back = found.controls.series(minimising(found.judge, turned, 200)[None], s)[0][:, angle]
    assert np.abs(np.cos(back - before[:, angle])).min() > 0.5


@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_polish_brings_in_a_switch(basis: delta.Basis) -> None:
    # A series without a zero, which no derivative would give one.
    found = Delta(double_integrator(), basis, 3, 20)
    start = np.array([0.5, 0.1, 0.05, 0.9])
    assert not switches(found.controls, start)
    polished = delta.Polish(evaluations=300).run(found.judge, start, 20)
    assert polished.cost == pytest.approx(2.0, abs=1e-5)
    assert polished.worst_end < 1e-6
    assert polished.evaluations <= 301
    ((when, _),) = switches(found.controls, polished.point)
    assert when == pytest.approx(0.5, abs=1e-4)


def test_a_polish_keeps_the_better_of_two() -> None:
    def point(cost: float, end: float) -> Polished:
        return Polished(np.zeros(1), cost, end, 1)

    assert point(1.0, 1e-9).beats(point(2.0, 1e-12), 1e-6)
    assert not point(1.0, 1e-5).beats(point(2.0, 1e-7), 1e-6)
    assert point(3.0, 1e-7).beats(point(2.0, 1e-5), 1e-6)


def test_restarts_and_polish_within_the_evaluations() -> None:
    heuristic = delta.GaPso(population=50, flights=5)
    settings = {"terms": 4, "nodes": 20, "stages": 1, "polish": delta.Polish(150), "restarts": 2, "box": 0.25}
    runs = [
        delta.solve(double_integrator(0.25), delta.Legendre(), heuristic, 600, 1, **settings)  # type: ignore[arg-type]
        for _ in range(2)
    ]
    np.testing.assert_array_equal(runs[0].state, runs[1].state)
    assert runs[0].solver.endswith("polished")
    assert runs[0].history[-1].iterations <= 600
    assert runs[0].residuals["boundary"] < 2e-6
    assert runs[0].final_time == pytest.approx(math.sqrt(3.0), abs=1e-5)
    with pytest.raises(SailnetError, match="a search and an evaluation a stage"):
        delta.solve(double_integrator(), evaluations=600, polish=delta.Polish(300), restarts=2)

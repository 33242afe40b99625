"""The delta method: a heuristic looks for the series whose flight meets the ends and Pontryagin's conditions.

Paper 004, Fig. 1 and Eqs. (8)-(25).
"""

import time
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from sailnet.errors import SailnetError
from sailnet.ocp.delta.controls import Controls
from sailnet.ocp.delta.criteria import Criteria, Judge, Weights
from sailnet.ocp.delta.flight import Flights
from sailnet.ocp.delta.heuristics import GaPso, Heuristic, Search
from sailnet.ocp.delta.polish import Polish, Polished
from sailnet.ocp.delta.sensitivity import aligned, linearised, switches
from sailnet.ocp.delta.series import Basis, Fourier
from sailnet.ocp.problem import Problem
from sailnet.ocp.solution import ConvergenceError, Solution, Step, Switch, Table
from sailnet.physics.arrays import Array

GOAL = 1e-3
"""Largest error at the end of an accepted flight, in the problem's units."""

NARROWING = 0.5
"""Ratio of the boxes of two stages."""

CHUNK = 40
"""Flights at a time; the matrices of more do not fit a processor's caches."""


class Delta:
    """The delta method's cost of a problem, of points z.

    Args:
        problem: the problem.
        basis: of the series.
        terms: of each series.
        nodes: intervals of the search's flights.
    """

    def __init__(self, problem: Problem, basis: Basis, terms: int, nodes: int) -> None:
        self.problem, self.nodes = problem, nodes
        self.controls = Controls(problem, basis, terms)
        self.judge = Judge(problem, self.controls)

    def cost(self, weights: Weights, z: Array) -> Array:
        """(m,) J_total of (m, d) points."""
        s = np.linspace(0.0, 1.0, self.nodes + 1)
        parts = [z[i : i + CHUNK] for i in range(0, len(z), CHUNK)]
        return np.concatenate([self.evaluate(part, s)[1].total(weights) for part in parts])

    def evaluate(self, z: Array, s: Array) -> tuple[Flights, Criteria]:
        """Flights over nodes of normalised time, and their criteria."""
        flights = self.judge.flyer.fly(z, s)
        return flights, self.judge.judge(flights)


def solve(
    problem: Problem,
    basis: Basis | None = None,
    heuristic: Heuristic | None = None,
    evaluations: int = 50_000,
    seed: int = 0,
    terms: int = 6,
    nodes: int = 60,
    weights: Weights | None = None,
    stages: int = 4,
    goal: float = GOAL,
    polish: Polish | None = None,
    restarts: int = 1,
    box: float = 1.0,
) -> Solution:
    """Solve a problem by the delta method.

    Args:
        problem: the problem; its initial state must be given, and its equations free of time.
        basis: of the series; Fourier's by default.
        heuristic: that searches; GA-PSO by default.
        evaluations: flights in all.
        seed: of the heuristic.
        terms: of each series.
        nodes: intervals of a flight; the accepted one is flown over four times as many, cut at its switches.
        weights: of the criteria in the first stage.
        stages: of a search, of equally many evaluations; each weighs the ends ten times as much as the one
            before, in a box NARROWING times as wide around its best point.
        goal: largest error at the end of an accepted flight.
        polish: what is done with the best point of a search, within the same evaluations; nothing by
            default, as in the paper.
        restarts: searches, of equally many evaluations.
        box: of the coefficients at first, as a share of the paper's. A polish may leave it.

    Returns:
        The best flight. Its ``residuals`` hold, beside the usual kinds, ``delta_s_h``, ``delta_s_i``,
        ``delta_u`` and ``delta_h``; its ``history`` the least cost after every generation, with the
        evaluations so far as iterations and the weight of the ends as rho.

    Raises:
        ConvergenceError: if the best flight does not end where it must.
        SailnetError: if the problem is none for this method.
    """
    began = time.perf_counter()
    basis, heuristic = basis or Fourier(), heuristic or GaPso()
    delta = Delta(problem, basis, terms, nodes)
    what = f"delta method, {basis.name} and {heuristic.name}" + (", polished" if polish else "")
    found = restarted(
        delta, heuristic, evaluations, seed, weights or Weights(), stages, polish, restarts, box
    )
    if not len(found.point):
        raise ConvergenceError(
            f"{what} on {problem.name}: no flight reaches its end; use more evaluations", {}, found.history
        )
    solution = flown(delta, found.point)
    solution.solver, solution.history = what, found.history
    solution.wall_time = time.perf_counter() - began
    if not solution.residuals["boundary"] <= goal:
        raise ConvergenceError(
            f"{what} on {problem.name} misses the end; more evaluations or terms may reach it",
            solution.residuals,
            found.history,
        )
    return solution


@dataclass(frozen=True)
class Found:
    """What a search has found.

    Attributes:
        point: z; empty if no flight has a finite cost.
        evaluations: flights used.
        history: of the searches.
    """

    point: Array
    evaluations: int
    history: list[Step]


def restarted(
    delta: Delta,
    heuristic: Heuristic,
    evaluations: int,
    seed: int,
    weights: Weights,
    stages: int,
    polish: Polish | None = None,
    restarts: int = 1,
    box: float = 1.0,
) -> Found:
    """The best of several searches, each polished if a polish is given; arguments are those of solve."""
    each = evaluations // max(restarts, 1)
    left = each - (polish.evaluations if polish else 0)
    if restarts < 1 or stages < 1 or left < stages or delta.controls.terms < 1 or delta.nodes < 2:
        raise SailnetError(
            "the delta method needs terms, two nodes, a search and an evaluation a stage at least; give more"
        )
    best: Polished | None = None
    used, history = 0, list[Step]()
    for restart in range(restarts):
        found = searched(delta, heuristic, left, seed + stages * restart, weights, stages, box)
        history += [replace(step, iterations=used + step.iterations) for step in found.history]
        used += found.evaluations
        if not len(found.point):
            continue
        linear = linearised(delta.judge.flyer, found.point, delta.nodes)
        made = Polished(found.point, linear.cost, float(np.abs(linear.errors).max(initial=0.0)), 0)
        if polish:
            made = polish.run(delta.judge, found.point, delta.nodes)
        used += made.evaluations
        if best is None or made.beats(best, polish.tolerance if polish else GOAL):
            best = made
    return Found(np.zeros(0) if best is None else best.point, used, history)


def searched(
    delta: Delta,
    heuristic: Heuristic,
    evaluations: int,
    seed: int,
    weights: Weights,
    stages: int,
    box: float = 1.0,
) -> Found:
    """The best point that a heuristic meets; arguments are those of solve."""
    lower, upper = delta.controls.bounds
    share = np.where(np.arange(len(lower)) < delta.controls.channels * delta.controls.terms, box, 1.0)
    floor, ceiling = share * lower, share * upper
    best, used, history = np.zeros(0), 0, list[Step]()
    for stage in range(stages):
        search = Search(
            partial(delta.cost, weights), floor, ceiling, evaluations * (stage + 1) // stages - used
        )
        if len(best):
            search(best[None])
        heuristic.run(search, seed + stage)
        history += [Step(weights.ends, cost, used + count, False) for count, cost in search.history]
        used += search.used
        if not len(search.best):
            break
        best = search.best
        reach = 0.5 * NARROWING * (ceiling - floor)
        floor, ceiling = np.maximum(lower, best - reach), np.minimum(upper, best + reach)
        weights = replace(weights, ends=10.0 * weights.ends)
    return Found(best, used, history)


def flown(delta: Delta, z: Array) -> Solution:
    """The flight of one point, cut at its switches, as a solution."""
    problem, functions = delta.problem, delta.judge.exact
    s = aligned(delta.controls, z, 4 * delta.nodes)
    flights, criteria = delta.evaluate(z[None], s)
    coarse = delta.judge.flyer.fly(z[None], aligned(delta.controls, z, 2 * delta.nodes))
    stop = float(flights.final_time[0])
    cuts = switches(delta.controls, z)
    # Begin of every interval and the last end; at a switch the end of the interval before as well.
    ends = np.isin(s[1:], [when for when, _ in cuts])
    ends[-1] = True
    rows = sorted([(k, 0) for k in range(len(s) - 1)] + [(int(k), 2) for k in np.flatnonzero(ends)])
    k, i = np.array(rows).T
    clock, x, u = flights.time[0, i, k], flights.state[0, i, k], flights.control[0, i, k]
    costate = criteria.costate[0, i, k]
    y = np.hstack([x, costate])
    modes = np.zeros((len(y), len(problem.bounded)))
    table = Table(
        time=clock,
        state=x,
        costate=costate,
        control=u,
        switching=functions.switching(clock, y, modes),
        hamiltonian=delta.judge.flyer.functions.hamiltonian(clock, x, costate, u),
    )
    residuals = {
        "boundary": float(criteria.worst_end[0]),
        "dynamics": float(np.abs(flights.final_state - coarse.final_state).max()) / 15.0,
        "delta_s_h": float(criteria.delta_s_h[0]),
        "delta_s_i": float(criteria.delta_s_i[0]),
        "delta_u": float(criteria.delta_u[0]),
    }
    if problem.time_is_free:
        residuals["delta_h"] = float(criteria.delta_h[0])
    names = [problem.bounded[switched.index].switching for switched in delta.controls.switched]
    channels = [switched.channel for switched in delta.controls.switched]
    coefficients = delta.controls.coefficients(z[None])[0]
    passed = [
        # A control rises where its series falls.
        Switch(
            when * stop,
            names[j],
            bool(delta.controls.basis.slopes([when], delta.controls.terms) @ coefficients[channels[j]] < 0.0),
        )
        for when, j in cuts
    ]
    return Solution(
        problem=problem.name,
        solver="delta method",
        **table,
        cost=float(criteria.cost[0]),
        residuals=residuals,
        switches=passed,
        names=problem.names,
        message=f"{len(passed)} switches",
    )

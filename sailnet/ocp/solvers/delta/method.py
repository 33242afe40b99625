"""The delta method: a heuristic looks for the series whose flight meets the ends and Pontryagin's conditions.

Paper 004, Fig. 1 and Eqs. (8)-(25).
"""

from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from sailnet.errors import SailnetError
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.solution import Step
from sailnet.ocp.solvers.delta.controls import Controls
from sailnet.ocp.solvers.delta.criteria import Criteria, Judge, Weights
from sailnet.ocp.solvers.delta.flight import Flights
from sailnet.ocp.solvers.delta.heuristics import Search
from sailnet.ocp.solvers.delta.options import GOAL, Options, RandomSeries
from sailnet.ocp.solvers.delta.polish import Polished
from sailnet.ocp.solvers.delta.sensitivity import linearised
from sailnet.physics.arrays import Array

NARROWING = 0.5
"""Ratio of the boxes of two stages."""

CHUNK = 40
"""Flights at a time; the matrices of more do not fit a processor's caches."""


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


class Delta:
    """The delta method's cost of a problem, of points z, and the searches for its least.

    Args:
        problem: the problem.
        options: the series, the flights and how they are searched.
    """

    def __init__(self, problem: Problem, options: Options) -> None:
        self.problem, self.options = problem, options
        self.controls = Controls(problem, options.basis, options.terms)
        self.judge = Judge(problem, self.controls)

    def cost(self, weights: Weights, z: Array) -> Array:
        """(m,) J_total of (m, d) points."""
        s = np.linspace(0.0, 1.0, self.options.nodes + 1)
        parts = [z[i : i + CHUNK] for i in range(0, len(z), CHUNK)]
        return np.concatenate([self.evaluate(part, s)[1].total(weights) for part in parts])

    def evaluate(self, z: Array, s: Array) -> tuple[Flights, Criteria]:
        """Flights over nodes of normalised time, and their criteria."""
        flights = self.judge.flyer.fly(z, s)
        return flights, self.judge.judge(flights)

    def search(self, guess: RandomSeries) -> Found:
        """The best of several searches, each polished if the options say so.

        Raises:
            SailnetError: too few evaluations for so many searches and stages.
        """
        options, polish = self.options, self.options.polish
        left = options.evaluations // guess.searches - (polish.evaluations if polish else 0)
        if left < options.stages:
            raise SailnetError(
                "the delta method needs an evaluation a stage and search at least,"
                " beside those of its polish; give more"
            )
        best: Polished | None = None
        used, history = 0, list[Step]()
        for number in range(guess.searches):
            found = self._staged(left, guess.seed + options.stages * number, guess.box)
            history += [replace(step, iterations=used + step.iterations) for step in found.history]
            used += found.evaluations
            if not len(found.point):
                continue
            linear = linearised(self.judge.flyer, found.point, options.nodes)
            made = Polished(found.point, linear.cost, float(np.abs(linear.errors).max(initial=0.0)), 0)
            if polish:
                made = polish.run(self.judge, found.point, options.nodes)
            used += made.evaluations
            if best is None or made.beats(best, polish.tolerance if polish else GOAL):
                best = made
        return Found(np.zeros(0) if best is None else best.point, used, history)

    def _staged(self, evaluations: int, seed: int, box: float) -> Found:
        """The best point that the heuristic meets in all stages of one search."""
        stages, weights = self.options.stages, self.options.weights
        lower, upper = self.controls.bounds
        share = np.where(np.arange(len(lower)) < self.controls.channels * self.controls.terms, box, 1.0)
        floor, ceiling = share * lower, share * upper
        best, used, history = np.zeros(0), 0, list[Step]()
        for stage in range(stages):
            search = Search(
                partial(self.cost, weights), floor, ceiling, evaluations * (stage + 1) // stages - used
            )
            if len(best):
                search(best[None])
            self.options.heuristic.run(search, seed + stage)
            history += [Step(weights.ends, cost, used + count, False) for count, cost in search.history]
            used += search.used
            if not len(search.best):
                break
            best = search.best
            reach = 0.5 * NARROWING * (ceiling - floor)
            floor, ceiling = np.maximum(lower, best - reach), np.minimum(upper, best + reach)
            weights = replace(weights, ends=10.0 * weights.ends)
        return Found(best, used, history)

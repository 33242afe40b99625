"""The delta method as a solver: series for the controls, found by a heuristic. Paper 004, Fig. 1."""

import time

from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.solution import ConvergenceError, Solution
from sailnet.ocp.solvers.delta.method import Delta
from sailnet.ocp.solvers.delta.options import Options, RandomSeries
from sailnet.ocp.solvers.delta.table import tabulate


def solve(problem: Problem, guess: RandomSeries | None = None, *, options: Options | None = None) -> Solution:
    """Solve a problem by the delta method.

    Args:
        problem: the problem; its initial state must be given, and its equations free of time.
        guess: the random series that its searches begin at; one search in the paper's box by default.
        options: how.

    Returns:
        The best flight. Its ``residuals`` hold, beside the usual kinds, ``delta_s_h``, ``delta_s_i``,
        ``delta_u`` and ``delta_h``; its ``history`` the least cost after every generation, with the
        evaluations so far as iterations and the weight of the ends as rho.

    Raises:
        ConvergenceError: if the best flight does not end where it must.
        SailnetError: if the problem is none for this method, or pygmo is missing.
    """
    began = time.perf_counter()
    options = options or Options()
    delta = Delta(problem, options)
    what = f"delta method, {options.basis.name} and {options.heuristic.name}"
    what += ", polished" if options.polish else ""
    found = delta.search(guess or RandomSeries())
    if not len(found.point):
        raise ConvergenceError(
            f"{what} on {problem.name}: no flight reaches its end; use more evaluations", {}, found.history
        )
    solution = tabulate(delta, found.point)
    solution.solver, solution.history = what, found.history
    solution.wall_time = time.perf_counter() - began
    if not solution.residuals["boundary"] <= options.goal:
        raise ConvergenceError(
            f"{what} on {problem.name} misses the end; more evaluations or terms may reach it",
            solution.residuals,
            found.history,
        )
    return solution

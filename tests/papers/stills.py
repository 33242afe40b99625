"""Solutions that are tables of states alone."""

import numpy as np

from sailnet.ocp import Problem, Solution


def _still(problem: Problem, states: list[list[float]]) -> Solution:
    """A table of states alone."""
    empty = np.zeros((len(states), 0))
    clock = np.linspace(0.0, problem.time_guess, len(states))
    return Solution(
        problem.name, "", clock, np.array(states), empty, empty, empty, clock, 0.0, {}, names=problem.names
    )

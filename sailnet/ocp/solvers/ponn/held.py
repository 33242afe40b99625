"""The end conditions that expressions make true by themselves: those that give one variable a value."""

import heyoka as hy
import numpy as np

from sailnet.ocp.definition.functions import ExtremalFunctions
from sailnet.physics.arrays import Array


def held_ends(first: ExtremalFunctions, last: ExtremalFunctions) -> tuple[list[Array], list[set[int]]]:
    """(2n,) values at either end, NaN for none, and the positions of the end conditions that they meet.

    End values of states are such conditions, and the transversality conditions of papers 000 and 002; a
    costate that depends on the state there is not, and stays among the losses.

    Args:
        first, last: functions of the first and of the last domain.
    """
    count = len(first.problem.states)
    zero = np.zeros(2 * count)
    residuals = (
        first.initial_residual(zero, np.zeros(len(first.ends.initial_multipliers)), _ones(first))[0],
        last.final_residual(0.0, zero, np.zeros(len(last.ends.final_multipliers)), _ones(last))[0],
    )
    parameters = set(first.problem.parameters)
    variables = [str(v) for v in first.equations.variables]
    found, known = [], []
    for rows, residual in zip((first.ends.initial, last.ends.final), residuals, strict=True):
        values, held = np.full(2 * count, np.nan), set[int]()
        # The first rows, one a state, say "state - value" or "costate - slope of the cost".
        for i in range(count):
            named = set(hy.get_variables(rows[i])) - parameters
            if len(named) == 1 and (name := named.pop()) in variables:
                values[variables.index(name)] = -residual[i]
                held.add(i)
        found.append(values)
        known.append(held)
    return found, known


def _ones(functions: ExtremalFunctions) -> Array:
    return np.ones(len(functions.equations.extras))

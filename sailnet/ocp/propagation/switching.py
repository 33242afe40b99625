"""Switches and arcs read off a tabulated extremal."""

from itertools import pairwise

import numpy as np

from sailnet.ocp.definition.canonical import canonical
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import Exact
from sailnet.ocp.definition.solution import Solution, Switch
from sailnet.physics.arrays import Array


def zero_crossings(problem: Problem, clock: Array, switching: Array) -> list[Switch]:
    """Zeros of tabulated switching functions, by linear interpolation."""
    found = []
    for control, s in zip(problem.bounded, switching.T, strict=True):
        for k in np.flatnonzero(s[:-1] * s[1:] < 0.0):
            when = clock[k] - s[k] * (clock[k + 1] - clock[k]) / (s[k + 1] - s[k])
            found.append(Switch(float(when), control.switching, bool(s[k] > 0.0)))
    return sorted(found, key=lambda switch: switch.time)


def structure_of(
    problem: Problem,
    solution: Solution,
    margin: float = 0.05,
    shortest: float = 0.02,
    singular: bool = True,
) -> list[tuple[float, str]]:
    """Read the sequence of arcs off a smoothed solution: (time of begin, letters) each.

    Args:
        problem: its problem.
        solution: smoothed, at a small parameter.
        margin: share of a control's range that still counts as its bound.
        shortest: share of the flight below which an interior stretch is a switch, not a singular arc.
        singular: whether there may be singular arcs.
    """
    begins: dict[float, list[tuple[int, str]]] = {}
    first = []
    columns = [problem.control_variables.index(control.variable) for control in problem.bounded]
    equations = canonical(problem, Exact())
    for i, (control, column) in enumerate(zip(problem.bounded, columns, strict=True)):
        # A control quadratic in H is between its bounds for a time; another one only on a singular arc.
        between = "s" if equations.corners[i] == equations.switching[i][1] else "0"
        share = (solution.control[:, column] - control.lower) / (control.upper - control.lower)
        # Without singular arcs the switching function alone decides, however wide the smoothing is.
        edge = margin if singular or between == "0" else 0.5
        letters = np.where(share > 1.0 - edge, "+", np.where(share < edge, "-", between))
        cuts = [0, *(np.flatnonzero(letters[1:] != letters[:-1]) + 1), len(letters)]
        runs = [
            (str(letters[a]), float(solution.time[a]), float(solution.time[min(b, len(letters) - 1)]))
            for a, b in pairwise(cuts)
        ]
        kept: list[tuple[str, float]] = []
        pending: float | None = None
        for letter, begin, end in runs:
            if letter == "s" and end - begin < shortest * solution.final_time:
                pending = 0.5 * (begin + end)
            elif not kept or kept[-1][0] != letter:
                kept.append((letter, begin if pending is None else pending))
                pending = None
        first.append(kept[0][0])
        for letter, begin in kept[1:]:
            begins.setdefault(begin, []).append((i, letter))
    arcs, word = [(0.0, "".join(first))], list(first)
    for begin in sorted(begins):
        for i, letter in begins[begin]:
            word[i] = letter
        arcs.append((begin, "".join(word)))
    return arcs

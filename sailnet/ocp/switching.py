"""Switches of a tabulated extremal."""

import numpy as np

from sailnet.dynamics import Array
from sailnet.ocp.problem import Problem
from sailnet.ocp.solution import Switch


def zero_crossings(problem: Problem, clock: Array, switching: Array) -> list[Switch]:
    """Zeros of tabulated switching functions, by linear interpolation."""
    found = []
    for control, s in zip(problem.bounded, switching.T, strict=True):
        for k in np.flatnonzero(s[:-1] * s[1:] < 0.0):
            when = clock[k] - s[k] * (clock[k + 1] - clock[k]) / (s[k + 1] - s[k])
            found.append(Switch(float(when), control.switching, bool(s[k] > 0.0)))
    return sorted(found, key=lambda switch: switch.time)

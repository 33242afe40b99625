"""Optimal control: one problem definition, and solvers that all take it.

    problem = goddard.problem(thrust=3.5)
    smooth = collocation.solve(problem, options=collocation.Options(L2Norm(), Schedule(1.0, 1e-5, 0.5)))
    limit = arcs.solve(problem, smooth)

Folders, each importing only those before it: :mod:`~sailnet.ocp.definition` (a problem and its necessary
conditions), :mod:`~sailnet.ocp.propagation` (their extremals through time), :mod:`~sailnet.ocp.solvers`
(each returns a :class:`Solution` or raises :class:`ConvergenceError`), :mod:`~sailnet.ocp.globalisation`
(shooting from far away, and from many starts). Problems are a file each in :mod:`~sailnet.ocp.problems`.
"""

from sailnet.ocp.definition.problem import TIME, Bounded, Direction, FreeTime, Problem, costate, symbols
from sailnet.ocp.definition.smoothing import Exact, HyperbolicTangent, L2Norm, Logistic, Saturation, Smoothing
from sailnet.ocp.definition.solution import ConvergenceError, Solution, Step, Switch
from sailnet.ocp.globalisation import reach, survey
from sailnet.ocp.solvers import arcs, collocation, delta, multiple, ponn, shooting, switch_times
from sailnet.ocp.solvers.continuation import Schedule

__all__ = [
    "TIME",
    "Bounded",
    "ConvergenceError",
    "Direction",
    "Exact",
    "FreeTime",
    "HyperbolicTangent",
    "L2Norm",
    "Logistic",
    "Problem",
    "Saturation",
    "Schedule",
    "Smoothing",
    "Solution",
    "Step",
    "Switch",
    "arcs",
    "collocation",
    "costate",
    "delta",
    "multiple",
    "ponn",
    "reach",
    "shooting",
    "survey",
    "switch_times",
    "symbols",
]

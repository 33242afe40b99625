"""Optimal control: one problem definition, and solvers that all take it.

    problem = goddard.problem(thrust=3.5)
    smooth = collocation.solve(problem, L2Norm(), Schedule(1.0, 1e-5, 0.5))
    limit = arcs.solve(problem, smooth)

:mod:`~sailnet.ocp.problem` says what a problem is, :mod:`~sailnet.ocp.canonical` and
:mod:`~sailnet.ocp.ends` derive its necessary conditions, :mod:`~sailnet.ocp.functions` compiles them.
The solvers are :mod:`~sailnet.ocp.shooting`, :mod:`~sailnet.ocp.multiple` (shooting in pieces),
:mod:`~sailnet.ocp.collocation`, :mod:`~sailnet.ocp.arcs`, :mod:`~sailnet.ocp.ponn` and, with the extra
`ocp`, :mod:`~sailnet.ocp.delta`; each returns a :class:`~sailnet.ocp.solution.Solution` or raises
:class:`~sailnet.ocp.solution.ConvergenceError`.
:mod:`~sailnet.ocp.reach` and :mod:`~sailnet.ocp.survey` shoot from far away and from many starts,
:mod:`~sailnet.ocp.switch_times` checks bang-bang controls without costates.
Problems are a file each in :mod:`sailnet.ocp.problems`, the papers' figures in :mod:`sailnet.ocp.papers`.
"""

from sailnet.ocp import arcs, collocation, ponn, shooting
from sailnet.ocp.continuation import Schedule
from sailnet.ocp.problem import TIME, Bounded, Direction, FreeTime, Problem, costate, symbols
from sailnet.ocp.smoothing import Exact, HyperbolicTangent, L2Norm, Logistic, Saturation, Smoothing
from sailnet.ocp.solution import ConvergenceError, Solution, Step, Switch

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
    "ponn",
    "shooting",
    "symbols",
]

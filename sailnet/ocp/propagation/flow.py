"""Compiled Taylor propagation of extremals, with tangents, and with switches located as events.

A Taylor step continues a control law analytically. The exact law is therefore a mode held until an
event changes it, and tangents jump there as neighbouring extremals switch earlier or later. Of a
smoothed law a step sees the coming layer only while its tail is above rounding; where that is not so,
a step must end at the layer's edge.
"""

from functools import cache
from itertools import pairwise
from typing import Any

import heyoka as hy
import numpy as np

from sailnet.ocp.definition.canonical import RHO, Canonical, Form, Singular, canonical
from sailnet.ocp.definition.functions import ExtremalFunctions
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import Exact
from sailnet.ocp.definition.solution import Switch
from sailnet.ocp.propagation.tangents import MOST_STEPS, LostError, system_of, tangents_of
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Expression

TOLERANCE = 1e-14
"""Local error of the Taylor integrator."""

MOST_SWITCHES = 200
"""An exact law that switches more often chatters: the extremal has a singular arc."""

LANES_FROM = 10
"""States and costates from which on tangents fly in lanes; fewer are carried in one system faster."""


def events_of(equations: Canonical, form: Form) -> list[tuple[int, Expression]]:
    """The bounded control and the expression, at whose zeros a step must end, of every event of a form."""
    if isinstance(form, Singular):
        return []
    if isinstance(form, Exact):
        return [(i, corner) for i, corner in enumerate(equations.corners) if hy.get_variables(corner)]
    found = []
    for i, (_, s) in enumerate(equations.switching):
        # A control quadratic in H has no layer: its switching function is that of the law itself.
        if form.layer and equations.corners[i] == s:
            found += [(i, s - form.layer * RHO), (i, s + form.layer * RHO)]
    return found


class _Integrator:
    """A heyoka integrator and the callbacks that serve it."""

    def __init__(self, equations: Canonical, form: Form, columns: int, cost: bool, tolerance: float) -> None:
        self.equations, self.form, self.columns = equations, form, columns
        system: Any
        system, places = system_of(equations)
        if cost:
            system.append((hy.expression("cost_so_far"), hy.subs(equations.running_cost, places)))
        self.size = len(system)
        if columns:
            # Any variables serve: the tangents get their own initial values.
            system = hy.var_ode_sys(system, equations.variables[:columns], order=1)
        self.watching: _Watch | None = None
        size = self.size * (1 + columns)
        events = [
            hy.t_event(hy.subs(e, places), callback=_Callback(self, i)) for i, e in events_of(equations, form)
        ]
        self.taylor = hy.taylor_adaptive(
            system,
            np.ones(size),
            t_events=events,
            tol=tolerance,
            # Straight code takes half the time to run and six times as long to compile, half a minute on a
            # busy machine: it pays where many trajectories are flown, along a continuation.
            compact_mode=size > 30 or cost or isinstance(form, Exact | Singular),
        )
        self.state = self.taylor.state
        self.extras = np.zeros(len(equations.extras))

    def fly(self, start: float, stop: float, y: Array, tangents: Array | None, pars: Array) -> None:
        """Propagate from one time to another; the end is in ``state``."""
        ta = self.taylor
        ta.time = start
        if ta.with_events:
            ta.reset_cooldowns()
        self.state[: len(y)] = y
        self.state[len(y) : self.size] = 0.0
        if tangents is not None:
            self.state[self.size :] = tangents.ravel()
        self.extras = np.array(pars[: len(self.extras)])
        # heyoka keeps no more parameters than the equations mention.
        ta.pars[:] = pars[: len(ta.pars)]
        outcome = ta.propagate_until(stop, max_steps=MOST_STEPS)[0]
        if outcome != hy.taylor_outcome.time_limit or not np.all(np.isfinite(self.state)):
            raise LostError


class _Callback:
    def __init__(self, owner: _Integrator, index: int) -> None:
        self.owner, self.index = owner, index

    def __deepcopy__(self, memo: object) -> "_Callback":
        # heyoka deep-copies its callbacks, which must reach this very integrator.
        return self

    def __call__(self, ta: Any, direction: int) -> bool:
        watch = self.owner.watching
        return True if watch is None else watch.cross(self.owner, self.index, float(ta.time))


class _Watch:
    """Keeps the modes of an exact law along one flight."""

    def __init__(self, functions: ExtremalFunctions) -> None:
        self.functions = functions
        self.switches: list[Switch] = []
        self.modes: list[Array] = []

    def cross(self, engine: _Integrator, index: int, time: float) -> bool:
        if len(self.switches) >= MOST_SWITCHES:
            return False
        functions, equations = self.functions, self.functions.equations
        y, before = np.array(engine.state[: len(equations.variables)]), engine.extras
        after = before.copy()
        after[index] = turned(functions, index, time, y, before)
        if engine.columns:
            rows = engine.state[engine.size :].reshape(engine.size, engine.columns)
            old, new = (functions.slopes(time, y, modes)[0] for modes in (before, after))
            if np.any(old != new):
                corner, at = [equations.corners[index]], (time, y, before)
                gradient = functions.evaluate(("corner", index), at, corner, equations.variables)[0, 0]
                # Saltation: along a neighbouring extremal the switch comes earlier or later.
                rows += np.outer(new - old, gradient @ rows) / (gradient @ old)
        engine.extras = after
        kept = engine.taylor.pars[: len(after)]
        kept[:] = after[: len(kept)]
        self.modes.append(after)
        self.switches.append(Switch(time, equations.switching[index][0], bool(after[index] > before[index])))
        return True


def turned(functions: ExtremalFunctions, index: int, time: float, y: Array, modes: Array) -> float:
    """The mode of one control after its corner is crossed."""
    if functions.equations.corners[index] == functions.equations.switching[index][1]:
        return -float(modes[index])
    if modes[index] != 0.0:
        return 0.0
    control = functions.problem.bounded[index]
    law = [functions.equations.law[control.variable]]
    bar = functions.evaluate(("law", index), (time, y, modes), law)[0, 0]
    return 1.0 if abs(bar - control.upper) < abs(bar - control.lower) else -1.0


def first_modes(functions: ExtremalFunctions, y: Array) -> Array:
    """(s,) modes of the exact law at t = 0."""
    equations = functions.equations
    modes = np.zeros(len(equations.extras))
    switching = functions.switching(0.0, y, modes)[0]
    for i, control in enumerate(functions.problem.bounded):
        if equations.corners[i] == equations.switching[i][1]:
            modes[i] = 1.0 if switching[i] < 0.0 else -1.0
        else:
            law = [equations.law[control.variable]]
            bar = functions.evaluate(("law", i), (0.0, y, modes), law)[0, 0]
            modes[i] = float(bar > control.upper) - float(bar < control.lower)
    return modes


@cache
def _integrator(equations: Canonical, form: Form, columns: int, cost: bool, tolerance: float) -> _Integrator:
    return _Integrator(equations, form, columns, cost, tolerance)


class Flow:
    """Propagation of a problem's extremals under one form of its control law.

    Args:
        problem: the problem.
        form: the form of the law.
        tolerance: local error.
    """

    def __init__(self, problem: Problem, form: Form, tolerance: float = TOLERANCE) -> None:
        self.functions = ExtremalFunctions(problem, form)
        self.form, self.tolerance = form, tolerance
        self.equations = canonical(problem, form)
        self._values = np.array(list(problem.parameters.values()), float)
        # Events belong to a trajectory, and lanes would each have their own.
        eventless = not isinstance(form, Singular) and not events_of(self.equations, form)
        self._in_lanes = eventless and len(self.equations.variables) >= LANES_FROM

    def __call__(
        self,
        start: float,
        stop: float,
        y: Array,
        extras: Array | float,
        tangents: Array | None = None,
        watch: _Watch | None = None,
        held: bool = False,
    ) -> tuple[Array, Array, Array]:
        """Fly from ``start`` to ``stop``.

        Args:
            start, stop: times.
            y: (2n,) states and costates.
            extras: smoothing parameter, or modes.
            tangents: (2n, c) derivatives of y to be carried along.
            watch: keeps the modes; made here if the law is exact.
            held: keep the modes of an exact law as they are, whatever its switching functions do.

        Returns:
            y, tangents and extras at the end.

        Raises:
            LostError: if the trajectory does not get there.
        """
        pars = np.concatenate([np.atleast_1d(np.asarray(extras, float)), self._values])
        ends = np.empty((len(y), 0))
        if tangents is not None and self._in_lanes:
            ends = tangents_of(self.equations, self.tolerance).fly(start, stop, y, tangents, pars)
            tangents = None
        columns = 0 if tangents is None else tangents.shape[1]
        engine = _integrator(self.equations, self.form, columns, False, self.tolerance)
        follow = isinstance(self.form, Exact) and not held
        engine.watching = watch or (_Watch(self.functions) if follow else None)
        engine.fly(start, stop, y, tangents, pars)
        size = engine.size
        if columns:
            ends = np.array(engine.state[size:]).reshape(size, columns)
        return np.array(engine.state[:size]), ends, engine.extras

    def arcs(self, start: float, stop: float, y: Array, extras: Array) -> tuple[list[Switch], list[Array]]:
        """Switches of the exact law along a flight, and the modes of every arc between them."""
        watch = _Watch(self.functions)
        self(start, stop, y, extras, watch=watch)
        return watch.switches, [extras, *watch.modes]

    def sample(self, times: Array, y: Array, extras: Array | float) -> tuple[Array, float]:
        """(m, 2n) points at the times of one arc, which begins at ``y``, and its running cost."""
        engine = _integrator(self.equations, self.form, 0, True, self.tolerance)
        engine.watching = None
        pars = np.concatenate([np.atleast_1d(np.asarray(extras, float)), self._values])
        rows, cost = [np.asarray(y, float)], 0.0
        for start, stop in pairwise(times):
            if stop > start:
                engine.fly(float(start), float(stop), rows[-1], None, pars)
                cost += float(engine.state[engine.size - 1])
                rows.append(np.array(engine.state[: engine.size - 1]))
            else:
                rows.append(rows[-1])
        return np.array(rows), cost

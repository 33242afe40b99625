"""Compiled propagation of extremals, with the cone angle's jump located as an event.

Four forms of the law need four treatments:

- *unconstrained* (phi_max = 90 deg, delta = 0): smooth but for the jump;
- *smooth* (delta > 0): Eq. (12), smooth but for the jump;
- *exact* (delta = 0): Eq. (11), whose corners at the bound are events as well;
- *real* (other optics): likewise, with the cone angle as a seventh unknown that starts anew at events.

A Taylor step continues the law analytically, so it would step over the jump: the branch of the law
is a parameter, flipped at the event lambda_v = 0. Where lambda_u < 0 the crossing is smooth and
flipping only keeps the books; where lambda_u > 0 the command jumps.
"""

import math
import threading
from collections.abc import Callable
from functools import cache
from typing import Any, Literal

import heyoka as hy
import numpy as np
from numpy.typing import NDArray

from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Expression
from sailnet.physics.pontryagin import (
    MODE,
    PHI_MAX,
    extremal_motion,
    lambda_u,
    lambda_v,
    real_extremal_motion,
    saturated_angle,
    takeover_event,
    unconstrained_angle,
    unconstrained_law,
)
from sailnet.physics.real_law import RealLaw
from sailnet.physics.transfer import AnyTransfer

TOLERANCE = 1e-12
"""Local error of the Taylor integrator."""

SHARP_DELTA = 1e-4
"""Below this the smoothed corner of Eq. (12) is sharper than a step, which must not span it."""

MOST_STEPS = 5000
"""A longest flight takes some hundred steps; a fall into the Sun takes ever smaller ones."""

LawKind = Literal["unconstrained", "smooth", "exact", "real"]


def law_kind(transfer: AnyTransfer) -> LawKind:
    """Which treatment the saturation of this problem needs."""
    if transfer.law is not None:
        return "real"
    if transfer.delta > 0.0:
        return "smooth"
    return "unconstrained" if transfer.phi_max >= math.pi / 2 else "exact"


def law_expression(kind: LawKind) -> Expression:
    """The cone angle as an expression of the costates, on the branch given by the parameters."""
    bar = unconstrained_angle()
    if kind == "unconstrained":
        return bar
    if kind == "smooth":
        return saturated_angle(bar)
    return hy.select(hy.eq(MODE, hy.expression(0.0)), bar, MODE * PHI_MAX)


def parameters(transfer: AnyTransfer, lambda_u: Array, lambda_v: Array) -> Array:
    """(10, n) parameters of the compiled systems that belong to these costates."""
    pars = np.zeros((10, len(lambda_v)))
    pars[0], pars[1], pars[2] = transfer.beta, transfer.phi_max, transfer.delta
    pars[3] = -np.copysign(1.0, lambda_v)
    if transfer.law is None:
        bar = unconstrained_law(lambda_u, lambda_v)
        pars[4] = np.where(np.abs(bar) > transfer.phi_max, np.sign(bar), 0.0)
    else:
        pars[4] = np.where(transfer.law.angle(lambda_u, lambda_v)[1], pars[3], 0.0)
        pars[5:8] = transfer.law.coefficients.T
        pars[1], pars[8], pars[9] = transfer.law.bound, transfer.law.takeover, transfer.law.last
    return pars


def backward_system(kind: LawKind) -> list[tuple[Expression, Expression]]:
    """Eq. (15): the extremal's equations with time running from arrival to departure."""
    forward = real_extremal_motion() if kind == "real" else extremal_motion(law_expression(kind))
    return [(x, -dx) for x, dx in forward]


@cache
def _compiled_slopes(kind: LawKind) -> Any:
    system = backward_system(kind)
    return hy.cfunc([dx for _, dx in system], vars=[x for x, _ in system])


class Propagator:
    """A batch Taylor integrator for Eq. (15), and optionally its sensitivity to the costates.

    Args:
        kind: form of the guidance law.
        split_corners: end a step wherever the unconstrained angle meets the bound.
        tolerance: local error.
        variational: also integrate two tangents, the derivatives along two directions of the
            initial costates; the third would only scale them.
    """

    def __init__(self, kind: LawKind, split_corners: bool, variational: bool, tolerance: float) -> None:
        self.kind: LawKind = kind
        self.lanes = int(hy.recommended_simd_size())
        self.variational = variational
        system: Any = backward_system(kind)
        self.size = len(system)
        events = [hy.t_event_batch(lambda_v, callback=self._cross)]
        if kind == "real":
            events.append(hy.t_event_batch(takeover_event(), callback=self._take_over))
        elif split_corners:
            corner = unconstrained_angle() ** 2 - PHI_MAX**2
            events.append(hy.t_event_batch(corner, callback=self._corner))
        if variational:
            # Any two variables serve: the tangents get their own initial values.
            system = hy.var_ode_sys(system, [lambda_u, lambda_v], order=1)
        self.integrator = hy.taylor_adaptive_batch(
            system,
            np.ones((self.size, self.lanes)),
            t_events=events,
            tol=tolerance,
            # Unrolled, the largest of the systems would take a minute to compile.
            compact_mode=kind == "real" and variational and tolerance <= TOLERANCE,
        )
        self.jumps = np.zeros(self.lanes, int)
        self.jump_times = np.full(self.lanes, np.nan)
        # Views of the integrator's own memory: asking for them in a callback costs as much as the rest.
        self._state, self._pars, self._time = (
            self.integrator.state,
            self.integrator.pars,
            self.integrator.time,
        )
        if variational:
            self._tangents = self._state[self.size :].reshape(self.size, 2, self.lanes)
        self._law: RealLaw | None = None

    def __deepcopy__(self, memo: object) -> "Propagator":
        # heyoka deep-copies its callbacks, which must write into this very object.
        return self

    def start(self, transfer: AnyTransfer, states: Array, tangents: Array | None = None) -> None:
        """Begin at tau = 0 from (6, lanes) states and costates, and (6, 2, lanes) tangents.

        The problem may be another one in every lane.
        """
        ta = self.integrator
        ta.set_time(np.zeros(self.lanes))
        ta.reset_cooldowns()
        self._state[:6] = states
        if tangents is not None:
            self._tangents[:6] = tangents
        self._pars[:] = parameters(transfer, states[4], states[5])[: len(self._pars)]
        self._law = transfer.law
        if self._law is not None:
            self._state[6] = self._law.angle(states[4], states[5])[0]
            if tangents is not None:
                self._turn_with_costates(slice(None))
        self.jumps[:] = 0
        self.jump_times[:] = np.nan

    def slopes(self) -> Array:
        """(6, lanes) derivatives by time to go at the current point, on the current branch.

        Of a real sail (7, lanes): the last is its cone angle's.
        """
        compiled = _compiled_slopes(self.kind)
        return np.asarray(
            compiled(np.array(self._state[: self.size]), pars=np.array(self._pars[: compiled.nparams]))
        )

    def tangents(self) -> Array:
        """(6, 2, lanes) derivatives of states and costates along the two initial tangents."""
        return np.array(self._tangents[:6])

    def failed(self) -> NDArray[np.bool_]:
        """(lanes,) which lanes fell into the Sun; they stop the others of the batch on their way."""
        fell = {hy.taylor_outcome.err_nf_state, hy.taylor_outcome.step_limit}
        return np.array([outcome[0] in fell for outcome in self.integrator.propagate_res])

    def _cross(self, ta: Any, direction: int, lane: int) -> bool:
        jump = self._state[4, lane] > 0.0
        if jump and self.variational:
            before = self.slopes()[:, lane]
        self._pars[3, lane] = -self._pars[3, lane]
        if not jump:
            return True
        if self.kind in ("exact", "real"):
            self._pars[4, lane] = -self._pars[4, lane]
        self.jumps[lane] += 1
        self.jump_times[lane] = self._time[lane]
        if self.variational:
            self._salt(lane, before, self._tangents[5, :, lane] / before[5])
        return True

    def _salt(self, lane: int, before: Array, shift: Array) -> None:
        """Saltation: the event happens earlier or later, by ``shift``, along neighbouring extremals."""
        after = self.slopes()[:, lane]
        self._tangents[:, :, lane] += np.outer(after - before, shift)

    def _corner(self, ta: Any, direction: int, lane: int) -> bool:
        # The smooth law needs the step to end here, and has no mode to switch.
        if self.kind == "exact":
            self._pars[4, lane] = 0.0 if self._pars[4, lane] else self._pars[3, lane]
        return True

    def _take_over(self, ta: Any, direction: int, lane: int) -> bool:
        assert self._law is not None
        branch, last = self._pars[3, lane], self._pars[9, lane]
        jump = self.variational and last != self._pars[1, lane]
        if jump:
            before = self.slopes()[:, lane]
        self._pars[4, lane] = 0.0 if self._pars[4, lane] else branch
        if not self._pars[4, lane]:
            self._state[6, lane] = branch * last
        if jump:
            at = self._pars[8, lane]
            along = np.array([np.sin(at), -np.cos(at) * branch])
            self._salt(lane, before, along @ self._tangents[4:6, :, lane] / (along @ before[4:6]))
        if self.variational:
            self._turn_with_costates(lane)
        return True

    def _turn_with_costates(self, lanes: int | slice) -> None:
        """The tangents of a real sail's cone angle follow from those of the costates."""
        assert self._law is not None
        by_u, by_v = self._law.gradient(self._state[6], self._state[4], self._state[5])
        turned = by_u * self._tangents[4] + by_v * self._tangents[5]
        self._tangents[6, :, lanes] = np.where(self._pars[4] == 0.0, turned, 0.0)[:, lanes]


class _Compiled(threading.local):
    # A propagator holds the trajectory it is on, so threads must not share one.
    def __init__(self) -> None:
        self.build: Callable[[LawKind, bool, bool, float], Propagator] = cache(Propagator)


_compiled = _Compiled()


def propagator(transfer: AnyTransfer, variational: bool = False, tolerance: float = TOLERANCE) -> Propagator:
    """The compiled propagator for a problem; compiled once per form of the law, tolerance and thread."""
    kind = law_kind(transfer)
    split = kind == "exact" or (kind == "smooth" and transfer.delta < SHARP_DELTA)
    return _compiled.build(kind, split, variational, tolerance)

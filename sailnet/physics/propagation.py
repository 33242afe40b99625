"""Compiled propagation of extremals, with the cone angle's jump located as an event.

A Taylor step continues the law analytically, so it would step over the jump: the branch of the law
is a parameter, flipped at the event lambda_v = 0. Where lambda_u < 0 the crossing is smooth and
flipping only keeps the books; where lambda_u > 0 the command jumps.

In space there is no jump but a fast turn of the clock angle, of which a long step would see as little: it
changes the square of the length of (lambda_v, lambda_w) by a square. So a step ends where that length is
least, which is an event too. From there on steps begin as short as the turn and grow with the distance from
it: some forty of them for a turn through 0 itself, which is as fast as the blur of
:mod:`sailnet.physics.geometry` lets it be.
"""

import threading
from collections.abc import Callable
from functools import cache
from typing import Any

import heyoka as hy
import numpy as np
from numpy.typing import NDArray

from sailnet.physics.arrays import Array
from sailnet.physics.geometry import PLANE, force_costates, geometry_of
from sailnet.physics.pontryagin import (
    PHI_MAX,
    lambda_v,
    nearest_event,
    real_tangent_motion,
    takeover_event,
    unconstrained_angle,
)
from sailnet.physics.real_law import RealLaw
from sailnet.physics.systems import LawKind, backward, backward_system, compiled_slopes, law_kind, parameters
from sailnet.physics.transfer import AnyTransfer

TOLERANCE = 1e-12
"""Local error of the Taylor integrator."""

SHARP_DELTA = 1e-4
"""Below this the smoothed corner of Eq. (12) is sharper than a step, which must not span it."""

BLUR_SHARE, ROUGH_BLUR_SHARE = 1e-13, 1e-4
"""How far the turns of the clock angle are blurred, as a share of the largest costate at arrival: see
:mod:`sailnet.physics.geometry`; and at larger tolerances. Newton's method takes the blurred turn in fewer and
larger strides from a plane's extremal, whose derivatives to the north have no bound at a jump."""

FAST_TURN = 10.0
"""Of the clock angle [rad/TU], 0.4 degrees an hour: a turn that counts as the jump it is next to."""

MOST_STEPS = 5000
"""A longest flight takes some hundred steps; a fall into the Sun takes ever smaller ones."""


class Propagator:
    """A batch Taylor integrator for Eq. (15), and optionally its sensitivity to the costates.

    Args:
        kind: form of the guidance law.
        split_corners: end a step wherever the unconstrained angle meets the bound.
        tolerance: local error.
        variational: also integrate two tangents, the derivatives along two directions of the
            initial costates; the third would only scale them. In space four.
        components: of a state: 3 in the plane, 5 in space.
    """

    def __init__(
        self, kind: LawKind, split_corners: bool, variational: bool, tolerance: float, components: int = 3
    ) -> None:
        self.kind: LawKind = kind
        self.components = components
        self._geometry = geometry = geometry_of(components)
        self.lanes = int(hy.recommended_simd_size())
        self.variational = variational
        system: Any = backward_system(kind, geometry)
        self.size = len(system)
        if geometry is PLANE:
            events = [hy.t_event_batch(lambda_v, callback=self._cross)]
        else:
            least = hy.event_direction.positive
            events = [hy.t_event_batch(nearest_event(system), callback=self._pass, direction=least)]
        if kind == "real":
            events.append(hy.t_event_batch(takeover_event(geometry), callback=self._take_over))
        elif split_corners:
            corner = unconstrained_angle(lateral=geometry.lateral) ** 2 - PHI_MAX**2
            events.append(hy.t_event_batch(corner, callback=self._corner))
        if variational and kind == "real":
            system += backward(real_tangent_motion(geometry))
        elif variational:
            # Any variables serve: the tangents get their own initial values.
            system = hy.var_ode_sys(system, geometry.variables[components + 1 :], order=1)
        self.integrator = hy.taylor_adaptive_batch(
            system,
            np.ones((len(system) if kind == "real" else self.size, self.lanes)),
            t_events=events,
            tol=tolerance,
            # Unrolled, a system that two of these make large would take a minute to compile, once a machine.
            compact_mode=variational and (components > 3) + (kind == "real") + (tolerance <= TOLERANCE) >= 2,
        )
        self._law: RealLaw | None = None
        self._blur = BLUR_SHARE if tolerance <= TOLERANCE else ROUGH_BLUR_SHARE
        self.jumps = np.zeros(self.lanes, int)
        self.jump_times = np.full(self.lanes, np.nan)
        # Views of the integrator's own memory: asking for them in a callback costs as much as the rest.
        self._state, self._pars, self._time = (
            self.integrator.state,
            self.integrator.pars,
            self.integrator.time,
        )
        if variational:
            self._tangents = self._state[self.size :].reshape(2 * components, components - 1, self.lanes)

    def __deepcopy__(self, memo: object) -> "Propagator":
        # heyoka deep-copies its callbacks, which must write into this very object.
        return self

    def start(self, transfer: AnyTransfer, states: Array, tangents: Array | None = None) -> None:
        """Begin at tau = 0 from (6, lanes) states and costates, and (6, 2, lanes) tangents.

        In space from 10, and (10, 4, lanes). The problem may be another one in every lane.
        """
        unknowns = 2 * self.components
        force = force_costates(states[self.components :].T)
        ta = self.integrator
        ta.set_time(np.zeros(self.lanes))
        ta.reset_cooldowns()
        self._state[:unknowns] = states
        if tangents is not None:
            self._tangents[:] = tangents
        self._law = transfer.law
        self._pars[:10] = parameters(transfer, *force)[: len(self._pars)]
        if self._geometry is not PLANE:
            self._pars[10] = self._blur * np.abs(states[self.components :]).max(axis=0)
        if transfer.law is not None:
            self._state[unknowns] = transfer.law.angle(*force)[0]
        self.jumps[:] = 0
        self.jump_times[:] = np.nan

    def slopes(self) -> Array:
        """(6, lanes) derivatives by time to go at the current point, on the current branch; in space 10.

        Of a real sail there is one more: its cone angle's.
        """
        compiled = compiled_slopes(self.kind, self._geometry)
        return np.asarray(
            compiled(np.array(self._state[: self.size]), pars=np.array(self._pars[: compiled.nparams]))
        )

    def tangents(self) -> Array:
        """(6, 2, lanes) derivatives of states and costates along the initial tangents; in space more."""
        return np.array(self._tangents)

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

    def _pass(self, ta: Any, direction: int, lane: int) -> bool:
        costates = self._state[self.components : 2 * self.components, lane]
        force_u, lateral = force_costates(costates)
        if force_u > 0.0:
            rate = np.hypot(*self.slopes()[2 * self.components - 2 : 2 * self.components, lane])
            if rate > FAST_TURN * -lateral:
                self.jumps[lane] += 1
                self.jump_times[lane] = self._time[lane]
        if self._law is not None and not self._pars[4, lane]:
            law = self._law.rows([lane])
            self._state[2 * self.components, lane] = law.angle(force_u[None], lateral[None])[0][0]
        return True

    def _salt(self, lane: int, before: Array, shift: Array) -> None:
        """Saltation: the event happens earlier or later, by ``shift``, along neighbouring extremals."""
        after = self.slopes()[:, lane]
        unknowns = 2 * self.components
        self._tangents[:, :, lane] += np.outer(after[:unknowns] - before[:unknowns], shift)

    def _corner(self, ta: Any, direction: int, lane: int) -> bool:
        # The smooth law needs the step to end here, and has no mode to switch.
        if self.kind == "exact":
            self._pars[4, lane] = 0.0 if self._pars[4, lane] else self._pars[3, lane]
        return True

    def _take_over(self, ta: Any, direction: int, lane: int) -> bool:
        branch, last = self._pars[3, lane], self._pars[9, lane]
        jump = self.variational and last != self._pars[1, lane]
        if jump:
            before = self.slopes()[:, lane]
        self._pars[4, lane] = 0.0 if self._pars[4, lane] else branch
        if not self._pars[4, lane]:
            self._state[2 * self.components, lane] = branch * last
        if jump:
            at, rows = self._pars[8, lane], slice(self.size - len(self._toward(lane)) - 2, self.size - 1)
            along = np.array([np.sin(at), *(-np.cos(at) * branch * self._toward(lane))])
            self._salt(lane, before, along @ self._tangents[rows, :, lane] / (along @ before[rows]))
        return True

    def _toward(self, lane: int) -> Array:
        """Derivative of the costate across the Sun line by lambda_v, and in space by lambda_w."""
        if self._geometry is PLANE:
            return np.ones(1)
        across = self._state[2 * self.components - 2 : 2 * self.components, lane]
        return np.asarray(-across / np.hypot(*across))


class _Compiled(threading.local):
    # A propagator holds the trajectory it is on, so threads must not share one.
    def __init__(self) -> None:
        self.build: Callable[[LawKind, bool, bool, float, int], Propagator] = cache(Propagator)


_compiled = _Compiled()


def propagator(
    transfer: AnyTransfer, variational: bool = False, tolerance: float = TOLERANCE, components: int = 3
) -> Propagator:
    """The compiled propagator for a problem; compiled once per form of the law, tolerance and thread.

    Args:
        transfer: the problem.
        variational, tolerance, components: as for :class:`Propagator`.
    """
    kind = law_kind(transfer)
    split = kind == "exact" or (kind == "smooth" and transfer.delta < SHARP_DELTA)
    return _compiled.build(kind, split, variational, tolerance, components)

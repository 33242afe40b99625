"""Steering: guidance with a memory. What a flight computer runs once a guidance period.

It estimates what the real sail does from the measured states, keeps a thrust margin as large as the
innovations are, tracks the optimal extremal, goes on by dead reckoning without a state, and decides when the
flight ends. This is the reference in NumPy for the C of ``sailnet_steer``; both are held equal by
test. The extremals themselves both compute by the same C, which is compared with the optimal solver.
"""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.guidance.interface import (
    Commands,
    Guidance,
    GuidanceStatus,
    Steered,
    as_attitudes,
    refuse_attitudes,
)
from sailnet.guidance.last_period import Change, predicted
from sailnet.guidance.memory import Memory
from sailnet.guidance.rules import LARGEST_PERIOD, RULES, SteeringRules
from sailnet.guidance.tilts import angles_of, limited, size_of, spread, tilt_of, turned
from sailnet.guidance.tracker.commands import Tracking
from sailnet.guidance.tracker.library import Vehicles, has_lost
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Coefficients
from sailnet.physics.geometry import lengths_of, target_of


class ReferenceSteering:
    """Steers by a guidance that has no memory of its own.

    *What the sail does.* By how much further the velocity changed than predicted says, along the sail's
    normal, what beta is, and across it what force there is along the surface beside that of the mission's
    optics, as a share T of beta. With r the mean distance, h the period, dv the innovation, n, t the
    directions and f the force along the normal per beta / r^2, which is cos^2 alpha of an ideal sail,

        d_beta = (dv . n) r^2 / (h f),    d_T cos(alpha) sin(alpha) / f = -(dv . t) r^2 / (h f beta).

    In space dv, n and t have three components, and all the rest is the same.

    The estimates start at the mission's beta and at 0, and move by a share of the measurement that falls as
    1, 1/2, 1/3, ... down to h / memory: the mean of all periods at first, and later of those not forgotten.
    They never leave their ranges. A period in which the sail turned far, or that was not seen, says
    nothing. The attitude is the commanded one, or the mean that was measured: by how much that exceeds the
    commanded, on average, is taken off the next command.

    *Thrust margin.* Plans are made for beta (1 - a T) (1 - k), with k = b s + c w sqrt(h / tau): s^2 is the
    lag-1 autocovariance of the innovation, less some one and a half standard deviations of what white noise
    has of it by chance; and w^2 is its white variance, the rest. The margin shrinks to nothing with the time
    of flight tau, so that arrival is as exact as without.

    *Age.* If the mission says how its sail ages, the estimate does so with it, and plans are made for the
    share of it that is left after some part of the time to go.

    *A plan.* See :mod:`sailnet.guidance.tracker`. Where none passes through the state the command is the
    networks'.

    *The end.* The flight ends when the predicted time of flight is no longer than a period or the mission's
    threshold, the longer of both: the last command is held until, on the straight line of one such step, the
    target is nearest. Where no plan is solved the predicted time says nothing: there the flight ends, within
    the arrival tolerance, in the period in which the target is nearest on such a line.

    Args:
        guidance: gives the commands.
        count: number of sails.
        rules: the numbers.
    """

    def __init__(self, guidance: Guidance, count: int, rules: SteeringRules = RULES) -> None:
        self._guidance, mission = guidance, guidance.mission
        self._rules = rules
        self._turn_rate = mission.flight.turn_rate
        self._force: Coefficients = mission.sail.optics.force
        self._degradation = mission.degradation
        self._tracking = Tracking(guidance)
        components = mission.components
        self._target = target_of(mission.problem, components)
        self._lengths = lengths_of(self._target)
        beta = float(np.clip(mission.sail.beta, *guidance.beta_range))
        self._memory = Memory.started(count, beta, components)

    def steer(
        self, states: ArrayLike, period: float, sails: NDArray[np.intp], attitudes: ArrayLike | None = None
    ) -> Steered:
        """See :class:`sailnet.guidance.interface.Steering`."""
        refuse_attitudes(self._guidance.mission, attitudes)
        rules, memory = self._rules, self._memory.rows(sails)
        if attitudes is not None:
            self._measured(memory, np.asarray(as_attitudes(attitudes, len(sails), "float64"), float))
        shown = np.asarray(states, float)
        timed = 0.0 < period <= LARGEST_PERIOD
        hold = np.full(len(shown), period if timed else 0.0)
        with np.errstate(all="ignore"):
            known, change = self._known(memory, shown) if timed else (np.full_like(shown, np.nan), None)
            own = memory.beta * self._aged(memory, known)
            plan = own * (1.0 - np.where(has_lost(memory.tracker), 0.0, self._reserve(memory, hold)))
            as_fast = 1.0 - rules.tangential_loss * np.maximum(memory.tangential, 0.0)
        limits = self._guidance.beta_range
        read, estimated = (np.clip(beta, *limits) for beta in (plan, own))
        vehicles = Vehicles(read, estimated, memory.tangential, read * as_fast)
        command = self._command(known, np.clip(vehicles.as_fast, *limits), hold, sails)
        valid = command.status != GuidanceStatus.INVALID_INPUT
        flown = np.zeros(len(shown), bool)
        if change is not None:
            command, flown = self._tracking.commands(
                memory.tracker, known, vehicles, memory.held, hold, command
            )
        tilt, status = tilt_of(command.cone_angle, command.clock_angle), command.status.copy()
        if change is not None:
            status, hold = self._end(command, status, hold)
        low, high = self._guidance.beta_range
        left = valid & (status != GuidanceStatus.ARRIVED)
        unseen = left & (memory.unseen > 0.0)
        status[left & (status == GuidanceStatus.OK) & (plan < low) & (low < high)] = GuidanceStatus.AT_LIMIT
        status[unseen] = GuidanceStatus.RECKONED
        each = spread(valid, tilt)
        told = np.where(each, self._told(memory, tilt), tilt)
        self._remember(memory, known, tilt, hold, command.time_of_flight, valid)
        memory.attitude = np.where(each, told + memory.offset, memory.attitude)
        ends = valid & (status == GuidanceStatus.ARRIVED)
        error = np.abs((known - self._target) * self._lengths).max(axis=1)
        there = valid & (command.status <= GuidanceStatus.ARRIVED)
        there &= error <= self._guidance.mission.flight.arrival_tolerance
        there &= ~(flown & (memory.tracker["planned"] == 1))
        if (ends | there).any():
            nearest = self._until_nearest(memory)
            ends |= there & (nearest < hold)
            status[ends] = GuidanceStatus.ARRIVED
            hold = np.where(ends, nearest, hold)
            memory.held = np.where(ends, hold, memory.held)
        self._memory.put(sails, memory)
        cone, clock = angles_of(told)
        # A tilt has two components, of which the size is rounded.
        widest = np.maximum(self._guidance.mission.problem.phi_max, np.abs(command.cone_angle))
        cone = np.clip(cone, -widest, widest)
        tau, lambda_v, lambda_w = command.time_of_flight, command.lambda_v, command.lambda_w
        return Steered(cone, hold, tau, memory.beta, lambda_v, status, clock, lambda_w)

    def _told(self, memory: Memory, tilt: Array) -> Array:
        """What the sails are told for a tilt to come true."""
        bound = np.maximum(self._guidance.mission.problem.phi_max, size_of(tilt))
        return limited(tilt - memory.offset, bound)

    def _measured(self, memory: Memory, attitudes: Array) -> None:
        """What the attitude was in the period that ends, where that was measured."""
        rules, there = self._rules, np.isfinite(attitudes)
        with np.errstate(all="ignore"):
            little = (attitudes - memory.measured) ** 2 <= rules.slew_blur
            askew = attitudes - self._told(memory, memory.cone_angle)
            # Farther off it lags.
            counts = there & (askew**2 <= rules.largest_offset**2)
            weight = _weight(memory, rules.surprise_memory)
        memory.offset += np.where(counts, weight * (askew - memory.offset), 0.0)
        memory.slewing = np.where(there, np.where(little, 0.0, memory.held), memory.slewing)
        memory.measured = np.where(there, attitudes, memory.measured)
        widest = rules.largest_attitude(self._guidance.mission.problem.phi_max)
        memory.attitude = np.where(there, np.clip(attitudes, -widest, widest), memory.attitude)

    def _command(self, states: Array, beta: Array, hold: Array, sails: NDArray[np.intp]) -> Commands:
        """Commands of the guidance for some of the sails, to be held so long [TU]."""
        return self._guidance.command(states, beta)

    def _known(self, memory: Memory, shown: Array) -> tuple[Array, Change]:
        """States to steer by: those shown, or where the sails must be; NaN where neither is known."""
        seen = np.asarray(np.isfinite(shown).all(axis=1))
        change = predicted(memory, self._force)
        self._learn(memory, shown, change, seen)
        memory.unseen = np.where(seen, 0.0, memory.unseen + memory.held)
        reckoned = memory.state + change.by
        lost = (memory.held <= 0.0) | (memory.unseen > self._rules.longest_reckoning)
        return np.where(seen[:, None], shown, np.where(lost[:, None], np.nan, reckoned)), change

    def _learn(self, memory: Memory, shown: Array, change: Change, seen: NDArray[np.bool_]) -> None:
        rules, beta = self._rules, self._guidance.mission.sail.beta
        held, normal = memory.held, change.along_normal
        telling = seen & (held > 0.0) & (memory.unseen == 0.0) & (normal >= rules.least_cosine2)
        telling &= memory.slewing**2 * self._turn_rate <= rules.slew_blur * held
        faster = (shown - memory.state - change.by)[:, -change.normal.shape[1] :]
        per = (0.5 * (memory.state[:, 0] + shown[:, 0])) ** 2 / (held * normal)
        along, across = ((faster * way).sum(axis=1) * per for way in (change.normal, change.surface))
        telling &= np.isfinite(along) & np.isfinite(across)
        bound = rules.largest_surprise * beta
        relative, aside = (np.clip(np.where(telling, x, 0.0), -bound, bound) / beta for x in (along, across))
        slow_share = np.where(telling, _weight(memory, rules.memory), 0.0)
        share = np.where(telling, _weight(memory, rules.surprise_memory), 0.0)
        memory.beta = np.clip(memory.beta + slow_share * relative * beta, *self._guidance.beta_range)
        memory.tangential = np.clip(
            memory.tangential - 2.0 * share * change.sine * change.cosine * aside,
            -rules.largest_tangential,
            rules.largest_tangential,
        )
        # The first says by how much the sail differs from the mission's, not how it varies.
        varies = telling & (memory.samples > 0)
        share = np.where(varies, share, 0.0)
        memory.variance += share * (relative**2 - memory.variance)
        memory.autocovariance += share * (relative * memory.innovation - memory.autocovariance)
        memory.innovation = np.where(varies, relative, memory.innovation)
        memory.samples += telling

    def _aged(self, memory: Memory, known: Array) -> Array:
        """The estimate ages; the share of it that is planned with."""
        loss, dose = self._degradation.loss, self._degradation.dose
        if loss == 0.0:
            return np.ones(len(known))
        r, before = known[:, 0], memory.worn
        worn = before + (1.0 - before) * _wear(np.clip(memory.held / r**2, 0.0, 1e3) / dose)
        ahead = self._rules.foresight * memory.time_of_flight
        ahead = ahead / (r * self._guidance.mission.problem.target_radius)
        later = worn + (1.0 - worn) * _wear(np.clip(ahead, 0.0, 1e3) / dose)
        left = 1.0 - loss * worn
        valid = np.isfinite(r)
        aged = np.clip(memory.beta * (left / (1.0 - loss * before)), *self._guidance.beta_range)
        memory.beta = np.where(valid, aged, memory.beta)
        memory.worn = np.where(valid, worn, before)
        return np.where(valid, (1.0 - loss * later) / left, 1.0)

    def _reserve(self, memory: Memory, hold: Array) -> Array:
        rules, mission = self._rules, self._guidance.mission
        tau = np.maximum(memory.time_of_flight, mission.flight.arrival_threshold)
        chance = memory.variance * np.sqrt(_weight(memory, rules.surprise_memory))
        slow = np.clip(memory.autocovariance - chance, 0.0, 1.0)
        white = np.clip(memory.variance - slow, 0.0, 1.0) * hold / tau
        reserve = rules.reserve_slow * np.sqrt(slow) + rules.reserve_white * np.sqrt(white)
        bounded = np.clip(reserve, 0.0, rules.largest_reserve)
        kept: Array = bounded * np.minimum(tau / rules.let_go, 1.0)
        return kept

    def _end(
        self, command: Commands, status: NDArray[np.int32], hold: Array
    ) -> tuple[NDArray[np.int32], Array]:
        """Status, ``ARRIVED`` where the predicted time ends in a period, and for how long to hold at most."""
        inside = status <= GuidanceStatus.ARRIVED
        longest = np.maximum(hold, self._guidance.mission.flight.arrival_threshold)
        last = inside & (command.time_of_flight <= longest)
        status = np.where(inside, np.int32(GuidanceStatus.OK), status)
        return np.where(last, np.int32(GuidanceStatus.ARRIVED), status), np.where(
            last, np.minimum(longest, LARGEST_PERIOD), hold
        )

    def _until_nearest(self, memory: Memory) -> Array:
        """(n,) for how long to hold the command that is remembered [TU]: at most what is."""
        missing = (self._target - memory.state) * self._lengths
        with np.errstate(all="ignore"):
            by = predicted(memory, self._force).by * self._lengths
            share = (missing * by).sum(axis=1) / (by * by).sum(axis=1)
        until: Array = memory.held * np.nan_to_num(np.clip(share, 0.0, 1.0), nan=0.0)
        return until

    def _remember(
        self, memory: Memory, known: Array, tilt: Array, hold: Array, tau: Array, valid: NDArray[np.bool_]
    ) -> None:
        left = np.clip(memory.slewing - memory.held, 0.0, LARGEST_PERIOD)
        turning = left + turned(tilt, memory.cone_angle) / self._turn_rate
        memory.slewing = np.where(valid & (memory.periods > 0), turning, memory.slewing)
        memory.state = np.where(valid[:, None], known, memory.state)
        memory.cone_angle = np.where(spread(valid, tilt), tilt, memory.cone_angle)
        # After an invalid state the rest stays, but the next is not what came of the last command.
        memory.held = np.where(valid, hold, 0.0)
        memory.time_of_flight = np.where(valid, tau, memory.time_of_flight)
        memory.periods += valid


def _wear(halvings: Array) -> Array:
    """(n,) what so many halvings take, by the series of the flight file."""
    x = math.log(2.0) * halvings
    more = x * (1.0 + x * (0.5 + x / 6.0))
    taken: Array = more / (1.0 + more)
    return taken


def _weight(memory: Memory, time: float) -> Array:
    """(n,) of a period in the mean of all at first, and later of those not forgotten over ``time`` [TU]."""
    weight: Array = np.maximum(1.0 / (memory.samples + 1.0), memory.held / time)
    return weight

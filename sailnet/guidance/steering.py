"""Steering: guidance with a memory. What a flight computer runs once a guidance period.

Beside the command it estimates the sail's real beta from the states it is shown, and decides when the
flight ends. This is the reference in NumPy for the C of ``sailnet_steer``; both are held equal by test.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.errors import GuidanceError
from sailnet.guidance.interface import Guidance, GuidanceStatus, Steered
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import runge_kutta_step
from sailnet.physics.units import DAY, TU

MEMORY = 1.0
"""Time over which the estimate of beta forgets [TU]."""

LARGEST_SURPRISE = 0.5
"""Largest difference, relative to the mission's beta, by which one period's measurement counts."""

LEAST_COSINE2 = 0.05
"""cos^2(alpha) below which a period says nothing about beta: the sail is edge-on."""


LARGEST_PERIOD = 0.5 * MEMORY
"""Longest guidance period [TU], some 29 days: one measurement of beta then counts for at most half."""


def refuse_long_period(period: float) -> None:
    """Raise an error if steering takes no such guidance period [TU].

    Raises:
        GuidanceError: it is longer than ``LARGEST_PERIOD``.
    """
    if period > LARGEST_PERIOD:
        days = TU / DAY
        raise GuidanceError(
            f"a guidance period of {period:g} TU is {period * days:,.0f} days: the longest is "
            f"{LARGEST_PERIOD:g} TU, {LARGEST_PERIOD * days:.0f} days. Periods are in TU, of {TU:,.0f} s"
        )


class ReferenceSteering:
    """Steers by a guidance that has no memory of its own.

    beta is measured, period by period, by how much further the velocity changed than predicted, along
    the direction of the force. With r the mean distance, h the period and dv the surprise,

        d_beta = (dv . (cos alpha, sin alpha)) r^2 / (h cos^2 alpha).

    The estimate starts at the mission's beta and moves by a share of the measurement that falls as
    1/2, 1/3, 1/4, ... down to h / MEMORY: the mean of all periods at first, with the start value as one of
    them, and later of those not forgotten. It never leaves the range the guidance was made for.

    The flight ends when the predicted time of flight is no longer than a period or the mission's
    threshold: the last command is held for that time. It also ends where it stands if the sail is within
    the arrival tolerance and the predicted time no longer falls: it is past the nearest point.

    Args:
        guidance: gives the commands.
        count: number of sails.
    """

    def __init__(self, guidance: Guidance, count: int) -> None:
        self._guidance = guidance
        self._beta = np.full(count, np.clip(guidance.mission.sail.beta, *guidance.beta_range))
        self._periods = np.zeros(count, int)
        self._state = np.zeros((count, 3))
        self._cone_angle, self._held = np.zeros((2, count))
        self._time_of_flight = np.full(count, np.inf)

    def steer(self, states: ArrayLike, period: float, sails: NDArray[np.intp]) -> Steered:
        """See :class:`sailnet.guidance.interface.Steering`."""
        state = np.asarray(states, float)
        mission = self._guidance.mission
        if not 0.0 < period <= LARGEST_PERIOD:
            state, period = np.full_like(state, np.nan), 0.0
        self._learn(state, sails)
        command = self._guidance.command(state, self._beta[sails])
        tau, status = command.time_of_flight, command.status
        known = status <= GuidanceStatus.ARRIVED
        last = known & (tau <= max(period, mission.flight.arrival_threshold))
        error = np.abs(state - mission.problem.target_state).max(axis=1)
        past = known & (error <= mission.flight.arrival_tolerance) & (tau >= self._time_of_flight[sails])
        hold = np.where(last, np.maximum(tau, 0.0), np.where(past, 0.0, period))

        # After an invalid state the memory stays, but the next is not what came of the last command.
        valid = status != GuidanceStatus.INVALID_INPUT
        self._held[sails] = np.where(valid, hold, 0.0)
        kept = sails[valid]
        self._state[kept], self._cone_angle[kept] = state[valid], command.cone_angle[valid]
        self._time_of_flight[kept] = tau[valid]
        self._periods[kept] += 1
        arrived = last | past
        status = np.where(arrived, np.int32(GuidanceStatus.ARRIVED), status)
        return Steered(command.cone_angle, hold, tau, self._beta[sails], status)

    def _learn(self, state: Array, sails: NDArray[np.intp]) -> None:
        nominal = self._guidance.mission.sail.beta
        cosine, sine = np.cos(self._cone_angle[sails]), np.sin(self._cone_angle[sails])
        held, periods = self._held[sails], self._periods[sails]
        telling = (periods > 0) & (held > 0.0) & (cosine**2 >= LEAST_COSINE2)
        telling &= np.isfinite(state).all(axis=1)
        at = np.flatnonzero(telling)
        if not len(at):
            return
        rows, held, cosine, sine = sails[at], held[at], cosine[at], sine[at]
        before = np.zeros((4, len(at)))
        before[[0, 2, 3]] = self._state[rows].T
        expected = runge_kutta_step(before, self._cone_angle[rows], self._beta[rows], held)
        bound = LARGEST_SURPRISE * nominal
        with np.errstate(invalid="ignore", over="ignore"):
            surprise = cosine * (state[at, 1] - expected[2]) + sine * (state[at, 2] - expected[3])
            distance = 0.5 * (before[0] + state[at, 0])
            measured = surprise * distance**2 / (held * cosine**2)
            measured = np.where(np.isfinite(measured), np.clip(measured, -bound, bound), 0.0)
        share = np.maximum(1.0 / (periods[at] + 1.0), held / MEMORY)
        self._beta[rows] = np.clip(self._beta[rows] + share * measured, *self._guidance.beta_range)

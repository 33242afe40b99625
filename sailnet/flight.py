"""Closed-loop flights: the exported guidance steers the plant, one command a guidance period.

Many sails fly side by side. Each flight draws its disturbances from a stream of its own, so its
result depends neither on its company nor on the number of workers.
"""

import itertools
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.dynamics import Array, hold_command
from sailnet.errors import SailnetError
from sailnet.guidance import Guidance
from sailnet.mission import Mission

RADII = (0.05, 20.0)
"""A sail outside these distances from the Sun [AU] is lost."""

DRAWS = 512
"""Guidance periods for which disturbances are drawn at a time."""


@dataclass(frozen=True)
class Disturbance:
    """How the real characteristic acceleration differs from the one guidance was trained for.

    Attributes:
        beta_bias: constant relative error of beta.
        beta_noise: half-width of a relative error drawn afresh, uniformly, every guidance period
            (Section 5.2: 0.15).
        seed: fixes the noise; flight i draws from stream (seed, i).
    """

    beta_bias: float = 0.0
    beta_noise: float = 0.0
    seed: int = 0

    def __post_init__(self) -> None:
        if not (np.isfinite(self.beta_bias) and self.beta_bias > -1.0):
            raise SailnetError(f"the bias of beta must be finite and above -1, not {self.beta_bias}")
        if not 0.0 <= self.beta_noise < 1.0 + min(0.0, self.beta_bias):
            raise SailnetError(f"the noise of beta must leave beta positive, not {self.beta_noise}")


@dataclass(frozen=True)
class Flights:
    """What became of each flight; arrays of length n.

    Attributes:
        starts: (n, 3) r, u, v at departure.
        ends: (n, 3) the same at the end.
        time_of_flight: duration [TU].
        stopped: the stop rule ended the flight (else it was lost or took too long).
        terminal_error: (n, 3) size of the deviation from the target state, Section 5.1.
        max_cone_angle: largest size of the command [rad].
        arrived: stopped, within the mission's tolerance, the cone angle never out of bounds.
    """

    starts: Array
    ends: Array
    time_of_flight: Array
    stopped: NDArray[np.bool_]
    terminal_error: Array
    max_cone_angle: Array
    arrived: NDArray[np.bool_]

    @staticmethod
    def join(parts: "list[Flights]") -> "Flights":
        """Flights of several batches, in order."""
        names = [field.name for field in fields(Flights)]
        return Flights(**{name: np.concatenate([getattr(part, name) for part in parts]) for name in names})


@dataclass(frozen=True)
class History:
    """One flight, period by period.

    Attributes:
        time: (k,) [TU].
        states: (k, 4) r, theta, u, v.
        cone_angle: (k,) commanded [rad].
        predicted_time_of_flight: (k,) by the guidance [TU].
    """

    time: Array
    states: Array
    cone_angle: Array
    predicted_time_of_flight: Array


def fly(
    mission: Mission,
    guidance: Guidance,
    starts: ArrayLike,
    *,
    disturbance: Disturbance | None = None,
    period: float | None = None,
    first: int = 0,
    recorder: list[History] | None = None,
) -> Flights:
    """Fly sails until guidance predicts less than the arrival threshold to go.

    Args:
        mission: the plant's beta, the target, and the rules of flight.
        guidance: a back end of :mod:`sailnet.guidance`.
        starts: (n, 3) rows r [AU], u, v [AU/TU].
        disturbance: of beta; none by default.
        period: guidance period [TU]; the mission's by default.
        first: number of the first flight, for the random streams.
        recorder: if given, the history of every flight is appended to it.

    Raises:
        SailnetError: a start is not finite or not at a positive distance; a period that is not positive.
    """
    start = np.atleast_2d(np.asarray(starts, float))
    if start.shape[1:] != (3,) or not np.isfinite(start).all() or not np.all(start[:, 0] > 0.0):
        raise SailnetError(f"a start needs three finite numbers (r, u, v) with r > 0, not {start.tolist()}")
    held = mission.flight.period if period is None else period
    if not (np.isfinite(held) and held > 0.0):
        raise SailnetError(f"the guidance period must be a positive number of TU, not {held}")
    noise = disturbance or Disturbance()
    count = len(start)
    streams = [np.random.default_rng([noise.seed, first + i]) for i in range(count)]

    states = np.zeros((4, count))
    states[[0, 2, 3]] = start.T
    duration = np.full(count, np.nan)
    stopped = np.zeros(count, bool)
    max_cone_angle = np.zeros(count)
    flying = np.arange(count)
    log: list[tuple[NDArray[np.intp], float, Array, Array, Array]] = []
    draws = np.empty((count, DRAWS))
    for k in itertools.count():
        time = k * held
        command = guidance.command(states[[0, 2, 3]][:, flying].T)
        if recorder is not None:
            log.append((flying, time, states[:, flying], command.cone_angle, command.time_of_flight))
        max_cone_angle[flying] = np.maximum(max_cone_angle[flying], np.abs(command.cone_angle))
        near = command.time_of_flight < mission.flight.arrival_threshold
        radius = states[0, flying]
        lost = ~((radius > RADII[0]) & (radius < RADII[1]))
        duration[flying[near | lost]] = time
        stopped[flying[near & ~lost]] = True
        going = ~(near | lost)
        flying = flying[going]
        if not len(flying) or time >= mission.flight.longest:
            break
        if k % DRAWS == 0:
            for i in flying:
                draws[i] = streams[i].uniform(-1.0, 1.0, DRAWS)
        error = noise.beta_bias + noise.beta_noise * draws[flying, k % DRAWS]
        beta = mission.sail.beta * (1.0 + error)
        states[:, flying] = hold_command(states[:, flying], command.cone_angle[going], beta, held)
    duration[flying] = time

    ends = states[[0, 2, 3]].T.copy()
    terminal_error = np.abs(ends - np.array(mission.problem.target_state))
    inside = np.all(terminal_error <= mission.flight.arrival_tolerance, axis=1)
    bounded = max_cone_angle <= mission.problem.phi_max
    if recorder is not None:
        recorder.extend(_histories(log, count))
    return Flights(
        starts=start,
        ends=ends,
        time_of_flight=duration,
        stopped=stopped,
        terminal_error=terminal_error,
        max_cone_angle=max_cone_angle,
        arrived=stopped & inside & bounded,
    )


def _histories(log: list[tuple[NDArray[np.intp], float, Array, Array, Array]], count: int) -> list[History]:
    rows = np.concatenate([flying for flying, *_ in log])
    time = np.concatenate([np.full(len(flying), t) for flying, t, *_ in log])
    states = np.concatenate([state.T for _, _, state, _, _ in log])
    cone_angle = np.concatenate([angle for *_, angle, _ in log])
    predicted = np.concatenate([tau for *_, tau in log])
    histories = []
    for i in range(count):
        own = rows == i
        histories.append(History(time[own], states[own], cone_angle[own], predicted[own]))
    return histories

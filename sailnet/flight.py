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
from sailnet.guidance import Guidance, Steered
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
        beta_spread: half-width of another constant one, drawn uniformly for each flight.
        beta_drift: relative change of beta per TU, for instance a slow degradation (negative).
        beta_noise: half-width of a relative error drawn afresh, uniformly, every guidance period
            (Section 5.2: 0.15).
        seed: fixes the noise; flight i draws from stream (seed, i).
    """

    beta_bias: float = 0.0
    beta_spread: float = 0.0
    beta_drift: float = 0.0
    beta_noise: float = 0.0
    seed: int = 0

    def __post_init__(self) -> None:
        if not (np.isfinite(self.beta_bias) and self.beta_bias > -1.0):
            raise SailnetError(f"the bias of beta must be finite and above -1, not {self.beta_bias}")
        if not np.isfinite(self.beta_drift):
            raise SailnetError(f"the drift of beta must be finite, not {self.beta_drift}")
        left = 1.0 + min(0.0, self.beta_bias)
        for name in ("spread", "noise"):
            value = getattr(self, f"beta_{name}")
            if not 0.0 <= value < left:
                raise SailnetError(f"the {name} of beta must leave beta positive, not {value}")
            left -= value


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
        beta_error: relative error of beta at departure.
        beta_estimate: the guidance's last estimate of beta.
        arrived: stopped, within the mission's tolerance, the cone angle never out of bounds.
    """

    starts: Array
    ends: Array
    time_of_flight: Array
    stopped: NDArray[np.bool_]
    terminal_error: Array
    max_cone_angle: Array
    beta_error: Array
    beta_estimate: Array
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
        beta_estimate: (k,) by the guidance.
    """

    time: Array
    states: Array
    cone_angle: Array
    predicted_time_of_flight: Array
    beta_estimate: Array


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
    """Fly sails until their guidance says that they have arrived.

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

    bias = noise.beta_bias + noise.beta_spread * np.array([stream.uniform(-1.0, 1.0) for stream in streams])
    states = np.zeros((4, count))
    states[[0, 2, 3]] = start.T
    duration, estimate = np.full((2, count), np.nan)
    stopped = np.zeros(count, bool)
    max_cone_angle = np.zeros(count)
    steering = guidance.steering(count)
    flying = np.arange(count)
    log: list[tuple[NDArray[np.intp], float, Array, Steered]] = []
    draws = np.empty((count, DRAWS))
    for k in itertools.count():
        time = k * held
        if k % DRAWS == 0:
            for i in flying:
                draws[i] = streams[i].uniform(-1.0, 1.0, DRAWS)
        steered = steering.steer(states[[0, 2, 3]][:, flying].T, held, flying)
        if recorder is not None:
            log.append((flying, time, states[:, flying], steered))
        max_cone_angle[flying] = np.maximum(max_cone_angle[flying], np.abs(steered.cone_angle))
        estimate[flying] = steered.beta
        error = bias[flying] + noise.beta_noise * draws[flying, k % DRAWS]
        beta = mission.sail.beta * np.maximum(0.0, (1.0 + error) * (1.0 + noise.beta_drift * time))
        longest = max(held, mission.flight.arrival_threshold)
        states[:, flying] = hold_command(states[:, flying], steered.cone_angle, beta, steered.hold, longest)
        radius = states[0, flying]
        lost = ~((radius > RADII[0]) & (radius < RADII[1]))
        duration[flying] = time + steered.hold
        stopped[flying[steered.arrived & ~lost]] = True
        flying = flying[~(steered.arrived | lost)]
        if not len(flying) or (k + 1) * held >= mission.flight.longest:
            break

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
        beta_error=bias,
        beta_estimate=estimate,
        arrived=stopped & inside & bounded,
    )


def _histories(log: list[tuple[NDArray[np.intp], float, Array, Steered]], count: int) -> list[History]:
    rows = np.concatenate([flying for flying, *_ in log])
    time = np.concatenate([np.full(len(flying), t) for flying, t, *_ in log])
    states = np.concatenate([state.T for _, _, state, _ in log])
    columns = [
        np.concatenate([getattr(steered, name) for *_, steered in log])
        for name in ("cone_angle", "time_of_flight", "beta")
    ]
    order = np.argsort(rows, kind="stable")
    ends = np.cumsum(np.bincount(rows, minlength=count))[:-1]
    parts = [np.split(column[order], ends) for column in (time, states, *columns)]
    return [History(*own) for own in zip(*parts, strict=True)]

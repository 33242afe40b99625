"""Closed-loop flights: the exported guidance steers the plant, one command a guidance period.

Many sails fly side by side. Each flight draws its disturbances from streams of its own, so its result
depends neither on its company nor on the number of workers. The loop is the plant's, in C, for every
guidance: the exported C is called by it directly, any other back end through a callback.

How a flight ends. The guidance on board ends it, by what it knows: when its predicted time of flight is
shorter than a period or the mission's threshold, or when no plan is solved and by its navigation the sail
is within the tolerance and will be nearest to the target in this period. The last command is held until
then, and the sail is scored where it really is. The truth is never looked at for the best moment; what
that would have given is reported beside it, as ``nearest_error``.
"""

from dataclasses import dataclass, fields
from enum import IntEnum

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.errors import SailnetError
from sailnet.flight.drawn_optics import optics_errors
from sailnet.flight.plant import (
    SHOWN,
    STATE,
    STATE_IN_SPACE,
    SideBySide,
    components_of,
    rules,
    step_quantile,
)
from sailnet.guidance.interface import Guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import lengths_of, target_of

BLOCK = 256
"""Guidance periods flown in one call of the plant; between calls an interruption is noticed."""


FAST = 0.99
"""Share of the steps of a command that ``Flights.command_rate`` bounds."""

AS_RECORDED = ("time", "cone_angle", "attitude", "beta", "beta_estimate", "status")
"""Attributes of a ``History`` that are members of ``plant_record``."""

AS_RECORDED_IN_SPACE = (*AS_RECORDED, "clock_angle", "attitude_clock")


class Ending(IntEnum):
    """How a flight ended."""

    STOPPED = 1
    """By its guidance, wherever that was."""
    LOST = 2
    """Out of the plant's distances from the Sun."""
    TOO_LONG = 3
    """At the mission's longest flight."""


@dataclass(frozen=True)
class Flights:
    """What became of each flight; arrays of length n.

    Other tolerances than the mission's can be applied to ``stopped`` and ``terminal_error`` afterwards.

    Attributes:
        starts: (n, 3) r, u, v at departure; (n, 5) r, latitude, u, v, w in three dimensions.
        ends: (n, 3) or (n, 5) the same at the end.
        time_of_flight: duration [TU].
        ending: values of ``Ending``.
        terminal_error: (n, 3) size of the deviation from the target state, Section 5.1; (n, 5) with r_f times
            the latitude's.
        max_cone_angle: largest size of the command [rad].
        max_attitude: largest size of the cone angle flown, misalignment and all [rad].
        beta_error: constant relative error of beta, bias and spread.
        beta_estimate: the guidance's last estimate of beta.
        nearest_error: smallest largest component of the deviation at the end of any period: what a stop
            rule that knew the truth would have got.
        nearest_time: when that was [TU].
        command_slew: sum of the sizes of all steps of the command, from one period to the next [rad]: in the
            plane of the cone angle, in space between the sail's normals, as the next two and ``reversals``.
        attitude_slew: by how much the actuator turned the sail in all [rad].
        command_rate: 99 % of the steps of the command are at most this, over the guidance period [rad/TU];
            too large by at most 1/16 (:func:`sailnet.flight.plant.step_quantile`).
        dose: sunlight that fell on the sail [TU/AU^2].
        periods: guidance periods flown.
        outside: of these, with a state outside the domain of the networks.
        outages: of these, without navigation.
        reckoned: of these, steered by where the sail must be, for want of a state.
        beyond_bound: of these, with the cone angle flown, misalignment and all, beyond the bound.
        beta_at_limit: of these, with the guidance's estimate of beta at an end of its range, or at the limit
            of what it can plan with.
        reversals: steps of the command of more than ``plant.REVERSAL``, 40 degrees.
        arrived: stopped, within the mission's tolerance, no command out of bounds.
    """

    starts: Array
    ends: Array
    time_of_flight: Array
    ending: NDArray[np.int32]
    terminal_error: Array
    max_cone_angle: Array
    max_attitude: Array
    beta_error: Array
    beta_estimate: Array
    nearest_error: Array
    nearest_time: Array
    command_slew: Array
    attitude_slew: Array
    command_rate: Array
    dose: Array
    periods: NDArray[np.uint32]
    outside: NDArray[np.uint32]
    outages: NDArray[np.uint32]
    reckoned: NDArray[np.uint32]
    beyond_bound: NDArray[np.uint32]
    beta_at_limit: NDArray[np.uint32]
    reversals: NDArray[np.uint32]
    arrived: NDArray[np.bool_]

    @property
    def stopped(self) -> NDArray[np.bool_]:
        """(n,) the guidance ended the flight; else it was lost or took too long."""
        return np.asarray(self.ending == Ending.STOPPED)

    @property
    def kept_attitude(self) -> NDArray[np.bool_]:
        """(n,) the cone angle flown, and not the command alone, was within the bound all the time."""
        return np.asarray(self.beyond_bound == 0)

    @staticmethod
    def join(parts: "list[Flights]") -> "Flights":
        """Flights of several batches, in order."""
        names = [field.name for field in fields(Flights)]
        return Flights(**{name: np.concatenate([getattr(part, name) for part in parts]) for name in names})


@dataclass(frozen=True)
class History:
    """One flight, period by period.

    Attributes:
        time: (k,) at the start of each period [TU].
        states: (k, 4) r, theta, u, v then; (k, 6) r, theta, latitude, u, v, w in three dimensions.
        seen: (k, 3) r, u, v as navigation showed them, or (k, 5) r, latitude, u, v, w; NaN in an outage.
        cone_angle: (k,) commanded [rad]; without a state too, by the guidance's own rule.
        attitude: (k,) the cone angle flown at the end of the period [rad].
        beta: (k,) the sail's real beta in the period.
        beta_estimate: (k,) by the guidance.
        predicted_time_of_flight: (k,) by the guidance [TU]: in an outage, from where the sail must be; the
            longest that it was trained on where it does not know that either.
        status: (k,) values of ``GuidanceStatus``.
        clock_angle: (k,) commanded [rad]; None in the plane, where the cone angle has a sign.
        attitude_clock: (k,) the clock angle flown at the end of the period [rad]; None likewise.
    """

    time: Array
    states: Array
    seen: Array
    cone_angle: Array
    attitude: Array
    beta: Array
    beta_estimate: Array
    predicted_time_of_flight: Array
    status: NDArray[np.int32]
    clock_angle: Array | None = None
    attitude_clock: Array | None = None

    @property
    def ruv(self) -> Array:
        """(k, 3) r, u, v at the start of each period: what guidance and navigation deal with in the plane."""
        names = STATE if self.states.shape[1] == len(STATE) else STATE_IN_SPACE
        return self.states[:, [names.index(name) for name in "ruv"]]

    @property
    def shown(self) -> Array:
        """(k, 3) or (k, 5) what navigation shows where it makes no error, at the start of each period."""
        return np.delete(self.states, 1, axis=1)


def fly(
    mission: Mission,
    guidance: Guidance,
    starts: ArrayLike,
    *,
    disturbance: Disturbance | None = None,
    period: float | None = None,
    first: int = 0,
) -> Flights:
    """Fly sails until their guidance says that they have arrived.

    Args:
        mission: the plant's beta, the target, and the rules of flight.
        guidance: a back end of :mod:`sailnet.guidance.interface`.
        starts: (n, 3) rows r [AU], u, v [AU/TU]; of a mission with an inclination (n, 5) rows r [AU],
            latitude [rad], u, v, w [AU/TU].
        disturbance: of sail, navigation and actuator; the mission's by default.
        period: guidance period [TU]; the mission's by default.
        first: number of the first flight, for the random streams.

    Raises:
        SailnetError: a start of the other kind, not finite, not at a positive distance or not between the
            poles; a period that is not positive; a disturbance that the mission's dimensions do not have.
    """
    start, under_way = _departing(mission, guidance, starts, disturbance, period, first)
    while under_way.flying:
        under_way.fly(BLOCK)
    return _flights(mission, start, under_way)


def fly_recorded(
    mission: Mission,
    guidance: Guidance,
    starts: ArrayLike,
    *,
    disturbance: Disturbance | None = None,
    period: float | None = None,
    first: int = 0,
) -> tuple[Flights, list[History]]:
    """:func:`fly`, and the history of each of the flights, which takes memory for every period."""
    start, under_way = _departing(mission, guidance, starts, disturbance, period, first)
    blocks = []
    while under_way.flying:
        blocks.append(under_way.fly_recorded(BLOCK))
    whole = np.concatenate(blocks)
    kept = [whole[: sail["periods"], i] for i, sail in enumerate(under_way.sails)]
    histories = [_history(mission, records) for records in kept]
    return _flights(mission, start, under_way), histories


def _departing(
    mission: Mission,
    guidance: Guidance,
    starts: ArrayLike,
    disturbance: Disturbance | None,
    period: float | None,
    first: int,
) -> tuple[Array, SideBySide]:
    start = np.atleast_2d(np.asarray(starts, float))
    _refuse_impossible(mission, start)
    held = mission.flight.period if period is None else period
    wanted = mission.disturbance if disturbance is None else disturbance
    given = rules(mission, wanted, held, guidance.beta_range)
    errors = optics_errors(mission, wanted, range(first, first + len(start)))
    return start, SideBySide(given, start, first, guidance.steering(len(start)), errors)


def _refuse_impossible(mission: Mission, start: Array) -> None:
    names = components_of(mission)
    possible = start.shape[1] == len(names) and np.isfinite(start).all() and np.all(start[:, 0] > 0.0)
    says = f"{'five' if mission.inclined else 'three'} finite numbers ({', '.join(names)}) with r > 0"
    if mission.inclined:
        says += " and the latitude between -pi/2 and pi/2"
        possible = possible and np.all(np.abs(start[:, names.index("latitude")]) < np.pi / 2)
    if not possible:
        raise SailnetError(f"a start of mission {mission.name!r} needs {says}, not {start.tolist()}")


def _flights(mission: Mission, start: Array, flown: SideBySide) -> Flights:
    sails = flown.sails
    names, problem = components_of(mission), mission.problem
    ends = np.column_stack([sails["state"][component] for component in names])
    target = target_of(problem, len(names))
    terminal_error = np.abs(ends - target) * lengths_of(target)
    inside = np.all(terminal_error <= mission.flight.arrival_tolerance, axis=1)
    bounded = sails["max_cone_angle"] <= problem.phi_max
    named = {field.name for field in fields(Flights)} & set(sails.dtype.names or ())
    return Flights(
        starts=start,
        ends=ends,
        time_of_flight=sails["time"].copy(),
        terminal_error=terminal_error,
        arrived=(sails["ending"] == Ending.STOPPED) & inside & bounded,
        command_rate=step_quantile(sails["steps"], FAST) / flown.period,
        dose=sails["state"]["dose"].copy(),
        **{name: sails[name].copy() for name in named},
    )


def _history(mission: Mission, records: NDArray[np.void]) -> History:
    state, recorded = (STATE_IN_SPACE, AS_RECORDED_IN_SPACE) if mission.inclined else (STATE, AS_RECORDED)
    return History(
        states=np.column_stack([records[name] for name in state]),
        seen=records["seen"][:, [SHOWN.index(name) for name in components_of(mission)]],
        predicted_time_of_flight=records["time_of_flight"].copy(),
        **{name: records[name].copy() for name in recorded},
    )

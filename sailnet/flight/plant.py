"""The plant in C, called by ctypes: sails side by side, from one guidance period to the next.

``sailnet.flight.closed_loop`` flies with it, whatever computes the guidance: the exported C is called by
the plant directly, anything else through a callback.
"""

import ctypes
import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.errors import SailnetError
from sailnet.flight.drawn_optics import COEFFICIENTS
from sailnet.flight.plant_library import STEER, plant
from sailnet.guidance.exported_files import SUFFIXES
from sailnet.guidance.interface import NativeSteering, Steering
from sailnet.guidance.rules import refuse_long_period
from sailnet.mission.disturbances import NAVIGATION, OFF_PLANE, Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import geometry_of, target_of

RADII = (0.05, 20.0)
"""A sail outside these distances from the Sun [AU] is lost."""

TOLERANCE = 1e-13
"""Of an integration step, relative to 1 + |state|: whole flights are within 1e-10 of a Taylor integrator."""

MOST_PERIODS = 10**8
"""A flight of more guidance periods is refused."""

REVERSAL = math.radians(40.0)
"""A command that differs by more from that of the period before reverses the sail [rad]."""

OPTICS_COEFFICIENTS = ("normal_square", "normal_linear", "tangential")
"""Names of ``Optics.force``, in its order."""

STATE = ("r", "theta", "u", "v")
"""Names of a state in the plane, in the order of its rows or columns."""

STATE_IN_SPACE = ("r", "theta", "latitude", "u", "v", "w")
"""The same in three dimensions."""

SHOWN = ("r", "latitude", "u", "v", "w")
"""Names of what navigation shows, as the plant keeps them; in the plane latitude and w are 0."""


def components_of(mission: Mission) -> tuple[str, ...]:
    """Names of what navigation shows of a sail of this mission, in order."""
    return tuple(geometry_of(mission.components).state_names)


def rules(
    mission: Mission, disturbance: Disturbance, period: float, beta_range: tuple[float, float]
) -> NDArray[np.void]:
    """What the plant has to know: ``plant_rules``.

    Args:
        mission: the sail's beta, the target and the longest flight.
        disturbance: how the sail differs.
        period: guidance period [TU].
        beta_range: smallest and largest beta that the guidance estimates.

    Raises:
        SailnetError: a period that is not positive, too long for steering or too short for the mission's
            longest flight; a time of an outage below it; disturbances of latitude and w in the plane, or
            measured attitudes in space.
    """
    longest, degradation = mission.flight.longest, mission.degradation_flown(disturbance)
    if not (math.isfinite(period) and period > 0.0):
        raise SailnetError(f"the guidance period must be a positive number of TU, not {period}")
    refuse_long_period(period)
    if longest / period > MOST_PERIODS:
        raise SailnetError(f"a guidance period of {period:g} TU makes more than {MOST_PERIODS} in a flight")
    if disturbance.outage_probability > 0.0 and disturbance.outage_duration < period:
        raise SailnetError(f"outage_duration must be at least the guidance period, {period:g} TU")
    if disturbance.delay > longest:
        raise SailnetError(f"delay must be at most the longest flight, {longest:g} TU")
    _refuse_other_dimensions(mission, disturbance)
    drawn_here = {f"{name}_spread" for name in COEFFICIENTS}
    navigated = {f"{component}_{kind}" for component in SHOWN for kind in NAVIGATION}
    values = {name: value for name, value in vars(disturbance).items() if name not in navigated | drawn_here}
    for kind in NAVIGATION:
        values[f"navigation_{kind}"] = [getattr(disturbance, f"{component}_{kind}") for component in SHOWN]
    return plant().filled(
        "plant_rules",
        values
        | {
            "period": period,
            "longest": longest,
            "least_radius": RADII[0],
            "largest_radius": RADII[1],
            "tolerance": TOLERANCE,
            "components": mission.components,
            "target": target_of(mission.problem, len(SHOWN)),
            "bound": mission.problem.phi_max,
            "reversal": REVERSAL,
            "beta_range": beta_range,
            "beta": mission.sail.beta,
            "optics": optics_of(mission.optics_flown(disturbance).force),
            "degradation_loss": degradation.loss,
            "degradation_dose": degradation.dose,
        },
    )


def _refuse_other_dimensions(mission: Mission, disturbance: Disturbance) -> None:
    if not mission.inclined and (given := [name for name in OFF_PLANE if getattr(disturbance, name)]):
        raise SailnetError(
            f"{', '.join(given)}: mission {mission.name!r} is of coplanar orbits, without latitude and w"
        )
    if mission.inclined and (disturbance.attitude_measured or disturbance.attitude_noise):
        raise SailnetError(
            f"attitude_measured, attitude_noise: mission {mission.name!r} has three dimensions, in which no "
            "attitudes are measured yet"
        )


def optics_of(force: tuple[float, float, float]) -> NDArray[np.void]:
    """``plant_optics`` of ``Optics.force``."""
    return plant().filled("plant_optics", dict(zip(OPTICS_COEFFICIENTS, force, strict=True)))


def constant_errors(rules: NDArray[np.void], numbers: Sequence[int]) -> Array:
    """(n,) constant relative errors of beta that flights with these numbers depart with."""
    loaded = plant()
    sails = np.zeros(len(numbers), loaded.structures["plant_sail"])
    sails["number"] = numbers
    for place in range(len(sails)):
        loaded.functions.plant_depart(rules.ctypes.data, sails[place:].ctypes.data)
    return np.asarray(sails["beta_error"].copy())


def step_quantile(steps: NDArray[np.uint32], level: float) -> Array:
    """(n,) a bound that this share of the steps of a command does not exceed [rad]; 0 without any step.

    It is the upper edge of the size that the quantile falls into: too large by at most 1/16, and no less
    than ``plant_step_edge(0)``, 0.004 degrees.

    Args:
        steps: (n, sizes) counts by size, ``plant_sail.steps``.
        level: from 0 to 1.
    """
    sizes = steps.shape[1]
    edges = np.array([plant().functions.plant_step_edge(size) for size in range(sizes)])
    upto = np.cumsum(steps, axis=1, dtype=np.int64)
    reached = upto >= np.maximum(1, np.ceil(level * upto[:, -1:]))
    return np.where(reached.any(axis=1), edges[reached.argmax(axis=1)], 0.0)


class SideBySide:
    """Flights under way.

    Args:
        rules: what is the same for all, from :func:`rules`.
        starts: (n, 3) r, u, v at departure, or (n, 5) with latitude and w, ``components_of`` the mission.
        first: number of the first flight.
        steering: of n sails that start; called by the plant directly if it can be.
        optics_errors: (n, 3) by how much the force of each sail differs from that of the rules.

    Attributes:
        sails: (n,) ``plant_sail``.
    """

    def __init__(
        self,
        rules: NDArray[np.void],
        starts: Array,
        first: int,
        steering: Steering,
        optics_errors: Array,
    ) -> None:
        count, loaded = len(starts), plant()
        self._fly, self._rules = loaded.functions.plant_fly, rules
        self._record = loaded.structures["plant_record"]
        self.sails = np.zeros(count, loaded.structures["plant_sail"])
        space = starts.shape[1] == len(SHOWN)
        for component, column in zip(SHOWN if space else "ruv", starts.T, strict=True):
            self.sails["state"][component] = column
        for name, column in zip(OPTICS_COEFFICIENTS, optics_errors.T, strict=True):
            self.sails["optics_error"][name] = column
        self.sails["number"] = np.arange(first, first + count, dtype=np.uint64)
        native = steering.native() if isinstance(steering, NativeSteering) else None
        address, memories, precision = native or (0, 0, "float64")
        suffix = SUFFIXES[precision]
        kind = f"plant_command_in_space_{suffix}" if space else f"plant_command_{suffix}"
        slots = loaded.functions.plant_queue_slots(rules.ctypes.data)
        # All these live as long as the C points to them, the steering for its memories.
        self._steered_by = steering
        self._places: dict[str, NDArray[Any]] = {
            "sails": self.sails,
            "rows": np.arange(count, dtype=np.uint64),
            "queue": np.zeros((count, slots), loaded.structures["plant_attitude"]),
            "states": np.empty(starts.shape, precision),
            "attitudes": np.empty(count, precision),
            "commands": np.empty(count, loaded.structures[kind]),
            "statuses": np.empty(count, np.int32),
        }
        addresses = {name: place.ctypes.data for name, place in self._places.items()}
        self._flights = loaded.filled(
            "plant_flights", {"count": count, "flying": count, "interrupted": 0, **addresses}
        )
        self._errors: list[BaseException] = []
        if native is None:
            steer = _called_back(steering, self._places, self._flights, self._errors)
            self._callback = STEER(steer)
            address = ctypes.cast(self._callback, ctypes.c_void_p).value or 0
        functions = dict.fromkeys(SUFFIXES.values(), 0) | {suffix: address}
        self._steering = loaded.filled("plant_steering", {**functions, "memories": memories})

    @property
    def period(self) -> float:
        """Guidance period [TU]."""
        return float(self._rules["period"])

    @property
    def flying(self) -> int:
        """How many still fly."""
        return int(self._flights["flying"])

    def fly(self, periods: int) -> None:
        """Fly on for at most so many guidance periods; what the steering raises comes out."""
        self._fly_on(periods, None)

    def fly_recorded(self, periods: int) -> NDArray[np.void]:
        """:meth:`fly`, returning (periods, n) of ``plant_record``, filled for the periods flown."""
        records = np.empty((periods, len(self.sails)), self._record)
        self._fly_on(periods, records.ctypes.data)
        return records

    def _fly_on(self, periods: int, records: int | None) -> None:
        structures = (self._rules, self._steering, self._flights)
        self._fly(*(item.ctypes.data for item in structures), periods, records)
        if self._errors:
            raise self._errors[0]


def _called_back(
    steering: Steering,
    places: Mapping[str, NDArray[Any]],
    flights: NDArray[np.void],
    errors: list[BaseException],
) -> Callable[..., None]:
    """``plant_steer_f64`` for a steering in Python; an error there ends the flights and is kept."""
    names = ("states", "attitudes", "rows", "commands", "statuses")
    states, attitudes, rows, commands, statuses = (places[name] for name in names)

    def steer(
        count: int,
        _memories: int,
        _rows: int,
        _states: int,
        measured: int | None,
        period: float,
        _commands: int,
        _statuses: int,
    ) -> None:
        # The addresses are those of the arrays of the flights.
        try:
            told = attitudes[:count].copy() if measured else None
            steered = steering.steer(states[:count].copy(), period, rows[:count].astype(np.intp), told)
            for name in commands.dtype.names or ():
                commands[name][:count] = getattr(steered, name)
            statuses[:count] = steered.status
        except BaseException as error:  # an interruption too: it must not be lost in the C below
            errors.append(error)
            flights["interrupted"] = 1

    return steer

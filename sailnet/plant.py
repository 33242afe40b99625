"""The plant in C, called by ctypes: sails side by side, from one guidance period to the next.

The C is in ``c_runtime/simulation/plant``; it is compiled when the package is installed. ``sailnet.flight``
flies with it, whatever computes the guidance: the exported C is called by the plant directly, anything else
through a callback.
"""

import ctypes
import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.checksums import verify_checksum
from sailnet.disturbances import Disturbance
from sailnet.dynamics import Array
from sailnet.errors import GuidanceError, SailnetError
from sailnet.mission import Mission

API_VERSION = 1

LIBRARY = Path(__file__).parent / "native" / "plant.so"

RADII = (0.05, 20.0)
"""A sail outside these distances from the Sun [AU] is lost."""

TOLERANCE = 1e-13
"""Of an integration step, relative to 1 + |state|: whole flights are within 1e-10 of a Taylor integrator."""

MOST_PERIODS = 10**8
"""A flight of more guidance periods is refused."""

_TRIPLE = ctypes.c_double * 3


class Rules(ctypes.Structure):
    """``plant_rules``: what is the same for all flights."""

    _fields_ = [
        *((name, ctypes.c_double) for name in ("period", "longest", "least_radius", "largest_radius")),
        ("tolerance", ctypes.c_double),
        ("target", _TRIPLE),
        ("beta", ctypes.c_double),
        ("optics", _TRIPLE),
        *((f"beta_{name}", ctypes.c_double) for name in ("bias", "spread", "drift", "noise")),
        *((name, ctypes.c_double) for name in ("beta_wander", "beta_wander_time")),
        *((name, ctypes.c_double) for name in ("degradation_loss", "degradation_dose")),
        *((f"navigation_{name}", _TRIPLE) for name in ("bias", "noise", "wander")),
        ("navigation_wander_time", ctypes.c_double),
        *((name, ctypes.c_double) for name in ("rate_limit", "delay", "resolution")),
        *((name, ctypes.c_double) for name in ("misalignment", "misalignment_spread")),
        *((name, ctypes.c_double) for name in ("outage_probability", "outage_duration")),
        ("seed", ctypes.c_uint64),
    ]


SAIL = np.dtype(
    [
        *((name, "f8") for name in ("r", "theta", "u", "v", "dose", "time", "attitude", "misalignment")),
        *((name, "f8") for name in ("beta_error", "beta_wander")),
        ("navigation_wander", "f8", 3),
        *((name, "f8") for name in ("step", "beta_estimate", "max_cone_angle", "max_attitude")),
        *((name, "f8") for name in ("nearest_error", "nearest_time")),
        ("number", "u8"),
        *((name, "u4") for name in ("periods", "outside", "outages")),
        *((name, "i4") for name in ("out", "ending", "unused")),
    ]
)
"""``plant_sail``: one flight."""

RECORD = np.dtype(
    [
        *((name, "f8") for name in ("time", "r", "theta", "u", "v")),
        ("seen", "f8", 3),
        *((name, "f8") for name in ("cone_angle", "attitude", "beta", "beta_estimate")),
        *((name, "f8") for name in ("time_of_flight", "status")),
    ]
)
"""``plant_record``: one period of one flight."""

_POINTER = ctypes.c_void_p
STEER = ctypes.CFUNCTYPE(
    None, ctypes.c_uint64, _POINTER, _POINTER, _POINTER, ctypes.c_double, _POINTER, _POINTER
)
"""``plant_steer_f64``: count, memories, sails, states, period, commands, statuses."""


class SteeringFunction(ctypes.Structure):
    """``plant_steering``: who commands; exactly one of the two functions is set."""

    _fields_ = [("f32", _POINTER), ("f64", _POINTER), ("memories", _POINTER)]


class FlightsSideBySide(ctypes.Structure):
    """``plant_flights``."""

    _fields_ = [
        ("count", ctypes.c_uint64),
        ("flying", ctypes.c_uint64),
        *((name, _POINTER) for name in ("sails", "rows", "queue", "states", "commands", "statuses")),
        ("interrupted", ctypes.c_int32),
        ("unused", ctypes.c_int32),
    ]


@cache
def library() -> ctypes.CDLL:
    """The compiled plant.

    Raises:
        GuidanceError: it is missing, damaged, of another version or cannot be loaded here.
    """
    verify_checksum(LIBRARY, LIBRARY.parent / "libraries.sha256")
    try:
        loaded = ctypes.CDLL(str(LIBRARY))
        sizes = {"rules": Rules, "flights": FlightsSideBySide}
        expected = {name: ctypes.sizeof(structure) for name, structure in sizes.items()}
        expected |= {"sail": SAIL.itemsize, "record": RECORD.itemsize}
        same = loaded.plant_api_version() == API_VERSION and all(
            loaded[f"plant_size_of_{name}"]() == size for name, size in expected.items()
        )
        number, word = ctypes.c_uint64, ctypes.c_uint32
        loaded.plant_sources_digest.restype = ctypes.c_char_p
        loaded.plant_queue_slots.restype = number
        loaded.plant_queue_slots.argtypes = [_POINTER]
        loaded.plant_fly.restype = number
        loaded.plant_fly.argtypes = [_POINTER, _POINTER, _POINTER, number, _POINTER]
        loaded.plant_hold.argtypes = [_POINTER, *[ctypes.c_double] * 4, _POINTER, _POINTER]
        loaded.plant_philox.restype = None
        loaded.plant_philox.argtypes = [_POINTER] * 3
        for draw in (loaded.plant_uniform, loaded.plant_normal):
            draw.restype, draw.argtypes = ctypes.c_double, [number, number, word, word]
    except (OSError, AttributeError) as error:
        raise GuidanceError(f"cannot load {LIBRARY}: {error}; install sailnet again") from error
    if not same:
        raise GuidanceError(f"{LIBRARY} is of another version of sailnet; install sailnet again")
    return loaded


def sources_digest() -> str:
    """SHA-256 of the C that the plant was compiled from."""
    digest: bytes = library().plant_sources_digest()
    return digest.decode("ascii")


def rules(mission: Mission, disturbance: Disturbance, period: float) -> Rules:
    """What the plant has to know.

    Args:
        mission: the sail's beta, the target and the longest flight.
        disturbance: how the sail differs.
        period: guidance period [TU].

    Raises:
        SailnetError: a period that is not positive, or too short for the mission's longest flight; a time
            of an outage below it.
    """
    longest = mission.flight.longest
    if not (math.isfinite(period) and period > 0.0):
        raise SailnetError(f"the guidance period must be a positive number of TU, not {period}")
    if longest / period > MOST_PERIODS:
        raise SailnetError(f"a guidance period of {period:g} TU makes more than {MOST_PERIODS} in a flight")
    if disturbance.outage_probability > 0.0 and disturbance.outage_duration < period:
        raise SailnetError(f"outage_duration must be at least the guidance period, {period:g} TU")
    if disturbance.delay > longest:
        raise SailnetError(f"delay must be at most the longest flight, {longest:g} TU")
    made = Rules(
        period=period,
        longest=longest,
        least_radius=RADII[0],
        largest_radius=RADII[1],
        tolerance=TOLERANCE,
        target=mission.problem.target_state,
        beta=mission.sail.beta,
        optics=disturbance.optics.force,
    )
    for kind in ("bias", "noise", "wander"):
        errors = [getattr(disturbance, f"{component}_{kind}") for component in "ruv"]
        setattr(made, f"navigation_{kind}", _TRIPLE(*errors))
    for name in (field[0] for field in Rules._fields_):
        if name != "optics" and hasattr(disturbance, name):
            setattr(made, name, getattr(disturbance, name))
    return made


class SideBySide:
    """Flights under way.

    Args:
        rules: what is the same for all.
        starts: (n, 3) r, u, v at departure.
        first: number of the first flight.
        steer: address of a steering function of the precision, ``sailnet_steer_batch`` of a flight library
            or a ``STEER``.
        memories: its memories.
        precision: of its states and commands.
    """

    def __init__(
        self, rules: Rules, starts: Array, first: int, steer: int, memories: int | None, precision: str
    ) -> None:
        count = len(starts)
        self._library = library()
        self._rules = rules
        self.sails = np.zeros(count, SAIL)
        for component, column in zip("ruv", starts.T, strict=True):
            self.sails[component] = column
        self.sails["number"] = np.arange(first, first + count, dtype=np.uint64)
        slots = self._library.plant_queue_slots(ctypes.byref(rules))
        places: dict[str, NDArray[Any]] = {
            "sails": self.sails,
            "rows": np.arange(count, dtype=np.uint64),
            "queue": np.zeros((count, slots)),
            "states": np.empty((count, 3), precision),
            "commands": np.empty((count, 4), precision),
            "statuses": np.empty(count, np.int32),
        }
        self._places = places  # lives as long as the C points to it
        addresses = {name: place.ctypes.data for name, place in places.items()}
        self.flights = FlightsSideBySide(count=count, flying=count, **addresses)
        bits = "f64" if np.dtype(precision).itemsize == 8 else "f32"
        self._steering = SteeringFunction(**{bits: steer}, memories=memories)

    def fly(self, periods: int, records: NDArray[np.void] | None = None) -> int:
        """Fly on for at most so many periods; returns how many still fly.

        Args:
            periods: guidance periods.
            records: (periods, n) of ``RECORD``, filled for the periods that are flown.
        """
        where = None if records is None else records.ctypes.data
        structures = (self._rules, self._steering, self.flights)
        left = self._library.plant_fly(*(ctypes.byref(item) for item in structures), periods, where)
        return int(left)


def hold_angle(
    states: Array,
    beta: ArrayLike,
    angle: ArrayLike,
    duration: ArrayLike,
    optics: tuple[float, float, float] = (1.0, 0.0, 0.0),
    rate: float = 0.0,
) -> Array:
    """Fly sails whose cone angle is held, or turns steadily; the plant's Eq. (1) alone.

    Args:
        states: (4, n) rows r, theta, u, v.
        beta: (n,) or one normalised characteristic acceleration.
        angle: (n,) or one cone angle at the start [rad].
        duration: (n,) or one time [TU].
        optics: coefficients of the force; ideal by default.
        rate: of the cone angle [rad/TU].

    Returns:
        (5, n) states at the end and the dose of sunlight [TU/AU^2]; NaN for a sail that was lost.
    """
    given = Rules(least_radius=RADII[0], largest_radius=RADII[1], tolerance=TOLERANCE, optics=optics)
    count = states.shape[1]
    columns = np.vstack([states, np.zeros(count)]).T.copy()
    numbers = np.broadcast_arrays(np.empty(count), beta, angle, duration)[1:]
    for row, *values in zip(columns, *numbers, strict=True):
        strength, start, time = map(float, values)
        step = ctypes.c_double(0.0)
        inside = library().plant_hold(
            ctypes.byref(given), strength, start, rate, time, row.ctypes.data, ctypes.byref(step)
        )
        if not inside:
            row[:] = np.nan
    return columns.T.copy()

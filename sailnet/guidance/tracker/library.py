"""The compiled tracker: extremals backward from the target, and plans corrected by Newton's method.

The C is in ``c_runtime/flight/tracker`` and is compiled when the package is installed, for the plane and for
space; what its structures mean is in its headers.
"""

import ctypes
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.artefacts.checksums import verify_checksum
from sailnet.artefacts.shared_objects import refuse_unloadable
from sailnet.errors import GuidanceError
from sailnet.physics.arrays import Array
from sailnet.physics.optics import Optics
from sailnet.physics.real_law import RealLaw, force_curve

FOLDER = Path(__file__).parent / "native"
NAMES = {3: "tracker_plane.so", 5: "tracker_space.so"}

ASKS_NETWORKS, ASKS_KNOWN = 1, 2
"""``SAILNET_ASKS_NETWORKS`` and ``SAILNET_ASKS_KNOWN``: what a tracker asks for, beside nothing."""

PROBLEM = np.dtype(
    [(name, "f8") for name in ("beta", "target_radius", "square", "linear", "across")]
    + [(name, "f8") for name in ("bound_cosine", "bound_sine", "edge_radial", "edge_lateral")]
)
"""``sailnet_problem``."""


def plan_type(components: int) -> np.dtype[np.void]:
    """``sailnet_plan`` of states with so many components, 3 or 5."""
    return np.dtype(
        [
            ("direction", "f8", (components,)),
            ("time_to_go", "f8"),
            ("beta", "f8"),
            ("across", "f8"),
            ("residual", "f8"),
            ("jacobian", "f8", (components, components)),
            ("per_beta", "f8", (components,)),
            ("per_across", "f8", (components,)),
            ("end", end_type(components)),
            ("age", "f8"),
            ("largest", "i4"),
            ("differentiated", "i4"),
        ]
    )


def end_type(components: int) -> np.dtype[np.void]:
    """``sailnet_end``."""
    return np.dtype([("value", "f8", (2 * components,)), ("rate", "f8", (2 * components,))])


def attitude_type(components: int) -> np.dtype[np.void]:
    """``sailnet_attitude``."""
    return np.dtype([("cosine", "f8"), ("sine", "f8"), ("across", "f8", (1 if components == 3 else 2,))])


def tracker_type(components: int) -> np.dtype[np.void]:
    """``sailnet_tracker``."""
    return np.dtype(
        [
            ("plan", plan_type(components)),
            ("candidate", plan_type(components)),
            ("since", "f8"),
            ("stride", "f8"),
            ("searched", "f8"),
            ("promised", "f8"),
            ("tried", "f8"),
            ("flown", attitude_type(components)),
            ("regret", "f8"),
        ]
        + [(name, "i4") for name in ("planned", "searching", "untried", "computed")],
        align=True,
    )


FAILED = 4e-4
"""A plan that misses the state by more [AU, AU/TU] has failed: ``FAILED`` of ``sailnet_candidate.c``."""


def has_lost(trackers: NDArray[np.void]) -> NDArray[np.bool_]:
    """(n,) of which the plan has failed and is not solved: for those there is no thrust margin."""
    return np.asarray((trackers["planned"] > 1) & ~(trackers["plan"]["residual"] < FAILED))


def known_type(components: int) -> np.dtype[np.void]:
    """``sailnet_known_plan`` of states with so many components, 3 or 5."""
    vector = "f4", (components,)
    return np.dtype([("state", *vector), ("beta", "f4"), ("direction", *vector), ("time_to_go", "f4")])


def known_plans(rows: Array) -> NDArray[np.void]:
    """Known plans as the C reads them.

    Args:
        rows: (k, 8) or (k, 12): :attr:`sailnet.networks.known_plans.KnownPlans.rows`.
    """
    components = rows.shape[1] // 2 - 1
    made = np.zeros(len(rows), known_type(components))
    made["state"], made["beta"] = rows[:, :components], rows[:, components]
    made["direction"], made["time_to_go"] = rows[:, components + 1 : -1], rows[:, -1]
    if components == 5:  # the C has the tangent of the latitude
        made["state"][:, 1] = np.tan(rows[:, 1])
    return made


def problem_of(optics: Optics, phi_max: float, beta: float, target_radius: float) -> NDArray[np.void]:
    """The problem as the C reads it, with the sharp law of Eq. (11).

    Args:
        optics: of the sail.
        phi_max: bound on the cone angle [rad].
        beta: normalised characteristic acceleration.
        target_radius: of the target orbit [AU].

    Raises:
        SolveError: there is no law for such a sail, see :meth:`sailnet.physics.real_law.RealLaw.of`.
    """
    force = np.array([optics.force])
    law = RealLaw.of(force, phi_max)
    bound = float(law.bound[0])
    made = np.zeros((), PROBLEM)
    made["beta"], made["target_radius"] = beta, target_radius
    made["square"], made["linear"], made["across"] = force[0]
    made["bound_cosine"], made["bound_sine"] = np.cos(bound), np.sin(bound)
    made["edge_radial"], made["edge_lateral"] = force_curve(law.last, force)[1, :, 0]
    return made


@dataclass(frozen=True)
class Vehicles:
    """What plans are made for; (n,) each.

    Attributes:
        beta: normalised characteristic acceleration to plan with.
        estimated: the same without the thrust margin.
        tangential: force along the surface beyond that of the mission's optics, as a share of the force along
            the normal.
        as_fast: beta of a vehicle of the mission's optics that is as fast: what the networks are asked for.
    """

    beta: Array
    estimated: Array
    tangential: Array
    as_fast: Array

    @classmethod
    def of_mission(cls, beta: Array) -> "Vehicles":
        """Of the mission's optics, without a thrust margin."""
        return cls(beta, beta, np.zeros(len(beta)), beta)

    def rows(self, chosen: NDArray[np.bool_]) -> "Vehicles":
        """Some of them."""
        columns = (self.beta, self.estimated, self.tangential, self.as_fast)
        return Vehicles(*(column[chosen] for column in columns))


@dataclass(frozen=True)
class Planned:
    """What plans command; (n,) each, of which only those count that are flown.

    Attributes:
        flown: whether there is a plan that passes through the state.
        cone_angle: [rad], signed in the plane.
        clock_angle: [rad], 0 in the plane.
        time_to_go: [TU].
        costates: (n, 3) or (n, 5) at the middle of the period, scaled to H = 0.
    """

    flown: NDArray[np.bool_]
    cone_angle: Array
    clock_angle: Array
    time_to_go: Array
    costates: Array


class Tracker:
    """The compiled tracker of one geometry.

    Args:
        components: of a state: 3 in the plane, 5 in space.

    Raises:
        GuidanceError: the library is missing, damaged, of another version or cannot be loaded here.
    """

    def __init__(self, components: int) -> None:
        file = FOLDER / NAMES[components]
        content = verify_checksum(file, FOLDER / "libraries.sha256")
        self.components = components
        attitude = attitude_type(components)
        self._planned = np.dtype(
            [("attitude", attitude), ("time_to_go", "f8"), ("costates", "f8", (components,))]
        )
        try:
            refuse_unloadable(content)
            functions = ctypes.CDLL(str(file))
            pointer, number, real = ctypes.c_void_p, ctypes.c_uint64, ctypes.c_double
            sizes = functions.tracker_size, functions.tracker_plan_size, functions.tracker_problem_size
            for size in sizes:
                size.restype = number
            functions.tracker_extremals.argtypes = [pointer, number, pointer, pointer, real, pointer, pointer]
            most = ctypes.c_int32
            functions.tracker_correct.argtypes = [pointer, number, pointer, pointer, most, pointer]
            functions.tracker_solved.argtypes = [number, *[pointer] * 2]
            functions.tracker_time_passes.argtypes = [number, *[pointer] * 3]
            functions.tracker_propose.argtypes = [pointer, number, *[pointer] * 5, ctypes.c_int32]
            functions.tracker_propose_known.argtypes = [pointer, number, *[pointer] * 6, ctypes.c_int32]
            functions.tracker_follow.argtypes = [pointer, number, *[pointer] * 6, most, *[pointer] * 2]
        except (OSError, AttributeError, ValueError) as error:
            raise GuidanceError(f"cannot load {file}: {error}; install sailnet again") from error
        expected = tracker_type(components), plan_type(components), PROBLEM
        if [size() for size in sizes] != [item.itemsize for item in expected]:
            raise GuidanceError(f"{file} is of another version of sailnet; install sailnet again")
        self._functions = functions

    def extremals(
        self, problem: NDArray[np.void], directions: ArrayLike, tau: ArrayLike, tolerance: float = 1e-10
    ) -> tuple[Array, NDArray[np.int32]]:
        """Fly extremals backward from the target orbit, Eqs. (14)-(19) with delta = 0.

        Args:
            problem: of :func:`problem_of`.
            directions: (n, 3) or (n, 5) arrival costates, of which the direction counts.
            tau: (n,) times to go [TU].
            tolerance: local error of a step, in AU and AU/TU.

        Returns:
            (n, 6) or (n, 10) states and costates there, the costates for the given arrival costates; and (n,)
            integration steps, 0 where the extremal could not be flown.
        """
        given = np.ascontiguousarray(directions, float)
        times = np.ascontiguousarray(tau, float)
        if given.shape != (len(times), self.components):
            raise GuidanceError(f"{len(times)} times need ({len(times)}, {self.components}) directions")
        ends, steps = np.zeros(len(times), end_type(self.components)), np.zeros(len(times), np.int32)
        self._functions.tracker_extremals(
            problem.ctypes.data,
            len(times),
            given.ctypes.data,
            times.ctypes.data,
            tolerance,
            ends.ctypes.data,
            steps.ctypes.data,
        )
        states = ends["value"].copy()
        if self.components == 5:  # the C has the tangent of the latitude, and its costate
            square = 1.0 + states[:, 1] ** 2
            states[:, 1], states[:, 6] = np.arctan(states[:, 1]), states[:, 6] * square
        return states, steps

    def begun(self, directions: ArrayLike, tau: ArrayLike, beta: ArrayLike) -> NDArray[np.void]:
        """(n,) plans that are not corrected yet.

        Args:
            directions: (n, 3) or (n, 5) of the arrival costates, of any size.
            tau: (n,) times to go [TU].
            beta: (n,) or one normalised characteristic acceleration.
        """
        plans = np.zeros(len(np.asarray(tau)), plan_type(self.components))
        plans["direction"], plans["time_to_go"], plans["beta"] = directions, tau, beta
        plans["largest"], plans["residual"] = -1, np.inf
        return plans

    def correct(
        self, problem: NDArray[np.void], plans: NDArray[np.void], states: Array, most: int
    ) -> NDArray[np.int32]:
        """Correct plans in place, each for its own beta: see ``sailnet_correct_plan``.

        Args:
            problem: of :func:`problem_of`; its beta is not used.
            plans: (n,) of :meth:`begun`.
            states: (n, 3) or (n, 5) to pass through.
            most: extremals computed at most for each, of which no call computes more than 64.

        Returns:
            (n,) extremals computed.
        """
        given, computed = self._as_states(states), np.zeros(len(plans), np.int32)
        places = [array.ctypes.data for array in (plans, given)]
        self._functions.tracker_correct(problem.ctypes.data, len(plans), *places, most, computed.ctypes.data)
        return computed

    def solved(self, plans: NDArray[np.void]) -> NDArray[np.bool_]:
        """(n,) whether plans pass through the states they were corrected for: ``sailnet_plan_is_solved``."""
        given, solved = np.ascontiguousarray(plans), np.zeros(len(plans), np.int32)
        self._functions.tracker_solved(len(given), given.ctypes.data, solved.ctypes.data)
        return solved.astype(bool)

    def time_passes(self, trackers: NDArray[np.void], held: Array) -> NDArray[np.int32]:
        """A period of (n,) ``held`` [TU] is over.

        Returns:
            (n,) what trackers ask for: ``ASKS_NETWORKS``, ``ASKS_KNOWN`` or nothing, 0.
        """
        asked, times = np.zeros(len(trackers), np.int32), np.ascontiguousarray(held, float)
        places = [array.ctypes.data for array in (trackers, times, asked)]
        self._functions.tracker_time_passes(len(trackers), *places)
        return asked

    def propose(
        self,
        problem: NDArray[np.void],
        trackers: NDArray[np.void],
        directions: ArrayLike,
        tau: ArrayLike,
        vehicles: Vehicles,
        known: int = 0,
    ) -> None:
        """Propose plans: see ``sailnet_propose``.

        Args:
            problem: of :func:`problem_of`, of the mission's optics; its beta is not used.
            trackers: (n,) of :func:`tracker_type`, changed in place.
            directions: (n, 3) or (n, 5) of the arrival costates, of any size.
            tau: (n,) times to go [TU].
            vehicles: of the sails.
            known: how many known plans there are.
        """
        columns = directions, tau, vehicles.tangential, vehicles.beta
        given = [np.ascontiguousarray(column, float) for column in columns]
        places = [array.ctypes.data for array in (trackers, *given)]
        self._functions.tracker_propose(problem.ctypes.data, len(trackers), *places, known)

    def propose_known(
        self,
        problem: NDArray[np.void],
        trackers: NDArray[np.void],
        states: Array,
        vehicles: Vehicles,
        known: NDArray[np.void],
    ) -> None:
        """Propose the nearest known plans that were not tried yet: see ``sailnet_propose_known``.

        Args:
            problem: of :func:`problem_of`, of the mission's optics and beta.
            trackers: (n,) of :func:`tracker_type`, changed in place.
            states: (n, 3) or (n, 5) to plan from.
            vehicles: of the sails.
            known: of :func:`known_plans`.
        """
        shares = vehicles.as_fast / float(problem["beta"])
        columns = self._as_states(states), shares, vehicles.tangential, vehicles.beta
        given = [np.ascontiguousarray(column, float) for column in columns]
        places = [array.ctypes.data for array in (trackers, *given, known)]
        self._functions.tracker_propose_known(problem.ctypes.data, len(trackers), *places, len(known))

    def follow(
        self,
        problem: NDArray[np.void],
        trackers: NDArray[np.void],
        states: Array,
        vehicles: Vehicles,
        hold: Array,
        most: int,
    ) -> Planned:
        """Correct the plans and command: see ``sailnet_follow``.

        Args:
            problem: of :func:`problem_of`, of the mission's optics; its beta is not used.
            trackers: (n,) of :func:`tracker_type`, changed in place.
            states: (n, 3) or (n, 5) to pass through.
            vehicles: what to plan for.
            hold: (n,) for how long [TU] the commands are held.
            most: extremals computed at most for each.
        """
        count, given = len(trackers), self._as_states(states)
        planned, flown = np.zeros(count, self._planned), np.zeros(count, np.int32)
        columns = vehicles.tangential, vehicles.beta, vehicles.estimated, hold
        numbers = [np.ascontiguousarray(column, float) for column in columns]
        places = [array.ctypes.data for array in (trackers, given, *numbers)]
        self._functions.tracker_follow(
            problem.ctypes.data, count, *places, most, planned.ctypes.data, flown.ctypes.data
        )
        attitude = planned["attitude"]
        cone, across = np.arctan2(attitude["sine"], attitude["cosine"]), attitude["across"]
        clock = np.zeros(count)
        if self.components == 5:
            clock = np.arctan2(across[:, 1], across[:, 0])
        else:
            cone = np.copysign(cone, across[:, 0])
        return Planned(flown != 0, cone, clock, planned["time_to_go"].copy(), planned["costates"].copy())

    def _as_states(self, states: Array) -> Array:
        given = np.array(states, float)
        if self.components == 5:
            given[:, 1] = np.tan(given[:, 1])
        return given


@cache
def tracker(components: int) -> Tracker:
    """The tracker that came with the package; see :class:`Tracker`."""
    return Tracker(components)

"""The compiled tracker: extremals backward from the target, and plans corrected by Newton's method.

The C is in ``c_runtime/flight/tracker`` and is compiled when the package is installed, for the plane and for
space; what its structures mean is in its headers.
"""

import ctypes
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.artefacts.checksums import verify_checksum
from sailnet.artefacts.shared_objects import refuse_unloadable
from sailnet.errors import GuidanceError
from sailnet.physics.arrays import Array
from sailnet.physics.real_law import RealLaw
from sailnet.physics.transfer import Transfer

FOLDER = Path(__file__).parent / "native"
NAMES = {3: "tracker_plane.so", 5: "tracker_space.so"}

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
            ("residual", "f8"),
            ("jacobian", "f8", (components, components)),
            ("largest", "i4"),
            ("differentiated", "i4"),
        ]
    )


def problem_of(transfer: Transfer) -> NDArray[np.void]:
    """The problem as the C reads it: with the sharp law, whatever the smoothing of the transfer.

    Args:
        transfer: of one sail, of any optics.

    Raises:
        SolveError: there is no law for such a sail, see :meth:`sailnet.physics.real_law.RealLaw.of`.
    """
    force = np.array([transfer.optics.force])
    law = RealLaw.of(force, transfer.phi_max)
    bound, takeover = float(law.bound[0]), float(law.takeover[0])
    made = np.zeros((), PROBLEM)
    made["beta"], made["target_radius"] = transfer.beta, transfer.target_radius
    made["square"], made["linear"], made["across"] = force[0]
    made["bound_cosine"], made["bound_sine"] = np.cos(bound), np.sin(bound)
    # sin(takeover - theta) > 0, with theta the angle of the force that is wanted from the Sun line.
    made["edge_radial"], made["edge_lateral"] = -np.sin(takeover), np.cos(takeover)
    return made


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
        self.plan_type = plan_type(components)
        self._end = np.dtype([("value", "f8", (2 * components,)), ("rate", "f8", (2 * components,))])
        across = 1 if components == 3 else 2
        self._attitude = np.dtype([("cosine", "f8"), ("sine", "f8"), ("across", "f8", (across,))])
        try:
            refuse_unloadable(content)
            functions = ctypes.CDLL(str(file))
            pointer, number, real = ctypes.c_void_p, ctypes.c_uint64, ctypes.c_double
            sizes = functions.tracker_plan_size, functions.tracker_problem_size
            for size in sizes:
                size.restype = number
            functions.tracker_extremals.argtypes = [pointer, number, pointer, pointer, real, pointer, pointer]
            functions.tracker_correct.argtypes = [
                pointer, number, *[pointer] * 5, ctypes.c_int32, *[pointer] * 3
            ]  # fmt: skip
        except (OSError, AttributeError, ValueError) as error:
            raise GuidanceError(f"cannot load {file}: {error}; install sailnet again") from error
        if [size() for size in sizes] != [self.plan_type.itemsize, PROBLEM.itemsize]:
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
        ends, steps = np.zeros(len(times), self._end), np.zeros(len(times), np.int32)
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

    def correct(
        self,
        problem: NDArray[np.void],
        plans: NDArray[np.void],
        sails: NDArray[np.intp],
        states: Array,
        beta: Array,
        ahead: Array,
        most: int,
    ) -> tuple[Array, Array, Array, NDArray[np.int32]]:
        """Correct the plans of some sails in place, see ``sailnet_correct_plan``.

        Args:
            problem: of :func:`problem_of`; its beta is not used.
            plans: of all sails, of ``plan_type``.
            sails: (n,) which of them.
            states: (n, 3) or (n, 5) states to pass through.
            beta: (n,) normalised characteristic accelerations to plan with.
            ahead: (n,) how much later [TU] the attitudes are wanted.
            most: extremals computed at most for each.

        Returns:
            (n,) cone angles [rad], signed in the plane; (n,) clock angles [rad], 0 in the plane; (n, 3) or
            (n, 5) costates now, scaled to H = 0; (n,) extremals computed.
        """
        count, size = len(sails), self.components
        given = np.array(states, float)
        if size == 5:
            given[:, 1] = np.tan(given[:, 1])
        ends, attitudes = np.zeros(count, self._end), np.zeros(count, self._attitude)
        computed = np.zeros(count, np.int32)
        rows = np.ascontiguousarray(sails, np.uint64)
        betas, later = np.ascontiguousarray(beta, float), np.ascontiguousarray(ahead, float)
        self._functions.tracker_correct(
            problem.ctypes.data,
            count,
            rows.ctypes.data,
            plans.ctypes.data,
            given.ctypes.data,
            betas.ctypes.data,
            later.ctypes.data,
            most,
            ends.ctypes.data,
            attitudes.ctypes.data,
            computed.ctypes.data,
        )
        cone = np.arctan2(attitudes["sine"], attitudes["cosine"])
        clock = np.zeros(count)
        if size == 5:
            clock = np.arctan2(attitudes["across"][:, 1], attitudes["across"][:, 0])
        else:
            cone = attitudes["across"][:, 0] * cone
        costates = ends["value"][:, size:].copy()
        # lambda . dx/dt = -1, and rates are by the time to go.
        with np.errstate(all="ignore"):
            costates /= (costates * ends["rate"][:, :size]).sum(axis=1)[:, None]
        if size == 5:
            costates[:, 1] *= 1.0 + ends["value"][:, 1] ** 2
        return cone, clock, costates, computed


@cache
def tracker(components: int) -> Tracker:
    """The tracker that came with the package; see :class:`Tracker`."""
    return Tracker(components)

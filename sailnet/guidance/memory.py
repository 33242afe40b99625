"""What steering remembers from one period to the next."""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.physics.arrays import Array

TILTS = ("cone_angle", "attitude", "measured", "offset")
ARCS = 8
"""Of a plan, see :mod:`sailnet.guidance.homing`."""
COUNTS = ("periods", "homing", "arc", "corrections")


@dataclass
class Memory:
    """Of n sails, as in ``sailnet_memory`` of one that ages and flies its model ahead, in order.

    States are (n, 3) or (n, 5); ``cone_angle``, ``attitude``, ``measured`` and ``offset`` are tilts of
    :mod:`sailnet.guidance.tilts`, one for each arc in ``arc_tilt``; all others are (n,).
    """

    state: Array
    cone_angle: Array
    attitude: Array
    measured: Array
    offset: Array
    held: Array
    time_of_flight: Array
    beta: Array
    tangential: Array
    surprise: Array
    variance: Array
    slow: Array
    slewing: Array
    stake: Array
    regret: Array
    late: Array
    wait: Array
    waited: Array
    unseen: Array
    worn: Array
    arc_tilt: Array
    arc_time: Array
    ahead: Array
    looked: Array
    promised: Array
    nearest: Array
    nearest_time: Array
    homing: NDArray[np.int64]
    arc: NDArray[np.int64]
    corrections: NDArray[np.int64]
    periods: NDArray[np.int64]

    @classmethod
    def started(cls, count: int, beta: float, components: int = 3) -> "Memory":
        """Of ``count`` sails that know nothing but a beta; a state has so many components, 3 or 5."""
        tilt = (count,) if components == 3 else (count, 2)
        shapes = {"state": (count, components), "ahead": (count, components), **dict.fromkeys(TILTS, tilt)}
        shapes |= {"arc_time": (count, ARCS), "arc_tilt": (count, ARCS, *tilt[1:])}
        names = [item.name for item in fields(cls) if item.name not in ("beta", *COUNTS)]
        counts: Any = {name: np.zeros(count, np.int64) for name in COUNTS}
        numbers: Any = {name: np.zeros(shapes.get(name, (count,))) for name in names}
        return cls(beta=np.full(count, beta), **numbers, **counts)

    def rows(self, sails: NDArray[np.intp]) -> "Memory":
        """Copies of some of them."""
        return Memory(**{item.name: getattr(self, item.name)[sails] for item in fields(self)})

    def put(self, sails: NDArray[np.intp], rows: "Memory") -> None:
        """Put copies back."""
        for item in fields(self):
            getattr(self, item.name)[sails] = getattr(rows, item.name)

"""What steering remembers from one period to the next."""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.guidance.tracker.library import tracker_type
from sailnet.physics.arrays import Array

COUNTS = ("periods", "samples")
TILTS = ("cone_angle", "attitude", "measured", "offset")


@dataclass
class Memory:
    """Of n sails: the estimate, the tracker with its plan, and the rest of ``sailnet_memory``.

    States are (n, 3) or (n, 5); ``cone_angle``, ``attitude``, ``measured`` and ``offset`` are tilts of
    :mod:`sailnet.guidance.tilts`; all others are (n,).
    """

    state: Array
    cone_angle: Array
    attitude: Array
    measured: Array
    offset: Array
    held: Array
    beta: Array
    tangential: Array
    innovation: Array
    variance: Array
    autocovariance: Array
    slewing: Array
    unseen: Array
    worn: Array
    periods: NDArray[np.int64]
    samples: NDArray[np.int64]
    tracker: NDArray[np.void]
    time_of_flight: Array

    @classmethod
    def started(cls, count: int, beta: float, components: int = 3) -> "Memory":
        """Of ``count`` sails that know nothing but a beta; a state has so many components, 3 or 5."""
        tilt = (count,) if components == 3 else (count, 2)
        shapes = {"state": (count, components), **dict.fromkeys(TILTS, tilt)}
        names = [item.name for item in fields(cls) if item.name not in ("beta", "tracker", *COUNTS)]
        counts: Any = {name: np.zeros(count, np.int64) for name in COUNTS}
        numbers: Any = {name: np.zeros(shapes.get(name, (count,))) for name in names}
        return cls(
            beta=np.full(count, beta),
            tracker=np.zeros(count, tracker_type(components)),
            **numbers,
            **counts,
        )

    def rows(self, sails: NDArray[np.intp]) -> "Memory":
        """Copies of some of them."""
        return Memory(**{item.name: getattr(self, item.name)[sails] for item in fields(self)})

    def put(self, sails: NDArray[np.intp], rows: "Memory") -> None:
        """Put copies back."""
        for item in fields(self):
            getattr(self, item.name)[sails] = getattr(rows, item.name)

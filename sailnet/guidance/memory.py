"""What steering remembers from one period to the next."""

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from sailnet.physics.arrays import Array


@dataclass
class Memory:
    """Of n sails, as in ``sailnet_memory`` of one that ages, in order; (n, 3) states r, u, v; arrays (n,)."""

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
    periods: NDArray[np.int64]

    @classmethod
    def started(cls, count: int, beta: float) -> "Memory":
        """Of ``count`` sails that know nothing but a beta."""
        names = [item.name for item in fields(cls) if item.name not in ("state", "beta", "periods")]
        return cls(
            state=np.zeros((count, 3)),
            beta=np.full(count, beta),
            periods=np.zeros(count, np.int64),
            **{name: np.zeros(count) for name in names},
        )

    def rows(self, sails: NDArray[np.intp]) -> "Memory":
        """Copies of some of them."""
        return Memory(**{item.name: getattr(self, item.name)[sails] for item in fields(self)})

    def put(self, sails: NDArray[np.intp], rows: "Memory") -> None:
        """Put copies back."""
        for item in fields(self):
            getattr(self, item.name)[sails] = getattr(rows, item.name)

"""Which trajectories of a data set are near-copies of each other: families, which are learnt from as a whole.

An approach begins at the arrival of a flight, varied by as little as 0.3 %; a crossing begins on a flight's
way; and flights from around the target begin in the same state for every sail, 1.7 % of beta apart. Were they
split between training and test one by one, networks would be tested on what they have all but learnt.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.dataset import ALONE
from sailnet.physics.arrays import Array

APART = 1 << 32
"""More than the flights of one sail."""


def families_of(level: int, flights: ArrayLike) -> NDArray[np.int64]:
    """(n,) families of the daughters of flights, no two sails' the same.

    Args:
        level: number of the sail; another for what belongs to none.
        flights: (n,) numbers of the flights among those of this sail; ``ALONE`` for a daughter of none.
    """
    numbers = np.asarray(flights, np.int64)
    return np.where(numbers == ALONE, ALONE, APART * level + numbers)


def rows_among(some: Array, every: Array) -> NDArray[np.intp]:
    """(n,) where each of some rows stands first among (m, k), to the last bit.

    Raises:
        KeyError: a row is not among them.
    """
    first: dict[bytes, int] = {}
    for number, row in enumerate(np.ascontiguousarray(every)):
        first.setdefault(row.tobytes(), number)
    return np.array([first[row.tobytes()] for row in np.ascontiguousarray(some)], np.intp)

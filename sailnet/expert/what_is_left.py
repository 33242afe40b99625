"""States of many that neither a search nor their neighbours have shown an extremal from: sought on their own.

A search of many runs out of directions before it comes to the slowest and rarest, a tenth of all starts to
4 AU; of those alone it finds most in seconds.
"""

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.any_dimension import solve_once
from sailnet.expert.neighbours import spread
from sailnet.expert.optima import Optima, put
from sailnet.physics.transfer import Transfer

WORTH_A_SEARCH = 12, 0.02
"""States without an extremal, and their share of all, from which on they are sought: 5 to 30 s."""

FEW = 8
"""So many are sought where all of them at once are too many: to 4 AU none was found from 50, and from 8 all,
which led to 38 others."""


def worth_a_search(optima: Optima) -> bool:
    """Whether so many of some states are left that they are sought alone."""
    least, share = WORTH_A_SEARCH
    return bool(np.count_nonzero(~optima.found) >= max(least, share * len(optima.state)))


def search_what_is_left(transfer: Transfer, optima: Optima) -> None:
    """Put in what searches find from the states that there is no extremal from, and what it shows others.

    Not their whole region is indexed: to 1.35 AU with JPL's optics that takes twenty times the memory.

    Args:
        transfer: the problem.
        optima: of states that fill a region.
    """
    for most in (len(optima.state), FEW):
        if worth_a_search(optima):
            left = np.flatnonzero(~optima.found)[:most]
            put_in(transfer, optima, left, solve_once(transfer, optima.state[left]))


def put_in(transfer: Transfer, optima: Optima, rows: NDArray[np.intp], found: Optima) -> None:
    """Put in what was found from the states of some rows, and show it to their neighbours."""
    put(optima, rows[found.found], found, found.found)
    spread(transfer, optima, rows[found.found])

"""The expert, in the plane or in space by what states it is given."""

import numpy as np
from numpy.typing import ArrayLike

from sailnet.expert import fastest, fastest_in_space
from sailnet.expert.fastest import Region
from sailnet.expert.optima import Extremal, Optima
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer


def solve(transfer: Transfer, state: ArrayLike) -> Extremal:
    """The fastest extremal from a state of 3 or 5 components: see the two functions of this name.

    Raises:
        SolveError: likewise.
    """
    if np.size(state) == 3:
        return fastest.solve(transfer, state)
    return fastest_in_space.solve(transfer, state)


def solve_states(transfer: Transfer, states: Array, region: Region | None = None) -> Optima:
    """The fastest extremals from (n, 3) or (n, 5) states: see the two functions of this name.

    Raises:
        SolveError: likewise.
    """
    if states.shape[1] == 3:
        return fastest.solve_states(transfer, states, region)
    return fastest_in_space.solve_states(transfer, states, region)


def solve_some(transfer: Transfer, states: Array) -> Optima:
    """The fastest extremals from most of some states that fill a region."""
    if states.shape[1] == 3:
        return fastest.solve_some(transfer, states)
    optima = fastest_in_space.solve_states(transfer, states, (states.min(axis=0), states.max(axis=0)))
    return optima.rows(optima.found)


def solve_once(transfer: Transfer, states: Array) -> Optima:
    """The fastest extremals that one search from some states finds."""
    if states.shape[1] == 3:
        return fastest.solve_once(transfer, states)
    return fastest_in_space.solve_states(transfer, states)

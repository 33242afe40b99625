"""Optima of the sails that flew: from one sail's optima to those of many others, by continuation.

A flight is judged by the shortest time of its very sail. To index the extremals of every single sail takes
a second or more each; an optimum of the nominal sail is followed to the sail that flew in milliseconds.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.continuation import follow
from sailnet.expert.fastest import Optima, keep_faster, no_optima, optima_of, solve_states
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer, Transfers

Extremals = tuple[Array, Array]
"""(n, 3) arrival costates and (n,) times of flight [TU], NaN where there is none."""


def own_optima(
    transfer: Transfer, states: Array, beta: Array, known: Sequence[Extremals], *, search: bool = True
) -> tuple[Optima, NDArray[np.bool_]]:
    """Minimum-time extremals of many sails, one a state.

    Continuation follows a family of extremals, and for another sail another family may be the fastest: give
    the optima and their rivals, and the faster of the two counts. Where none can be followed to the end, at
    a fold for instance, that very sail is solved anew.

    Args:
        transfer: the problem of the nominal sail.
        states: (n, 3) r [AU], u, v [AU/TU] at the start.
        beta: (n,) normalised characteristic accelerations of the sails.
        known: extremals of the nominal sail from these states, at least its optima.
        search: solve sails anew, which takes many seconds each; otherwise theirs are not found.

    Returns:
        The optima of the sails; and (n,) which of them were solved anew, or would have been.
    """
    beta = np.asarray(beta, float)
    best = no_optima(states)
    for costates, times in known:
        rows = np.flatnonzero(np.isfinite(times))

        def family(shares: Array, rows: NDArray[np.intp] = rows) -> Transfers:
            return Transfers(transfer, transfer.beta + shares * (beta[rows] - transfer.beta))

        followed = follow(family, states[rows], costates[rows], times[rows])
        ended = followed.reached == 1.0
        at = rows[ended]
        keep_faster(
            best, at, optima_of(Transfers(transfer, beta[at]), states[at], followed.shots.rows(ended))
        )
    anew = ~best.found
    for row in np.flatnonzero(anew) if search else ():
        own = replace(transfer, beta=float(beta[row]))
        keep_faster(best, np.array([row]), solve_states(own, states[[row]]))
    return best, anew

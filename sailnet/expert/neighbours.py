"""The fastest extremals from many states that lie close together: each shows its neighbours the way.

To index the extremals of every sail takes most of a minute, while an extremal from beside, or that of a
slightly weaker sail, is some Newton steps away. Which of several extremals from a state is the fastest shows
in its neighbours too: the costates say how the time of flight changes from one state to the next
(lambda = dtau/dx), so a neighbour's extremal that does not fit is another one, and may be faster here.
Where the sails differ as well, their constants are further coordinates of the states, with costates.
"""

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.optima import Optima, nothing_found, optima_of, put
from sailnet.expert.sail_costates import sail_constants, sail_costates
from sailnet.expert.shooting import shoot
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import AnyTransfer, Transfer

NEIGHBOURS = 8
"""States around one that are asked for their extremals."""

TRIES = 2
"""Of them whose extremals are tried before the state's own neighbours are known."""

ITERATIONS = 10
"""Newton steps from a neighbour's extremal; what takes more is not found from there."""

SAME = 0.7
"""Let two families take the times A and B, and A be known at state i, B at state j. By first order the mean
of both costates misses the difference of the known times by ((A_i - B_i) + (A_j - B_j)) / 2, and they differ
by (A_i - B_i) - (A_j - B_j) along the way. So the miss is less than half of that if each has the faster one,
and of second order if there is one family only. A neighbour is tried where it is more than this share."""

HOPELESS = 1.005
"""What a neighbour's costates predict to take this many times as long is not tried."""

IMPROVED = 1e-7
"""A neighbour that got faster by so much [TU] is asked again."""

ROUNDS = 40
"""At most; a family that is faster spreads by one neighbour a round."""


def solve_among(transfer: Transfer, states: Array, known: Optima) -> Optima:
    """The fastest extremals from states that are close together, from some that are known around them.

    Args:
        transfer: the problem.
        states: (n, 3) r [AU], u, v [AU/TU]; they should fill their region evenly. Or (n, 5) in space.
        known: optima from states there, of this sail or of one some per cent weaker or stronger.

    Returns:
        The optima, ``searched`` NaN: that none is faster is known from the neighbours alone. None is found
        where no neighbour's extremal leads to one.
    """
    optima = nothing_found(states)
    known = known.rows(known.found)
    if not len(known.state):
        return optima
    count = min(NEIGHBOURS, len(known.state))
    beside = _in_order(_places(transfer, known.state), _places(transfer, states), count)
    for nth in range(min(TRIES, beside.shape[1])):
        rows = np.flatnonzero(~optima.found)
        _try(transfer, optima, rows, known, beside[rows, nth])
    spread(transfer, optima)
    return optima


def next_optima(transfer: AnyTransfer, before: Optima) -> Optima:
    """Extremals from the same states by Newton's method from those of a sail a little weaker or stronger.

    Args:
        transfer: the problem, or one a row.
        before: optima of that other sail.
    """
    optima = nothing_found(before.state)
    every = np.arange(len(before.state))
    _try(transfer, optima, every, before, every)
    return optima


def spread(transfer: AnyTransfer, optima: Optima, new: NDArray[np.intp] | None = None) -> None:
    """Try neighbours' extremals where they are of another family, or there is none, until none is faster.

    What was followed from one sail to others keeps to its family and ends at folds. Of 1,000 random starts to
    2.77 AU, beta within 15 per cent or 5, 160 had ended, of which 133 are found, and 67 others are faster.

    Args:
        transfer: the problem, or one a row.
        optima: of states that are close together; what is faster is put in.
        new: rows that were put in since it was spread the last time: others need not ask each other again.
    """
    if len(optima.state) < 2:
        return
    places = _places(transfer, optima.state)
    beside = _in_order(places, places, min(NEIGHBOURS + 1, len(places)))[:, 1:]
    coordinates, costates = _coordinates(transfer, optima), _costates(transfer, optima)
    tried = np.full(beside.shape, np.inf)
    if new is not None:
        old = np.ones(len(places), bool)
        old[new] = False
        asked = old[:, None] & (old & optima.found)[beside]
        tried[asked] = optima.time_of_flight[beside[asked]]
    for _ in range(ROUNDS):
        predicted = _predicted(optima.time_of_flight, coordinates, costates, beside)
        predicted[~(optima.time_of_flight[beside] < tried - IMPROVED)] = np.inf
        best = np.argmin(predicted, axis=1)
        rows = np.flatnonzero(np.isfinite(predicted[np.arange(len(best)), best]))
        if not len(rows):
            break
        start = beside[rows, best[rows]]
        tried[rows, best[rows]] = optima.time_of_flight[start]
        faster = _try(transfer, optima, rows, optima, start)
        costates[faster] = _costates(transfer.rows(faster), optima.rows(faster))


def _places(transfer: AnyTransfer, states: Array) -> Array:
    """(n, k) states in units of the target orbit, up to a factor; and beta, by its mean, if that differs."""
    size = transfer.target_radius
    angle = [size] if states.shape[1] == 5 else []
    units = [1.0, *angle, *(states.shape[1] - 1 - len(angle)) * [size**1.5]]
    places = np.asarray(states * np.array(units))
    if isinstance(transfer, Transfer):
        return places
    return np.column_stack([places, size * transfer.beta / transfer.beta.mean()])


def _in_order(places: Array, points: Array, count: int) -> NDArray[np.intp]:
    """(n, count) rows of the places nearest to points, nearest first."""
    # It takes long to load, and who comes second to a folder is told at once.
    from scipy.spatial import cKDTree

    return np.asarray(cKDTree(places).query(points, range(1, count + 1))[1])


def _coordinates(transfer: AnyTransfer, optima: Optima) -> Array:
    """(n, k) states, and the constants of the sails if they differ."""
    if isinstance(transfer, Transfer):
        return optima.state
    return np.column_stack([optima.state, sail_constants(transfer)])


def _costates(transfer: AnyTransfer, optima: Optima) -> Array:
    """(n, k) of the coordinates."""
    if isinstance(transfer, Transfer):
        return optima.costates.copy()
    return np.column_stack([optima.costates, sail_costates(transfer, optima)])


def _predicted(tau: Array, coordinates: Array, costates: Array, beside: NDArray[np.intp]) -> Array:
    """(n, k) times of flight by the neighbours' costates; infinite for those that need not be tried."""
    own, theirs = tau[:, None], tau[beside]
    way = coordinates[:, None] - coordinates[beside]
    predicted = theirs + np.einsum("nki,nki->nk", costates[beside], way)
    here = theirs + np.einsum("ni,nki->nk", costates, way)
    same = np.abs(own - (predicted + here) / 2.0) <= SAME * np.abs(predicted - here) / 2.0
    # Comparisons are written so that a state without an extremal tries everything.
    predicted[same | (predicted > HOPELESS * own) | ~np.isfinite(predicted)] = np.inf
    return np.asarray(predicted)


def _try(
    transfer: AnyTransfer, optima: Optima, rows: NDArray[np.intp], known: Optima, start: NDArray[np.intp]
) -> NDArray[np.intp]:
    """Put into rows of the optima what Newton's method finds faster from the extremals known at ``start``.

    Returns:
        Those rows for which it did.
    """
    if not len(rows):
        return rows
    own, guesses = transfer.rows(rows), known.rows(start)
    shots = shoot(
        own,
        optima.state[rows],
        guesses.arrival_costates,
        guesses.time_of_flight,
        iterations=ITERATIONS,
    )
    found = optima_of(own, optima.state[rows], shots)
    faster = found.found & ~(found.time_of_flight >= optima.time_of_flight[rows])
    put(optima, rows[faster], found, faster)
    return rows[faster]

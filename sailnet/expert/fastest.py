"""The expert: the minimum-time extremal from any state, found by backward shooting.

Guesses come from an index of coarse extremals, refined around the states that are asked for;
Newton's method finishes them, and of the extremals that reach a state the fastest wins.
"""

import math
import sys
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.errors import SolveError
from sailnet.expert.directions import Rows
from sailnet.expert.index import INNERMOST, Guesses, Index, build_index
from sailnet.expert.optima import RESIDUAL_GOAL, Extremal, Optima, nothing_found, optima_of, put
from sailnet.expert.prisms import bins_of
from sailnet.expert.shooting import shoot
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

Region = tuple[ArrayLike, ArrayLike]
"""Lowest and highest state of a box."""

EFFORT, SHORT, TRIES = 2.0, 0.3, 16
"""How many times the budget of directions a second search may take, of the few states that need one; and one
that only has to find most, which follows so many guesses of a state: beside the target are hundreds."""

DEEPER = 0.8
"""How near to the Sun a last search follows extremals, in perihelia of the states that need it. Where these
are below ``INNERMOST``, the coarse extremals beside the way from such a state end there, if not the way."""

DEEPEST = 0.25
"""States with a perihelion below this share of the target radius fall into the Sun, and are not."""

SAME = 0.02
"""Guesses of one extremal from neighbouring prisms differ by less than this in time to go."""

SAME_TIME = 1e-6
"""Extremals from one state whose times [TU] differ by less are one."""


def solve(transfer: Transfer, state: ArrayLike) -> Extremal:
    """The minimum-time extremal from ``state`` = (r, u, v).

    Args:
        transfer: the problem.
        state: r [AU], u [AU/TU], v [AU/TU].

    Raises:
        SolveError: the state is not finite, or no extremal was found that passes through it.
    """
    target = np.asarray(state, float)
    if target.shape != (3,):
        raise SolveError(
            f"the state (r, u, v) must be three finite numbers with r > 0, not {target.tolist()}"
        )
    optima = solve_states(transfer, target[None], rivals=True)
    if not optima.found[0]:
        raise SolveError(
            f"no extremal found from r = {target[0]:g} AU, u = {target[1]:g}, v = {target[2]:g} AU/TU "
            f"to a circular orbit of {transfer.target_radius:g} AU"
        )
    return optima.extremal(0)


def solve_states(
    transfer: Transfer,
    states: ArrayLike,
    region: Region | None = None,
    rivals: bool = False,
) -> Optima:
    """The minimum-time extremals from many states.

    Args:
        transfer: the problem.
        states: (n, 3) rows r [AU], u, v [AU/TU].
        region: lowest and highest state of a box to index at once, for this and later calls. By
            default what surrounds the states is indexed, and what was not found once more alone.
            Where a faster one than found may have been missed, the search goes on until none is left, with
            ``EFFORT`` times its budget.
        rivals: also look for the second fastest extremal, however slow.

    Raises:
        SolveError: a state is not finite, has r <= 0, lies outside the region or on the target orbit.
    """
    return solve_families(transfer, states, region, math.inf if rivals else 1.0)[0]


def solve_families(
    transfer: Transfer, states: ArrayLike, region: Region | None, slower: float
) -> tuple[Optima, Optima]:
    """The fastest extremals from many states, and the second fastest of those looked at.

    Args:
        transfer, states, region: as for :func:`solve_states`.
        slower: how many times the fastest's time a second fastest may take for it to be looked for.

    Raises:
        SolveError: likewise.
    """
    given = np.asarray(states, float).reshape(-1, 3)
    bad = ~np.isfinite(given).all(axis=1) | ~(given[:, 0] > 0.0)
    if bad.any():
        worst = given[np.argmax(bad)].tolist()
        raise SolveError(f"the state (r, u, v) must be three finite numbers with r > 0, not {worst}")
    if (np.abs(given - transfer.target_state).max(axis=1) < RESIDUAL_GOAL).any():
        raise SolveError("the state is on the target orbit already: there is nothing to solve")
    best, second = nothing_found(given), nothing_found(given)
    _search(transfer, best, second, np.arange(len(given)), region, slower)
    if region is None:
        _search(transfer, best, second, np.flatnonzero(~best.found), None, slower)
    lost = np.flatnonzero(~best.found)
    perihelia = _perihelia(_scaled(transfer, given[lost]))
    ends = INNERMOST * np.fmin(1.0, given[lost, 0] / transfer.target_radius)
    falling = (perihelia > DEEPEST) & (perihelia < ends)
    innermost = DEEPER * perihelia[falling].min(initial=math.inf)
    _search(transfer, best, second, lost[falling], None, slower, innermost=innermost)
    missed = np.flatnonzero(best.found & ~best.complete)
    _search(transfer, best, second, missed, None, slower, EFFORT, longer=True)
    best.rival_time[:] = second.time_of_flight
    return best, second


def solve_some(transfer: Transfer, states: Array) -> Optima:
    """The fastest extremals from most of (n, 3) states, by a short search; from the others none.

    Most of a search goes into the slow and the rare. What it leaves out has neighbours that it does not.
    """
    best = solve_once(transfer, states, SHORT, TRIES)
    return best.rows(best.complete)


def solve_once(transfer: Transfer, states: Array, effort: float = 1.0, tries: int = sys.maxsize) -> Optima:
    """The fastest extremals that one search from (n, 3) states finds; what it misses is not sought again.

    A second search, of the few that are left, takes as long as the first.

    Args:
        transfer: the problem.
        states: (n, 3) r [AU], u, v [AU/TU].
        effort: how many times its usual budget of directions the search may take.
        tries: guesses of a state that are followed at most.
    """
    best = nothing_found(states)
    _search(transfer, best, nothing_found(states), np.arange(len(states)), None, 1.0, effort, tries=tries)
    return best


def _scaled(transfer: Transfer, states: ArrayLike) -> Array:
    """States in units of the target orbit."""
    size = transfer.target_radius
    return np.asarray(np.asarray(states, float) * [1.0 / size, np.sqrt(size), np.sqrt(size)])


def _perihelia(scaled: Array) -> Array:
    """(n,) of the orbits that (n, 3) states are on, in the same units."""
    r, u, v = scaled.T
    parameter = (r * v) ** 2
    eccentricity = np.sqrt(np.fmax(0.0, 1.0 + (u**2 + v**2 - 2.0 / r) * parameter))
    return np.asarray(parameter / (1.0 + eccentricity))


def _search(
    transfer: Transfer,
    best: Optima,
    second: Optima,
    rows: Rows,
    region: Region | None,
    slower: float,
    effort: float = 1.0,
    longer: bool = False,
    innermost: float = math.inf,
    tries: int = sys.maxsize,
) -> None:
    """Put what is found faster into some rows of both, and how far it was looked for."""
    if not len(rows):
        return
    states = best.state[rows]
    scaled, size = _scaled(transfer, states), transfer.target_radius
    until = best.time_of_flight[rows] / size**1.5 if longer else None
    index = _index(transfer, scaled, region, effort, until, innermost)
    for found in _fastest(transfer, states, _distinct(index.look_up(scaled)), slower, tries):
        keep_faster(best, second, rows, found)
    best.searched[rows] = np.fmax(best.searched[rows], index.searched(scaled) * size**1.5)


def _index(
    transfer: Transfer,
    scaled: Array,
    region: Region | None,
    effort: float,
    until: Array | None,
    innermost: float = math.inf,
) -> Index:
    """The index of the states' bins, or of a region; searched until all that is faster is known, if asked."""
    bins = bins_of(scaled)
    if region is not None:
        low, high = bins_of(_scaled(transfer, np.array(region, float)))
        if (bins < low).any() or (bins > high).any():
            raise SolveError("a state lies outside the region that was to be indexed")
        bins = np.stack(np.meshgrid(*map(np.arange, low, high + 1), indexing="ij"), axis=-1).reshape(-1, 3)
    wanted, which = np.unique(bins, axis=0, return_inverse=True)
    unit = replace(transfer, target_radius=1.0)
    named = tuple(map(tuple, wanted.tolist()))
    if until is None:
        return build_index(unit, named, effort, innermost=innermost)
    np.maximum.at(last := np.zeros(len(wanted)), which.ravel(), until)
    return build_index(unit, named, effort, tuple(last.tolist()), innermost)


def _distinct(guesses: Guesses) -> Guesses:
    """One guess an extremal: neighbouring prisms that nearly hold a state all point to it."""
    order = np.lexsort((guesses.outside, guesses.state))
    kept = [order[:0]]
    while len(order):
        begins = np.flatnonzero(np.diff(guesses.state[order], prepend=-1))
        best = order[begins]
        kept.append(best)
        beside = np.repeat(best, np.diff(begins, append=len(order)))
        turned = np.linalg.norm(guesses.directions[order] - guesses.directions[beside], axis=1)
        # The farther a state lies from a prism, the less its guess says.
        width = guesses.width[order] + guesses.width[beside]
        apart = turned > (1.0 + 10.0 * guesses.outside[order]) * width
        later = np.abs(guesses.tau[order] - guesses.tau[beside]) > SAME + guesses.outside[order]
        order = order[apart | later]
    rows = np.concatenate(kept)
    return Guesses(*(column[rows] for column in vars(guesses).values()))


def _fastest(
    transfer: Transfer, states: Array, guesses: Guesses, slower: float, tries: int
) -> tuple[Optima, Optima]:
    """Refine guesses, so many of a state, fastest first, until no other could be one of the two asked for."""
    size = transfer.target_radius
    directions = guesses.directions * [np.sqrt(size), size**2, size**2]
    tau, margin = guesses.tau * size**1.5, SAME * size**1.5
    best, second = nothing_found(states), nothing_found(states)
    waiting = np.lexsort((tau, guesses.state))
    for _ in range(tries):
        # Without a fastest there is no second; without a second, what is slow enough may still be one.
        limit = np.fmin(slower * best.time_of_flight, second.time_of_flight)[guesses.state[waiting]]
        waiting = waiting[~(tau[waiting] > limit + margin)]
        if not len(waiting):
            break
        first = np.diff(guesses.state[waiting], prepend=-1) != 0
        rows, waiting = waiting[first], waiting[~first]
        at = guesses.state[rows]
        shots = shoot(transfer, states[at], directions[rows], tau[rows])
        keep_faster(best, second, at, optima_of(transfer, states[at], shots))
    return best, second


def keep_faster(best: Optima, second: Optima, at: NDArray[np.intp], found: Optima) -> None:
    """Replace rows ``at`` of ``best`` by what is faster; the slower of two may be the second fastest."""
    old, new = best.time_of_flight[at], found.time_of_flight
    faster = found.found & ~(new >= old)
    slower = found.rows(np.arange(len(at)))
    put(slower, faster, best.rows(at), faster)
    put(best, at[faster], found, faster)
    next_fastest = slower.found & ~(np.abs(new - old) < SAME_TIME)
    next_fastest &= ~(slower.time_of_flight >= second.time_of_flight[at])
    put(second, at[next_fastest], slower, next_fastest)

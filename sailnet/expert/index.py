"""Which extremals pass near a state: coarse extremals in every direction, refined where one looks.

The motion is the same for every target radius once lengths, times and speeds are measured by the
target orbit, so everything here is in those units: r / r_f, time / r_f^1.5, speed * sqrt(r_f). An
extremal is then a point on the sphere of arrival directions. A triangle of directions sweeps a
*prism* of states in a short time, and a state lies on one extremal for every prism that holds it.

Extremals part by a factor of many thousand after a pinch or a close passage of the Sun, so no even
mesh will do: triangles are halved until their prisms are small, but only where a prism meets one
of the bins of states asked for. Most of what could be refined is slower than what has been found:
time to go advances in windows, and a bin whose states are all held by a prism is done with soon after.
"""

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.directions import Rows, halve, icosphere
from sailnet.expert.prisms import BIN, SLACK, Grid, Prisms, enumerate_rows, meets, sums_of
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.transfer import Transfer

SPACING = 0.05
"""Time between samples of a coarse extremal."""

TOLERANCE = 1e-7
"""Local error of these, which only have to point: at 1e-12 they cost half as much again."""

WINDOW = 20
"""Samples by which the time to go advances. A bin is searched for one window after it was filled."""

HORIZONS = (7.0, 14.0, 28.0, 56.0)
"""Times to go up to which extremals are followed, one after the other as long as bins are open."""

HALVINGS = 40
"""Of a triangle of directions at most, in one window."""

PRISM = 0.1
"""Longest edge of a prism that is not halved."""

MOST = 60_000
"""Directions at which the search ends, unless asked for more effort: what is left to find is a needle in a
haystack. How far the search came is known for every bin (:meth:`Index.searched`)."""

BULGE = 0.3
"""How far beyond its corners a prism may reach, in units of its largest extent."""

RIM = 0.02
"""Triangles of directions on the rim of what is possible are halved down to this angle [rad]."""

HOLD = 0.1
"""How far outside a prism a test point may lie for its bin to count as filled."""

TOGETHER = 4096
"""Prisms whose bins are listed together: of real sails near the target half a million meet some hundred
bins each, and all of that at once was 13 GB."""

STATES, LOOKED_AT = 200, 4_000_000
"""States that are looked up together, as many as stay in the processor's cache; and prisms of their bins."""

INNERMOST, OUTERMOST = 0.6, 4.5
"""Extremals are followed as long as they are bound and their radius stays above this share of the
smallest radius among states and target, and below this or 1.5 times the largest."""


@dataclass(frozen=True)
class Guesses:
    """Extremals that pass near states, one row each.

    Attributes:
        state: (n,) row of the state.
        directions: (n, 3) arrival directions (unit vectors), in the units of this module.
        tau: (n,) time to go.
        outside: (n,) how far outside its prism the state lies, 0 inside.
        width: (n,) how far apart the prism's directions are.
    """

    state: Rows
    directions: Array
    tau: Array
    outside: Array
    width: Array


class Index:
    """Prisms listed by the bins they meet. Made by :func:`build_index`."""

    def __init__(self, grid: Grid, directions: Array, prisms: list[Prisms], searched: Array) -> None:
        columns = zip(*(vars(part).values() for part in prisms), strict=True)
        self._prisms = Prisms(*(np.concatenate(column) for column in columns))
        self._grid, self._directions, self._searched = grid, directions, searched
        count = np.zeros(len(grid), int)
        for _, _, bins in _listing(grid, self._prisms):
            count += np.bincount(bins, minlength=len(grid))
        self._first = np.append(0, np.cumsum(count))
        self._listed = np.empty(self._first[-1], np.int32)
        filled = self._first[:-1].copy()
        for start, prism, bins in _listing(grid, self._prisms):
            order = np.argsort(bins, kind="stable")
            count = np.bincount(bins, minlength=len(grid))
            among = enumerate_rows(count)[1]
            self._listed[filled[bins[order]] + among] = start + prism[order]
            filled += count

    def __len__(self) -> int:
        return len(self._prisms.column)

    def searched(self, states: Array) -> Array:
        """(n,) time to go up to which all that passes through the bins of (n, 3) states was refined."""
        return np.asarray(self._searched[self._grid.numbers(states)])

    def look_up(self, states: Array) -> Guesses:
        """Everything that passes through or near (n, 3) states in the bins asked for."""
        bins = self._grid.numbers(states)
        prisms = np.cumsum(self._first[bins + 1] - self._first[bins])
        begins = np.diff(np.arange(len(states)) // STATES) + np.diff(prisms // LOOKED_AT)
        starts = [0, *(np.flatnonzero(begins) + 1), len(states)]
        parts = []
        for start, stop in itertools.pairwise(starts):
            part = self._look_up(states[start:stop], bins[start:stop])
            parts.append(replace(part, state=part.state + start))
        return Guesses(*(np.concatenate(c) for c in zip(*(vars(p).values() for p in parts), strict=True)))

    def _look_up(self, states: Array, bins: Rows) -> Guesses:
        row, number = enumerate_rows(self._first[bins + 1] - self._first[bins])
        prism = self._listed[self._first[bins][row] + number]
        # Comparisons first: most prisms that meet a bin do not come near the state.
        at = states[row]
        close = np.ones(len(row), bool)
        for axis in range(3):
            close &= self._prisms.lowest[prism, axis] <= at[:, axis]
            close &= self._prisms.highest[prism, axis] >= at[:, axis]
        row, prism = row[close], prism[close]
        weights, outside = self._prisms.weigh(prism, states[row])
        near = outside <= SLACK
        row, prism, weights = row[near], prism[near], weights[near]
        corners = self._directions[self._prisms.corners[prism]]
        edges = corners[:, 1:] - corners[:, :1]
        directions = corners[:, 0] + np.einsum("nc,nci->ni", weights[:, :2], edges)
        directions /= np.linalg.norm(directions, axis=1, keepdims=True)
        tau = SPACING * (self._prisms.column[prism] + weights[:, 2])
        width = np.linalg.norm(edges, axis=2).max(axis=1)
        return Guesses(row, directions, tau, outside[near], width)


@lru_cache(maxsize=32)
def build_index(
    transfer: Transfer,
    wanted: tuple[tuple[int, int, int], ...],
    effort: float = 1.0,
    until: tuple[float, ...] = (),
    innermost: float = math.inf,
) -> Index:
    """Refine whatever passes through the bins that are wanted.

    Args:
        transfer: the problem with target radius 1.
        wanted: bins of states, see :func:`sailnet.expert.prisms.bins_of`.
        effort: how many times ``MOST`` directions the search may take.
        until: time to go up to which each of the bins is searched, filled or not. By default a bin is done
            with soon after prisms hold its corners and its centre.
        innermost: extremals are followed down to this radius at least, where ``INNERMOST`` ends before.
    """
    most = round(effort * MOST)
    grid = Grid(np.array(wanted))
    points = _test_points(grid)
    radii = (
        min(innermost, INNERMOST * min(1.0, BIN * grid.low[0])),
        max(OUTERMOST, 1.5 * points[:, :, 0].max()),
    )
    directions, leaves = icosphere()
    paths = np.empty((0, 1, 3), np.float32)
    held = np.zeros(points.shape[:2], bool)
    active = grid.wanted.copy()
    searched = np.zeros(len(grid))
    found: list[Prisms] = []
    horizons = iter(HORIZONS)
    for start in range(0, round(HORIZONS[-1] / SPACING), WINDOW):
        if not active.any() or len(directions) > most:
            break
        paths = paths[:, WINDOW:]
        if paths.shape[1] <= WINDOW:
            horizon = next(horizons)
            paths = _paths(transfer, directions, horizon, start, radii)
        done = np.array(until) <= SPACING * (start + WINDOW) if until else held.all(axis=1)
        sums, kept = sums_of(active), []
        for halving in range(HALVINGS + 1):
            near, edges = _near(grid, sums, paths[:, : WINDOW + 1], directions, leaves)
            fine = (edges.max(axis=1) <= PRISM) | (halving == HALVINGS) | (len(directions) > most)
            kept.append(leaves[fine])
            which, column = np.nonzero(near & fine[:, None])
            found.append(Prisms.of(paths, leaves[which], start, column))
            _hold(grid, points, held, found[-1])
            if fine.all():
                break
            born = len(directions)
            directions, leaves = halve(directions, leaves[~fine], np.argmax(edges[~fine], axis=1))
            paths = np.concatenate([paths, _paths(transfer, directions[born:], horizon, start, radii)])
        leaves = np.concatenate(kept)
        if len(directions) <= most:
            searched[active[grid.wanted]] = SPACING * (start + WINDOW)
        active[tuple(grid.places[done].T)] = False
    return Index(grid, directions, found, searched)


def _test_points(grid: Grid) -> Array:
    """(bins, 9, 3) corners and centre of every wanted bin."""
    offsets = np.array([*itertools.product((0.0, 1.0), repeat=3), (0.5, 0.5, 0.5)])
    return np.asarray(((grid.places + grid.low)[:, None] + offsets) * BIN)


def _hold(grid: Grid, points: Array, held: NDArray[np.bool_], prisms: Prisms) -> None:
    """Mark the test points that lie in one of the prisms."""
    for start, prism, bins in _listing(grid, prisms):
        for point in range(points.shape[1]):
            missing = ~held[bins, point]
            inside = prisms.weigh(start + prism[missing], points[bins[missing], point])[1] <= HOLD
            held[bins[missing][inside], point] = True


def _listing(grid: Grid, prisms: Prisms) -> Iterator[tuple[int, Rows, Rows]]:
    """All pairs of a prism and a bin that meet, some prisms after the others, and the row of their first."""
    for start in range(0, len(prisms.column), TOGETHER):
        part = slice(start, start + TOGETHER)
        yield start, *grid.listing(prisms.lowest[part], prisms.highest[part])


def _near(
    grid: Grid, sums: Rows, paths: NDArray[np.float32], directions: Array, triangles: Rows
) -> tuple[NDArray[np.bool_], Array]:
    """Which prisms may meet one of the bins with these sums, and how long their edges get there.

    Returns:
        (triangles, columns) whether all three extremals exist and a bin may be met; and
        (triangles, 3) the edges opposite the corners where one is met, 0 for what needs no halving.
    """
    near = np.zeros((len(triangles), paths.shape[1] - 1), bool)
    longest = np.zeros((len(triangles), 3))
    for start in range(0, len(triangles), 4000):
        part = slice(start, start + 4000)
        corners = paths[triangles[part]]
        lowest, highest = np.fmin.reduce(corners, axis=1), np.fmax.reduce(corners, axis=1)
        lowest, highest = np.fmin(lowest[:, :-1], lowest[:, 1:]), np.fmax(highest[:, :-1], highest[:, 1:])
        margin = BULGE * np.max(highest - lowest, axis=2, keepdims=True)
        met = meets(sums, *grid.span(lowest - margin, highest + margin))
        exists = np.isfinite(corners.sum(axis=(1, 3)))
        whole = exists[:, :-1] & exists[:, 1:]
        near[part] = met & whole
        edges = np.linalg.norm(corners[:, [2, 0, 1]] - corners[:, [1, 2, 0]], axis=3)[:, :, :-1]
        edges[~np.broadcast_to(near[part][:, None], edges.shape)] = 0.0
        longest[part] = edges.max(axis=2)
        # Where an extremal is missing, at the rim of what is possible, the angle decides.
        turned = directions[triangles[part]]
        angles = np.linalg.norm(turned[:, [2, 0, 1]] - turned[:, [1, 2, 0]], axis=2)
        angles[(angles < RIM) | ~(met & ~whole).any(axis=1)[:, None]] = 0.0
        longest[part] = np.maximum(longest[part], angles / RIM * PRISM)
    return near, longest


def _paths(
    transfer: Transfer, directions: Array, horizon: float, start: int, radii: tuple[float, float]
) -> NDArray[np.float32]:
    """(n, columns, 3) states along the extremals from sample ``start`` on; NaN once out of bounds."""
    grid = SPACING * np.arange(round(horizon / SPACING) + 1)
    paths = np.full((len(directions), len(grid) - start, 3), np.nan, np.float32)
    allowed = np.flatnonzero(arrival_gain(transfer, directions) < 0.0)
    for rows in np.array_split(allowed, 1 + len(allowed) // 256):
        states = propagate_extremals(transfer, directions[rows], grid, TOLERANCE).states[:, :, :3]
        r, u, v = np.moveaxis(states, 2, 0)
        with np.errstate(invalid="ignore", divide="ignore"):
            bound = (r > radii[0]) & (r < radii[1]) & (v > 0.0) & ((u**2 + v**2) / 2.0 < 1.0 / r)
        states[~np.logical_and.accumulate(bound, axis=1)] = np.nan
        paths[rows] = states[:, start:]
    return paths

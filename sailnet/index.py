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
from dataclasses import dataclass, replace
from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from sailnet.dynamics import Array
from sailnet.extremals import arrival_gain, propagate_extremals
from sailnet.mission import Transfer

BIN = 1.0 / 64.0
"""Edge of a bin of states."""

SPACING = 0.05
"""Time between samples of a coarse extremal."""

WINDOW = 20
"""Samples by which the time to go advances. A bin is searched for one window after it was filled."""

HORIZONS = (7.0, 14.0, 28.0, 56.0)
"""Times to go up to which extremals are followed, one after the other as long as bins are open."""

PRISM = 0.1
"""Longest edge of a prism that is not halved."""

QUARTERINGS, HALVINGS = 4, 40
"""Of the icosahedron everywhere, and of its triangles at most in one window."""

MOST = 60_000
"""Directions at which the search ends: what is left to find is a needle in a haystack."""

BULGE = 0.3
"""How far beyond its corners a prism may reach, in units of its largest extent."""

RIM = 0.02
"""Triangles of directions on the rim of what is possible are halved down to this angle [rad]."""

SLACK = 0.3
"""How far outside a prism, in units of its edges, a state may lie: prisms are not quite straight."""

DEVIATION, THINNEST = 0.002, 0.001
"""How far a prism may be bent, and its smallest thickness that is made use of."""

HOLD = 0.1
"""How far outside a prism a test point may lie for its bin to count as filled."""

INNERMOST, OUTERMOST = 0.6, 4.5
"""Extremals are followed as long as they are bound and their radius stays above this share of the
smallest radius among states and target, and below this or 1.5 times the largest."""

Rows = NDArray[np.intp]


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


class _Grid:
    """The bins asked for, in the smallest box that holds them; (n, 3) are their integer coordinates."""

    def __init__(self, bins: NDArray[np.int64]) -> None:
        self.low = bins.min(axis=0)
        self.shape = tuple((bins.max(axis=0) - self.low + 1).tolist())
        self.wanted = np.zeros(self.shape, bool)
        self.wanted[tuple((bins - self.low).T)] = True
        self.places = np.argwhere(self.wanted)
        # How many bins are wanted before each one of the box: what is wanted may be a tiny part of it.
        self._before = np.append(0, self.wanted.ravel().cumsum())

    def __len__(self) -> int:
        return len(self.places)

    def numbers(self, states: Array) -> Rows:
        """The number of each state's bin among those wanted; it must be one of them."""
        at = np.floor(states / BIN).astype(int) - self.low
        return np.asarray(self._before[np.ravel_multi_index(tuple(at.T), self.shape)])

    def span(self, lowest: Array, highest: Array) -> tuple[Rows, Rows]:
        """First bin and last bin + 1 along each axis that boxes (..., 3) meet; empty for NaN."""
        start = np.floor(np.nan_to_num(lowest, nan=1e9) / BIN) - self.low
        stop = np.floor(np.nan_to_num(highest, nan=-1e9) / BIN) + 1 - self.low
        return np.clip(start, 0, self.shape).astype(int), np.clip(stop, 0, self.shape).astype(int)

    def listing(self, lowest: Array, highest: Array) -> tuple[Rows, Rows]:
        """All pairs (box, number of a wanted bin) that meet."""
        start, stop = self.span(lowest, highest)
        extent = np.maximum(stop - start, 0)
        box, number = _enumerate(extent.prod(axis=1) // np.maximum(extent[:, 2], 1))
        # Along the last axis what is wanted has consecutive numbers.
        along = np.column_stack([number // extent[box, 1], number % extent[box, 1], 0 * number])
        first = np.ravel_multi_index(tuple((start[box] + along).T), self.shape)
        before = self._before[first]
        row, number = _enumerate(self._before[first + extent[box, 2]] - before)
        return box[row], before[row] + number


def _meets(mask: NDArray[np.bool_], start: Rows, stop: Rows) -> NDArray[np.bool_]:
    """Whether boxes of bins hold any bin of the mask, by its sums over all boxes from the origin."""
    sums = np.zeros([n + 1 for n in mask.shape], int)
    sums[1:, 1:, 1:] = mask.cumsum(0).cumsum(1).cumsum(2)
    total = 0
    for corner in itertools.product((False, True), repeat=3):
        at = np.where(corner, stop, start)
        total = total + (-1) ** (3 - sum(corner)) * sums[at[..., 0], at[..., 1], at[..., 2]]
    return np.asarray((stop > start).all(axis=-1) & (total > 0))


def _enumerate(counts: Rows) -> tuple[Rows, Rows]:
    """Rows 0, 0, ..., 1, 1, ... as often as they count, and a number from 0 within each."""
    rows = np.repeat(np.arange(len(counts)), counts)
    return rows, np.arange(len(rows)) - np.repeat(np.cumsum(counts) - counts, counts)


@dataclass(frozen=True)
class _Prisms:
    """A state is origin + edges @ (weight of 2nd corner, of 3rd, of the later sample)."""

    corners: Rows
    column: Rows
    origin: Array
    edges: Array
    inverse: Array
    lowest: Array
    highest: Array

    @classmethod
    def of(cls, paths: NDArray[np.float32], corners: Rows, start: int, column: Rows) -> "_Prisms":
        now = paths[corners, column[:, None]].astype(float)
        later = paths[corners, column[:, None] + 1].astype(float)
        edges = np.stack([now[:, 1] - now[:, 0], now[:, 2] - now[:, 0], (later - now).mean(axis=1)], axis=2)
        both = np.concatenate([now, later], axis=1)
        lowest, highest = both.min(axis=1), both.max(axis=1)
        slack = np.maximum(SLACK * (highest - lowest), DEVIATION)
        # Not the inverse: near a fold, where neighbouring extremals meet, prisms are thinner than bent.
        transposed = edges.transpose(0, 2, 1)
        inverse = np.linalg.solve(transposed @ edges + THINNEST**2 * np.eye(3), transposed)
        return cls(corners, start + column, now[:, 0], edges, inverse, lowest - slack, highest + slack)

    def weigh(self, rows: Rows, states: Array) -> tuple[Array, Array]:
        """(n, 3) weights of states in prisms, and how far outside they lie."""
        offset = states - self.origin[rows]
        weights = np.einsum("nij,nj->ni", self.inverse[rows], offset)
        second, third, time = weights.T
        over = np.maximum(
            np.maximum(second + third, time) - 1.0, -np.minimum(np.minimum(second, third), time)
        )
        x, y, z = np.abs(np.einsum("nij,nj->ni", self.edges[rows], weights) - offset).T
        deviation = np.maximum(np.maximum(x, y), z)
        return weights, np.maximum(0.0, np.maximum(over, SLACK / DEVIATION * deviation))


class Index:
    """Prisms listed by the bins they meet. Made by :func:`build_index`."""

    def __init__(self, grid: _Grid, directions: Array, prisms: list[_Prisms]) -> None:
        columns = zip(*(vars(part).values() for part in prisms), strict=True)
        self._prisms = _Prisms(*(np.concatenate(column) for column in columns))
        self._grid, self._directions = grid, directions
        prism, bins = grid.listing(self._prisms.lowest, self._prisms.highest)
        self._listed = prism[np.argsort(bins, kind="stable")]
        self._first = np.append(0, np.cumsum(np.bincount(bins, minlength=len(grid))))

    def __len__(self) -> int:
        return len(self._prisms.column)

    def look_up(self, states: Array) -> Guesses:
        """Everything that passes through or near (n, 3) states in the bins asked for."""
        parts = []
        for start in range(0, len(states), 200):  # as much as stays in the processor's cache
            part = self._look_up(states[start : start + 200])
            parts.append(replace(part, state=part.state + start))
        return Guesses(*(np.concatenate(c) for c in zip(*(vars(p).values() for p in parts), strict=True)))

    def _look_up(self, states: Array) -> Guesses:
        bins = self._grid.numbers(states)
        row, number = _enumerate(self._first[bins + 1] - self._first[bins])
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
def build_index(transfer: Transfer, wanted: tuple[tuple[int, int, int], ...]) -> Index:
    """Refine whatever passes through the bins that are wanted.

    Args:
        transfer: the problem with target radius 1.
        wanted: bins of states, see :func:`bins_of`.
    """
    grid = _Grid(np.array(wanted))
    points = _test_points(grid)
    radii = (INNERMOST * min(1.0, BIN * grid.low[0]), max(OUTERMOST, 1.5 * points[:, :, 0].max()))
    directions, leaves = _base()
    paths = np.empty((0, 1, 3), np.float32)
    held = np.zeros(points.shape[:2], bool)
    active = grid.wanted.copy()
    found: list[_Prisms] = []
    horizons = iter(HORIZONS)
    for start in range(0, round(HORIZONS[-1] / SPACING), WINDOW):
        if not active.any() or len(directions) > MOST:
            break
        paths = paths[:, WINDOW:]
        if paths.shape[1] <= WINDOW:
            horizon = next(horizons)
            paths = _paths(transfer, directions, horizon, start, radii)
        filled = grid.places[held.all(axis=1)]
        kept = []
        for halving in range(HALVINGS + 1):
            near, edges = _near(grid, active, paths[:, : WINDOW + 1], directions, leaves)
            fine = (edges.max(axis=1) <= PRISM) | (halving == HALVINGS) | (len(directions) > MOST)
            kept.append(leaves[fine])
            which, column = np.nonzero(near & fine[:, None])
            found.append(_Prisms.of(paths, leaves[which], start, column))
            _hold(grid, points, held, found[-1])
            if fine.all():
                break
            born = len(directions)
            directions, leaves = _halve(directions, leaves[~fine], np.argmax(edges[~fine], axis=1))
            paths = np.concatenate([paths, _paths(transfer, directions[born:], horizon, start, radii)])
        leaves = np.concatenate(kept)
        active[tuple(filled.T)] = False
    return Index(grid, directions, found)


def _test_points(grid: _Grid) -> Array:
    """(bins, 9, 3) corners and centre of every wanted bin."""
    offsets = np.array([*itertools.product((0.0, 1.0), repeat=3), (0.5, 0.5, 0.5)])
    return np.asarray(((grid.places + grid.low)[:, None] + offsets) * BIN)


def _hold(grid: _Grid, points: Array, held: NDArray[np.bool_], prisms: _Prisms) -> None:
    """Mark the test points that lie in one of the prisms."""
    prism, bins = grid.listing(prisms.lowest, prisms.highest)
    for point in range(points.shape[1]):
        missing = ~held[bins, point]
        inside = prisms.weigh(prism[missing], points[bins[missing], point])[1] <= HOLD
        held[bins[missing][inside], point] = True


def _near(
    grid: _Grid, active: NDArray[np.bool_], paths: NDArray[np.float32], directions: Array, triangles: Rows
) -> tuple[NDArray[np.bool_], Array]:
    """Which prisms may meet an active bin, and how long their edges get there.

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
        met = _meets(active, *grid.span(lowest - margin, highest + margin))
        exists: NDArray[np.bool_] = np.asarray(np.isfinite(corners).all(axis=(1, 3)))
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


def _halve(directions: Array, triangles: Rows, opposite: Rows) -> tuple[Array, Rows]:
    """Halve each triangle across the edge opposite to a corner; returns all directions and the halves."""
    corner, a, b = np.take_along_axis(triangles, (opposite[:, None] + np.arange(3)) % 3, axis=1).T
    edges, inverse = np.unique(np.sort(np.column_stack([a, b]), axis=1), axis=0, return_inverse=True)
    middle = directions[edges[:, 0]] + directions[edges[:, 1]]
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    m = len(directions) + inverse.ravel()
    halves = np.concatenate([np.column_stack([corner, a, m]), np.column_stack([corner, m, b])])
    return np.concatenate([directions, middle]), halves


def _paths(
    transfer: Transfer, directions: Array, horizon: float, start: int, radii: tuple[float, float]
) -> NDArray[np.float32]:
    """(n, columns, 3) states along the extremals from sample ``start`` on; NaN once out of bounds."""
    grid = SPACING * np.arange(round(horizon / SPACING) + 1)
    paths = np.full((len(directions), len(grid) - start, 3), np.nan, np.float32)
    allowed = np.flatnonzero(arrival_gain(transfer, directions) < 0.0)
    for rows in np.array_split(allowed, 1 + len(allowed) // 256):
        states = propagate_extremals(transfer, directions[rows], grid).states[:, :, :3]
        r, u, v = np.moveaxis(states, 2, 0)
        with np.errstate(invalid="ignore", divide="ignore"):
            bound = (r > radii[0]) & (r < radii[1]) & (v > 0.0) & ((u**2 + v**2) / 2.0 < 1.0 / r)
        states[~np.logical_and.accumulate(bound, axis=1)] = np.nan
        paths[rows] = states[:, start:]
    return paths


@cache
def _base() -> tuple[Array, Rows]:
    """Directions and triangles of the icosahedron, subdivided evenly."""
    golden = (1.0 + np.sqrt(5.0)) / 2.0
    corners = np.array([(0.0, s, t * golden) for s in (-1, 1) for t in (-1, 1)])
    directions = np.concatenate([np.roll(corners, k, axis=1) for k in range(3)])
    touch = np.isclose(np.linalg.norm(directions[:, None] - directions, axis=2), 2.0)
    sets = itertools.combinations(range(12), 3)
    triangles = np.array([(a, b, c) for a, b, c in sets if touch[a, b] and touch[b, c] and touch[a, c]])
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    for _ in range(QUARTERINGS):
        directions, triangles = _quarter(directions, triangles)
    return directions, triangles


def _quarter(directions: Array, triangles: Rows) -> tuple[Array, Rows]:
    """Four triangles for each; returns all directions and the new triangles."""
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, inverse = np.unique(edges, axis=0, return_inverse=True)
    middle = directions[edges[:, 0]] + directions[edges[:, 1]]
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    ab, bc, ca = (len(directions) + inverse.reshape(-1, 3)).T
    a, b, c = triangles.T
    parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    quarters = np.concatenate([np.column_stack(part) for part in parts])
    return np.concatenate([directions, middle]), quarters


def bins_of(states: Array) -> NDArray[np.int64]:
    """(n, 3) bin of each of (n, 3) states."""
    return np.floor(np.asarray(states) / BIN).astype(int)

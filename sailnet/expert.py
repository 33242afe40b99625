"""The expert: the minimum-time extremal from any state, found by backward shooting.

Guesses come from an index of coarse extremals that covers every arrival direction; Newton's method
finishes them, and among the extremals that reach the state the one with the smallest time wins.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from sailnet.dynamics import Array
from sailnet.errors import SolveError
from sailnet.extremals import arrival_gain, propagate_extremals
from sailnet.mission import Transfer
from sailnet.pontryagin import guidance_law
from sailnet.shooting import Shots, shoot

RESIDUAL_GOAL = 1e-9
"""An extremal counts as found when it passes this close to the state (any component)."""

DIRECTIONS = 12_000
LONGEST = 25.0
SPACING = 0.1
RADII = (0.2, 4.5)
"""The index: arrival directions, time to go [TU] and its sampling, radii [AU] it is kept in."""

ZOOMS, ZOOM_FACTOR, PATCH = 4, 0.5, 400
"""Refinements of the index around the nearest samples, their shrinkage, and directions in each."""


@dataclass(frozen=True)
class Extremal:
    """A minimum-time extremal from a state to the target orbit.

    Attributes:
        state: (3,) r [AU], u, v [AU/TU] at the start.
        time_of_flight: time to the target orbit [TU].
        costates: (3,) lambda_r, lambda_u, lambda_v at the start, scaled to H = 0.
        arrival_costates: (3,) the same at the target.
        cone_angle: optimal cone angle at the start [rad].
        jumps: jumps of the cone angle on the way.
        jump_time: time to go at the jump [TU], NaN without one.
        residual: largest component of the error in the state.
    """

    state: Array
    time_of_flight: float
    costates: Array
    arrival_costates: Array
    cone_angle: float
    jumps: int
    jump_time: float
    residual: float


@dataclass(frozen=True)
class Index:
    """Samples of coarse extremals: where they are, and which arrival direction leads there."""

    tree: cKDTree
    directions: Array
    tau: Array


@lru_cache(maxsize=8)
def build_index(transfer: Transfer) -> Index:
    """Coarse extremals in every arrival direction; kept for the life of the process."""
    return _propagate_index(transfer, _fibonacci_sphere(DIRECTIONS))


def _propagate_index(transfer: Transfer, directions: Array) -> Index:
    directions = directions[arrival_gain(transfer, directions) < 0.0]
    grid = np.arange(0.0, LONGEST + SPACING / 2, SPACING)
    extremals = propagate_extremals(transfer, directions, grid)
    radius = extremals.states[:, :, 0]
    inside = (radius > RADII[0]) & (radius < RADII[1])
    inside = np.logical_and.accumulate(inside, axis=1)
    rows, columns = np.nonzero(inside)
    return Index(cKDTree(extremals.states[rows, columns, :3]), directions[rows], grid[columns])


def solve(transfer: Transfer, state: ArrayLike, guesses: int = 16) -> Extremal:
    """The minimum-time extremal from ``state`` = (r, u, v).

    Args:
        transfer: the problem.
        state: r [AU], u [AU/TU], v [AU/TU].
        guesses: how many different coarse extremals are refined.

    Raises:
        SolveError: the state is not finite, or no extremal was found that passes through it.
    """
    target = np.asarray(state, float)
    if target.shape != (3,) or not np.isfinite(target).all() or target[0] <= 0.0:
        raise SolveError(
            f"the state (r, u, v) must be three finite numbers with r > 0, not {target.tolist()}"
        )
    if np.max(np.abs(target - transfer.target_state)) < RESIDUAL_GOAL:
        raise SolveError("the state is on the target orbit already: there is nothing to solve")
    index = build_index(transfer)
    spread = math.sqrt(4.0 * math.pi / DIRECTIONS)
    for _ in range(1 + ZOOMS):
        _, near = index.tree.query(target, k=40 * guesses)
        chosen = _distinct(index, near, guesses)
        targets = np.tile(target, (len(chosen), 1))
        shots = shoot(transfer, targets, index.directions[chosen], index.tau[chosen])
        solved = np.flatnonzero(shots.residual <= RESIDUAL_GOAL)
        if len(solved):
            return extremal_of(transfer, target, shots, int(solved[np.argmin(shots.tau[solved])]))
        # Neighbouring extremals part quickly after they pass a pinch: look between them.
        patches = [_patch(index.directions[i], spread) for i in chosen]
        index = _propagate_index(transfer, np.concatenate(patches))
        spread *= ZOOM_FACTOR
    raise SolveError(
        f"no extremal found from r = {target[0]:g} AU, u = {target[1]:g}, v = {target[2]:g} AU/TU "
        f"to a circular orbit of {transfer.target_radius:g} AU within {LONGEST:g} TU"
    )


def sample(transfer: Transfer, extremal: Extremal, count: int = 501) -> tuple[Array, Array]:
    """An extremal from departure to arrival.

    Returns:
        (count,) time since departure [TU], and (count, 7) columns r, u, v, lambda_r, lambda_u,
        lambda_v and the optimal cone angle [rad].
    """
    tau = np.linspace(0.0, extremal.time_of_flight, count)
    states = propagate_extremals(transfer, extremal.arrival_costates, tau).states[0, ::-1]
    alpha = guidance_law(transfer, states[:, 4], states[:, 5])
    return tau, np.column_stack([states, alpha])


def extremal_of(transfer: Transfer, state: Array, shots: Shots, row: int) -> Extremal:
    """One shot as an extremal, its costates scaled to H = 0 (Eq. 19)."""
    scale = -1.0 / float(arrival_gain(transfer, shots.directions[row : row + 1])[0])
    costates = scale * shots.states[row, 3:]
    return Extremal(
        state=state,
        time_of_flight=float(shots.tau[row]),
        costates=costates,
        arrival_costates=scale * shots.directions[row],
        cone_angle=float(guidance_law(transfer, costates[1], costates[2])),
        jumps=int(shots.jumps[row]),
        jump_time=float(shots.jump_times[row]),
        residual=float(shots.residual[row]),
    )


def _fibonacci_sphere(count: int) -> Array:
    """(count, 3) nearly even unit vectors."""
    i = np.arange(count) + 0.5
    height = 1.0 - 2.0 * i / count
    angle = math.pi * (1.0 + math.sqrt(5.0)) * i
    ring = np.sqrt(1.0 - height**2)
    return np.column_stack([height, ring * np.cos(angle), ring * np.sin(angle)])


def _patch(centre: Array, spread: float) -> Array:
    """(PATCH, 3) unit vectors that fill a disc of radius 2 ``spread`` about ``centre``."""
    i = np.arange(PATCH)
    angle = math.pi * (1.0 + math.sqrt(5.0)) * i
    radius = 2.0 * spread * np.sqrt(i / PATCH)
    across = np.linalg.svd(centre[None])[2][1:]
    vectors = centre + radius[:, None] * (
        np.cos(angle)[:, None] * across[0] + np.sin(angle)[:, None] * across[1]
    )
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def _distinct(index: Index, near: Array, count: int) -> list[int]:
    """The nearest samples that belong to clearly different extremals, nearest first."""
    chosen: list[int] = []
    for candidate in near.tolist():
        turned = index.directions[chosen] @ index.directions[candidate] < math.cos(0.15)
        later = np.abs(index.tau[chosen] - index.tau[candidate]) > 0.3
        if np.all(turned | later):
            chosen.append(candidate)
            if len(chosen) == count:
                break
    return chosen

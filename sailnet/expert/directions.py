"""Arrival directions: the sphere in even triangles and pieces of them, and its tangent planes."""

import itertools
from functools import cache

import numpy as np
from numpy.typing import NDArray

from sailnet.physics.arrays import Array

Rows = NDArray[np.intp]

QUARTERINGS = 4
"""Of the icosahedron's triangles, everywhere."""


@cache
def icosphere() -> tuple[Array, Rows]:
    """Directions and triangles of the icosahedron, subdivided evenly."""
    golden = (1.0 + np.sqrt(5.0)) / 2.0
    corners = np.array([(0.0, s, t * golden) for s in (-1, 1) for t in (-1, 1)])
    directions = np.concatenate([np.roll(corners, k, axis=1) for k in range(3)])
    touch = np.isclose(np.linalg.norm(directions[:, None] - directions, axis=2), 2.0)
    sets = itertools.combinations(range(12), 3)
    triangles = np.array([(a, b, c) for a, b, c in sets if touch[a, b] and touch[b, c] and touch[a, c]])
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    for _ in range(QUARTERINGS):
        directions, triangles = quarter(directions, triangles)
    return directions, triangles


def quarter(directions: Array, triangles: Rows) -> tuple[Array, Rows]:
    """Four triangles for each; returns all directions and the new triangles."""
    directions, middle = _with_midpoints(directions, triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2))
    ab, bc, ca = middle.reshape(-1, 3).T
    a, b, c = triangles.T
    parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return directions, np.concatenate([np.column_stack(part) for part in parts])


def halve(directions: Array, triangles: Rows, opposite: Rows) -> tuple[Array, Rows]:
    """Halve each triangle across the edge opposite to a corner; returns all directions and the halves."""
    corner, a, b = np.take_along_axis(triangles, (opposite[:, None] + np.arange(3)) % 3, axis=1).T
    directions, m = _with_midpoints(directions, np.column_stack([a, b]))
    return directions, np.concatenate([np.column_stack([corner, a, m]), np.column_stack([corner, m, b])])


def _with_midpoints(directions: Array, edges: Rows) -> tuple[Array, Rows]:
    """The directions with the middle of every edge appended once, and (n,) which of them is each edge's."""
    unique, inverse = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True)
    middle = directions[unique[:, 0]] + directions[unique[:, 1]]
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    return np.concatenate([directions, middle]), len(directions) + inverse.ravel()


def tangent_plane(directions: Array) -> Array:
    """(n, 3, 2) two orthonormal vectors across each of (n, 3) unit vectors; or four, (n, 5, 4)."""
    if directions.shape[1] > 3:
        return _mirrored_axes(directions)
    # Cross products with the axis that is farthest from the vector.
    axis = np.eye(3)[np.argmin(np.abs(directions), axis=1)]
    first = np.cross(directions, axis)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    return np.stack([first, np.cross(directions, first)], axis=2)


def _mirrored_axes(directions: Array) -> Array:
    """(n, k, k - 1) all axes but the first, mirrored as that is into each of (n, k) unit vectors."""
    side = np.copysign(1.0, directions[:, :1])
    normal = directions + side * np.eye(directions.shape[1])[0]
    share = normal[:, 1:] / (1.0 + np.abs(directions[:, :1]))
    return np.asarray(np.eye(directions.shape[1])[:, 1:] - normal[:, :, None] * share[:, None, :])

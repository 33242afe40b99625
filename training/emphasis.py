"""Which samples are drawn: more of those where a wrong angle costs more.

A cone angle that is wrong by da for a time dt loses the time g'' / 2 |lambda| beta / r^2 da^2 dt, where
lambda is the costate of the velocity and g the force along it over beta / r^2, least on the fastest way: the
second order of the Hamiltonian of Eq. (7). So |lambda| beta / r^2 is what an error costs. It grows beside
the edges of the fastest way, which samples drawn evenly hardly show.
"""

import numpy as np
from numpy.typing import NDArray

from sailnet.dataset import Dataset
from sailnet.physics.arrays import Array

BOUNDS = (0.5, 50.0)
"""A sample's cost counts for no less and no more; of wide data to 0.9 AU 16 and 0.14 % lie beyond."""


def costs_of_error(data: Dataset) -> Array:
    """(samples,) |lambda| beta / r^2 of each, within ``BOUNDS``.

    Args:
        data: with costates, and beta of each sample.
    """
    speeds = [f"lambda_{name}" for name in data.states[len(data.states) // 2 :]]
    found = np.empty(data.samples)
    for rows, columns in data.blocks(("r", "beta", *speeds)):
        size = np.linalg.norm([columns[name] for name in speeds], axis=0)
        found[rows] = size * columns["beta"] / columns["r"] ** 2
    return np.clip(np.nan_to_num(found, nan=BOUNDS[0]), *BOUNDS)


def draw(
    rng: np.random.Generator, rows: NDArray[np.intp], limit: int, costs: Array | None, emphasis: float
) -> NDArray[np.intp]:
    """At most so many of the rows, in order; each with a chance that grows with a power of its cost.

    Args:
        rng: random numbers.
        rows: to draw from.
        limit: where there are no more rows, all of them are taken.
        costs: of every row of the data; None: evenly.
        emphasis: the power.
    """
    if limit >= len(rows):
        return rows
    chances = None
    if costs is not None:
        chances = costs[rows] ** emphasis
        chances /= chances.sum()
    return np.sort(rng.choice(rows, limit, replace=False, p=chances))

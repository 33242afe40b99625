"""The states a set of networks was trained on, described by a few hundred numbers.

Samples lie in a tube that a box around them hardly resembles. Two families of bounds follow it, each
continuous and piecewise linear between ``KNOTS`` evenly spaced knots:

*By size*, what is missing to the target. With (dr, du, dv) the deviation from it, a = beta / r_f^2 the
sail's acceleration there and

    q^2 = du^2 + dv^2 + 2 a |dr|,        size = q / a  [TU],

the direction x = (2 a dr / q^2, du / q, dv / q), whose components are at most 1 in size, is bounded along
nine axes: its components, and the sums and differences of every two. Near the target optimal approaches
of all sizes look alike (``sailnet.networks.approach``), so one knot there does for all of them.

*By angular momentum* h = r v: the radial speed u and the energy (u^2 + v^2) / 2 - 1 / r. A sail edge-on
keeps h and energy; those of optimal flights hang together closely.

Within the arrival tolerance of the target every state is inside: nothing is left to do there.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sailnet.errors import NetworkError
from sailnet.physics.arrays import Array

KNOTS = 11
AXES = np.array(
    [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]]
)
"""(9, 3) axes of the direction x, in the order of ``c_runtime/simulation/host/domain.inc``."""

SMALLEST_SQUARE = 1e-12
"""Smallest q^2 [AU^2/TU^2], far within any arrival tolerance."""

Table = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class TrainedDomain:
    """Bounds on what the networks were trained on; ``lower`` above ``upper`` where there was nothing.

    Attributes:
        size_step: spacing of the knots of size, from 0 [TU].
        momentum_min: first knot of angular momentum [AU^2/TU].
        momentum_step: their spacing.
        lower, upper: (KNOTS, 11) bounds: of x along ``AXES`` by size; of u [AU/TU] and energy
            [AU^2/TU^2] by angular momentum.
    """

    size_step: float
    momentum_min: float
    momentum_step: float
    lower: Table
    upper: Table

    def __post_init__(self) -> None:
        shape = (KNOTS, len(AXES) + 2)
        tables = [np.array(self.lower, float), np.array(self.upper, float)]
        finite = all(table.shape == shape and np.isfinite(table).all() for table in tables)
        scales = np.array([self.size_step, self.momentum_min, self.momentum_step], float)
        if not finite or not np.isfinite(scales).all() or not min(self.size_step, self.momentum_step) > 0.0:
            raise NetworkError(
                f"the trained domain is damaged: it needs two tables of shape {shape} of finite numbers"
            )

    @classmethod
    def parse(cls, content: object) -> "TrainedDomain":
        """What was stored: a mapping of the attributes.

        Raises:
            NetworkError: it is not that.
        """
        try:
            given = dict(content)  # type: ignore[call-overload]
            lower, upper = (tuple(tuple(map(float, row)) for row in given.pop(n)) for n in ("lower", "upper"))
            scales = {name: float(value) for name, value in given.items()}
            return cls(lower=lower, upper=upper, **scales)
        except (TypeError, ValueError, KeyError, OverflowError) as error:
            raise NetworkError(f"the trained domain is damaged: {error}") from error

    def excess(self, states: ArrayLike, beta: ArrayLike, target: ArrayLike) -> Array:
        """(n,) by how much the worst bound is passed, in its own unit; positive is outside.

        Sizes and momenta beyond the last knot count in steps.

        Args:
            states: (n, 3) rows r [AU], u, v [AU/TU], finite, r > 0.
            beta: (n,) or one normalised characteristic acceleration, positive.
            target: (3,) r, u, v on the target orbit.
        """
        size, direction = size_and_direction(states, beta, target)
        momentum, orbit = momentum_and_orbit(states)
        middle = len(AXES)
        return np.maximum(
            self._excess(size / self.size_step, direction, slice(0, middle)),
            self._excess(
                (momentum - self.momentum_min) / self.momentum_step, orbit, slice(middle, middle + 2)
            ),
        )

    def _excess(self, position: Array, values: Array, columns: slice) -> Array:
        lower, upper = np.array(self.lower)[:, columns], np.array(self.upper)[:, columns]
        knot, weight = interval(position)
        low = lower[knot] + weight[:, None] * (lower[knot + 1] - lower[knot])
        high = upper[knot] + weight[:, None] * (upper[knot + 1] - upper[knot])
        beyond = np.maximum(-position, position - (KNOTS - 1))
        worst = np.maximum(low - values, values - high).max(axis=1)
        return np.asarray(np.maximum(worst, beyond))


def interval(position: Array) -> tuple[Array, Array]:
    """(n,) the knot before each position, in units of the spacing, and the share of the way to the next."""
    within = np.clip(position, 0.0, KNOTS - 1.0)
    knot = np.minimum(within.astype(int), KNOTS - 2)
    return knot, within - knot


def size_and_direction(states: ArrayLike, beta: ArrayLike, target: ArrayLike) -> tuple[Array, Array]:
    """(n,) size [TU] and (n, 9) direction along ``AXES``, of states as in :meth:`TrainedDomain.excess`."""
    goal = np.asarray(target, float)
    acceleration = np.asarray(beta, float) / goal[0] ** 2
    dr, du, dv = (np.asarray(states, float) - goal).T
    square = np.maximum(du**2 + dv**2 + 2.0 * acceleration * np.abs(dr), SMALLEST_SQUARE)
    q = np.sqrt(square)
    return q / acceleration, np.column_stack([2.0 * acceleration * dr / square, du / q, dv / q]) @ AXES.T


def momentum_and_orbit(states: ArrayLike) -> tuple[Array, Array]:
    """(n,) angular momentum [AU^2/TU] and (n, 2) radial speed and energy of states (r, u, v)."""
    r, u, v = np.asarray(states, float).T
    return r * v, np.column_stack([u, 0.5 * (u**2 + v**2) - 1.0 / r])

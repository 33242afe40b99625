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

In three dimensions the bounds are the same to the north and to the south. With dw the northward speed and
dz = r_f times the latitude phi, q^2 = du^2 + dv^2 + dw^2 + 2 a (|dr| + |dz|), and the direction has two more
components, 2 a dz / q^2 and dw / q, whose sizes are bounded (their sums and differences too would tell next
to nothing more). The angular momentum is that about the axis of the target orbit, h = r v cos(phi); that
across the axis, r (w^2 + v^2 sin^2(phi))^(1/2), which a sail edge-on keeps too, is bounded beside u and the
energy (u^2 + v^2 + w^2) / 2 - 1 / r.

Within the arrival tolerance of the target every state is inside: nothing is left to do there.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sailnet.errors import NetworkError
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import lengths_of

KNOTS = 11
AXES = np.array(
    [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]]
)
"""(9, 3) axes of the direction x in the plane, in the order of ``c_runtime/simulation/host/domain.inc``."""

DIRECTIONS = {3: len(AXES), 5: len(AXES) + 2}
"""Quantities that are bounded by size, by the components of a state."""

ORBITS = {3: 2, 5: 3}
"""Those that are bounded by angular momentum."""

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
            [AU^2/TU^2] by angular momentum. In space (KNOTS, 14): behind ``AXES`` of the sizes of the
            lateral components, and last of the angular momentum across the axis [AU^2/TU].
    """

    size_step: float
    momentum_min: float
    momentum_step: float
    lower: Table
    upper: Table

    def __post_init__(self) -> None:
        shapes = [(KNOTS, DIRECTIONS[size] + ORBITS[size]) for size in DIRECTIONS]
        tables = [np.array(self.lower, float), np.array(self.upper, float)]
        finite = all(np.isfinite(table).all() for table in tables)
        finite &= tables[0].shape in shapes and tables[0].shape == tables[1].shape
        scales = np.array([self.size_step, self.momentum_min, self.momentum_step], float)
        if not finite or not np.isfinite(scales).all() or not min(self.size_step, self.momentum_step) > 0.0:
            raise NetworkError(
                "the trained domain is damaged: it needs two tables of finite numbers, of shape "
                f"{shapes[0]}, or in space of {shapes[1]}"
            )

    @property
    def components(self) -> int:
        """Of the states it is of: 3, or 5 in space."""
        return next(size for size in DIRECTIONS if len(self.lower[0]) == DIRECTIONS[size] + ORBITS[size])

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
            states: (n, 3) rows r [AU], u, v [AU/TU], finite, r > 0; in space (n, 5) rows r, latitude [rad],
                u, v, w.
            beta: (n,) or one normalised characteristic acceleration, positive.
            target: (3,) or (5,), the state on the target orbit.
        """
        size, direction = size_and_direction(states, beta, target)
        momentum, orbit = momentum_and_orbit(states)
        middle = DIRECTIONS[self.components]
        return np.maximum(
            self._excess(size / self.size_step, direction, slice(0, middle)),
            self._excess((momentum - self.momentum_min) / self.momentum_step, orbit, slice(middle, None)),
        )

    def _excess(self, position: Array, values: Array, columns: slice) -> Array:
        lower, upper = np.array(self.lower)[:, columns], np.array(self.upper)[:, columns]
        knot, weight = interval(position)
        low = lower[knot] + weight[:, None] * (lower[knot + 1] - lower[knot])
        high = upper[knot] + weight[:, None] * (upper[knot + 1] - upper[knot])
        beyond = np.maximum(-position, position - (KNOTS - 1))
        worst = np.maximum(low - values, values - high).max(axis=1)
        return np.asarray(np.maximum(worst, beyond))


def recorded_domain(provenance: Mapping[str, object], components: int) -> TrainedDomain:
    """The tube of states that networks were trained on, as ``tau`` has recorded it.

    Args:
        provenance: of ``tau``.
        components: of a state, 3 or 5.

    Raises:
        NetworkError: none is recorded, or one of other states.
    """
    if "domain" not in provenance:
        raise NetworkError(
            "network tau does not say which states it was trained on: "
            "add it with python -m training.fit_domain DATASET NETWORKS_DIR"
        )
    domain = TrainedDomain.parse(provenance["domain"])
    if domain.components != components:
        raise NetworkError(
            f"the trained domain is of states of {domain.components} numbers, the networks of {components}: "
            "add theirs with python -m training.fit_domain DATASET NETWORKS_DIR"
        )
    return domain


def interval(position: Array) -> tuple[Array, Array]:
    """(n,) the knot before each position, in units of the spacing, and the share of the way to the next."""
    within = np.clip(position, 0.0, KNOTS - 1.0)
    knot = np.minimum(within.astype(int), KNOTS - 2)
    return knot, within - knot


def size_and_direction(states: ArrayLike, beta: ArrayLike, target: ArrayLike) -> tuple[Array, Array]:
    """(n,) size [TU] and (n, 9) direction along ``AXES``, of states as in :meth:`TrainedDomain.excess`.

    In space (n, 11): with the sizes of the lateral components.
    """
    goal = np.asarray(target, float)
    acceleration = np.asarray(beta, float) / goal[0] ** 2
    missing = ((np.asarray(states, float) - goal) * lengths_of(goal)).T
    position, speed = missing[: len(missing) // 2], missing[len(missing) // 2 :]
    square = (speed**2).sum(axis=0) + 2.0 * acceleration * np.abs(position).sum(axis=0)
    square = np.maximum(square, SMALLEST_SQUARE)
    q = np.sqrt(square)
    fall, (u, v) = 2.0 * acceleration * position / square, speed[:2] / q
    along = np.column_stack([fall[0], u, v]) @ AXES.T
    if len(missing) == 5:
        along = np.column_stack([along, np.abs(fall[1]), np.abs(speed[2]) / q])
    return q / acceleration, along


def momentum_and_orbit(states: ArrayLike) -> tuple[Array, Array]:
    """(n,) angular momentum and (n, 2) radial speed and energy of states (r, u, v).

    In space the angular momentum is that about the axis, and the size of that across it is the third, (n, 3).
    """
    given = np.asarray(states, float)
    r, u, v = given.T if given.shape[1] == 3 else given[:, [0, 2, 3]].T
    energy = 0.5 * (u**2 + v**2) - 1.0 / r
    if given.shape[1] == 3:
        return r * v, np.column_stack([u, energy])
    latitude, w = given[:, [1, 4]].T
    across = r * np.hypot(w, v * np.sin(latitude))
    return r * v * np.cos(latitude), np.column_stack([u, energy + 0.5 * w**2, across])

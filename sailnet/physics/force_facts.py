"""What the optics of a sail amount to: how strong its force is, where it points, and what turning gains."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sailnet.physics.arrays import Array
from sailnet.physics.optics import Optics
from sailnet.physics.real_law import RealLaw, force_curve

STEPS = 90
"""Of cone angles from 0 to 90 degrees among which the largest transverse force is looked for, before Newton's
kind of method finds it exactly."""


@dataclass(frozen=True)
class AtBound:
    """How the optimal law meets a bound on the cone angle.

    Attributes:
        phi_max: the bound [rad].
        last: the cone angle just before the bound is active [rad]: phi_max, or one that jumps to it.
        takeover: the angle of -(lambda_u, lambda_v) from the radial direction from which it is active [rad].
    """

    phi_max: float
    last: float
    takeover: float

    @property
    def jumps(self) -> bool:
        """Whether cone angles between ``last`` and the bound are never the best."""
        return self.last < self.phi_max


@dataclass(frozen=True)
class ForceFacts:
    """One sail's force per beta / r^2.

    Attributes:
        optics: of the sail.
        widest_useful: the cone angle with the largest transverse force [rad]; beyond it that falls. 0 where
            turning the sail gains none at all.
        largest_transverse: that force.
        at_bounds: how the law meets some bounds; none where turning the sail gains nothing.
    """

    optics: Optics
    widest_useful: float
    largest_transverse: float
    at_bounds: tuple[AtBound, ...]

    @classmethod
    def of(cls, optics: Optics, bounds: Sequence[float]) -> "ForceFacts":
        """The facts of a sail, with some bounds on its cone angle [rad]."""
        widest = _widest_useful(optics)
        met = []
        for phi_max in bounds if widest > 0.0 else ():
            law = RealLaw.of(np.array([optics.force]), phi_max)
            met.append(AtBound(phi_max, float(law.last[0]), float(law.takeover[0])))
        return cls(optics, widest, float(force_at(optics, np.array([widest]))[1, 0]), tuple(met))

    def lean(self, angle: float) -> float:
        """By how much the force leans from the sail's normal, away from the Sun, at a cone angle [rad]."""
        radial, transverse = force_at(self.optics, np.array([angle]))[:, 0]
        return float(angle - np.arctan2(transverse, radial))


def force_at(optics: Optics, angles: Array) -> Array:
    """(2, n) radial and transverse force per beta / r^2 at (n,) cone angles [rad]."""
    return np.asarray(force_curve(angles, np.array(optics.force))[0])


def _widest_useful(optics: Optics) -> float:
    from scipy.optimize import brentq  # loaded where it is needed: it takes half a second

    def slope(angle: float) -> float:
        return float(force_curve(np.array([angle]), np.array(optics.force))[1, 1, 0])

    grid = np.linspace(0.0, np.pi / 2.0, STEPS + 1)
    falls = force_curve(grid, np.array(optics.force))[1, 1] <= 0.0
    first = int(np.argmax(falls))
    return 0.0 if first == 0 else float(brentq(slope, grid[first - 1], grid[first], xtol=1e-15))

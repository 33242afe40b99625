"""The optimal cone angle of a flat sail that is not ideal, where Eq. (11) has no closed form.

Per beta / r^2 the force traces a curve f(alpha) = (f_r, f_t) as the sail turns. The minimum of
lambda_u f_r + lambda_v f_t is the curve's farthest point along -(lambda_u, lambda_v), whose angle theta from
the radial direction decides: tan theta = -f_r'(alpha) / f_t'(alpha) inside the bound. At wide angles the
curve bends inwards: no force there is ever the best. Where a tangent of the curve meets its end, at the
bound, the minimum jumps from one to the other.

By symmetry it suffices to look at |alpha| and |lambda_v|; the two signs are opposite (Eq. 24), but at bounds
so wide, beyond 89.6 degrees for ``jpl``, that the heat of the back pushes more than all light does: there the
far end of the mirrored curve is the better one.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any

import heyoka as hy
import numpy as np
from numpy.typing import NDArray

from sailnet.errors import SolveError
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Expression, alpha, thrust

NEWTON_STEPS = 12
"""From 0, left of where a concave function crosses, Newton's method never overshoots; half as many reach the
last digit but where the curve is about to bend inwards."""

COEFFICIENTS = hy.make_vars("square", "linear", "across")


def _curve() -> list[Expression]:
    curve = list(thrust(1.0, 1.0, alpha, COEFFICIENTS)[:2])
    slope = [hy.diff(f, alpha) for f in curve]
    return [*curve, *slope, *(hy.diff(f, alpha) for f in slope)]


@cache
def _compiled_curve() -> Any:
    return hy.cfunc(_curve(), vars=[alpha, *COEFFICIENTS])


@cache
def _compiled_angle() -> Any:
    theta = hy.make_vars("theta")
    _, _, slope_r, slope_t, bend_r, bend_t = _curve()
    turning = (slope_r * bend_t - slope_t * bend_r) / (slope_r**2 + slope_t**2)
    step = (theta - hy.atan2(-slope_r, slope_t)) / turning
    angle = hy.expression(0.0)
    for _ in range(NEWTON_STEPS):
        angle = angle + hy.subs(step, {alpha: angle})
    return hy.cfunc([angle], vars=[theta, *COEFFICIENTS], compact_mode=True)


def force_curve(angle: Array, coefficients: Array) -> Array:
    """(3, 2, n) f_r and f_t per beta / r^2, their first and second derivatives by the cone angle.

    Args:
        angle: (n,) cone angles [rad].
        coefficients: (n, 3) or (3,), see :attr:`sailnet.physics.optics.Optics.force`.
    """
    inputs = np.empty((4, len(angle)))
    inputs[0], inputs[1:] = angle, np.broadcast_to(coefficients, (len(angle), 3)).T
    return np.asarray(_compiled_curve()(inputs)).reshape(3, 2, -1)


@dataclass(frozen=True)
class RealLaw:
    """Force laws of sails and where their bound takes over, one a row or one for all.

    Attributes:
        coefficients: (n, 3) of the force.
        phi_max: bound on the cone angle [rad].
        takeover: (n,) theta from which the bound is active.
        last: (n,) the cone angle just before: the bound's, or a smaller one that jumps to it.
        bound: (n,) the cone angle from there on: phi_max, or -phi_max where the force there is the better.
    """

    coefficients: Array
    phi_max: float
    takeover: Array
    last: Array
    bound: Array

    @classmethod
    def of(cls, coefficients: Array, phi_max: float) -> "RealLaw":
        """The laws of (n, 3) coefficients.

        Raises:
            SolveError: heat pushes such a sail back as it turns, and not only at the bound.
        """
        square, linear, across = coefficients.T
        mirrored = (square - across) * np.cos(phi_max) + linear < 0.0
        last = _last_angle(coefficients, phi_max, mirrored)
        slope = force_curve(last, coefficients)[1]
        takeover = np.arctan2(-slope[0], slope[1])
        end = force_curve(np.full(len(last), phi_max), coefficients)[1]
        outwards = np.cos(takeover) * end[0] + np.where(mirrored, -1.0, 1.0) * np.sin(takeover) * end[1]
        if (across >= 1.0).any() or (mirrored & (outwards < 0.0)).any():
            raise SolveError(
                "no law for such a sail: the heat that its back radiates pushes it against the way it turns"
            )
        # Edge-on there is no force: either side is as good.
        other = mirrored & (phi_max < np.pi / 2)
        return cls(coefficients, phi_max, takeover, last, np.where(other, -phi_max, phi_max))

    def rows(self, chosen: Any) -> "RealLaw":
        """Some of them; the one for all stays."""
        if len(self.last) == 1:
            return self
        columns = (column[chosen] for column in (self.takeover, self.last, self.bound))
        return RealLaw(self.coefficients[chosen], self.phi_max, *columns)

    def angle(self, lambda_u: Array, lambda_v: Array) -> tuple[Array, NDArray[np.bool_]]:
        """(n,) optimal cone angle [rad], and (n,) whether the bound is active."""
        theta, beyond = self._direction(lambda_u, lambda_v), self.beyond(lambda_u, lambda_v)
        inputs = np.empty((4, len(theta)))
        inputs[0], inputs[1:] = np.minimum(theta, self.takeover), self.coefficients.T
        size = _compiled_angle()(inputs)[0]
        return np.copysign(1.0, -lambda_v) * np.where(beyond, self.bound, size), beyond

    def beyond(self, lambda_u: Array, lambda_v: Array) -> NDArray[np.bool_]:
        """(n,) whether the bound is active."""
        return np.asarray(self._direction(lambda_u, lambda_v) > self.takeover)

    @staticmethod
    def _direction(lambda_u: Array, lambda_v: Array) -> Array:
        """(n,) theta [rad]."""
        # Not -lambda_u: where both vanish, and no angle is better than any other, theta is 0.
        return np.asarray(np.arctan2(np.abs(lambda_v), 0.0 - lambda_u))


def _last_angle(coefficients: Array, phi_max: float, mirrored: NDArray[np.bool_]) -> Array:
    """(n,) the angle at which a tangent of the force curve meets its end, mirrored or not, or that end."""
    # Loaded here, for real sails alone: it takes half a second, and every process would pay.
    from scipy.optimize.elementwise import find_root

    count = len(coefficients)
    curve = force_curve(np.full(count, phi_max), coefficients)
    end = np.array([curve[0, 0], np.where(mirrored, -curve[0, 1], curve[0, 1])])

    def turning(angle: Array, *rows: Array) -> Array:
        return _turning(force_curve(angle, np.column_stack(rows)))

    def off_tangent(angle: Array, *rows: Array) -> Array:
        force, slope, _ = force_curve(angle, np.column_stack(rows[:3]))
        return np.asarray(slope[0] * (rows[4] - force[1]) - slope[1] * (rows[3] - force[0]))

    last = np.full(count, phi_max)
    jumps = np.flatnonzero(mirrored | (_turning(curve) < 0.0))
    if len(jumps):
        rows, first = (*coefficients[jumps].T, *end[:, jumps]), np.zeros(len(jumps))
        # The tangent touches where the curve does not bend inwards yet; at its very end both factors vanish.
        bend = find_root(turning, (first, last[jumps]), args=rows[:3])
        near = np.where(bend.success, bend.x, phi_max)
        touch = find_root(off_tangent, (first, near), args=rows)
        # Where the curve has hardly bent, rounding hides on which side of it the tangent passes.
        last[jumps] = np.where(touch.success, touch.x, near)
    return last


def _turning(curve: Array) -> Array:
    """(n,) of points of :func:`force_curve`: negative where the curve bends inwards."""
    _, slope, bend = curve
    return np.asarray(slope[0] * bend[1] - slope[1] * bend[0])

"""The constrained expressions of a whole trajectory: which variables they stand for, and their linear maps.

Where a variable's time derivative is another variable, x' = v or lambda_v' = -lambda_r, one expression
stands for both, with the conditions on v as conditions on its slope; that equation then holds identically.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import heyoka as hy
import numpy as np

from sailnet.ocp.definition.canonical import Canonical
from sailnet.ocp.solvers.ponn.bases import Basis
from sailnet.ocp.solvers.ponn.connections import ENDS, Connections, EndCondition
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Expression

NEGLIGIBLE = 1e-13
"""Directions of the features smaller than this, of the largest, are rounding."""


@dataclass(frozen=True)
class Curve:
    """What one constrained expression stands for.

    Attributes:
        value: position among states and costates of the variable that it is.
        slope: position of the variable that its derivative is, if one is.
        sign: +-1; value' = sign * slope.
    """

    value: int
    slope: int | None = None
    sign: float = 1.0

    @property
    def equation(self) -> int:
        """The differential equation that remains to be met: that of the highest derivative."""
        return self.value if self.slope is None else self.slope


def curves(equations: Canonical) -> list[Curve]:
    """Choose the expressions for a problem's states and costates."""
    variables, found, taken = equations.variables, [], set[int]()
    for i, slope in enumerate(equations.slopes):
        j, sign = _is_variable(slope, variables)
        if j is not None and j != i and not {i, j} & taken:
            found.append(Curve(i, j, sign))
            taken |= {i, j}
    found += [Curve(i) for i in range(len(variables)) if i not in taken]
    return sorted(found, key=lambda curve: curve.value)


def _is_variable(slope: Expression, variables: Sequence[Expression]) -> tuple[int | None, float]:
    for j, variable in enumerate(variables):
        for sign in (1.0, -1.0):
            if hy.get_variables(slope) == [str(variable)] and hy.diff(slope, variable) == hy.expression(sign):
                return j, sign
    return None, 1.0


class Maps(NamedTuple):
    """Linear maps from q = (coefficients, end values) to variables and rates at m points.

    With c = dz/dt, y = (constant + c per_c + h per_h) q for h = 1 / c, and the rates of the curves'
    equations are (c rate_c + c^2 rate_cc) q.

    Attributes:
        z: (m,) points.
        constant, per_c, per_h: (m, 2n, q).
        rate_c, rate_cc: (m, j, q) for j curves.
    """

    z: Array
    constant: Array
    per_c: Array
    per_h: Array
    rate_c: Array
    rate_cc: Array


class Expressions:
    """All constrained expressions on one domain.

    Their coefficients are measured along the singular directions of the highest derivative with the
    value, so that least squares are well conditioned whatever the basis is.

    Args:
        chosen: what the expressions stand for.
        basis: of their free functions.
        prescribed: (2, 2n) whether a variable has a prescribed value at either end.
        z: (m,) training points.
    """

    def __init__(self, chosen: Sequence[Curve], basis: Basis, prescribed: Array, z: Array) -> None:
        self.curves, self.basis = list(chosen), basis
        self.width = prescribed.shape[1]
        self.connections = [self._connections(curve, prescribed) for curve in chosen]
        self._directions: dict[tuple[Connections, bool], tuple[Array, Array]] = {}
        sizes = []
        for curve, connections in zip(chosen, self.connections, strict=True):
            key = (connections, curve.slope is not None)
            if key not in self._directions:
                free = self._free(connections, z)
                stacked = np.vstack([free[1 if curve.slope is None else 2], free[0]])
                _, s, vt = np.linalg.svd(stacked, full_matrices=False)
                kept = s > NEGLIGIBLE * s[0]
                self._directions[key] = (vt[kept].T / s[kept], vt[kept].T * s[kept])
            sizes.append(self._directions[key][0].shape[1])
        self.starts = np.concatenate([[0], np.cumsum(sizes)])
        self.coefficients = int(self.starts[-1])
        self.training = self.maps(z)
        self._sampled: dict[tuple[str, int], Maps] = {}

    def _connections(self, curve: Curve, prescribed: Array) -> Connections:
        found = []
        for end in (0, 1):
            if prescribed[end, curve.value]:
                found.append(EndCondition(end, 0))
            if curve.slope is not None and prescribed[end, curve.slope]:
                found.append(EndCondition(end, 1))
        return Connections(tuple(sorted(found, key=lambda c: (c.derivative, c.end))))

    def _free(self, connections: Connections, z: Array) -> list[Array]:
        dropped = connections.degrees
        at_ends = self.basis.features(np.array(ENDS), dropped)
        return connections.free(self.basis.features(z, dropped), at_ends, z)

    def random(self, rng: np.random.Generator) -> Array:
        """Coefficients of free functions whose features all have weights from U(0, 1)."""
        parts = []
        for curve, connections in zip(self.curves, self.connections, strict=True):
            forward = self._directions[connections, curve.slope is not None][1]
            parts.append(rng.uniform(0.0, 1.0, len(forward)) @ forward)
        return np.concatenate(parts)

    def sampled(self, grid: Callable[[int], Array], count: int) -> Maps:
        """The linear maps at so many points of a grid; each is made once."""
        key = (grid.__name__, count)
        if key not in self._sampled:
            self._sampled[key] = self.maps(grid(count))
        return self._sampled[key]

    def maps(self, z: Array) -> Maps:
        """The linear maps at any points."""
        m, n, j = len(z), self.width, len(self.curves)
        size = self.coefficients + 2 * n
        tensors = [np.zeros((m, rows, size)) for rows in (n, n, n, j, j)]
        constant, per_c, per_h, rate_c, rate_cc = tensors
        made: dict[tuple[Connections, bool], tuple[list[Array], list[Array]]] = {}
        for k, (curve, connections) in enumerate(zip(self.curves, self.connections, strict=True)):
            paired = curve.slope is not None
            key = (connections, paired)
            if key not in made:
                free = [f @ self._directions[key][0] for f in self._free(connections, z)]
                made[key] = free, [connections.switching(z, order) for order in range(3)]
            free, omega = made[key]
            own = slice(self.starts[k], self.starts[k + 1])
            constant[:, curve.value, own] = free[0]
            if paired:
                per_c[:, curve.slope, own] = curve.sign * free[1]
                rate_cc[:, k, own] = curve.sign * free[2]
            else:
                rate_c[:, k, own] = free[1]
            for i, condition in enumerate(connections.conditions):
                node = self.coefficients + condition.end * n
                if condition.derivative == 0:
                    at = node + curve.value
                    constant[:, curve.value, at] = omega[0][:, i]
                    if paired:
                        per_c[:, curve.slope, at] = curve.sign * omega[1][:, i]
                        rate_cc[:, k, at] = curve.sign * omega[2][:, i]
                    else:
                        rate_c[:, k, at] = omega[1][:, i]
                elif curve.slope is not None:
                    # Prescribed is dy/dt = sign * slope; in z it is h times that.
                    at = node + curve.slope
                    per_h[:, curve.value, at] = curve.sign * omega[0][:, i]
                    constant[:, curve.slope, at] = omega[1][:, i]
                    rate_c[:, k, at] = omega[2][:, i]
        return Maps(z, *tensors)

"""Levenberg-Marquardt for square systems."""

from collections.abc import Callable

import numpy as np

from sailnet.ocp.solvers.newton import Root, solve_equations
from sailnet.physics.arrays import Array


def counted(
    residual: Callable[[Array], Array], slope: Callable[[Array], Array], z: Array, goal: float
) -> tuple[Root, int]:
    calls = []

    def linearise(u: Array) -> tuple[Array, Array]:
        calls.append(u)
        return residual(u), slope(u)

    return solve_equations(residual, linearise, z, goal, 50), len(calls)


def test_newton_keeps_derivatives_that_serve() -> None:
    matrix, right = np.array([[3.0, 1.0], [1.0, 2.0]]), np.array([1.0, 2.0])

    def residual(z: Array) -> Array:
        return np.asarray(matrix @ z + 0.1 * np.sin(z) - right)

    root, calls = counted(residual, lambda z: matrix + 0.1 * np.diag(np.cos(z)), np.zeros(2), 1e-13)
    assert root.converged
    assert calls == 1
    assert root.iterations <= 6
    # The last step needs none either, however little it gains.
    root, calls = counted(lambda z: z**2 - 1.0, lambda z: 2.0 * np.diag(z), np.array([2.0]), 0.6)
    assert root.converged
    assert calls == root.iterations == 1

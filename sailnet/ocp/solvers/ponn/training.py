"""Training of the output weights: iterative least squares, and Levenberg-Marquardt.

Losses need not vanish: a few features cannot bend like the solution does. The iteration therefore ends
where the loss no longer falls, and it has converged if the mean loss is below a goal there.
"""

from collections.abc import Callable

import numpy as np
from scipy.linalg import solve_triangular

from sailnet.errors import SailnetError
from sailnet.ocp.solvers.newton import Root
from sailnet.physics.arrays import Array

Linearise = Callable[[Array], tuple[Array, Array]]
"""Losses of the unknowns and their Jacobian; may raise SailnetError where they make no sense."""

STALLED = 1e-4
"""A relative fall of the squared loss below this is none, twice in a row."""

ROUNDING = 1e-3
"""Share of the goal below which one step that fails to lower the loss ends the training."""

LONGEST = 0.5
"""A mapping coefficient changes by at most this share of itself in one step."""


Measure = Callable[[Array, Array], float]
"""The mean absolute loss of unknowns and their losses, in the problem's units."""


def mean_loss(losses: Array) -> float:
    """The mean absolute loss, which the papers print."""
    return float(np.abs(losses).mean())


def iterative_least_squares(
    linearise: Linearise,
    z: Array,
    goal: float,
    iterations: int,
    measure: Measure,
    times: int = 0,
) -> Root:
    """Eqs. (37)-(39) of paper 002: full steps until the loss is below the goal and no longer falls.

    Of a step only the mapping coefficients are held back: far from their solution they would leap across
    zero. The weights take the step that is best for the coefficients as they become.

    Args:
        linearise: losses and their Jacobian.
        z: where to begin.
        goal: mean loss of an accepted point.
        iterations: most steps.
        measure: what is compared with the goal.
        times: how many of the unknowns, the last ones, are mapping coefficients.

    Raises:
        SailnetError: if the starting point itself makes no sense.
    """
    value, jacobian = linearise(z)
    held = times > 0
    for count in range(1, iterations + 1):
        # The row of the final time comes last, as its mapping coefficient does.
        rows, columns = (len(value) - times, len(z) - times) if held else (len(value), len(z))
        step = np.zeros_like(z)
        step[:columns], held = _full_step(jacobian[:rows, :columns], value[:rows], z, 0 if held else times)
        try:
            new, new_jacobian = linearise(z + step)
        except SailnetError:
            return Root(z, value, count, False)
        if measure(z, value) <= goal and not new @ new < value @ value:
            return Root(z, value, count, True)
        z, value, jacobian = z + step, new, new_jacobian
    return Root(z, value, iterations, measure(z, value) <= goal)


def _full_step(jacobian: Array, value: Array, z: Array, times: int) -> tuple[Array, bool]:
    """The Gauss-Newton step, and whether the mapping coefficients were held back."""
    r, step, scale = _factored(jacobian, value)
    split, held = len(scale) - times, False
    if times:
        wanted = solve_triangular(r[split:, split:], step[split:], check_finite=False)
        most = LONGEST * np.abs(z[split:]) * scale[split:]
        held = bool(np.any(np.abs(wanted) > most))
        step[split:] = np.clip(wanted, -most, most)
        step[:split] -= r[:split, split:] @ step[split:]
    step[:split] = solve_triangular(r[:split, :split], step[:split], check_finite=False)
    return step / scale, held


def _factored(jacobian: Array, value: Array) -> tuple[Array, Array, Array]:
    """R and -Q^T value of the Jacobian with columns of unit length, and their lengths."""
    size = jacobian.shape[1]
    scale = np.sqrt(np.einsum("ij,ij->j", jacobian, jacobian))
    scale[scale == 0.0] = 1.0
    r = _triangle(np.column_stack([jacobian / scale, -value]))
    return r[:size, :size], np.array(r[:size, size]), scale


def levenberg_marquardt(
    linearise: Linearise, z: Array, goal: float, iterations: int, measure: Measure
) -> Root:
    """Damped steps, accepted only where the loss falls.

    Args:
        linearise: losses and their Jacobian.
        z: where to begin.
        goal: mean loss of an accepted point.
        iterations: most trial points.
        measure: what is compared with the goal.

    Raises:
        SailnetError: if the starting point itself makes no sense.
    """
    value, jacobian = linearise(z)
    damping, growth, count, stalled = 1e-3, 2.0, 0, 0
    step_for = _damped(jacobian, value)
    while count < iterations and stalled < 2 and damping < 1e12:
        step = step_for(damping)
        count += 1
        try:
            new, new_jacobian = linearise(z + step)
        except SailnetError:
            new, new_jacobian = np.full_like(value, np.inf), jacobian
        before, after = float(value @ value), float(new @ new)
        predicted = before - float(np.sum((value + jacobian @ step) ** 2))
        if not after < before:
            if measure(z, value) <= ROUNDING * goal or predicted < STALLED * before:
                break
            damping, growth = damping * growth, 2.0 * growth
            continue
        ratio = (before - after) / max(predicted, 1e-300)
        stalled = stalled + 1 if before - after < STALLED * before else 0
        z, value, jacobian = z + step, new, new_jacobian
        step_for = _damped(jacobian, value)
        # Close to the solution damping only delays the Gauss-Newton steps.
        damping = max(damping * max(1e-2, 1.0 - (2.0 * min(ratio, 1.0) - 1.0) ** 3), 1e-16)
        growth = 2.0
    return Root(z, value, count, measure(z, value) <= goal)


def _triangle(matrix: Array) -> Array:
    return np.asarray(np.linalg.qr(matrix, mode="r"))


def _damped(jacobian: Array, value: Array) -> Callable[[float], Array]:
    """The step for any damping; the tall Jacobian is factored once for all of them."""
    r, side, scale = _factored(jacobian, value)
    size = len(side)

    def step(damping: float) -> Array:
        lower = np.column_stack([np.sqrt(damping) * np.eye(size), np.zeros(size)])
        both = _triangle(np.vstack([np.column_stack([r, side]), lower]))
        triangle = both[:size, :size]
        return np.asarray(solve_triangular(triangle, both[:size, size], check_finite=False) / scale)

    return step

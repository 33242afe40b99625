"""Levenberg-Marquardt with exact derivatives for square systems whose trial points may have no value."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sailnet.errors import SailnetError
from sailnet.physics.arrays import Array

QUICK = 0.1
"""A step that leaves less of the residual than this needs no new derivatives."""


@dataclass(frozen=True)
class Root:
    """Where the iteration ended.

    Attributes:
        z: the unknowns.
        residual: of them.
        iterations: trial points.
        converged: whether the largest residual is below the goal.
    """

    z: Array
    residual: Array
    iterations: int
    converged: bool


def solve_equations(
    residual: Callable[[Array], Array],
    linearise: Callable[[Array], tuple[Array, Array]],
    z: Array,
    goal: float,
    iterations: int,
) -> Root:
    """Find a root of as many equations as unknowns.

    Args:
        residual: of the unknowns; may raise SailnetError where they make no sense.
        linearise: residual and its Jacobian there.
        z: where to begin.
        goal: largest residual at which a point counts as a root.
        iterations: most trial points.

    Raises:
        SailnetError: if the starting point itself makes no sense.
    """
    value, jacobian = linearise(z)
    damping, growth = 1e-3, 2.0
    scale = np.zeros(len(z))
    count = 0
    while count < iterations and np.abs(value).max() > goal:
        scale = np.maximum(scale, np.linalg.norm(jacobian, axis=0))
        weights = np.where(scale > 0.0, scale, 1.0)
        step = np.asarray(_step(jacobian / weights, value, damping) / weights)
        count += 1
        trial = z + step
        try:
            new = residual(trial)
        except SailnetError:
            new = np.full_like(value, np.inf)
        predicted = float(value @ value - np.sum((value + jacobian @ step) ** 2))
        gained = float(value @ value - new @ new) if np.all(np.isfinite(new)) else -np.inf
        if gained > 0.0:
            ratio = gained / max(predicted, 1e-300)
            if np.linalg.norm(new) < QUICK * np.linalg.norm(value) or np.abs(new).max() <= goal:
                # The derivatives still serve; Broyden's update adds what the step has shown.
                change = new - value - jacobian @ step
                value, jacobian = new, jacobian + np.outer(change, step) / (step @ step)
            else:
                try:
                    value, jacobian = linearise(trial)
                except SailnetError:
                    damping, growth = damping * growth, 2.0 * growth
                    continue
            z = trial
            damping *= max(1e-2, 1.0 - (2.0 * min(ratio, 1.0) - 1.0) ** 3) if ratio > 0.0 else 1.0
            # Close to the root damping only delays Newton's method.
            damping, growth = max(damping, 1e-16), 2.0
        else:
            damping, growth = damping * growth, 2.0 * growth
            if damping > 1e12:
                break
    return Root(z, value, count, bool(np.abs(value).max() <= goal))


def _step(jacobian: Array, value: Array, damping: float) -> Array:
    size = jacobian.shape[1]
    stacked = np.vstack([jacobian, np.sqrt(damping) * np.eye(size)])
    return np.asarray(np.linalg.lstsq(stacked, np.concatenate([-value, np.zeros(size)]), rcond=None)[0])

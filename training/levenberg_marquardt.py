"""Levenberg-Marquardt with geodesic acceleration, for networks of about a thousand parameters.

A step solves (J^T J + mu D) v = -J^T r (D. W. Marquardt 1963), corrected by half the geodesic
acceleration a, which solves the same system for the second derivative of the residuals along v:
M. K. Transtrum and J. P. Sethna, "Improvements to the Levenberg-Marquardt algorithm for nonlinear
least-squares minimization", arXiv:1201.5885. J^T J costs a hundred times what a trial costs, so
the damping is searched with trials and J^T J is formed once an accepted step.

J^T J may be taken from a rotating part of the samples (``curvature_samples``); gradient and loss
always use all of them, so the minimum is the same and only the path to it differs.

Trials are brought back to what the exporter takes (:mod:`training.bounded`), so that every iterate
can be flown.
"""

from dataclasses import dataclass

import torch
from torch import Tensor

from training.bounded import bounded
from training.least_squares import LeastSquares

LOWER, RAISE = 0.1, 2.0
"""Factors on the damping after an accepted and a rejected trial: lowered by less, it stays where steps are
short, and some trainings are not done when their epochs are."""

LARGEST_BEND = 3.0
"""Largest |a| / |v| of a trial: beyond, the second-order correction cannot be trusted. What the loss says of
a trial decides first; 0.75, as the paper has it, holds steps short for most of a training."""

FORGETTING = 0.99
"""D is the largest diagonal of J^T J seen, forgotten at this rate a step."""

FLOOR = 1e-9
"""Added to D, so that a neuron that does nothing is not moved without bound."""

SINGLE = 1e-5
"""Damping above which J^T J is formed in float32, a relative 1e-7 off, in half the time."""

TRIALS = 60
"""Rejected trials after which no smaller loss is to be had in this arithmetic."""


@dataclass(frozen=True)
class Iterate:
    """Everything the next step depends on.

    Attributes:
        parameters: (p,) parameter vector.
        scale: (p,) diagonal D of the damping.
        damping: mu.
        steps: accepted steps so far.
        loss: mean squared error at ``parameters``.
    """

    parameters: Tensor
    scale: Tensor
    damping: float
    steps: int
    loss: float


def begin(problem: LeastSquares, parameters: Tensor) -> Iterate:
    """The iterate before the first step."""
    return Iterate(parameters, torch.zeros_like(parameters), 1e-2, 0, problem.loss(parameters))


def advance(problem: LeastSquares, at: Iterate, curvature_samples: int) -> Iterate | None:
    """Take one step that lowers the loss.

    Args:
        problem: the samples.
        at: where the last step ended.
        curvature_samples: samples whose J^T J is formed; all of them if there are no more.

    Returns:
        The next iterate, or None if no trial lowers the loss: a minimum to machine precision.
    """
    part = problem.block(at.steps, curvature_samples)
    rounded = at.parameters.float() if at.damping > SINGLE else at.parameters
    curvature = part.curvature(rounded).to(at.parameters.dtype)
    gradient, loss = problem.gradient(at.parameters)
    scale = torch.maximum(at.scale * FORGETTING, curvature.diagonal() + FLOOR)
    damping = at.damping
    for _ in range(TRIALS):
        trial = _trial(part, at.parameters, curvature, gradient, damping * scale)
        if trial is not None:
            trial = bounded(problem.layers, trial)
            reached = problem.loss(trial)
            if reached < loss:
                return Iterate(trial, scale, damping * LOWER, at.steps + 1, reached)
        damping *= RAISE
    return None


def _trial(
    part: LeastSquares, parameters: Tensor, curvature: Tensor, gradient: Tensor, damping: Tensor
) -> Tensor | None:
    """Where a step with this damping leads; None if it is not worth an evaluation."""
    damped = curvature.clone()
    damped.diagonal().add_(damping)
    factor, failed = torch.linalg.cholesky_ex(damped)
    if int(failed):
        return None
    velocity = -torch.cholesky_solve(gradient[:, None], factor)[:, 0]
    bend = part.bend(parameters, velocity)
    acceleration = -torch.cholesky_solve(bend[:, None], factor)[:, 0]
    speed, change = (float((damping * x * x).sum()) for x in (velocity, acceleration))
    # Negated, so that NaN is rejected as well.
    if not change <= LARGEST_BEND**2 * speed:
        return None
    return parameters + velocity + 0.5 * acceleration

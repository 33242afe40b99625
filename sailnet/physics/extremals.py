"""The parameterised backward initial-value problem, Eqs. (14)-(19): one costate in, one extremal out."""

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.errors import SolveError
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import IDEAL
from sailnet.physics.geometry import force_costates, target_of
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.propagation import MOST_STEPS, TOLERANCE, propagator
from sailnet.physics.real_law import force_curve
from sailnet.physics.transfer import AnyTransfer, Transfer


def arrival_gain(transfer: AnyTransfer, costates: Array) -> Array:
    """lambda . dx/dt at the target, whose value must be -1 for H = 0, Eq. (19).

    On the target orbit U = 0 and V^2/R = 1/R^2, so only the sail's force counts and lambda_R
    drops out. The value is homogeneous of degree one in the costates: a direction with a
    negative gain becomes an extremal once divided by minus its gain.

    Args:
        costates: (n, 3) rows (lambda_R, lambda_U, lambda_V), or (n, 5) in space.
    """
    lambda_u, lateral = force_costates(costates)
    alpha = guidance_law(transfer, lambda_u, lateral)
    coefficients = np.array([IDEAL]) if transfer.law is None else transfer.law.coefficients
    radial, transverse = force_curve(alpha, coefficients)[0]
    pressure = transfer.beta / transfer.target_radius**2
    return np.asarray(pressure * (lambda_u * radial + lateral * transverse))


def arrival_lambda_v(transfer: Transfer, lambda_u0: ArrayLike, arrival_sign: float) -> Array:
    """Solve Eq. (19) for lambda_V0.

    Args:
        transfer: the problem.
        lambda_u0: costates of the radial speed at arrival, any shape.
        arrival_sign: sign of the cone angle at arrival. Eq. (19) is even in lambda_V0, so there is
            a root of each sign; the cone angle has the sign opposite to lambda_V0 (Eq. 24).

    Raises:
        SolveError: no extremal arrives with one of these lambda_U0.
    """
    # Loaded here: nothing else that propagates extremals needs it, and it takes half a second.
    from scipy.optimize.elementwise import bracket_root, find_root

    given = np.asarray(lambda_u0, float)

    def residual(size: Array, lambda_u: Array) -> Array:
        lambda_v = -arrival_sign * size
        rows = np.column_stack([np.zeros(size.size), lambda_u.ravel(), lambda_v.ravel()])
        return 1.0 + arrival_gain(transfer, rows).reshape(size.shape)

    bracket = bracket_root(residual, np.zeros(given.shape), np.ones(given.shape), xmin=0.0, args=(given,))
    root = find_root(residual, bracket.bracket, args=(given,), tolerances={"xrtol": 8.9e-16})
    if not np.all(root.success):
        worst = float(given.ravel()[np.argmin(root.success.ravel())])
        raise SolveError(f"Eq. (19) has no root lambda_V0 for lambda_U0 = {worst:g}")
    return np.asarray(-arrival_sign * root.x)


@dataclass(frozen=True)
class Extremals:
    """A set of extremals sampled in time to go.

    Attributes:
        tau: (n, m) time to go [TU], from 0 at arrival.
        states: (n, m, 6) r, u, v [AU, AU/TU] and lambda_r, lambda_u, lambda_v; in space (n, m, 10) r,
            latitude [rad], u, v, w and their costates. NaN after a failure.
        jumps: (n,) number of jumps of the cone angle; in space of turns of the clock angle that are faster
            than ``sailnet.physics.propagation.FAST_TURN``.
        jump_times: (n,) time to go at the last jump found, NaN where there is none.
    """

    tau: Array
    states: Array
    jumps: Array
    jump_times: Array


def propagate_extremals(
    transfer: AnyTransfer, costates: ArrayLike, tau: ArrayLike, tolerance: float = TOLERANCE
) -> Extremals:
    """Propagate Eq. (15) from the target orbit, Eq. (17), for many arrival costates at once.

    Args:
        transfer: the problem, or one a row.
        costates: (n, 3) arrival costates (lambda_R0, lambda_U0, lambda_V0), or (n, 5) in space.
        tau: (m,) increasing grid of time to go [TU], beginning at 0; or (n, m), one a row.
        tolerance: local error of a step.

    Returns:
        One extremal per row; a row that could not be propagated (a fall into the Sun) holds NaN.
    """
    given = np.asarray(costates, float)
    components = 5 if given.shape[-1] == 5 else 3
    arrivals = given.reshape(-1, components)
    # The integrator's error is a share of the largest unknown: in space, where steps are short, of 1.
    unit = np.ones(len(arrivals)) if components == 3 else np.linalg.norm(arrivals, axis=1)
    grid = np.asarray(tau, float)
    grid = np.broadcast_to(grid, (len(arrivals), grid.shape[-1]))
    states = np.empty((*grid.shape, 2 * components))
    jumps = np.zeros(len(arrivals), int)
    jump_times = np.full(len(arrivals), np.nan)
    engine = propagator(transfer, tolerance=tolerance, components=components)
    batches = deque(_batches(len(arrivals), engine.lanes))
    while batches:
        rows = batches.popleft()
        lanes = np.resize(rows, engine.lanes)
        initial = np.empty((2 * components, engine.lanes))
        initial[:components] = target_of(transfer, components)[:, None]
        initial[components:] = arrivals[lanes].T / unit[lanes]
        engine.start(transfer.rows(lanes), initial)
        sampled = engine.integrator.propagate_grid(grid[lanes].T.copy(), max_steps=MOST_STEPS)[1]
        kept = len(rows)
        states[rows] = sampled[:, : 2 * components, :kept].transpose(2, 0, 1)
        states[rows, :, components:] *= unit[rows, None, None]
        jumps[rows] = engine.jumps[:kept]
        jump_times[rows] = engine.jump_times[:kept]
        unfinished = ~np.isfinite(sampled[-1, 0, :kept])
        states[rows[unfinished]] = np.nan
        # A lane that fails stops the others of its batch on their way: those start again.
        stopped = rows[unfinished & ~engine.failed()[:kept]]
        if 0 < len(stopped) < kept:
            batches.append(stopped)
    return Extremals(grid, states, jumps, jump_times)


def _batches(count: int, size: int) -> Iterator[NDArray[np.intp]]:
    for start in range(0, count, size):
        yield np.arange(start, min(start + size, count))

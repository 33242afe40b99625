"""The paper's equations written by hand in NumPy, and integrated by SciPy: what sailnet is held against.

Nothing here is derived from sailnet's expressions. Equation numbers are those of Wang, Lu, Chen and
Li; in Eq. (15) the "+" missing between 2 beta cos^3 / R^3 and V^2 / R^2 is put back.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.integrate import solve_ivp

from sailnet.physics.transfer import Transfer

Array = NDArray[np.float64]


def sail_motion(state: ArrayLike, alpha: ArrayLike, beta: ArrayLike) -> Array:
    """Eq. (1) for rows r, theta, u, v."""
    r, _, u, v = np.asarray(state, float)
    c, s = np.cos(alpha), np.sin(alpha)
    beta = np.asarray(beta)
    return np.array([u, v / r, beta * c**3 / r**2 + v**2 / r - 1 / r**2, beta * s * c**2 / r**2 - u * v / r])


def costate_motion(x: ArrayLike, alpha: ArrayLike, beta: float) -> Array:
    """Eq. (8) with lambda_theta = 0, for rows r, u, v, lambda_r, lambda_u, lambda_v."""
    r, u, v, lr, lu, lv = np.asarray(x, float)
    c, s = np.cos(alpha), np.sin(alpha)
    return np.array(
        [
            lu * (2 * beta * c**3 / r**3 + v**2 / r**2 - 2 / r**3)
            + lv * (2 * beta * c**2 * s / r**3 - u * v / r**2),
            -lr + lv * v / r,
            -2 * lu * v / r + lv * u / r,
        ]
    )


def backward_motion(x: ArrayLike, alpha: ArrayLike, beta: float) -> Array:
    """Eq. (15) for rows R, U, V, lambda_R, lambda_U, lambda_V."""
    r, u, v, lr, lu, lv = np.asarray(x, float)
    c, s = np.cos(alpha), np.sin(alpha)
    return np.array(
        [
            -u,
            -beta * c**3 / r**2 - v**2 / r + 1 / r**2,
            -beta * s * c**2 / r**2 + u * v / r,
            -lu * (2 * beta * c**3 / r**3 + v**2 / r**2 - 2 / r**3)
            - lv * (2 * beta * c**2 * s / r**3 - u * v / r**2),
            lr - lv * v / r,
            2 * lu * v / r - lv * u / r,
        ]
    )


def hamiltonian(x: ArrayLike, alpha: ArrayLike, beta: float) -> Array:
    """Eq. (7)."""
    r, u, v, lr, lu, lv = np.asarray(x, float)
    slopes = sail_motion([r, np.zeros_like(r), u, v], alpha, beta)
    return np.asarray(1 + lr * slopes[0] + lu * slopes[2] + lv * slopes[3])


def unconstrained_angle(lambda_u: ArrayLike, lambda_v: ArrayLike, branch: ArrayLike) -> Array:
    """alpha_bar of Eq. (11), continued through lambda_v = 0 on the given side of the jump.

    For lambda_u < 0 the printed fraction is multiplied by -3 lambda_u + sqrt(...), which removes
    its cancellation; for lambda_u > 0 its reciprocal is used, which stays finite at lambda_v = 0.
    """
    lu, lv, side = (np.asarray(x, float) for x in (lambda_u, lambda_v, branch))
    root = np.sqrt(9 * lu**2 + 8 * lv**2)
    # No denominator is negative, so that arctan2 is the arc tangent of the quotient, and may be zero.
    facing = np.arctan2(-2 * lv, root - 3 * lu)
    averted = side * np.pi / 2 + np.arctan2(4 * lv, root + 3 * lu)
    return np.asarray(np.where(lu < 0, facing, averted))


def smoothed(bar: ArrayLike, phi_max: float, delta: float) -> Array:
    """Eq. (12)."""
    bar = np.asarray(bar)
    return np.asarray((np.sqrt((bar + phi_max) ** 2 + delta) - np.sqrt((bar - phi_max) ** 2 + delta)) / 2)


@dataclass(frozen=True)
class Flown:
    """Samples (m, 6) of an extremal at the times asked for, and the times of its jumps."""

    states: Array
    jump_times: list[float]


def fly(
    transfer: Transfer, start: ArrayLike, times: ArrayLike, backward: bool = True, flip: bool = True
) -> Flown:
    """Integrate an extremal with DOP853, restarted wherever its law is not smooth.

    Args:
        transfer: the problem.
        start: (6,) state and costates at time 0.
        times: (m,) increasing times of the samples.
        backward: Eq. (15), time to go; else Eqs. (1) and (8), time.
        flip: change the branch of the law at lambda_v = 0. False is the classic error: a
            fixed branch that steps over the jump.
    """

    def bar(x: Array) -> Array:
        return unconstrained_angle(x[4], x[5], branch)

    def slopes(_: float, x: Array) -> Array:
        alpha = mode * transfer.phi_max if mode else smoothed(bar(x), transfer.phi_max, transfer.delta)
        forth = backward_motion(x, alpha, transfer.beta)
        return forth if backward else -forth

    def crossing(_: float, x: Array) -> float:
        return float(x[5])

    def corner(_: float, x: Array) -> float:
        return float(bar(x) ** 2 - transfer.phi_max**2)

    crossing.terminal = corner.terminal = True  # type: ignore[attr-defined]
    exact = transfer.delta == 0.0 and transfer.phi_max < np.pi / 2
    times = np.asarray(times, float)
    x, t = np.asarray(start, float), float(times[0])
    branch = -np.copysign(1.0, x[5])
    mode = float(np.sign(bar(x))) if exact and corner(t, x) > 0 else 0.0
    states = np.full((len(times), 6), np.nan)
    jump_times: list[float] = []
    while True:
        events = [crossing, corner] if exact else [crossing]
        flown = solve_ivp(
            slopes,
            (t, times[-1]),
            x,
            "DOP853",
            dense_output=len(times) > 2,
            events=events,
            rtol=3e-14,
            atol=1e-13,
            max_step=0.05,
        )
        covered = (times >= t) & (times <= flown.t[-1])
        if flown.sol is None:
            states[covered] = flown.y[:, np.isin(flown.t, times)].T
        elif covered.any():
            states[covered] = flown.sol(times[covered]).T
        if flown.status == 0:
            return Flown(states, jump_times)
        t, x = float(flown.t[-1]), flown.y[:, -1].copy()
        if len(flown.t_events[0]):
            if flip:
                if x[4] > 0:
                    jump_times.append(t)
                    mode = -mode
                branch = -branch
            # Step off the surface, or the next leg would find the same event again.
        else:
            mode = 0.0 if mode else branch
        hop = 1e-9
        x, t = x + hop * slopes(t, x), t + hop

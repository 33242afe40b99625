"""Motion and optimal extremals in three dimensions, by hand, in Cartesian coordinates and by SciPy.

Nothing here is derived from sailnet's expressions, and nothing is spherical: positions x, velocities y and
their costates p, q of the Hamiltonian H = 1 + p.y + q.(-x / |x|^3 + a). An ideal sail's acceleration a is
beta / r^2 cos^2 alpha n, with n at alpha from x towards -q across x. At the best alpha

    H_a = beta / r^2 cos^2 alpha (cos alpha q_x - sin alpha L),

q_x being the component of q along x and L the length of the rest of q; its gradient is taken at that alpha.
"""

import numpy as np
from scipy.integrate import solve_ivp

from sailnet.physics.transfer import Transfer
from tests.reference import Array


def best_angle(along: float, across: float, phi_max: float) -> float:
    """The cone angle in [0, phi_max] that minimises cos^2 a (cos a along - sin a across), across >= 0."""
    # Stationary where 2 t^2 across - 3 t along - across = 0, t = tan a.
    if across == 0.0:
        return 0.0 if along <= 0.0 else phi_max
    tangent = (3.0 * along + np.sqrt(9.0 * along**2 + 8.0 * across**2)) / (4.0 * across)
    return float(min(np.arctan(tangent), phi_max))


def cartesian(state: Array) -> Array:
    """(6,) x and y at azimuth 0 of (r, latitude, u, v, w)."""
    r, latitude, u, v, w = state
    outward, north = _axes(latitude)
    east = np.array([0.0, 1.0, 0.0])
    return np.concatenate([r * outward, u * outward + v * east + w * north])


def spherical(x: Array) -> Array:
    """(..., 5) r, latitude, u, v, w of (..., 6) positions and velocities."""
    position, velocity = x[..., :3], x[..., 3:6]
    r = np.linalg.norm(position, axis=-1)
    outward = position / r[..., None]
    ring = np.hypot(position[..., 0], position[..., 1])
    east = np.stack([-position[..., 1], position[..., 0], 0.0 * r], axis=-1) / ring[..., None]
    north = np.cross(outward, east)
    speeds = [(velocity * axis).sum(axis=-1) for axis in (outward, east, north)]
    return np.stack([r, np.arctan2(position[..., 2], ring), *speeds], axis=-1)


def cartesian_costates(state: Array, costates: Array) -> Array:
    """(6,) p and q at azimuth 0: p . dx + q . dy is lambda . d(state), and 0 for a change of azimuth."""
    whole = cartesian(state)
    # Complex steps: derivatives to the last digit.
    columns = list(np.array([cartesian(state + 1e-30j * step) for step in np.eye(5)]).imag / 1e-30)
    about = np.array([0.0, 0.0, 1.0])
    columns.append(np.concatenate([np.cross(about, whole[:3]), np.cross(about, whole[3:])]))
    return np.asarray(np.linalg.solve(np.array(columns), np.append(costates, 0.0)))


def fly_back(transfer: Transfer, arrival: Array, tau: Array, rtol: float = 1e-12) -> Array:
    """(m, 5) states on the extremal that ends with (10,) state and costates ``arrival``, by DOP853.

    Args:
        transfer: of an ideal sail, delta = 0.
        arrival: r, latitude, u, v, w and their costates.
        tau: (m,) times to go [TU], beginning at 0.
        rtol: local error.
    """

    def slope(_: float, z: Array) -> Array:
        x, y, p, q = z.reshape(4, 3)
        r = float(np.linalg.norm(x))
        outward = x / r
        along = float(q @ outward)
        rest = q - along * outward
        across = float(np.linalg.norm(rest))
        side = rest / across if across > 0.0 else 0.0 * rest
        alpha = best_angle(along, across, transfer.phi_max)
        c, s = np.cos(alpha), np.sin(alpha)
        push = transfer.beta * c**2 / r**2
        pull = c * along - s * across
        gravity = 3.0 * (q @ x) * x / r**5 - q / r**3
        light = -2.0 * push * pull / r * outward + push / r * (c * rest + s * along * side)
        return -np.concatenate([y, push * (c * outward - s * side) - x / r**3, -gravity - light, -p])

    start = np.concatenate([cartesian(arrival[:5]), cartesian_costates(arrival[:5], arrival[5:])])
    flown = solve_ivp(slope, (0.0, tau[-1]), start, method="DOP853", t_eval=tau, rtol=rtol, atol=1e-13)
    return spherical(flown.y[:6].T)


def _axes(latitude: float) -> tuple[Array, Array]:
    c, s = np.cos(latitude), np.sin(latitude)
    return np.array([c, 0.0, s]), np.array([-s, 0.0, c])

"""A sail's motion in Cartesian coordinates by SciPy: the plant's second opinion in three dimensions."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike
from scipy.integrate import solve_ivp

from sailnet.physics.arrays import Array

Normal = Callable[[float], Array]
"""Radial, transverse and northward components of the sail's normal at a time."""


def frame_at(theta: float, latitude: float) -> Array:
    """(3, 3) rows radial, transverse and northward unit vectors."""
    c, s, cl, sl = np.cos(theta), np.sin(theta), np.cos(latitude), np.sin(latitude)
    return np.array([[cl * c, cl * s, sl], [-s, c, 0.0], [-sl * c, -sl * s, cl]])


def cartesian(state: ArrayLike) -> Array:
    """(6,) position and velocity of r, theta, latitude, u, v, w."""
    r, theta, latitude, *speeds = np.asarray(state, float)
    frame = frame_at(float(theta), float(latitude))
    return np.concatenate([r * frame[0], np.array(speeds) @ frame])


def spherical(moving: Array) -> Array:
    """(6,) r, theta, latitude, u, v, w of position and velocity."""
    x, y, z = moving[:3]
    theta, latitude = np.arctan2(y, x), np.arctan2(z, np.hypot(x, y))
    return np.array([np.linalg.norm(moving[:3]), theta, latitude, *(frame_at(theta, latitude) @ moving[3:])])


def flown(
    state: ArrayLike, beta: float, force: tuple[float, float, float], normal: Normal, duration: float
) -> Array:
    """(7,) r, theta, latitude, u, v, w and the dose of sunlight after a time.

    The force is along the normal and along what is left of the Sun's direction in the sail's surface; none
    where the normal points towards the Sun.
    """
    square, linear, across = force

    def slope(time: float, y: Array) -> Array:
        place, speed = y[:3], y[3:6]
        r = np.linalg.norm(place)
        sun = place / r
        east = np.array([-sun[1], sun[0], 0.0]) / np.hypot(sun[0], sun[1])
        n = normal(time) @ np.array([sun, east, np.cross(sun, east)])
        caught = max(float(n @ sun), 0.0)
        push = (square * caught**2 + linear * caught) * n + across * caught * (sun - float(n @ sun) * n)
        return np.concatenate([speed, (beta * push - sun) / r**2, [caught / r**2]])

    begin = np.append(cartesian(state), 0.0)
    end = solve_ivp(slope, (0.0, duration), begin, "DOP853", rtol=1e-13, atol=1e-14, max_step=0.05).y[:, -1]
    return np.append(spherical(end[:6]), end[6])

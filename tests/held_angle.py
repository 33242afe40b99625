"""The plant's Eq. (1) in C by itself, for what holds it against other integrators."""

import ctypes

import numpy as np
from numpy.typing import ArrayLike

from sailnet.flight.plant import RADII, STATE, TOLERANCE, optics_of
from sailnet.flight.plant_library import plant
from sailnet.physics.arrays import Array


def hold_angle(
    states: Array,
    beta: ArrayLike,
    angle: ArrayLike,
    duration: ArrayLike,
    optics: tuple[float, float, float] = (1.0, 0.0, 0.0),
    rate: float = 0.0,
) -> Array:
    """Fly sails whose cone angle is held, or turns steadily.

    Args:
        states: (4, n) rows r, theta, u, v.
        beta: (n,) or one normalised characteristic acceleration.
        angle: (n,) or one cone angle at the start [rad].
        duration: (n,) or one time [TU].
        optics: coefficients of the force; ideal by default.
        rate: of the cone angle [rad/TU].

    Returns:
        (5, n) states at the end and the dose of sunlight [TU/AU^2]; NaN for a sail that was lost.
    """
    functions, structures = plant().functions, plant().structures
    given = np.zeros((), structures["plant_rules"])
    given["least_radius"], given["largest_radius"] = RADII
    given["tolerance"], given["optics"] = TOLERANCE, optics_of(optics)
    count = states.shape[1]
    held = np.zeros(count, structures["plant_state"])
    for name, row in zip(STATE, states, strict=True):
        held[name] = row
    numbers = np.broadcast_arrays(np.empty(count), beta, angle, duration)[1:]
    inside = np.empty(count, bool)
    for i, values in enumerate(zip(*numbers, strict=True)):
        strength, start, time = map(float, values)
        step = ctypes.c_double(0.0)
        inside[i] = functions.plant_hold(
            given.ctypes.data, strength, start, rate, time, held[i:].ctypes.data, ctypes.byref(step)
        )
    return np.where(inside, [held[name] for name in (*STATE, "dose")], np.nan)

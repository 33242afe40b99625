"""The plant's Eq. (1) in C by itself, for what holds it against other integrators."""

import ctypes

import numpy as np
from numpy.typing import ArrayLike, NDArray

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
    given, held = _rules(optics), _sails(states)
    numbers = np.broadcast_arrays(np.empty(len(held)), beta, angle, duration)[1:]
    inside = np.empty(len(held), bool)
    for i, values in enumerate(zip(*numbers, strict=True)):
        strength, start, time = map(float, values)
        inside[i], _ = _hold(given, held[i:], strength, start, rate, time, 0.0)
    return np.where(inside, [held[name] for name in (*STATE, "dose")], np.nan)


def step_after(state: ArrayLike, first: float, duration: float) -> float:
    """What the integrator would try next [TU] after it held the cone angle of a sail.

    Args:
        state: (4,) r, theta, u, v.
        first: what it tries at first [TU].
        duration: for how long the angle is held [TU].
    """
    inside, step = _hold(
        _rules((1.0, 0.0, 0.0)), _sails(np.asarray(state)[:, None]), 0.17, 0.5, 0.0, duration, first
    )
    assert inside
    return step


def _rules(optics: tuple[float, float, float]) -> NDArray[np.void]:
    given = np.zeros((), plant().structures["plant_rules"])
    given["least_radius"], given["largest_radius"] = RADII
    given["tolerance"], given["optics"] = TOLERANCE, optics_of(optics)
    return given


def _sails(states: Array) -> NDArray[np.void]:
    held = np.zeros(states.shape[1], plant().structures["plant_state"])
    for name, row in zip(STATE, states, strict=True):
        held[name] = row
    return held


def _hold(
    given: NDArray[np.void],
    held: NDArray[np.void],
    beta: float,
    angle: float,
    rate: float,
    duration: float,
    first: float,
) -> tuple[bool, float]:
    """Fly the first of these; whether it is still there, and what the integrator would try next [TU]."""
    step = ctypes.c_double(first)
    inside = plant().functions.plant_hold(
        given.ctypes.data,
        given["optics"].ctypes.data,
        beta,
        angle,
        rate,
        duration,
        held.ctypes.data,
        ctypes.byref(step),
    )
    return bool(inside), step.value

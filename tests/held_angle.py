"""The plant's Eq. (1) in C by itself, for what holds it against other integrators."""

import ctypes

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.flight.plant import RADII, SHOWN, STATE, STATE_IN_SPACE, TOLERANCE, optics_of
from sailnet.flight.plant_library import plant
from sailnet.physics.arrays import Array

Force = tuple[float, float, float]
IDEAL: Force = (1.0, 0.0, 0.0)


def hold_angle(
    states: Array,
    beta: ArrayLike,
    angle: ArrayLike,
    duration: ArrayLike,
    optics: Force = IDEAL,
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
    given, held = _rules(optics, 3), _sails(states, STATE)
    numbers = np.broadcast_arrays(np.empty(len(held)), beta, angle, duration)[1:]
    inside = np.empty(len(held), bool)
    for i, values in enumerate(zip(*numbers, strict=True)):
        strength, start, time = map(float, values)
        inside[i], _ = _hold(given, held[i:], strength, _in_plane(start, rate), time, 0.0)
    return np.where(inside, [held[name] for name in (*STATE, "dose")], np.nan)


def hold_turn(
    states: Array, beta: float, turn: NDArray[np.void], duration: float, optics: Force = IDEAL
) -> Array:
    """Fly sails in three dimensions that turn alike.

    Args:
        states: (6, n) rows r, theta, latitude, u, v, w.
        beta: normalised characteristic acceleration.
        turn: of :func:`kept` or :func:`turn_between`.
        duration: [TU].
        optics: coefficients of the force; ideal by default.

    Returns:
        (7, n) states at the end and the dose of sunlight [TU/AU^2]; NaN for a sail that was lost.
    """
    given, held = _rules(optics, len(SHOWN)), _sails(states, STATE_IN_SPACE)
    inside = [_hold(given, held[i:], beta, turn, duration, 0.0)[0] for i in range(len(held))]
    return np.where(inside, [held[name] for name in (*STATE_IN_SPACE, "dose")], np.nan)


def kept(cone: float, clock: float) -> NDArray[np.void]:
    """``plant_turn`` of a sail that keeps its cone and clock angle [rad]."""
    turn = np.zeros((), plant().structures["plant_turn"])
    plant().functions.plant_keep(attitude(cone, clock).ctypes.data, turn.ctypes.data)
    return turn


def turn_between(
    one: tuple[float, float], other: tuple[float, float], rate: float = 1.0
) -> tuple[NDArray[np.void], float]:
    """``plant_turn`` from one cone and clock angle to another [rad], and the angle between the normals."""
    turn = np.zeros((), plant().structures["plant_turn"])
    ends = [attitude(*angles) for angles in (one, other)]
    angle: float = plant().functions.plant_turn_between(*(end.ctypes.data for end in ends), turn.ctypes.data)
    turn["rate"] *= rate
    return turn, angle


def attitude(cone: float, clock: float) -> NDArray[np.void]:
    """``plant_attitude``."""
    return plant().filled("plant_attitude", {"cone_angle": cone, "clock_angle": clock})


def step_after(state: ArrayLike, first: float, duration: float) -> float:
    """What the integrator would try next [TU] after it held the cone angle of a sail.

    Args:
        state: (4,) r, theta, u, v.
        first: what it tries at first [TU].
        duration: for how long the angle is held [TU].
    """
    held = _sails(np.asarray(state)[:, None], STATE)
    inside, step = _hold(_rules(IDEAL, 3), held, 0.17, _in_plane(0.5, 0.0), duration, first)
    assert inside
    return step


def _in_plane(angle: float, rate: float) -> NDArray[np.void]:
    turn = {"first": (1.0, 0.0, 0.0), "second": (0.0, 1.0, 0.0), "angle": angle, "rate": rate}
    return plant().filled("plant_turn", turn)


def _rules(optics: Force, components: int) -> NDArray[np.void]:
    given = np.zeros((), plant().structures["plant_rules"])
    given["least_radius"], given["largest_radius"] = RADII
    given["tolerance"], given["optics"] = TOLERANCE, optics_of(optics)
    given["components"] = components
    return given


def _sails(states: Array, names: tuple[str, ...]) -> NDArray[np.void]:
    held = np.zeros(states.shape[1], plant().structures["plant_state"])
    for name, row in zip(names, states, strict=True):
        held[name] = row
    return held


def _hold(
    given: NDArray[np.void],
    held: NDArray[np.void],
    beta: float,
    turn: NDArray[np.void],
    duration: float,
    first: float,
) -> tuple[bool, float]:
    """Fly the first of these; whether it is still there, and what the integrator would try next [TU]."""
    step = ctypes.c_double(first)
    inside = plant().functions.plant_hold(
        given.ctypes.data,
        given["optics"].ctypes.data,
        beta,
        turn.ctypes.data,
        duration,
        held.ctypes.data,
        ctypes.byref(step),
    )
    return bool(inside), step.value

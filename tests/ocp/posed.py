"""Problems of all kinds for several tests, points near their starts, and derivatives by differences."""

import math
from collections.abc import Callable

import numpy as np

from sailnet.ocp import (
    Bounded,
    FreeTime,
    Problem,
    symbols,
)
from sailnet.ocp.problems import (
    earth_dionysus,
    earth_mars,
    goddard,
    intercept,
    mars_landing,
    reorientation,
    solar_sail,
)
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

PROBLEMS: dict[str, Callable[[], Problem]] = {
    "goddard": goddard.problem,
    "intercept": intercept.problem,
    "bounded intercept": lambda: intercept.problem(1.0, intercept.BOUND),
    "earth-mars": earth_mars.problem,
    "mars-landing": mars_landing.problem,
    "earth-dionysus": earth_dionysus.problem,
    "reorientation I": lambda: reorientation.problem(True),
    "reorientation II": lambda: reorientation.problem(False),
    "sail": lambda: solar_sail.problem(Transfer(0.16892, math.pi / 3, 1e-3, 1.524)),
}


def points(problem: Problem, count: int, seed: int = 0) -> Array:
    """(count, 2n) states near the initial ones, and costates of either sign."""
    rng = np.random.default_rng(seed)
    first = np.array([problem.initial.get(x, 1.0) for x in problem.states])
    scale = np.maximum(np.abs(first), 0.1)
    states = first + 0.02 * scale * rng.uniform(-1.0, 1.0, (count, len(first)))
    return np.hstack([states, rng.uniform(-1.0, 1.0, states.shape)])


def differences(function: Callable[[Array], Array], x: Array, step: float = 1e-6) -> Array:
    """Central differences of a vector function of one point, (rows, len(x))."""
    size = step * np.maximum(1.0, np.abs(x))
    return np.column_stack(
        [
            (function(x + h * e) - function(x - h * e)) / (2 * h)
            for h, e in zip(size, np.eye(len(x)), strict=True)
        ]
    )


def manifold(final_time: float | FreeTime) -> Problem:
    """From x = 1 at any speed to the line x + v = 3, by least effort: every kind of end condition."""
    x, v, u = symbols("x v u")
    return Problem(
        name="manifold",
        source="",
        dynamics={x: v, v: u},
        controls=[Bounded(u)],
        final_time=final_time,
        initial={},
        initial_equations=[x**2 + v**2 - 1.0],
        final_equations=[x + v - 3.0],
        running_cost=0.5 * u**2 + (0.5 if isinstance(final_time, FreeTime) else 0.0),
        terminal_cost=0.25 * v**2,
    )

"""Small problems for the delta method, its bases and heuristics, and series near a solution."""

import heyoka as hy
import numpy as np

from sailnet.ocp import (
    Bounded,
    FreeTime,
    Problem,
    Solution,
    symbols,
)
from sailnet.ocp.solvers import delta
from sailnet.ocp.solvers.delta.heuristics import Heuristic
from sailnet.ocp.solvers.delta.method import Delta
from sailnet.physics.arrays import Array

BASES = [delta.Fourier(), delta.Chebyshev(), delta.Legendre()]


HEURISTICS: list[Heuristic] = [
    delta.GaPso(population=50, flights=10),
    delta.Imperialist(countries=50, imperialists=5),
    delta.CmaEs(population=20),
]


def double_integrator(end: float = 0.0) -> Problem:
    """From rest at 1 to rest at the end, fastest: 2 sqrt(1 - end), the switch half way."""
    x, v, u = symbols("x v u")
    return Problem(
        name="double-integrator",
        source="Pontryagin et al.",
        dynamics={x: v, v: u},
        controls=[Bounded(u, -1.0, 1.0)],
        final_time=FreeTime(1.7),
        initial={x: 1.0, v: 0.0},
        final={x: end, v: 0.0},
        running_cost=hy.expression(1.0),
    )


def fitted(found: Delta, solution: Solution) -> Array:
    """The point z whose series are nearest to a solution's switching functions and angles."""
    controls, s = found.controls, solution.time / solution.final_time
    wanted = np.empty((len(s), controls.channels))
    for switched in controls.switched:
        wanted[:, switched.channel] = solution.switching[:, switched.index]
    for pointed in controls.pointed:
        a = solution.control[:, pointed.columns]
        wanted[:, pointed.channels[0]] = np.unwrap(np.arctan2(a[:, 0], a[:, 1]))
    values = controls.basis.values(s, controls.terms)
    z = np.linalg.lstsq(values, wanted, rcond=None)[0].T.ravel()
    time = [solution.final_time / found.problem.time_guess] if found.problem.time_is_free else []
    return np.concatenate([z, time])


def least_effort() -> Problem:
    """From 0 to 1 in one second: u = 1, between bounds that random series reach."""
    x, u = symbols("x u")
    return Problem(
        name="least-effort",
        source="closed form",
        dynamics={x: u},
        controls=[Bounded(u, -2.0, 3.0)],
        final_time=1.0,
        initial={x: 0.0},
        final={x: 1.0},
        running_cost=0.5 * u**2,
    )

"""Minimum time in three dimensions by a direct method that knows nothing of Pontryagin: as tests.direct.

Positions and velocities are Cartesian, the target's plane is z = 0. The controls of an interval are the
cone angle's size and a vector in the unit disk across the Sun line, which points the lateral force; shorter
vectors fill in the convex hull of the sail's forces, as the sides between -1 and 1 do in the plane, and let
Ipopt move a fast turn of the clock angle from one interval to the next. The time found is an upper bound.
"""

from dataclasses import astuple, dataclass
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from sailnet.physics.transfer import Transfer
from tests.direct import STEPS, runge_kutta
from tests.photons import Sail, push

Array = NDArray[np.float64]

INTERVALS = 100

GUESSES = tuple((time, side) for time in (5.0, 9.0) for side in (-0.5, 0.5))
"""Final time [TU] and lateral force along the motion of every start."""


@dataclass(frozen=True)
class Direct:
    """The best local minimum of the nonlinear program.

    Attributes:
        time_of_flight: the final time [TU].
        agreeing: how many of the starts ended here.
    """

    time_of_flight: float
    agreeing: int


def minimise(transfer: Transfer, state: Array, intervals: int = INTERVALS) -> Direct:
    """From (r, latitude, u, v, w); every guess is solved, and the fastest result kept."""
    program = _Program(transfer, state, intervals)
    times = np.array([time for time in (program.solve(*guess) for guess in GUESSES) if time is not None])
    return Direct(float(times.min()), int((times < 1.0001 * times.min()).sum()))


class _Program:
    """The nonlinear program of one transfer from one state."""

    def __init__(self, transfer: Transfer, state: Array, intervals: int) -> None:
        self.intervals = intervals
        x, final = ca.MX.sym("x", 6, intervals + 1), ca.MX.sym("final")
        control = ca.MX.sym("control", 3, intervals)
        step = ca.repmat(final / (intervals * STEPS), 1, intervals)
        flown = _interval(transfer.beta, astuple(transfer.optics)).map(intervals)
        gaps = ca.vec(flown(x[:, :-1], control, step) - x[:, 1:])
        radius, end = transfer.target_radius, x[:, -1]
        arrival = ca.vertcat(
            end[0] ** 2 + end[1] ** 2 - radius**2,
            end[0] * end[3] + end[1] * end[4],
            end[0] * end[4] - end[1] * end[3] - radius**0.5,
            end[2],
            end[5],
        )
        length = ca.vec(control[1, :] ** 2 + control[2, :] ** 2)
        program: dict[str, Any] = {
            "x": ca.veccat(x, control, final),
            "f": final,
            "g": ca.vertcat(gaps, arrival, length),
        }
        quiet: dict[str, Any] = {"print_time": False, "show_eval_warnings": False}
        settings = {"tol": 1e-8, "max_iter": 500, "print_level": 0, "sb": "yes"}
        self.solver = ca.nlpsol("solver", "ipopt", program, quiet | {"ipopt": settings})
        equal = np.zeros(gaps.shape[0] + 5)
        self.bounds = (
            np.concatenate([equal, np.full(intervals, -1.0)]),
            np.concatenate([equal, np.ones(intervals)]),
        )
        self.state, self.transfer = state, transfer

    def solve(self, time: float, side: float) -> float | None:
        """The final time, None where Ipopt gave up."""
        r, latitude, u, v, w = self.state
        c, s = np.cos(latitude), np.sin(latitude)
        start = np.array([r * c, 0.0, r * s, u * c - w * s, v, u * s + w * c])
        share = np.linspace(0.0, 1.0, self.intervals + 1)
        radius = r + share * (self.transfer.target_radius - r)
        azimuth = np.cumsum(np.append(0.0, radius[1:] ** -1.5 * time / self.intervals))
        zero = np.zeros_like(radius)
        place = [radius * np.cos(azimuth), radius * np.sin(azimuth), zero]
        speed = [-np.sin(azimuth) / radius**0.5, np.cos(azimuth) / radius**0.5, zero]
        lower, upper = np.full((6, self.intervals + 1), -np.inf), np.full((6, self.intervals + 1), np.inf)
        lower[:, 0] = upper[:, 0] = start
        answer = self.solver(
            x0=self._stack(np.array([*place, *speed]), (0.5, side, 0.0), time),
            lbx=self._stack(lower, (0.0, -1.0, -1.0), 0.1),
            ubx=self._stack(upper, (self.transfer.phi_max, 1.0, 1.0), 100.0),
            lbg=self.bounds[0],
            ubg=self.bounds[1],
        )
        return float(answer["f"]) if self.solver.stats()["success"] else None

    def _stack(self, states: Array, control: tuple[float, float, float], time: float) -> Array:
        return np.concatenate([states.ravel("F"), np.tile(control, self.intervals), [time]])


def _interval(beta: float, sail: Sail) -> Any:
    """(state, controls, step) -> the state after ``STEPS`` Runge-Kutta steps."""
    start, control, step = ca.SX.sym("x", 6), ca.SX.sym("c", 3), ca.SX.sym("s")
    radial, transverse = push(sail, control[0], ca)

    def slope(x: Any) -> Any:
        place, r = x[:3], ca.norm_2(x[:3])
        outward = place / r
        ring = ca.sqrt(place[0] ** 2 + place[1] ** 2)
        along = ca.vertcat(-place[1] / ring, place[0] / ring, 0.0)
        north = ca.cross(outward, along)
        lateral = control[1] * along + control[2] * north
        return ca.vertcat(x[3:], beta * (radial * outward + transverse * lateral) / r**2 - place / r**3)

    return ca.Function("interval", [start, control, step], [runge_kutta(slope, start, step)])

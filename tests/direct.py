"""Minimum time by a direct method that knows nothing of Pontryagin: multiple shooting, solved by Ipopt.

The flight is cut into equal intervals with constant controls; the states between them, the controls
and the final time are the unknowns of a nonlinear program. Eq. (1) is written by hand. The controls
are the cone angle's size, from 0 to its bound, and a side from -1 to 1 that scales the transverse
force. Sides between -1 and 1 fill in the convex hull of the sail's forces: they stand for a sail
that tacks quickly, which is never faster than what such tacking approaches, and they let Ipopt move
a jump of the cone angle from one interval to the next, where it would otherwise be stuck. Piecewise
constant controls are slower than the best ones, so the time found is an upper bound; by how much falls with
the square of an interval, but for what a jump or a corner in one costs. The force is tests.photons'.
"""

from collections.abc import Callable
from dataclasses import astuple, dataclass
from itertools import product
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from sailnet.physics.transfer import Transfer
from tests.photons import Sail, push

Array = NDArray[np.float64]
State = tuple[float, float, float]

INTERVALS = 100
STEPS = 2
"""Runge-Kutta steps in an interval."""

GUESSES = tuple(product((5.0, 20.0), (-1.0, 0.0, 1.0)))
"""Final time [TU] and side of every start; the angle is guessed as 0.5 rad, the radius as linear."""


@dataclass(frozen=True)
class Direct:
    """The best local minimum of the nonlinear program.

    Attributes:
        time_of_flight: the final time [TU].
        alpha: (intervals,) sizes of the cone angle [rad].
        side: (intervals,) the side, -1 to 1.
        costates: (3,) estimate of the initial costates: the multipliers of the first interval.
        agreeing: how many of the starts ended here.
    """

    time_of_flight: float
    alpha: Array
    side: Array
    costates: Array
    agreeing: int


def minimise(transfer: Transfer, state: State, intervals: int = INTERVALS) -> Direct:
    """Solve the program from every guess and keep the fastest result."""
    program = _Program(transfer, state, intervals)
    found = [one for one in (program.solve(*guess) for guess in GUESSES) if one is not None]
    times = np.array([values[-1] for values, _ in found])
    values, multipliers = found[int(np.argmin(times))]
    alpha, side = values[3 * (intervals + 1) : -1].reshape(2, intervals)
    agreeing = int((times < 1.0001 * times.min()).sum())
    return Direct(float(times.min()), alpha, side, multipliers[:3], agreeing)


class _Program:
    """The nonlinear program of one transfer from one state."""

    def __init__(self, transfer: Transfer, state: State, intervals: int) -> None:
        self.intervals = intervals
        x, final = ca.MX.sym("x", 3, intervals + 1), ca.MX.sym("final")
        alpha, side = ca.MX.sym("alpha", 1, intervals), ca.MX.sym("side", 1, intervals)
        step = ca.repmat(final / (intervals * STEPS), 1, intervals)
        flown = _interval(transfer.beta, astuple(transfer.optics)).map(intervals)
        gaps = flown(x[:, :-1], alpha, side, step) - x[:, 1:]
        unknowns = ca.veccat(x, alpha, side, final)
        program: dict[str, Any] = {"x": unknowns, "f": final, "g": ca.vec(gaps)}
        quiet: dict[str, Any] = {"print_time": False, "show_eval_warnings": False}
        settings = {"tol": 1e-8, "max_iter": 300, "print_level": 0, "sb": "yes"}
        self.solver = ca.nlpsol("solver", "ipopt", program, quiet | {"ipopt": settings})
        end = np.array([transfer.target_radius, 0.0, transfer.target_radius**-0.5])
        radius = np.linspace(state[0], end[0], intervals + 1)
        self.guess = np.array([radius, np.zeros_like(radius), radius**-0.5])
        lower, upper = np.full_like(self.guess, -np.inf), np.full_like(self.guess, np.inf)
        lower[0] = 0.05
        lower[:, 0] = upper[:, 0] = state
        lower[:, -1] = upper[:, -1] = end
        self.lower = self._stack(lower, 0.0, -1.0, 0.1)
        self.upper = self._stack(upper, transfer.phi_max, 1.0, 100.0)

    def solve(self, time: float, side: float) -> tuple[Array, Array] | None:
        """Unknowns and multipliers, None where Ipopt gave up."""
        answer = self.solver(
            x0=self._stack(self.guess, 0.5, side, time), lbx=self.lower, ubx=self.upper, lbg=0.0, ubg=0.0
        )
        if not self.solver.stats()["success"]:
            return None
        return np.array(answer["x"]).ravel(), np.array(answer["lam_g"]).ravel()

    def _stack(self, states: Array, alpha: float, side: float, time: float) -> Array:
        controls = np.repeat([alpha, side], self.intervals)
        return np.concatenate([states.ravel("F"), controls, [time]])


def runge_kutta(slope: Callable[[Any], Any], x: Any, step: Any) -> Any:
    """The state after ``STEPS`` steps of order 4."""
    for _ in range(STEPS):
        k1 = slope(x)
        k2 = slope(x + step / 2 * k1)
        k3 = slope(x + step / 2 * k2)
        k4 = slope(x + step * k3)
        x = x + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return x


def _interval(beta: float, sail: Sail) -> Any:
    """(state, size of the angle, side, step) -> the state after ``STEPS`` Runge-Kutta steps."""
    start, alpha, side, step = (
        ca.SX.sym(name, rows) for name, rows in zip("xasd", (3, 1, 1, 1), strict=True)
    )
    radial, transverse = push(sail, alpha, ca)

    def slope(x: Any) -> Any:
        r, u, v = x[0], x[1], x[2]
        outwards = beta * radial / r**2 + v**2 / r - 1 / r**2
        return ca.vertcat(u, outwards, beta * side * transverse / r**2 - u * v / r)

    x = runge_kutta(slope, start, step)
    return ca.Function("interval", [start, alpha, side, step], [x])

"""The shooting equations: end conditions as functions of the initial costates, with exact derivatives."""

import numpy as np
from numpy.typing import ArrayLike

from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import Exact, Smoothing
from sailnet.ocp.definition.solution import Solution
from sailnet.ocp.propagation.flow import TOLERANCE, Flow, first_modes
from sailnet.ocp.propagation.tangents import LostError
from sailnet.ocp.solvers.newton import Root, solve_equations
from sailnet.physics.arrays import Array


class Shooting:
    """The shooting equations of a problem under one form of the law.

    Unknowns, in order: initial costates, initial values of states that are free there, multipliers of
    the initial and of the final equations, the final time if it is free.

    Args:
        problem: the problem.
        smoothing: the form of the law; :class:`Exact` locates the switches as events.
        tolerance: local error of the propagation.
    """

    def __init__(self, problem: Problem, smoothing: Smoothing, tolerance: float = TOLERANCE) -> None:
        self.problem, self.smoothing = problem, smoothing
        self.exact = isinstance(smoothing, Exact)
        self.flow = Flow(problem, smoothing, tolerance)
        self.functions = self.flow.functions
        states = problem.states
        self._free = [i for i, x in enumerate(states) if x not in problem.initial]
        self._fixed = np.array([problem.initial.get(x, 0.0) for x in states])
        # A state that is given at t = 0 is put there; no equation needs to say so.
        given = {i for i, x in enumerate(states) if x in problem.initial}
        self.initial_rows = [i for i in range(len(self.functions.ends.initial)) if i not in given]
        ends = self.functions.ends
        self.kinds = [*(ends.initial_kinds[i] for i in self.initial_rows), *ends.final_kinds]
        n, f = len(states), len(self._free)
        self.tangents = np.zeros((2 * n, n + f))
        self.tangents[n:, :n] = np.eye(n)
        self.tangents[self._free, n + np.arange(f)] = 1.0
        self._parts = np.cumsum(
            [n, f, len(problem.initial_equations), len(problem.final_equations), int(problem.time_is_free)]
        )

    def guess(self, costates: ArrayLike, final_time: float | None = None) -> Array:
        """Unknowns from initial costates, with zeros for free states and multipliers."""
        z = np.zeros(self._parts[-1])
        z[: self._parts[0]] = costates
        if self.problem.time_is_free:
            z[-1] = self.problem.time_guess if final_time is None else final_time
        return z

    def unknowns(self, solution: Solution) -> Array:
        """Unknowns from a solution of this problem or of a near one."""
        z = self.guess(solution.costate[0], solution.final_time)
        _, b, _, d, _ = self._parts
        z[self._parts[0] : b] = solution.state[0, self._free]
        if len(solution.multipliers):
            z[b:d] = solution.multipliers
        return z

    def start(self, z: Array) -> Array:
        """(2n,) states and costates at t = 0."""
        x = self._fixed.copy()
        x[self._free] = z[self._parts[0] : self._parts[1]]
        return np.concatenate([x, z[: self._parts[0]]])

    def final_time(self, z: Array) -> float:
        """The final time of these unknowns."""
        return float(z[-1]) if self.problem.time_is_free else self.problem.time_guess

    def multipliers(self, z: Array) -> tuple[Array, Array]:
        """Multipliers of the initial and of the final equations."""
        return z[self.initial_multipliers], z[self.final_multipliers]

    @property
    def initial_multipliers(self) -> slice:
        """Where the multipliers of the initial equations are among the unknowns."""
        return slice(int(self._parts[1]), int(self._parts[2]))

    @property
    def final_multipliers(self) -> slice:
        """Where those of the final equations are."""
        return slice(int(self._parts[2]), int(self._parts[3]))

    def extras(self, z: Array, rho: float) -> Array:
        """The smoothing parameter, or the first modes of the exact law."""
        return first_modes(self.functions, self.start(z)) if self.exact else np.array([rho])

    def residual(self, z: Array, rho: float) -> Array:
        """Residuals of the end conditions; raises LostError where there is no trajectory."""
        return self._shoot(z, rho, False)[0]

    def linearise(self, z: Array, rho: float) -> tuple[Array, Array]:
        """Residuals and their exact Jacobian."""
        return self._shoot(z, rho, True)

    def _shoot(self, z: Array, rho: float, derivatives: bool) -> tuple[Array, Array]:
        stop, extras, y_0 = self.final_time(z), self.extras(z, rho), self.start(z)
        if not stop > 0.0:
            raise LostError("the final time must stay positive; begin at a larger one")
        nu_0, nu_f = self.multipliers(z)
        first, first_y, first_nu = self.functions.initial_residual(y_0, nu_0, extras)
        tangents = self.tangents if derivatives else None
        y, moved, extras = self.flow(0.0, stop, y_0, extras, tangents)
        last, last_y, last_nu, last_t = self.functions.final_residual(stop, y, nu_f, extras)
        value = np.concatenate([first[self.initial_rows], last])
        if not derivatives:
            return value, np.empty((0, 0))
        jacobian = np.zeros((len(value), len(z)))
        split, b = len(self.initial_rows), self._parts[1]
        jacobian[:split, :b] = (first_y @ self.tangents)[self.initial_rows]
        jacobian[:split, self.initial_multipliers] = first_nu[self.initial_rows]
        jacobian[split:, :b] = last_y @ moved
        jacobian[split:, self.final_multipliers] = last_nu
        if self.problem.time_is_free:
            jacobian[split:, -1] = last_y @ self.functions.slopes(stop, y, extras)[0] + last_t
        return value, jacobian

    def root(self, z: Array, rho: float, goal: float, iterations: int) -> Root:
        """Solve the shooting equations at one value of the smoothing parameter."""
        return solve_equations(
            lambda u: self.residual(u, rho), lambda u: self.linearise(u, rho), z, goal, iterations
        )

"""Pontryagin networks on one domain, followed to a small smoothing parameter."""

import time
from functools import lru_cache
from typing import Literal

import numpy as np

from sailnet.errors import SailnetError
from sailnet.ocp.continuation import Schedule, follow
from sailnet.ocp.functions import ExtremalFunctions
from sailnet.ocp.newton import Root
from sailnet.ocp.ponn.bases import Basis, Chebyshev
from sailnet.ocp.ponn.network import Network
from sailnet.ocp.ponn.table import tabulate
from sailnet.ocp.ponn.training import iterative_least_squares, levenberg_marquardt
from sailnet.ocp.problem import Problem
from sailnet.ocp.smoothing import HyperbolicTangent, Smoothing
from sailnet.ocp.solution import ConvergenceError, Solution, Step
from sailnet.ocp.tangents import LostError
from sailnet.physics.arrays import Array

Training = Literal["iterative least squares", "levenberg-marquardt"]

GOAL = 1e-9
"""Mean loss of an accepted solution, unless the caller asks for less."""


@lru_cache(1)
def _network(problem: Problem, smoothing: Smoothing, basis: Basis, points: int) -> Network:
    # To make a small network takes as long as to train it, which is often done from many starts.
    return Network(problem, [ExtremalFunctions(problem, smoothing)], None, basis, points)


class Trainer:
    """One network and how it is trained at a value of the smoothing parameter.

    Args:
        problem: the problem.
        smoothing: the form of the law.
        basis: of the free functions.
        points: training points.
        training: the algorithm.
        goal: mean loss at which a network counts as trained.
        iterations: most steps at one value of the smoothing parameter.
    """

    def __init__(
        self,
        problem: Problem,
        smoothing: Smoothing,
        basis: Basis,
        points: int,
        training: Training,
        goal: float,
        iterations: int,
    ) -> None:
        if training not in ("iterative least squares", "levenberg-marquardt"):
            raise SailnetError(
                f"no training {training!r}; take iterative least squares or levenberg-marquardt"
            )
        self.problem, self.goal, self.iterations, self.training = problem, goal, iterations, training
        self.network = _network(problem, smoothing, basis, points)

    def random(self, seed: int, spread: float) -> Array:
        """Unknowns from U(0, 1): output weights, times ``spread``, multipliers, mapping coefficient."""
        rng, network = np.random.default_rng(seed), self.network
        others = rng.uniform(0.0, 1.0, network.size - network.weights[0].stop)
        return np.concatenate([spread * network.domains[0].random(rng), others])

    def near(self, solution: Solution) -> Array:
        """Unknowns whose expressions are nearest to a solution."""
        z = np.zeros(self.network.size)
        z[self.network.nu_0.start : self.network.nu_f.stop] = solution.multipliers
        if self.network.times:
            z[-1] = self.network.mapping(np.array([solution.final_time]))[0]
        return self.network.fit(z, [(0.0, solution.final_time)], solution)

    def train(self, z: Array, rho: float) -> Root:
        """Train at one value of the smoothing parameter; may raise LostError at the start."""
        network, extras = self.network, [np.array([rho])]

        def linearise(u: Array) -> tuple[Array, Array]:
            return network.linearise(u, extras)

        if self.training == "levenberg-marquardt":
            root = levenberg_marquardt(linearise, z, self.goal, self.iterations, network.mean_loss)
        else:
            root = iterative_least_squares(
                linearise, z, self.goal, self.iterations, network.mean_loss, network.times
            )
        return root

    def solve_at(self, rho: float, z: Array) -> tuple[Array, Step]:
        """One step of a continuation; its residual is the mean loss."""
        try:
            root = self.train(z, rho)
        except LostError:
            return z, Step(rho, np.inf, 0, False)
        return root.z, Step(
            rho, self.network.mean_loss(root.z, root.residual), root.iterations, root.converged
        )


def solve(
    problem: Problem,
    smoothing: Smoothing | None = None,
    schedule: Schedule | float = 1.0,
    guess: Solution | None = None,
    basis: Basis | None = None,
    points: int = 40,
    training: Training = "levenberg-marquardt",
    seed: int = 0,
    spread: float = 1.0,
    starts: int = 1,
    goal: float = GOAL,
    iterations: int = 200,
    samples: int = 200,
) -> Solution:
    """Solve a problem by a Pontryagin network.

    Args:
        problem: the problem.
        smoothing: how bang-bang and clipped controls are smoothed; not the exact law.
        schedule: smoothing parameters to follow, or one value of it.
        guess: a solution to begin from; else random output weights, as in the papers.
        basis: of the free functions; 20 Chebyshev polynomials by default.
        points: training points.
        training: "levenberg-marquardt", or "iterative least squares", which suits free final times.
        seed: of the first random start; the next has the next seed.
        spread: random output weights are drawn from U(0, spread).
        starts: most random starts.
        goal: mean absolute loss of an accepted solution. A smoothed switch narrower than the training
            points are apart costs orders of magnitude; :func:`~sailnet.ocp.ponn.split.solve` regains them.
        iterations: most training steps at one smoothing parameter.
        samples: points of the solution, at least.

    Returns:
        An extremal; its ``dynamics`` residual is the largest relative loss, at unseen points.

    Raises:
        ConvergenceError: if none was found from any start.
    """
    began = time.perf_counter()
    form, features = smoothing or HyperbolicTangent(), basis or Chebyshev()
    trainer = Trainer(problem, form, features, points, training, goal, iterations)
    if not isinstance(schedule, Schedule):
        schedule = Schedule(schedule, schedule)
    what = f"PoNN ({features.name}, {form.name}) on {problem.name}"
    failure = ConvergenceError(f"{what} was given no start; let starts be at least 1")
    for k in range(1 if guess else starts):
        z = trainer.near(guess) if guess else trainer.random(seed + k, spread)
        try:
            z, history = follow(trainer.solve_at, schedule, z, what)
        except ConvergenceError as error:
            if len(error.history) > len(failure.history):
                failure = error
            continue
        rho = history[-1].rho
        solution = tabulate(trainer.network, z, [np.array([rho])], samples)
        solution.solver, solution.rho = f"PoNN, {features.name}, {form.name}", rho
        solution.history, solution.wall_time = history, time.perf_counter() - began
        return solution
    raise failure

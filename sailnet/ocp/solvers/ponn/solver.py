"""Pontryagin networks on one domain, followed to a small smoothing parameter."""

import time
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Literal, get_args

import numpy as np

from sailnet.errors import SailnetError
from sailnet.ocp.definition.functions import ExtremalFunctions
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import HyperbolicTangent, Smoothing
from sailnet.ocp.definition.solution import ConvergenceError, Solution, Step
from sailnet.ocp.propagation.tangents import LostError
from sailnet.ocp.solvers.continuation import Schedule, follow
from sailnet.ocp.solvers.newton import Root
from sailnet.ocp.solvers.one_thread import on_one_thread
from sailnet.ocp.solvers.options import check_at_least, check_positive, check_smoothed
from sailnet.ocp.solvers.ponn.bases import Basis, Chebyshev
from sailnet.ocp.solvers.ponn.network import Network
from sailnet.ocp.solvers.ponn.table import tabulate
from sailnet.ocp.solvers.ponn.training import iterative_least_squares, levenberg_marquardt
from sailnet.physics.arrays import Array

Training = Literal["iterative least squares", "levenberg-marquardt"]

GOAL = 1e-9
"""Mean loss of an accepted solution, unless the caller asks for less."""


@dataclass(frozen=True)
class RandomWeights:
    """Output weights drawn from U(0, 1) times a factor, as in the papers.

    Attributes:
        spread: the factor.
        seed: of the first start; the next has the next seed.
        starts: most draws.

    Raises:
        SailnetError: there is no draw.
    """

    spread: float = 1.0
    seed: int = 0
    starts: int = 1

    def __post_init__(self) -> None:
        check_at_least(self, 1, "starts")


@dataclass(frozen=True)
class Options:
    """How a network is built and trained.

    Attributes:
        smoothing: how bang-bang and clipped controls are smoothed; not the exact law.
        schedule: smoothing parameters to follow, or one value of it.
        basis: of the free functions.
        points: training points.
        training: "levenberg-marquardt", or "iterative least squares", which suits free final times.
        goal: mean absolute loss of an accepted solution. A smoothed switch narrower than the training
            points are apart costs orders of magnitude, which
            :func:`~sailnet.ocp.solvers.ponn.split.solve` regains.
        iterations: most training steps at one smoothing parameter.
        samples: points of the solution, at least.

    Raises:
        SailnetError: a number that makes no sense, an unknown training, or the exact law.
    """

    smoothing: Smoothing = field(default_factory=HyperbolicTangent)
    schedule: Schedule | float = 1.0
    basis: Basis = field(default_factory=Chebyshev)
    points: int = 40
    training: Training = "levenberg-marquardt"
    goal: float = GOAL
    iterations: int = 200
    samples: int = 200

    def __post_init__(self) -> None:
        check_smoothed(self)
        check_positive(self, "goal")
        check_at_least(self, 1, "iterations", "samples")
        if self.training not in get_args(Training):
            raise SailnetError(f"no training {self.training!r}; take {' or '.join(get_args(Training))}")


@lru_cache(1)
def _network(problem: Problem, smoothing: Smoothing, basis: Basis, points: int) -> Network:
    # To make a small network takes as long as to train it, which is often done from many starts.
    return Network(problem, [ExtremalFunctions(problem, smoothing)], None, basis, points)


class Trainer:
    """One network and how it is trained at a value of the smoothing parameter.

    Args:
        problem: the problem.
        options: what the network is made of, and how it is trained.
    """

    def __init__(self, problem: Problem, options: Options) -> None:
        self.options = options
        self.network = _network(problem, options.smoothing, options.basis, options.points)

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
        network, options, extras = self.network, self.options, [np.array([rho])]

        def linearise(u: Array) -> tuple[Array, Array]:
            return network.linearise(u, extras)

        goal, iterations = options.goal, options.iterations
        if options.training == "levenberg-marquardt":
            return levenberg_marquardt(linearise, z, goal, iterations, network.mean_loss)
        return iterative_least_squares(linearise, z, goal, iterations, network.mean_loss, network.times)

    def solve_at(self, rho: float, z: Array) -> tuple[Array, Step]:
        """One step of a continuation; its residual is the mean loss."""
        try:
            root = self.train(z, rho)
        except LostError:
            return z, Step(rho, np.inf, 0, False)
        return root.z, Step(
            rho, self.network.mean_loss(root.z, root.residual), root.iterations, root.converged
        )


@on_one_thread
def solve(
    problem: Problem, guess: Solution | RandomWeights | None = None, *, options: Options | None = None
) -> Solution:
    """Solve a problem by a Pontryagin network.

    Args:
        problem: the problem.
        guess: a solution to begin from, or random output weights, which are the default.
        options: how.

    Returns:
        An extremal; its ``dynamics`` residual is the largest relative loss, at unseen points.

    Raises:
        ConvergenceError: if none was found from any start.
        SailnetError: if there are more weights than losses.
    """
    began = time.perf_counter()
    options, guess = options or Options(), guess or RandomWeights()
    trainer = Trainer(problem, options)
    form, features = options.smoothing, options.basis
    what = f"PoNN ({features.name}, {form.name}) on {problem.name}"
    failure = ConvergenceError(f"{what} was given no start")
    for k in range(guess.starts if isinstance(guess, RandomWeights) else 1):
        if isinstance(guess, RandomWeights):
            z = trainer.random(guess.seed + k, guess.spread)
        else:
            z = trainer.near(guess)
        try:
            z, history = follow(trainer.solve_at, Schedule.of(options.schedule), z, what)
        except ConvergenceError as error:
            if len(error.history) > len(failure.history):
                failure = error
            continue
        rho = history[-1].rho
        solution = tabulate(trainer.network, z, [np.array([rho])], options.samples)
        solution.solver, solution.rho = f"PoNN, {features.name}, {form.name}", rho
        solution.history, solution.wall_time = history, time.perf_counter() - began
        return solution
    raise failure

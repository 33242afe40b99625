"""The domain split at its switches: what the papers leave as future work.

Between two switches the exact control is smooth, so expressions there converge as fast as their basis
does. States and costates at the switches are unknowns that both neighbours take as end values, and so
continuous for any weights; the mapping coefficient of every domain is an unknown, too.
"""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.solution import ConvergenceError, Solution, Step
from sailnet.ocp.propagation.switching import structure_of
from sailnet.ocp.propagation.tangents import LostError
from sailnet.ocp.solvers.arcs import LAWFUL, Arcs
from sailnet.ocp.solvers.one_thread import on_one_thread
from sailnet.ocp.solvers.options import check_at_least, check_positive
from sailnet.ocp.solvers.ponn.bases import Basis, Chebyshev
from sailnet.ocp.solvers.ponn.network import Network
from sailnet.ocp.solvers.ponn.table import tabulate
from sailnet.ocp.solvers.ponn.training import iterative_least_squares, levenberg_marquardt
from sailnet.physics.arrays import Array

GOAL = 1e-9
"""Mean loss of an accepted solution."""

FULL_STEPS = 30
"""Most undamped steps before damped ones are tried."""


@dataclass(frozen=True)
class Options:
    """How the networks of all arcs are built and trained.

    Attributes:
        structure: (time of begin, letters) of every arc, as :mod:`~sailnet.ocp.solvers.arcs` has them; None
            reads it off the guess, with no singular arcs.
        order: of singular arcs.
        basis: of the free functions.
        points: training points of every arc.
        goal: mean absolute loss of an accepted solution.
        iterations: most training steps.
        samples: points of the solution, at least.

    Raises:
        SailnetError: a number that makes no sense.
    """

    structure: Sequence[tuple[float, str]] | None = None
    order: int = 1
    basis: Basis = field(default_factory=Chebyshev)
    points: int = 40
    goal: float = GOAL
    iterations: int = 200
    samples: int = 200

    def __post_init__(self) -> None:
        check_positive(self, "goal")
        check_at_least(self, 1, "order", "iterations", "samples")


@on_one_thread
def solve(problem: Problem, guess: Solution, *, options: Options | None = None) -> Solution:
    """Solve the limit problem by a network on every arc of a given structure.

    Args:
        problem: the problem.
        guess: a smoothed solution near it.
        options: how.

    Raises:
        ConvergenceError: if there is no solution of this structure near the guess.
    """
    began = time.perf_counter()
    options = options or Options()
    goal, iterations = options.goal, options.iterations
    chosen = list(options.structure or structure_of(problem, guess, singular=False))
    words = [word for _, word in chosen]
    arcs, features = Arcs(problem, words, options.order), options.basis
    functions = [flow.functions for flow in arcs.flows]
    network = Network(problem, functions, arcs.conditions, features, options.points)
    edges = np.array([*(begin for begin, _ in chosen), guess.final_time])
    z, extras = _near(network, guess, edges), arcs.modes
    what = f"split PoNN {' '.join(words)} on {problem.name}"

    def linearise(u: Array) -> tuple[Array, Array]:
        return network.linearise(u, extras)

    try:
        # From a near guess full steps take some six iterations; the damped ones creep along the valley in
        # which the times of the switches lie.
        root = iterative_least_squares(linearise, z, goal, min(iterations, FULL_STEPS), network.mean_loss)
        if not root.converged:
            root = levenberg_marquardt(linearise, z, goal, iterations, network.mean_loss)
    except LostError as error:
        raise ConvergenceError(f"{what}: the guess itself fails; give a nearer one") from error
    step = Step(0.0, network.mean_loss(root.z, root.residual), root.iterations, root.converged)
    if not root.converged:
        raise ConvergenceError(
            f"{what} cannot be trained; another structure or more neurons may",
            {"mean": step.residual},
            [step],
        )
    sweep = network.sweep(root.z)
    broken = max(arcs.violation(k, t, y) for k, (t, y) in enumerate(zip(sweep.clock, sweep.y, strict=True)))
    if broken > LAWFUL:
        raise ConvergenceError(
            f"{what} meets its equations and not the control law; another structure may",
            {"mean": step.residual, "law": broken},
            [step],
        )
    solution = tabulate(network, root.z, extras, options.samples)
    solution.solver = f"split PoNN, {features.name}"
    durations, _ = network.durations(root.z)
    times = np.cumsum(2.0 * durations)[:-1]
    solution.switches = arcs.switches(times)
    solution.message = "arcs " + " ".join(words)
    solution.history, solution.wall_time = [step], time.perf_counter() - began
    return solution


def _near(network: Network, guess: Solution, edges: Array) -> Array:
    """Unknowns whose expressions are nearest to a guess on every arc."""
    z = np.zeros(network.size)
    z[network.nu_0.start : network.nu_f.stop] = guess.multipliers
    if network.times:
        z[-network.times :] = network.mapping(np.diff(edges))
    return network.fit(z, list(pairwise(edges)), guess)

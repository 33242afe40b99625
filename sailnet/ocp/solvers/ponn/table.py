"""Trained networks as solutions: sampled, their cost integrated, their losses measured at unseen points."""

from functools import cache, lru_cache

import numpy as np

from sailnet.ocp.definition.functions import ProblemFunctions
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.solution import Solution
from sailnet.ocp.propagation.switching import zero_crossings
from sailnet.ocp.propagation.tabulate import joined, largest
from sailnet.ocp.solvers.ponn.network import Network
from sailnet.ocp.solvers.ponn.training import mean_loss
from sailnet.physics.arrays import Array

UNSEEN = 2
"""Gauss points a training point, for the cost and for the losses where nothing was trained."""


@lru_cache(16)
def _own_functions(problem: Problem) -> ProblemFunctions:
    return ProblemFunctions(problem)


@cache
def gauss(nodes: int) -> tuple[Array, Array]:
    """Nodes and weights of Gauss's quadrature."""
    points, weights = np.polynomial.legendre.leggauss(nodes)
    return points, weights


def gauss_points(count: int) -> Array:
    """Nodes of Gauss's quadrature."""
    return gauss(count)[0]


def uniform(count: int) -> Array:
    """Evenly spaced points, the ends among them."""
    return np.linspace(-1.0, 1.0, count)


def tabulate(network: Network, z: Array, extras: list[Array], samples: int) -> Solution:
    """The solution of these unknowns; where two domains meet, both sides are given."""
    problem, functions, n = network.problem, network.functions, network.n2 // 2
    count = UNSEEN * len(network.domains[0].training.z)
    weight = gauss(count)[1]
    unseen = network.sweep(z, [domain.sampled(gauss_points, count) for domain in network.domains])
    losses = network.losses(unseen, extras)
    half, _ = network.durations(z)
    stop = 2.0 * float(half.sum())
    parts, cost, worst = [], 0.0, 0.0
    counts = [max(3, round(samples * 2.0 * h / stop)) for h in half]
    shown = network.sweep(
        z, [domain.sampled(uniform, m) for domain, m in zip(network.domains, counts, strict=True)]
    )
    for k, f in enumerate(functions):
        clock, y = unseen.clock[k], unseen.y[k]
        cost += float(half[k] * weight @ f.running_cost(clock, y, extras[k]))
        worst = max(worst, float(np.max(np.abs(losses[k]) / (1.0 + np.abs(unseen.rates[k])))))
        parts.append(f.table(shown.clock[k], shown.y[k], extras[k]))
    table = joined(parts)
    last = shown.y[-1][-1]
    cost += float(_own_functions(problem).terminal_cost(stop, last[None, :n])[0])
    first, final = functions[0], functions[-1]
    ends = np.concatenate(
        [
            first.initial_residual(shown.y[0][0], z[network.nu_0], extras[0])[0],
            final.final_residual(stop, last, z[network.nu_f], extras[-1])[0],
        ]
    )
    trained = network.losses(network.sweep(z), extras)
    return Solution(
        problem=problem.name,
        solver="PoNN",
        **table,
        cost=cost,
        residuals={
            **largest(ends, [*first.ends.initial_kinds, *final.ends.final_kinds]),
            "dynamics": worst,
            "mean loss": mean_loss(np.concatenate([loss.ravel() for loss in trained])),
        },
        switches=zero_crossings(problem, table["time"], table["switching"]),
        names=problem.names,
        multipliers=z[network.nu_0.start : network.nu_f.stop],
        message=f"{len(network.domains)} domains of {network.domains[0].basis.name}",
    )

"""Extremals as tables: arcs flown one after the other, sampled evenly in time."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sailnet.ocp.definition.functions import ProblemFunctions
from sailnet.ocp.definition.solution import Table
from sailnet.ocp.propagation.flow import Flow
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class Arc:
    """A stretch of an extremal under one form of the law, its modes held.

    Attributes:
        flow: what propagates it.
        extras: smoothing parameter, or modes.
        stop: when it ends.
    """

    flow: Flow
    extras: Array
    stop: float


def tabulate(arcs: Sequence[Arc], y: Array, samples: int) -> tuple[Table, float]:
    """Fly arcs from t = 0 on; where two meet, both sides are given.

    Args:
        arcs: in the order of time.
        y: (2n,) states and costates at t = 0.
        samples: points in all, at least; every arc has three.

    Returns:
        The columns of a solution, and its cost.
    """
    parts, start, cost, final = [], 0.0, 0.0, arcs[-1].stop
    for arc in arcs:
        count = max(3, round(samples * (arc.stop - start) / final))
        clock = np.linspace(start, arc.stop, count)
        rows, running = arc.flow.sample(clock, y, arc.extras)
        parts.append(arc.flow.functions.table(clock, rows, arc.extras))
        start, y, cost = arc.stop, rows[-1], cost + running
    table = joined(parts)
    problem = arcs[-1].flow.functions.problem
    cost += float(ProblemFunctions(problem).terminal_cost(final, table["state"][-1:])[0])
    return table, cost


def joined(parts: Sequence[Table]) -> Table:
    """The columns of parts of a solution, one after the other."""
    return Table(
        time=np.concatenate([part["time"] for part in parts]),
        state=np.concatenate([part["state"] for part in parts]),
        costate=np.concatenate([part["costate"] for part in parts]),
        control=np.concatenate([part["control"] for part in parts]),
        switching=np.concatenate([part["switching"] for part in parts]),
        hamiltonian=np.concatenate([part["hamiltonian"] for part in parts]),
    )


def largest(residual: Array, kinds: Sequence[str]) -> dict[str, float]:
    """The largest residual of every kind."""
    named = np.array(kinds)
    return {kind: float(np.abs(residual[named == kind]).max()) for kind in dict.fromkeys(kinds)}

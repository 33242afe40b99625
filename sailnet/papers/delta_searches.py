"""The delta method on all problems of paper 004: bases against heuristics on equal numbers of evaluations."""

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from sailnet.ocp.solvers.delta import (
    Basis,
    Chebyshev,
    CmaEs,
    Fourier,
    GaPso,
    Heuristic,
    Imperialist,
    Legendre,
    Options,
    Polish,
    RandomSeries,
)
from sailnet.ocp.solvers.delta.method import Delta, Found
from sailnet.ocp.solvers.delta.options import GOAL
from sailnet.ocp.solvers.delta.table import tabulate
from sailnet.papers.delta import REFERENCES

TERMS: Mapping[str, int] = {
    "lunar-landing": 6,
    "asteroid-rendezvous": 7,
    "leo-geo-time": 8,
    "leo-geo-fuel": 8,
}
"""Terms of each series: the paper's own, and as many as the angles of our LEO-GEO transfers ask for."""

BASES: Sequence[Basis] = (Fourier(), Chebyshev(), Legendre())

HEURISTICS: Sequence[Heuristic] = (GaPso(), Imperialist(), CmaEs())

ALONE, POLISHED, RESTARTED = "alone", "polished", "restarted"
"""Methods: the paper's; its best point polished, by flights beyond its own; eight short searches in a quarter
of the paper's box, each polished, by no more flights than the paper's method has."""

NODES, STAGES, RESTARTS, BOX, SPACING = 60, 4, 8, 0.25, 100
"""Intervals of a flight; stages of the paper's method; searches and box of RESTARTED; between seeds."""

POLISH = Polish(evaluations=500)


@dataclass(frozen=True)
class Entry:
    """What one method made of one problem.

    Attributes:
        problem, basis, heuristic, method, seed: what was searched, and how.
        evaluations: flights; of POLISHED with those of ALONE.
        converged: whether the best one ends within GOAL of where it must.
        end_error: its largest error at the end, in the problem's units.
        cost: its cost; of a flight that misses its end it means little.
        reference: the optimal cost, by shooting.
        final_time, reference_time: in the problem's units.
        switches, reference_switches: their times.
        criteria: delta_s_h, delta_s_i, delta_u and delta_h.
        point: the coefficients of the series, and of the final time if it is free.
        history: (evaluations, least J_total) at up to ten moments.
        cpu_seconds: of the processor.
    """

    problem: str
    basis: str
    heuristic: str
    method: str
    seed: int
    evaluations: int
    converged: bool
    end_error: float
    cost: float
    reference: float
    final_time: float
    reference_time: float
    switches: list[float]
    reference_switches: list[float]
    criteria: dict[str, float]
    point: list[float]
    history: list[tuple[int, float]]
    cpu_seconds: float

    @property
    def key(self) -> tuple[str, str, str, str, int]:
        """What distinguishes it from every other."""
        return self.problem, self.basis, self.heuristic, self.method, self.seed

    @property
    def cost_error(self) -> float:
        """Cost above the optimum, relative to its size."""
        return (self.cost - self.reference) / abs(self.reference)


def entry(
    problem: str,
    basis: Basis,
    heuristic: Heuristic,
    method: str,
    evaluations: int,
    seed: int,
    begun: Entry | None = None,
) -> Entry | None:
    """One entry; None if not one of its flights has a finite cost.

    Args:
        problem: its name.
        basis: of the series.
        heuristic: that searches.
        method: ALONE, POLISHED or RESTARTED.
        evaluations: of ALONE, and most of RESTARTED.
        seed: of the heuristic.
        begun: for POLISHED, the entry of ALONE that it begins at.
    """
    reference = REFERENCES[problem].solve()
    options = Options(basis, heuristic, TERMS[problem], NODES, evaluations, STAGES)
    guess = RandomSeries(seed=SPACING * seed)
    if method == RESTARTED:
        options = replace(options, stages=1, polish=POLISH)
        guess = replace(guess, box=BOX, searches=RESTARTS)
    delta = Delta(REFERENCES[problem].problem(), options)
    busy = time.process_time()
    if method == POLISHED:
        assert begun is not None
        made = POLISH.run(delta.judge, np.array(begun.point), NODES)
        found = Found(made.point, begun.evaluations + made.evaluations, [])
    else:
        found = delta.search(guess)
    if not len(found.point):
        return None
    busy = time.process_time() - busy + (begun.cpu_seconds if begun else 0.0)
    solution, stride = tabulate(delta, found.point), max(1, len(found.history) // 10)
    return Entry(
        problem=problem,
        basis=basis.name,
        heuristic=heuristic.name,
        method=method,
        seed=seed,
        evaluations=found.evaluations,
        converged=solution.residuals["boundary"] <= GOAL,
        end_error=solution.residuals["boundary"],
        cost=solution.cost,
        reference=reference.cost,
        final_time=solution.final_time,
        reference_time=reference.final_time,
        switches=[switch.time for switch in solution.switches],
        reference_switches=[switch.time for switch in reference.switches],
        criteria={kind: value for kind, value in solution.residuals.items() if kind.startswith("delta_")},
        point=found.point.tolist(),
        history=[(step.iterations, step.residual) for step in found.history[::stride]],
        cpu_seconds=busy,
    )


def entries(
    evaluations: int, seeds: int, made: Sequence[Entry] = (), problems: Sequence[str] = tuple(TERMS)
) -> Iterator[Entry]:
    """All entries, those made already among them."""
    known = {one.key: one for one in made}
    for seed in range(seeds):
        for problem in problems:
            for heuristic in HEURISTICS:
                for basis in BASES:
                    begun: Entry | None = None
                    for method in (ALONE, POLISHED, RESTARTED):
                        key = problem, basis.name, heuristic.name, method, seed
                        if method == POLISHED and begun is None:
                            continue
                        before = begun if method == POLISHED else None
                        one = known.get(key) or entry(
                            problem, basis, heuristic, method, evaluations, seed, before
                        )
                        begun = one if method == ALONE else begun
                        if one is not None:
                            yield one

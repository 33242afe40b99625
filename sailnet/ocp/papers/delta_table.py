"""Table 2 of paper 004 for all its problems: bases against heuristics on equal numbers of evaluations.

python -m sailnet.ocp.papers.delta_table benchmarks/delta_table2.json --readme sailnet/ocp/README.md
"""

import argparse
import json
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from sailnet.artefacts.files import fill_block, write_whole
from sailnet.artefacts.provenance import software
from sailnet.ocp.delta import (
    Basis,
    Chebyshev,
    CmaEs,
    Fourier,
    GaPso,
    Heuristic,
    Imperialist,
    Legendre,
    Polish,
    Weights,
)
from sailnet.ocp.delta.solver import GOAL, Delta, Found, flown, restarted
from sailnet.ocp.papers.delta import REFERENCES

PRINTED_SECONDS: Mapping[tuple[str, str], float] = {
    ("Fourier", "GA-PSO"): 91.73,
    ("Legendre", "GA-PSO"): 187.16,
    ("Chebyshev", "GA-PSO"): 145.89,
    ("Fourier", "ICA"): 268.05,
}
"""Table 2, of the lunar landing; on an unnamed machine, by unprinted numbers of evaluations."""

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
    delta = Delta(REFERENCES[problem].problem(), basis, TERMS[problem], NODES)
    busy = time.process_time()
    if method == POLISHED:
        assert begun is not None
        made = POLISH.run(delta.judge, np.array(begun.point), NODES)
        found = Found(made.point, begun.evaluations + made.evaluations, [])
    elif method == RESTARTED:
        found = restarted(delta, heuristic, evaluations, SPACING * seed, Weights(), 1, POLISH, RESTARTS, BOX)
    else:
        found = restarted(delta, heuristic, evaluations, SPACING * seed, Weights(), STAGES)
    if not len(found.point):
        return None
    busy = time.process_time() - busy + (begun.cpu_seconds if begun else 0.0)
    solution, stride = flown(delta, found.point), max(1, len(found.history) // 10)
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


def markdown(found: Sequence[Entry], origin: Mapping[str, str]) -> str:
    """A row for each problem, heuristic and basis; of every method the median over seeds.

    Args:
        found: the entries.
        origin: of their file, with machine, date and revision.
    """
    seeds = len({one.seed for one in found})
    lines = [
        f"Written by `python -m sailnet.ocp.papers.delta_table` on {origin['machine']}, {origin['date']},"
        f" revision {origin['revision']}; {seeds} seeds.",
        "",
        "| problem | heuristic | basis | "
        + " | ".join(f"{method}: ends met, end error, cost" for method in (ALONE, POLISHED, RESTARTED))
        + " | flights | CPU s | paper's s |",
        "| --- " * 9 + "|",
    ]
    for problem in TERMS:
        for heuristic in HEURISTICS:
            for basis in BASES:
                those = [
                    one
                    for one in found
                    if (one.problem, one.heuristic, one.basis) == (problem, heuristic.name, basis.name)
                ]
                if not those:
                    continue
                by_method = [
                    [one for one in those if one.method == method] for method in (ALONE, POLISHED, RESTARTED)
                ]
                seconds = PRINTED_SECONDS.get((basis.name, heuristic.name))
                cells = [
                    problem,
                    heuristic.name,
                    basis.name,
                    *map(_cell, by_method),
                    ", ".join(
                        f"{np.median([one.evaluations for one in group]):.0f}" for group in by_method if group
                    ),
                    ", ".join(
                        f"{np.median([one.cpu_seconds for one in group]):.1f}" for group in by_method if group
                    ),
                    f"{seconds}" if seconds and problem == "lunar-landing" else "",
                ]
                lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _cell(group: Sequence[Entry]) -> str:
    if not group:
        return ""
    met = [one for one in group if one.converged]
    error = f"{np.median([one.end_error for one in group]):.0e}"
    if not met:
        return f"0 of {len(group)}, {error}"
    cost = 100.0 * float(np.median([one.cost_error for one in met]))
    return f"{len(met)} of {len(group)}, {error}, " + ("0 %" if abs(cost) < 1e-4 else f"{cost:+.2g} %")


def main() -> None:
    """Make the table; what its file holds already is not made again."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path, help="JSON file to write")
    parser.add_argument("--readme", type=Path, help="text whose block <!-- delta --> becomes the table")
    parser.add_argument("--evaluations", type=int, default=10_000)
    parser.add_argument("--seeds", type=int, default=3)
    arguments = parser.parse_args()
    held = json.loads(arguments.out.read_text()) if arguments.out.exists() else {"origin": {}, "entries": []}
    made, origin = [Entry(**one) for one in held["entries"]], held["origin"]
    kept, found = {one.key: one for one in made}, list[Entry]()
    for one in entries(arguments.evaluations, arguments.seeds, made):
        found.append(one)
        if one.key in kept:
            continue
        kept[one.key], origin = one, software()
        lines = ",\n".join(json.dumps(asdict(each)) for each in kept.values())
        text = f'{{"origin": {json.dumps(origin)}, "entries": [\n{lines}\n]}}\n'
        write_whole(arguments.out, lambda path, text=text: path.write_text(text))  # type: ignore[misc]
        print(
            f"{one.seed} {one.problem:20} {one.basis:10} {one.heuristic:7} {one.method:10}"
            f" end {one.end_error:.1e} cost {one.cost:.6f} {one.cost_error:+.1e} {one.cpu_seconds:.1f} s",
            flush=True,
        )
    if arguments.readme:
        fill_block(arguments.readme, "delta", markdown(found, origin))


if __name__ == "__main__":
    main()

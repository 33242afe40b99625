"""Table 2 of paper 004 for all its problems: bases against heuristics on equal numbers of evaluations.

python -m sailnet.ocp.papers.delta_table table2.json --evaluations 20000
"""

import argparse
import json
import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from sailnet.files import write_whole
from sailnet.ocp.delta import (
    Basis,
    Chebyshev,
    CmaEs,
    Fourier,
    GaPso,
    Heuristic,
    Imperialist,
    Legendre,
    solve,
)
from sailnet.ocp.delta.solver import GOAL
from sailnet.ocp.papers.delta import REFERENCES
from sailnet.ocp.solution import ConvergenceError

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


@dataclass(frozen=True)
class Entry:
    """One search.

    Attributes:
        problem, basis, heuristic: what was searched, and how.
        evaluations: flights.
        converged: whether the best one ends within GOAL of where it must.
        end_error: its largest error at the end, in the problem's units.
        cost: its cost; of a flight that misses its end it means little.
        reference: the optimal cost, by shooting.
        cost_error: relative difference of the two.
        final_time, reference_time: in the problem's units.
        switches, reference_switches: their times.
        criteria: delta_s_h, delta_s_i, delta_u and delta_h.
        history: (evaluations, least J_total) at up to twenty moments.
        seconds: wall time.
        cpu_seconds: of the processor.
        paper_seconds: Table 2's, where it has an entry.
    """

    problem: str
    basis: str
    heuristic: str
    evaluations: int
    converged: bool
    end_error: float
    cost: float
    reference: float
    cost_error: float
    final_time: float
    reference_time: float
    switches: list[float]
    reference_switches: list[float]
    criteria: dict[str, float]
    history: list[tuple[int, float]]
    seconds: float
    cpu_seconds: float
    paper_seconds: float | None


def entry(problem: str, basis: Basis, heuristic: Heuristic, evaluations: int, seed: int) -> Entry | None:
    """One search; None if not one of its flights has a finite cost."""
    posed, reference = REFERENCES[problem].problem(), REFERENCES[problem].solve()
    began, busy = time.perf_counter(), time.process_time()
    try:
        found = solve(
            posed,
            basis,
            heuristic,
            evaluations,
            seed,
            TERMS[problem],
            goal=math.inf,
        )
    except ConvergenceError:
        return None
    busy = time.process_time() - busy
    stride = max(1, len(found.history) // 20)
    return Entry(
        problem=problem,
        basis=basis.name,
        heuristic=heuristic.name,
        evaluations=found.history[-1].iterations,
        converged=found.residuals["boundary"] <= GOAL,
        end_error=found.residuals["boundary"],
        cost=found.cost,
        reference=reference.cost,
        cost_error=found.cost / reference.cost - 1.0,
        final_time=found.final_time,
        reference_time=reference.final_time,
        switches=[switch.time for switch in found.switches],
        reference_switches=[switch.time for switch in reference.switches],
        criteria={kind: value for kind, value in found.residuals.items() if kind.startswith("delta_")},
        history=[(step.iterations, step.residual) for step in found.history[::stride]],
        seconds=time.perf_counter() - began,
        cpu_seconds=busy,
        paper_seconds=PRINTED_SECONDS.get((basis.name, heuristic.name))
        if problem == "lunar-landing"
        else None,
    )


def table2(
    out: Path,
    evaluations: int = 20_000,
    seed: int = 0,
    problems: Sequence[str] = tuple(TERMS),
    bases: Sequence[Basis] = BASES,
    heuristics: Sequence[Heuristic] = HEURISTICS,
) -> list[Entry]:
    """Search every problem with every basis and heuristic; the file is written anew after each.

    Args:
        out: JSON file, a list of entries.
        evaluations: flights of every search.
        seed: of every search.
        problems: names.
        bases, heuristics: to be compared.
    """
    found: list[Entry] = []
    for problem in problems:
        for heuristic in heuristics:
            for basis in bases:
                made = entry(problem, basis, heuristic, evaluations, seed)
                if made is not None:
                    found.append(made)
                    text = json.dumps([asdict(one) for one in found], indent=1) + "\n"
                    write_whole(out, lambda path, text=text: path.write_text(text))  # type: ignore[misc]
    return found


def main() -> None:
    """Write the table and print it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path, help="JSON file to write")
    parser.add_argument("--evaluations", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    for one in table2(arguments.out, arguments.evaluations, arguments.seed):
        print(
            f"{one.problem:20} {one.basis:10} {one.heuristic:7} end {one.end_error:.1e}"
            f" cost {one.cost:.6f} of {one.reference:.6f} {one.cpu_seconds:.1f} s"
        )


if __name__ == "__main__":
    main()

"""Table 2 of paper 004 for all its problems: bases against heuristics on equal numbers of evaluations.

python -m sailnet.papers.delta_table benchmarks/delta_table2.json --readme sailnet/papers/RESULTS.md
"""

import argparse
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np

from sailnet.artefacts.files import fill_block, write_text
from sailnet.artefacts.provenance import software
from sailnet.papers.delta_searches import ALONE, BASES, HEURISTICS, POLISHED, RESTARTED, TERMS, Entry, entries

PRINTED_SECONDS: Mapping[tuple[str, str], float] = {
    ("Fourier", "GA-PSO"): 91.73,
    ("Legendre", "GA-PSO"): 187.16,
    ("Chebyshev", "GA-PSO"): 145.89,
    ("Fourier", "ICA"): 268.05,
}
"""Table 2, of the lunar landing; on an unnamed machine, by unprinted numbers of evaluations."""

NEAR = 2e-3
"""Cost above the optimum, relative to its size, up to which a search has found it."""


def markdown(found: Sequence[Entry], origin: Mapping[str, str]) -> str:
    """A row for each problem, heuristic and basis; of every method the median over seeds.

    Args:
        found: the entries.
        origin: of their file, with machine, date and revision.
    """
    seeds = len({one.seed for one in found})
    lines = [
        f"Written by `python -m sailnet.papers.delta_table` on {origin['machine']}, {origin['date']},"
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


def counted(found: Sequence[Entry]) -> str:
    """Of all searches of a problem by each method: how many arrive, and how many near the optimum."""
    lines = [
        f"| method: searches that arrive (within 0.2 % of the optimum) | {' | '.join(TERMS)} |",
        "| --- " * 5 + "|",
    ]
    for method in (ALONE, POLISHED, RESTARTED):
        cells = []
        for problem in TERMS:
            those = [one for one in found if (one.problem, one.method) == (problem, method)]
            met = [one for one in those if one.converged]
            near = sum(one.cost_error < NEAR for one in met)
            cells.append(f"{len(met)} ({near}) of {len(those)}")
        lines.append(f"| {method} | {' | '.join(cells)} |")
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
        write_text(arguments.out, text)
        print(
            f"{one.seed} {one.problem:20} {one.basis:10} {one.heuristic:7} {one.method:10}"
            f" end {one.end_error:.1e} cost {one.cost:.6f} {one.cost_error:+.1e} {one.cpu_seconds:.1f} s",
            flush=True,
        )
    if arguments.readme:
        fill_block(arguments.readme, "delta", f"{markdown(found, origin)}\n\n{counted(found)}")


if __name__ == "__main__":
    main()

"""The benchmark's figures: ratios, an aligned table, the same in Markdown."""

from collections.abc import Mapping, Sequence

from c_runtime.builds import PRECISIONS
from c_runtime.verification.bench.emlearn_c import EMLEARN
from c_runtime.verification.bench.exported_c import SSE2
from c_runtime.verification.bench.onnxruntime_c import ONNXRUNTIME_C
from c_runtime.verification.bench.python_peers import ONNXRUNTIME
from c_runtime.verification.bench.rounds import Row

EXPORTED = "exported C"
"""The flight file."""

ON_VECTORS = f"{EXPORTED}, on vectors"
"""Its form for hosts."""

HEADINGS = ("one command", "precision", "min", "median", "min", "median")
OVER = ("", "", "in a chain [ns]", "", "back to back [ns]", "")
COLUMNS = ("min_ns", "median_ns", "back_to_back_min_ns", "back_to_back_median_ns")

NOTE = (
    "In a chain each command waits for the one before, as in flight; back to back a processor may begin the "
    "next one early. emlearn and onnx2c's three networks get approach coordinates ready-made, and have "
    "neither guard nor safety from NaN."
)


def ratios(rows: Sequence[Row]) -> dict[str, float]:
    """How many times as long others take as the exported C on vectors, native: by the minima in a chain.

    emlearn's fastest build counts, in single precision as it is.
    """
    own = {str(row["precision"]): row for row in rows if row["what"] == ON_VECTORS}
    others = (ONNXRUNTIME_C, ONNXRUNTIME, f"{ON_VECTORS}, {SSE2}", EXPORTED)
    groups = {
        "emlearn": [row for row in rows if str(row["what"]).startswith(EMLEARN)],
        **{what: [row for row in rows if row["what"] == what] for what in others},
    }
    found = {}
    for name, group in groups.items():
        for precision in PRECISIONS:
            times = [float(row["min_ns"]) for row in group if row["precision"] == precision]
            if times and precision in own:
                found[f"{name}, {precision}"] = min(times) / float(own[precision]["min_ns"])
    return found


def _cells(row: Row) -> list[str]:
    times = (f"{float(row[name]):,.0f}" if name in row else "" for name in COLUMNS)
    return [str(row["what"]), str(row["precision"]), *times]


def text_table(rows: Sequence[Row]) -> str:
    """Aligned columns."""
    table = [list(OVER), list(HEADINGS), *(_cells(row) for row in rows)]
    widths = [max(len(line[i]) for line in table[1:]) for i in range(len(HEADINGS))]
    widths[2:] = [max(width, 8) for width in widths[2:]]
    lines = []
    for line in table:
        cells = [cell.ljust(width) for cell, width in zip(line[:2], widths[:2], strict=True)]
        if line is table[0]:
            pairs = (widths[2] + widths[3] + 2, widths[4] + widths[5] + 2)
            cells += [line[2].rjust(pairs[0]), line[4].rjust(pairs[1])]
        else:
            cells += [cell.rjust(width) for cell, width in zip(line[2:], widths[2:], strict=True)]
        lines.append("  ".join(cells).rstrip())
    return "\n".join(lines)


def text_ratios(found: Mapping[str, float]) -> str:
    """One a line."""
    return "\n".join(f"{name:<32}{ratio:>8.1f} times {ON_VECTORS}" for name, ratio in found.items())


def markdown(origin: Mapping[str, str], rows: Sequence[Row], notes: Sequence[str]) -> str:
    """What ``--readme`` writes."""
    lines = [
        f"Written by `python -m c_runtime.verification.bench` on {origin['machine']}, {origin['date']}, "
        f"revision {origin['revision']}, {origin['compiler']}, `{origin['flags']}`, native where no set of "
        f"instructions is named; nanoseconds, {origin['batches']} batches. {NOTE}",
        "",
        "| one command | precision | chain: min | median | back to back: min | median |",
        "|---|---|---:|---:|---:|---:|",
        *("| " + " | ".join(_cells(row)) + " |" for row in rows),
        "",
        f"| times as long as the {ON_VECTORS}, native | |",
        "|---|---:|",
        *(f"| {name} | {ratio:.1f} |" for name, ratio in ratios(rows).items()),
        *(["", *(f"- {note}" for note in notes)] if notes else []),
    ]
    return "\n".join(lines)

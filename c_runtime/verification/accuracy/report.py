"""The accuracy's figures as tables."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from c_runtime.verification.accuracy.errors import KEPT, QUANTITIES

Found = dict[str, Any]
"""What the command prints as JSON."""

LABELS = {
    "size": "cone angle, size [rad]",
    "time_of_flight": "time of flight [TU]",
    "time_of_flight_per_s": "time of flight / s",
}

NOTE = (
    "Both sides get the same inputs, rounded to the C's precision. Errors of the cone angle are of its size: "
    "its sign is that of lambda_v, and where rounding decides it otherwise the state counts as a flip, with "
    "the largest |lambda_v| among them (output of the network). s is the scale of approach coordinates."
)

Table = tuple[str, list[str], list[list[str]]]


def _tables(found: Found) -> list[Table]:
    tables: list[Table] = []
    for kind, by_build in found["kinds"].items():
        states = min(record["states"] for record in by_build.values())
        beta = max(record["beta"] for record in by_build.values())
        heading = ["build", "quantity", "largest", "99.9 %", "median", "flips", "|lambda_v| there"]
        rows = []
        for name, record in by_build.items():
            for quantity in QUANTITIES:
                error = record[quantity]
                cells = [_short(error[key]) for key in ("largest", "quantile_999", "median")]
                flips = [str(record["flips"]), _short(record["nearest"])] if quantity == "size" else ["", ""]
                rows.append([name, LABELS[quantity], *cells, *flips])
        tables.append((f"{states:,} states {kind}; beta within {_short(beta)} of it", heading, rows))
    rows = [
        [name, *(_short(record[quantity]) for quantity in QUANTITIES)]
        for name, record in found["refined"].items()
    ]
    heading = ["build", *(LABELS[quantity] for quantity in QUANTITIES)]
    tables.append((f"The worst {KEPT} of each kind, refined: largest error", heading, rows))
    rows = [
        [name, f"{record['pairs']:.0f}", f"{record['flips']:.0f}", _short(record["nearest"])]
        for name, record in found["sign_changes"].items()
    ]
    title = "Flips on the way to lambda_v = 0, by bisection"
    tables.append((title, ["build", "pairs", "flips", "|lambda_v| there"], rows))
    rows = [
        [name, *(_short(record[f"{quantity}, extended"]) for quantity in QUANTITIES)]
        for name, record in found["refined"].items()
        if name.startswith("float64")
    ]
    rows.append(["the reference itself", *(_short(found["reference"][quantity]) for quantity in QUANTITIES)])
    title = f"Those of float64 against extended precision (eps {found['extended_eps']:.1e})"
    tables.append((title, heading, rows))
    return tables


def _short(value: float) -> str:
    return f"{value:.1e}"


def _joined(found: Found, layout: Callable[[Sequence[str], Sequence[Sequence[str]]], str]) -> list[str]:
    lines = []
    for title, heading, rows in _tables(found):
        lines += ["", f"{title}:", "", layout(heading, rows)]
    return lines


def text(found: Found) -> str:
    """Aligned columns."""
    return "\n".join([_origin(found), NOTE, *_joined(found, _aligned)])


def markdown(found: Found) -> str:
    """What ``--readme`` writes."""
    return "\n".join([_origin(found), NOTE, *_joined(found, _pipes)])


def _origin(found: Mapping[str, Any]) -> str:
    return (
        f"Written by `python -m c_runtime.verification.accuracy` on {found['machine']}, {found['date']}, "
        f"revision {found['revision']}, seed {found['seed']}."
    )


def _aligned(heading: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    table = [heading, *rows]
    widths = [max(len(line[i]) for line in table) for i in range(len(heading))]
    return "\n".join(
        "  ".join(
            [line[0].ljust(widths[0]), *(c.rjust(w) for c, w in zip(line[1:], widths[1:], strict=True))]
        )
        for line in table
    )


def _pipes(heading: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    escaped = [[cell.replace("|", "&#124;") for cell in line] for line in (heading, *rows)]
    lines = ["| " + " | ".join(line) + " |" for line in escaped]
    return "\n".join([lines[0], "|---|" + "---:|" * (len(heading) - 1), *lines[1:]])

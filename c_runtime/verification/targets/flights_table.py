"""The table of flights with processors in the loop, from what was stored of them."""

from collections.abc import Mapping
from typing import Any

from c_runtime.verification.targets.flown import BOUNDS
from c_runtime.verification.targets.machines import TARGETS

HEAD = (
    "| processor | precision | products and sums | mission | periods | instructions a command, most "
    "| on average | arrives | end, from the host's | time, from the host's [TU] |"
)
CAPTION = """\
Written by `make targets-flights` on {machine}, {date}, revision {revision}.
One flight of each mission on each processor, from {start}, of a sail {weaker:g} % weaker than assumed:
the plant is on the host, and a state and a command pass over the emulator's console once a guidance period.
*End*: largest difference in {state} from where the flight ends that is steered by the same
file on the host, its products and sums apart. *Bit for bit*: every number of every command is the same.
Fused, a flight may end at most {float64:g} from it in float64, and {float32:g} in float32. Instructions are
those of `sailnet_steer`, of every command of the flight."""

IN_THE_PLANE, IN_SPACE = "r [AU], u and v [AU/TU]", "r [AU], latitude [rad] and speeds [AU/TU]"
"""What a state consists of: of plane missions alone, and where one in space is among them."""


def table(stored: Mapping[str, Any]) -> str:
    """The table in Markdown with its caption.

    Args:
        stored: what ``fly`` wrote: where and when, which sail, and a row a flight.
    """
    start = stored["start"]
    caption = CAPTION.format(
        **{name: stored[name] for name in ("machine", "date", "revision")},
        **BOUNDS,
        start="the departure orbit"
        if start is None
        else f"{'r, u, v' if len(start) == 3 else 'r, latitude, u, v, w'} = {start}",
        weaker=-100.0 * stored["beta_bias"],
        state=IN_SPACE if any(len(row["end"]) > 3 for row in stored["rows"]) else IN_THE_PLANE,
    )
    rows = [_row(row) for row in stored["rows"]]
    return "\n".join([caption, "", HEAD, "|---" * (HEAD.count("|") - 1) + "|", *rows])


def _row(row: Mapping[str, Any]) -> str:
    titles = {target.name: target.title for target in TARGETS}
    same, most, mean = row["same_bits"], row["instructions"]["most"], row["instructions"]["mean"]
    columns = [
        titles[row["target"]],
        row["precision"],
        "fused" if row["fused"] else "apart",
        row["mission"],
        f"{row['periods']:,}",
        "" if most is None else f"{most:,}",
        "" if mean is None else f"{mean:,.0f}",
        "yes" if row["arrived"] else "no",
        "bit for bit" if same else f"{row['end_unlike_host']:.1e}",
        "0" if same else f"{row['time_unlike_host']:.1e}",
    ]
    return f"| {' | '.join(columns)} |"

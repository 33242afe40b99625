"""``sailnet info``: verify a data set and summarise it."""

import argparse
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from tqdm import tqdm

from sailnet.cli.arguments import Commands
from sailnet.cli.output import Line, Result, number, percent, table


def _ranges(found: Mapping[str, Sequence[float]]) -> str:
    from sailnet.dataset.schema import LAYOUT, LAYOUT_IN_SPACE

    units = {
        f"{group}/{name}": told[0]
        for layout in (LAYOUT, LAYOUT_IN_SPACE)
        for group, names in layout.groups.items()
        for name, told in names.items()
    }
    shown = {
        key: f"{low:.8g} to {high:.8g}" + (f" {units[key]}" if units[key] != "1" else "")
        for key, (low, high) in found.items()
    }
    return table(str)(shown)


LINES = {
    "mission": Line("mission"),
    "recipe": Line("recipe"),
    "trajectories": Line("trajectories", number),
    "samples": Line("samples", number),
    "jump_share": Line("jumps of the cone angle", percent),
    "negative_arrival_share": Line("arrivals at a negative cone angle", percent),
    "crossing_share": Line("flights that begin on another sail's way", percent),
    "largest_hamiltonian": Line("largest Hamiltonian, 0 at an optimum", number),
    "ranges": Line("ranges", _ranges),
    "software": Line("made by", table(str)),
    "date": Line("made on"),
    "digest": Line("digest (SHA-256)"),
}


def add(commands: Commands) -> None:
    """Add the command."""
    about = "Verify a data set (checksums, ranges, optimality) and summarise it."
    example = "example: sailnet info build/earth_mars/wide.h5"
    info = commands.add_parser("info", help=about, description=about, epilog=example)
    info.add_argument("file", metavar="FILE", type=Path, help="the HDF5 file")
    info.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    info.set_defaults(run=run, lines=LINES)


def run(options: argparse.Namespace) -> Result:
    """Verify; what the file holds by name."""
    from sailnet.dataset.inspection import inspect_dataset

    # Shown where it takes longer than two seconds.
    with tqdm(desc="verify", unit="value", unit_scale=True, delay=2.0, file=sys.stderr, disable=None) as bar:
        return inspect_dataset(options.file, bar)

"""``sailnet info``: verify a data set and summarise it."""

import argparse
import sys
from pathlib import Path

from tqdm import tqdm

from sailnet.cli.arguments import Commands
from sailnet.cli.output import Result


def add(commands: Commands) -> None:
    """Add the command."""
    about = "Verify a data set (checksums, ranges, optimality) and summarise it."
    example = "example: sailnet info build/earth_mars/domain.h5"
    info = commands.add_parser("info", help=about, description=about, epilog=example)
    info.add_argument("file", metavar="FILE", type=Path, help="the HDF5 file")
    info.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    info.set_defaults(run=run)


def run(options: argparse.Namespace) -> Result:
    """Verify; what the file holds by name."""
    from sailnet.dataset.inspection import inspect_dataset

    # Shown where it takes longer than two seconds.
    with tqdm(desc="verify", unit="value", unit_scale=True, delay=2.0, file=sys.stderr, disable=None) as bar:
        return inspect_dataset(options.file, bar)

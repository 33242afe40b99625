"""``python -m export.ship``: make a finished run the networks that come with the package.

Copies the weights, exports them into the package, and writes their model card and the tables of results
from the files of the run: no figure is typed by hand.
"""

import argparse
import sys
from pathlib import Path

from export.errors import ExportError
from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.errors import SailnetError
from sailnet.workers.interruption import run_command


def main() -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m export.ship",
        description=__doc__,
        epilog="example: python -m export.ship build/earth_mars/wide sailnet/shipped/earth_mars",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("build", type=Path, help="folder of a finished run")
    parser.add_argument("package", type=Path, help="folder in the package")
    parser.add_argument("--mission", default="earth_mars", help="mission name or TOML file (%(default)s)")
    parser.add_argument("--readme", type=Path, help="also write a few rows of results into this file")
    parser.add_argument("--results", type=Path, help="and into this one")
    parser.add_argument("--paper", type=Path, help="and those of this report.json, of `make paper`")
    parser.add_argument("--picture", type=Path, help="also draw the flight from the departure orbit: a PNG")
    options = parser.parse_args()
    try:
        with sole_owner(options.package / LOCK, f"networks in {options.package}", ExportError):
            _ship(options)
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


def _ship(options: argparse.Namespace) -> None:
    # Torch takes seconds to load: whoever comes second into a folder has been sent away by now.
    from export.shipping import ship
    from sailnet.mission.mission import load_mission

    ship(
        options.build, options.package, load_mission(options.mission),
        options.readme, options.results, options.paper, options.picture,
    )  # fmt: skip


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

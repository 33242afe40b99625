"""``python -m benchmarks.pipeline_times``: how long `make` takes from a fresh clone, stage by stage.

The repository is cloned into a temporary folder, at `--revision` where one is named, so that before and
after come from one command. A stage is a target of the Makefile; the last, `all`, shows that nothing is left.
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.campaign.tables import Table
from sailnet.errors import SailnetError

MARK = "pipeline-times"

STAGES = ("setup", "dataset", "train", "export", "accept", "all")
"""Targets of the Makefile, in the order in which `make` comes by them."""

ROOT = Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class Stage:
    """What a target of the Makefile took.

    Attributes:
        target: its name.
        wall: seconds on the wall.
        processor: seconds of all processors, of it and of every process that it waited for.
    """

    target: str
    wall: float
    processor: float


def clone(repository: Path, folder: Path, revision: str) -> str:
    """Clone a repository at a revision, of which the short name is returned.

    Args:
        repository: where it is; only what is committed counts.
        folder: for the clone.
        revision: as git understands it in ``repository``.

    Raises:
        SailnetError: git fails.
    """
    commit = _told(["git", "-C", str(repository), "rev-parse", "--verify", f"{revision}^{{commit}}"])
    _told(["git", "clone", "--quiet", "--no-checkout", str(repository), str(folder)])
    _told(["git", "-C", str(folder), "checkout", "--quiet", "--detach", commit])
    return _told(["git", "-C", str(folder), "rev-parse", "--short", "HEAD"])


def measure(folder: Path, settings: Sequence[str], stages: Sequence[str] = STAGES) -> list[Stage]:
    """Make one stage after the other.

    Args:
        folder: with a Makefile.
        settings: of make, such as ``SIZE=quick``.
        stages: targets.

    Raises:
        SailnetError: a stage fails.
    """
    taken = []
    # An outer make would hand on its own variables and jobs.
    surroundings = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    for target in stages:
        wall, processor = time.monotonic(), _processor()
        run = ["make", "-C", str(folder), target, *settings]
        done = subprocess.run(run, stdout=subprocess.DEVNULL, env=surroundings, check=False)
        if done.returncode:
            raise SailnetError(f"make {target} ended with status {done.returncode}: see above")
        taken.append(Stage(target, time.monotonic() - wall, _processor() - processor))
    return taken


def lines(stages: Sequence[Stage]) -> list[str]:
    """A table in Markdown, the sum in its last row."""
    whole = Stage("together", sum(stage.wall for stage in stages), sum(stage.processor for stage in stages))
    cells = [[of_one.target, f"{of_one.wall:.0f}", f"{of_one.processor:.0f}"] for of_one in [*stages, whole]]
    return Table("", ["stage", "seconds", "of processors"], cells).markdown()


def _processor() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _told(command: list[str]) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SailnetError(f"{' '.join(command)}: {done.stderr.strip()}")
    return done.stdout.strip()


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.pipeline_times", description=__doc__)
    parser.add_argument("--revision", default="HEAD", help="of the repository (%(default)s)")
    parser.add_argument("--mission", default="earth_mars", help="name of one (%(default)s)")
    parser.add_argument("--size", choices=("quick", "full"), default="full", help="(%(default)s)")
    parser.add_argument("--repository", type=Path, default=ROOT, help="to be cloned (this one)")
    parser.add_argument("--text", type=Path, help=f"file with marks such as <!-- {MARK} --> for the table")
    parser.add_argument("--mark", default=MARK, help="of the place in that file (%(default)s)")
    options = parser.parse_args(arguments)
    try:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name) / "sailnet"
            revision = clone(options.repository, folder, options.revision)
            stages = measure(folder, [f"MISSION={options.mission}", f"SIZE={options.size}"])
        made = software()
        told = (
            f"`python -m benchmarks.pipeline_times --mission {options.mission} --size {options.size} "
            f"--revision {revision}` on {made['machine']}, {os.cpu_count()} cores, {made['date']}."
        )
        content = "\n".join([told, "", *lines(stages)])
        if options.text:
            fill_block(options.text, options.mark, content)
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print(content)
    return 0


if __name__ == "__main__":
    sys.exit(main())

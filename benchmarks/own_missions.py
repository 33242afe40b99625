"""``python -m benchmarks.own_missions``: missions that the repository does not hold, as a stranger has them.

For each, ``sailnet mission new`` writes the file and ``sailnet pipeline`` makes data, networks, C and the
flights that they pass, with nothing said but target, sail and bound. What was finished in the folder is kept;
where its results were removed, what is missing is made again.
"""

import argparse
import json
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sailnet.artefacts.files import fill_block, write_text
from sailnet.campaign.acceptance import headline
from sailnet.campaign.results import open_results
from sailnet.campaign.tables import Table
from sailnet.errors import SailnetError
from sailnet.mission.sizes import SIZES

SAILNET = [sys.executable, "-m", "sailnet.cli"]


@dataclass(frozen=True)
class Own:
    """What a stranger says of his mission.

    Attributes:
        target: radius of the target's orbit [AU]; the departure's is 1.
        beta: of the sail.
        max_cone_angle: [deg].
    """

    target: float
    beta: float
    max_cone_angle: float

    @property
    def name(self) -> str:
        """Of its file and folder."""
        return f"to_{self.target:g}_au".replace(".", "_")

    @property
    def title(self) -> str:
        """For people."""
        return f"to {self.target:g} AU, β {self.beta:g}, {self.max_cone_angle:g}°"


MISSIONS = (Own(0.9, 0.12, 55.0), Own(1.2, 0.15, 60.0), Own(2.0, 0.2, 65.0))
"""One inward and near, which is passed easily; one a little farther out; one beyond Mars."""


def fly(own: Own, folder: Path, size: str, seed: int, workers: int | None) -> dict[str, Any]:
    """Write the mission and run its pipeline; what that printed.

    Args:
        own: the mission.
        folder: for its file, for all that is made, and for what was printed; made where there is none.
        size: of the recipe.
        seed: of the flights.
        workers: processes; None for all cores.

    Raises:
        SailnetError: a command failed.
    """
    base = folder / f"{own.name}-{size}"
    printed = base.with_suffix(".json")
    before = dict(json.loads(printed.read_text())) if printed.exists() else {}
    if before and Path(before["results"]).exists():
        return before
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{own.name}.toml"
    transfer = ["--target", f"{own.target}", "--beta", f"{own.beta}"]
    bound = ["--max-cone-angle", f"{own.max_cone_angle}"]
    _run(["mission", "new", *transfer, *bound, "--output", str(file), "--overwrite"])
    options = ["--size", size, "--seed", str(seed), "--output", str(base), "--json"]
    if workers is not None:
        options += ["--workers", str(workers)]
    made = dict(json.loads(_run(["pipeline", str(file), *options])))
    for step, taken in before.get("seconds", {}).items():  # what was finished then takes no time now
        made["seconds"][step] = max(taken, made["seconds"][step])
    write_text(printed, json.dumps(made))
    return made


def _run(arguments: list[str]) -> str:
    done = subprocess.run([*SAILNET, *arguments], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode:
        raise SailnetError(f"sailnet {' '.join(arguments)} ended with status {done.returncode}: see above")
    return done.stdout


def table(flown: list[tuple[Own, dict[str, Any]]]) -> list[str]:
    """How the networks of each mission fly, and how long each step took; lines of Markdown."""
    cells, heads = [], []
    for own, result in flown:
        rows = headline(open_results(Path(result["results"])))
        heads = ["mission", *rows.heads]
        cells += [[own.title, *row] for row in rows.cells]
    steps = list(flown[0][1]["seconds"])
    times = [
        [own.title, *(f"{result['seconds'][step]:.0f}" for step in steps), f"{total(result):.0f}"]
        for own, result in flown
    ]
    taken = Table("", ["mission, seconds of", *steps, "all"], times)
    return [*Table("", heads, cells).markdown(), "", *taken.markdown()]


def written_by(flown: list[tuple[Own, dict[str, Any]]]) -> str:
    """Where and when the flights of the last mission were flown, and the seeds of all, where they differ."""
    results = [open_results(Path(result["results"])) for _, result in flown]
    made, seeds = results[-1].provenance, [str(of_one.plan.seed) for of_one in results]
    told = seeds[0] if len(set(seeds)) == 1 else ", ".join(seeds)
    return f"Flown on {made['machine']}, {made['date']}, revision {made['revision']}, seed {told}; written by"


def total(result: dict[str, Any]) -> float:
    """Seconds of all steps."""
    return float(sum(result["seconds"].values()))


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.own_missions",
        description=__doc__,
        epilog="example: python -m benchmarks.own_missions build/own --size quick",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("folder", type=Path, help="for missions and all that is made of them")
    parser.add_argument("--size", choices=SIZES, default="quick", help="of the recipes (%(default)s)")
    parser.add_argument("--seed", type=int, default=31, help="of the flights (%(default)s)")
    parser.add_argument("--workers", type=int, help="processes (all cores)")
    parser.add_argument("--text", type=Path, help="file with marks <!-- own-missions-SIZE --> for the tables")
    options = parser.parse_args()
    try:
        flown = [
            (own, fly(own, options.folder, options.size, options.seed, options.workers)) for own in MISSIONS
        ]
        lines = [f"{written_by(flown)} `python -m benchmarks.own_missions FOLDER --size {options.size}`.", ""]
        lines += table(flown)
        if options.text:
            fill_block(options.text, f"own-missions-{options.size}", "\n".join(lines))
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())

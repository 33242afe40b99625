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
        target: radius of the target's orbit [AU].
        beta: of the sail.
        max_cone_angle: [deg].
        departure: radius of the orbit where it begins [AU].
        optics: of the sail.
        inclination: of the departure orbit to the target's [deg].
    """

    target: float
    beta: float
    max_cone_angle: float
    departure: float = 1.0
    optics: str = "ideal"
    inclination: float = 0.0

    @property
    def name(self) -> str:
        """Of its file and folder."""
        begins = "" if self.departure == 1.0 else f"from_{self.departure:g}_"
        inclined = f"_inclined_{self.inclination:g}" if self.inclination else ""
        return f"{begins}to_{self.target:g}_au{inclined}".replace(".", "_")

    @property
    def title(self) -> str:
        """For people."""
        begins = "" if self.departure == 1.0 else f"{self.departure:g} AU "
        inclined = f", inclined by {self.inclination:g}°" if self.inclination else ""
        optics = "" if self.optics == "ideal" else f", {self.optics}"
        return f"{begins}to {self.target:g} AU{inclined}, β {self.beta:g}, {self.max_cone_angle:g}°{optics}"


MISSIONS = (Own(0.9, 0.12, 55.0), Own(1.2, 0.15, 60.0), Own(2.0, 0.2, 65.0))
"""One inward and near, which is passed easily; one a little farther out; one beyond Mars."""

OTHERS = (
    Own(0.35, 0.25, 55.0),
    Own(0.55, 0.12, 65.0),
    Own(0.65, 0.08, 60.0),
    Own(0.75, 0.2, 50.0),
    Own(0.85, 0.05, 40.0),
    Own(0.97, 0.15, 60.0),
    Own(1.07, 0.1, 50.0),
    Own(1.15, 0.07, 65.0),
    Own(1.35, 0.13, 60.0, optics="jpl"),
    Own(1.6, 0.1, 90.0),
    Own(2.4, 0.12, 60.0),
    Own(4.0, 0.2, 55.0),
    Own(0.7, 0.2, 60.0, departure=1.6),
)
"""None was flown while the recipes were chosen: strong and weak sails, narrow bounds and none, targets beside
the departure and far from it."""

IN_SPACE = (
    Own(0.45, 0.2, 60.0, inclination=6.0),
    Own(0.75, 0.15, 60.0, inclination=2.0),
    Own(1.1, 0.12, 60.0, inclination=1.0),
    Own(1.4, 0.12, 55.0, inclination=4.0),
)
"""Out of the plane; nor was one of these."""

SETS = {"": MISSIONS, "others": OTHERS, "in-space": IN_SPACE}


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
    transfer = ["--target", f"{own.target}", "--departure", f"{own.departure}"]
    transfer += ["--inclination", f"{own.inclination}"]
    sail = ["--beta", f"{own.beta}", "--max-cone-angle", f"{own.max_cone_angle}", "--optics", own.optics]
    _run(["mission", "new", *transfer, *sail, "--output", str(file), "--overwrite"])
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


def line_by_line(flown: list[tuple[Own, dict[str, Any]]], failed: list[Own]) -> list[str]:
    """The same with a line a mission, the numbers of its series side by side, and one for what failed."""
    rows, series = [[own.title, "the pipeline fails", "", "", "", ""] for own in failed], []
    for own, result in flown:
        scores = result["scores"]
        series = [str(score["series"]) for score in scores]
        late = [100.0 * score["time_above_own_optimum"]["mean"] for score in scores]
        rows.append(
            [
                own.title,
                ", ".join(str(score["flights"] - score["arrived"]) for score in scores),
                ", ".join(f"{mean:.3g}" for mean in late),
                ", ".join(f"{score['reversals']['0.99']:.0f}" for score in scores),
                ", ".join(str(score["own_optimum_unknown"]) for score in scores),
                f"{total(result):.0f}",
            ]
        )
    told = f"Of {flown[0][1]['scores'][0]['flights']:,} flights each: {', '.join(series)}."
    heads = ["mission", "failed", "mean excess over the optimum [%]", "attitude reversals, 99 %"]
    return [told, "", *Table("", [*heads, "optimum unknown", "all [s]"], rows).markdown()]


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
    instead = parser.add_mutually_exclusive_group()
    for chosen, told in (
        ("others", "thirteen others, which are harder"),
        ("in-space", "four out of the plane"),
    ):
        instead.add_argument(
            f"--{chosen}", action="store_const", const=chosen, dest="chosen", default="", help=told
        )
    marks = "<!-- own-missions-SIZE -->, or <!-- own-missions-others-SIZE --> or -in-space-SIZE"
    parser.add_argument("--text", type=Path, help=f"file with marks {marks}, for the tables")
    options = parser.parse_args()
    chosen = options.chosen
    flown: list[tuple[Own, dict[str, Any]]] = []
    failed: list[Own] = []
    try:
        for own in SETS[chosen]:
            try:
                made = fly(own, options.folder, options.size, options.seed, options.workers)
                flown.append((own, made))
            except SailnetError as error:
                if not chosen:
                    raise
                print(f"error: {error}", file=sys.stderr)
                failed.append(own)
        if not flown:
            raise SailnetError("none of the missions could be flown: see above")
        command = f"python -m benchmarks.own_missions FOLDER --size {options.size}"
        lines = [f"{written_by(flown)} `{command}{f' --{chosen}' if chosen else ''}`.", ""]
        lines += line_by_line(flown, failed) if chosen else table(flown)
        if options.text:
            name = f"own-missions-{chosen}-{options.size}" if chosen else f"own-missions-{options.size}"
            fill_block(options.text, name, "\n".join(lines))
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print("\n".join(lines))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

"""``python -m benchmarks.long_runs``: memory of a campaign of a million flights, and of 100 million samples.

Each length runs in a process of its own, so that its largest memory is its own.
"""

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import numpy as np

from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.campaign.plan import parse_plan
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import scores_of
from sailnet.dataset import SAMPLES, Block, open_dataset, write_dataset
from sailnet.errors import SailnetError
from sailnet.guidance.backends import load_guidance
from sailnet.mission.mission import load_mission
from sailnet.mission.sections import MOST_PERIODS

MARK = "long-runs"
FLIGHTS, SAMPLES_WRITTEN = 1_000_000, 100_000_000
STEPS = (0.1, 0.3, 1.0)
"""Shares of the length asked for, which show whether memory grows with it."""

TRAJECTORY, BLOCK = 351, 2000
"""Samples of a trajectory, and trajectories of a block, as of the paper's box."""


def campaign(flights: int, folder: Path) -> Callable[[], object]:
    """Fly so many, each for some periods: its rows are what counts here; then their scores are to be had."""
    mission = load_mission("earth_mars")
    brief = mission.flight.model_copy(update={"longest": 10 * mission.flight.period})
    assert brief.longest < MOST_PERIODS * brief.period
    series = [{"name": "all", "flights": flights}]
    content = {"schema": 1, "name": "long", "title": "Long", "sample": 0, "failures": 0, "optima": 0}
    plan = parse_plan(content | {"series": series}, "long")
    short = mission.model_copy(update={"flight": brief})
    # Guidance of the mission itself: the rules of flight are not part of what networks are trained for.
    results = fly_plan(short, load_guidance(mission, layout="host"), plan, folder / "long.h5")
    return partial(scores_of, results)


def samples(count: int, folder: Path) -> None:
    """Write and verify a data set of so many."""
    path = folder / "long.h5"
    write_dataset(path, load_mission("earth_mars"), _blocks(count), {"made": "for its length"})
    with open_dataset(path) as found:
        found.verify()
        assert found.samples == count - count % TRAJECTORY


def _blocks(count: int) -> Iterator[Block]:
    left = count // TRAJECTORY
    rng = np.random.default_rng(1)
    names = ("lambda_r0", "lambda_u0", "lambda_v0", "jump_time", "flags")
    while left:
        rows = min(left, BLOCK)
        column = rng.normal(size=rows * TRAJECTORY)
        yield Block(
            {name: column for name in SAMPLES if name != "trajectory"},
            {name: np.zeros(rows) for name in names},
            np.full(rows, TRAJECTORY),
        )
        left -= rows


KINDS: dict[str, Callable[[int, Path], Callable[[], object] | None]] = {
    "campaign, flights": campaign,
    "data set, samples": samples,
}


def measure(kind: str, count: int) -> dict[str, float]:
    """In this process: its largest memory [GB] before and after, the size of the file [GB], and seconds;
    and its largest memory with the scores of all flights, which are one series, if it has any."""
    before, started = _peak(), time.monotonic()
    with tempfile.TemporaryDirectory(dir=Path.cwd()) as name:
        scores = KINDS[kind](count, Path(name))
        found = {"before": before, "after": _peak(), "seconds": time.monotonic() - started}
        found["file"] = (Path(name) / "long.h5").stat().st_size / 1e9
        if scores is not None:
            scores()
            found["scored"] = _peak()
    return found


def _peak() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e9


def table(rows: list[tuple[str, int, dict[str, float]]], flights: int, samples: int) -> list[str]:
    """The record as Markdown."""
    made = software()
    lines = [
        f"`python -m benchmarks.long_runs --flights {flights} --samples {samples}` on {made['machine']}, "
        f"{made['date']}, revision {made['revision']}. Flights end after ten periods; samples are invented; "
        f"a full run has {FLIGHTS:,} flights and {SAMPLES_WRITTEN:,} samples.",
        "",
        "| what | how many | largest memory [GB] | before the work | with all scores | file [GB] | seconds |",
        "|---|---|---|---|---|---|---|",
    ]
    for kind, count, found in rows:
        cells = [f"{found['after']:.2f}", f"{found['before']:.2f}"]
        cells += [f"{found['scored']:.2f}" if "scored" in found else "–", f"{found['file']:.3f}"]
        lines.append(f"| {kind} | {count:,} | {' | '.join(cells)} | {found['seconds']:.0f} |")
    return lines


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.long_runs", description=__doc__)
    parser.add_argument("--flights", type=int, default=FLIGHTS, help="of the campaign (%(default)s)")
    parser.add_argument("--samples", type=int, default=SAMPLES_WRITTEN, help="of the data set (%(default)s)")
    parser.add_argument("--only", choices=KINDS, help="one, in this process, of --count; prints JSON")
    parser.add_argument("--count", type=int)
    parser.add_argument("--text", type=Path, help=f"file with marks <!-- {MARK} --> for the table")
    options = parser.parse_args()
    try:
        if options.only:
            print(json.dumps(measure(options.only, options.count)))
            return 0
        rows = []
        for kind, whole in zip(KINDS, (options.flights, options.samples), strict=True):
            for step in STEPS:
                count = int(whole * step)
                command = ["-m", "benchmarks.long_runs", "--only", kind, "--count", str(count)]
                done = subprocess.run(
                    [sys.executable, *command], stdout=subprocess.PIPE, text=True, check=False
                )
                if done.returncode:
                    raise SailnetError(f"{kind}: {count} did not come to an end: {done.returncode}")
                rows.append((kind, count, json.loads(done.stdout.splitlines()[-1])))
                print(rows[-1], file=sys.stderr, flush=True)
        lines = table(rows, options.flights, options.samples)
        print("\n".join(lines))
        if options.text:
            fill_block(options.text, MARK, "\n".join(lines))
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

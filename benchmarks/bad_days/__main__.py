"""``python -m benchmarks.bad_days``: every command on its bad days, at toy size, and the table of it."""

import argparse
import json
import sys
import tempfile
import time
from collections.abc import Iterable
from pathlib import Path
from random import Random

from benchmarks.bad_days.clusters import LOSSES, lose
from benchmarks.bad_days.disks import fill
from benchmarks.bad_days.faults import faults
from benchmarks.bad_days.kills import kill_at_random
from benchmarks.bad_days.record import Day, Days, Records, counted, merged, table
from benchmarks.bad_days.work import LEARNED, ROOT, Work, works
from benchmarks.bad_days.writers import second_writer
from sailnet.artefacts.files import fill_block, write_text
from sailnet.artefacts.provenance import software
from sailnet.errors import SailnetError

MARK = "bad-days"

KINDS = ("kills", "writers", "clusters", "disks")
FAULTS = "faults"
"""Not of one command."""


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.bad_days", description=__doc__)
    parser.add_argument("--kills", type=int, default=5, help="of each command (%(default)s)")
    parser.add_argument("--sizes", type=int, default=5, help="of disks, for each command (%(default)s)")
    parser.add_argument(
        "--only", nargs="+", choices=(*KINDS, FAULTS), default=(*KINDS, FAULTS), help="kinds of day (all)"
    )
    parser.add_argument(
        "--works", nargs="+", metavar="NAME", help="commands or faults: data, training... (all)"
    )
    parser.add_argument("--seed", type=int, default=1, help="of the moments (%(default)s)")
    parser.add_argument("--minutes", type=float, default=1e9, help="after which no other day begins")
    parser.add_argument("--folder", type=Path, help="to work in, and for records.json, from which it goes on")
    parser.add_argument("--text", type=Path, help=f"file with marks <!-- {MARK} --> for the table")
    return parser.parse_args()


def run_all(folder: Path, options: argparse.Namespace) -> Records:
    """Every bad day asked for, one after the other; those in the folder's records not again."""
    end = time.monotonic() + 60.0 * options.minutes
    known = folder / "records.json"
    records: Records = json.loads(known.read_text()) if known.exists() else {}
    made: Day = {key: software()[key] for key in ("date", "revision")}
    every = works(folder)
    asked = tuple(options.works or [""])
    chosen = {work.name for work in every if work.name.startswith(asked) and set(options.only) & set(KINDS)}
    needed = chosen | ({LEARNED} if FAULTS in options.only else set())
    for work in reversed(every):
        needed |= {work.reads} if work.name in needed else set()
    for work in every:
        if work.name not in needed:
            continue
        expected, seconds = _undisturbed(work, folder)
        if work.name not in chosen:
            continue
        had = {kind: counted(records.get(kind, {}).get(work.name, [])) for kind in KINDS}
        random = Random(f"{options.seed} {work.name} {len(had['kills'])}")
        for kind, results in _days(work, folder, expected, seconds, random, options, had):
            records.setdefault(kind, {}).setdefault(work.name, []).append(results | made)
            _say(f"{kind}: {work.name}: {json.dumps(results)}")
            _keep(records, known)
            if time.monotonic() > end:
                return records
    if FAULTS in options.only:
        learned = folder / "reference" / LEARNED / "x.h5"
        for given, day in faults(folder / "faults", learned, asked):
            records.setdefault(FAULTS, {})[given] = [day | made]
            _say(f"{FAULTS}: {given}: {json.dumps(day)}")
            _keep(records, known)
    return records


def _undisturbed(work: Work, folder: Path) -> tuple[str, float]:
    """Digest of what a command writes on a good day, and the seconds it takes; it is run once.

    Raises:
        SailnetError: it fails.
    """
    reference = folder / "reference" / work.name
    if not (reference / "seconds").exists():
        work.prepare()
        reference.mkdir(parents=True, exist_ok=True)
        _say(f"{work.name}: undisturbed")
        status, said, seconds = work.complete(reference)
        if status:
            raise SailnetError(f"{work.name} does not even work on a good day: {said[-500:]}")
        (reference / "seconds").write_text(str(seconds))
    return work.digest(reference), float((reference / "seconds").read_text())


def _keep(records: Records, path: Path) -> None:
    write_text(path, json.dumps(records, indent=1))


def _days(
    work: Work,
    folder: Path,
    expected: str,
    seconds: float,
    random: Random,
    options: argparse.Namespace,
    had: dict[str, Days],
) -> Iterable[tuple[str, Day]]:
    if "kills" in options.only:
        kills = len(had["kills"])
        while kills < options.kills:
            day = kill_at_random(work, folder / "killed", expected, seconds, random)
            kills += len(counted([day]))
            yield "kills", day
    if "writers" in options.only and not had["writers"]:
        yield "writers", second_writer(work, folder / "twice", expected)
    if "disks" in options.only:
        reference = folder / "reference" / work.name
        needed = sum(path.stat().st_size for path in reference.rglob("*") if path.is_file())
        for step in range(len(had["disks"]), options.sizes):
            size = 20_000 + int(1.2 * needed * step / max(1, options.sizes - 1))
            yield "disks", fill(work, folder / "disk", expected, size)
    if "clusters" in options.only and work.spreads:
        lost = {day["loss"] for day in had["clusters"]}
        for loss in (loss for loss in LOSSES if loss not in lost):
            yield "clusters", {"loss": loss, **lose(loss, work, folder / "cluster", expected, seconds)}


def _say(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def main() -> int:
    """Run the command; returns the exit status."""
    options = _options()
    try:
        with tempfile.TemporaryDirectory() as name:
            folder = (options.folder or Path(name)).resolve()
            folder.mkdir(parents=True, exist_ok=True)
            records = run_all(folder, options)
        here = {str(folder): "FOLDER", sys.executable: "python", f"{ROOT}/": ""}
        lines = table(records)
        for place, name in here.items():  # of no machine in particular
            lines = [line.replace(place, name) for line in lines]
        print("\n".join(lines))
        if options.text:
            lines = merged(lines, options.text, MARK)
            fill_block(options.text, MARK, "\n".join(lines))
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

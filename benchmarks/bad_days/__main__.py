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
from benchmarks.bad_days.kills import kill_at_random
from benchmarks.bad_days.work import ROOT, Work, works
from benchmarks.bad_days.writers import second_writer
from sailnet.artefacts.files import fill_block, write_text
from sailnet.artefacts.provenance import software
from sailnet.errors import SailnetError

MARK = "bad-days"

KINDS = ("kills", "writers", "clusters", "disks")

Records = dict[str, dict[str, list[dict[str, object]]]]
"""By kind of day and name of the work; of clusters by loss and work."""


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.bad_days", description=__doc__)
    parser.add_argument("--kills", type=int, default=5, help="of each command (%(default)s)")
    parser.add_argument("--sizes", type=int, default=5, help="of disks, for each command (%(default)s)")
    parser.add_argument("--only", nargs="+", choices=KINDS, default=KINDS, help="kinds of day (all)")
    parser.add_argument("--works", nargs="+", metavar="NAME", help="commands: data, training... (all)")
    parser.add_argument("--seed", type=int, default=1, help="of the moments (%(default)s)")
    parser.add_argument("--minutes", type=float, default=1e9, help="after which no other day begins")
    parser.add_argument("--folder", type=Path, help="to work in, and for records.json, from which it goes on")
    parser.add_argument("--text", type=Path, help=f"file with marks <!-- {MARK} --> for the table")
    return parser.parse_args()


def run_all(folder: Path, options: argparse.Namespace) -> Records:
    """Every bad day asked for, one after the other; those in the folder's records not again."""
    random = Random(options.seed)
    end = time.monotonic() + 60.0 * options.minutes
    known = folder / "records.json"
    records: Records = json.loads(known.read_text()) if known.exists() else {}
    expected: dict[str, str] = {}
    every = works(folder)
    chosen = {work.name for work in every if not options.works or work.name.startswith(tuple(options.works))}
    needed = set(chosen)
    for work in reversed(every):
        needed |= {work.reads} if work.name in needed else set()
    for work in every:
        if work.name not in needed:
            continue
        reference = folder / "reference" / work.name
        if not reference.exists():
            reference.mkdir(parents=True)
            _say(f"{work.name}: undisturbed")
            status, said, seconds = work.complete(reference)
            if status:
                raise SailnetError(f"{work.name} does not even work on a good day: {said[-500:]}")
            (reference / "seconds").write_text(str(seconds))
        seconds = float((reference / "seconds").read_text())
        expected[work.name] = work.digest(reference)
        if work.name not in chosen:
            continue
        had = {kind: len(records.get(kind, {}).get(work.name, [])) for kind in KINDS}
        for kind, results in _days(work, folder, expected[work.name], seconds, random, options, had):
            records.setdefault(kind, {}).setdefault(work.name, []).append(results)
            _say(f"{kind}: {work.name}: {json.dumps(results)}")
            _keep(records, known)
            if time.monotonic() > end:
                return records
    return records


def _keep(records: Records, path: Path) -> None:
    write_text(path, json.dumps(records, indent=1))


def _days(
    work: Work,
    folder: Path,
    expected: str,
    seconds: float,
    random: Random,
    options: argparse.Namespace,
    had: dict[str, int],
) -> Iterable[tuple[str, dict[str, object]]]:
    if "kills" in options.only:
        for _ in range(had["kills"], options.kills):
            yield "kills", kill_at_random(work, folder / "killed", expected, seconds, random)
    if "writers" in options.only and not had["writers"]:
        yield "writers", second_writer(work, folder / "twice", expected)
    if "disks" in options.only:
        reference = folder / "reference" / work.name
        needed = sum(path.stat().st_size for path in reference.rglob("*") if path.is_file())
        for step in range(had["disks"], options.sizes):
            size = 20_000 + int(1.2 * needed * step / max(1, options.sizes - 1))
            yield "disks", fill(work, folder / "disk", expected, size)
    if "clusters" in options.only and work.spreads:
        for loss in list(LOSSES)[had["clusters"] :]:
            yield "clusters", {"loss": loss, **lose(loss, work, folder / "cluster", expected)}


def table(records: Records) -> list[str]:
    """The records as Markdown."""
    made = software()
    lines = [
        f"`make bad-days` on {made['machine']}, {made['date']}, revision {made['revision']}, commands at "
        "toy size. Content is compared by digests that hold no date.",
    ]
    if kills := records.get("kills"):
        lines += [
            "",
            "| kill -9 at random moments, then the same command again | kills | moments [s] | same content "
            "| orphans after 5 s | left-overs |",
            "|---|---|---|---|---|---|",
        ]
        for name, days in kills.items():
            before = [day for day in days if not day["finished"]]
            moments = ", ".join(str(day["moment"]) for day in before)
            cells = [name, len(before), moments, f"{_count(days, 'same')} of {len(days)}"]
            cells += [_total(days, "orphans"), _total(days, "leftovers")]
            lines.append(_row(cells))
    if writers := records.get("writers"):
        lines += [
            "",
            "| two writers at once | status | seconds, processor | what it says | first as ever |",
            "|---|---|---|---|---|",
        ]
        for name, days in writers.items():
            for day in days:
                seconds = f"{day['seconds']}, {day['cpu']}"
                lines.append(_row([name, day["status"], seconds, day["said"], day["same"]]))
    if clusters := records.get("clusters"):
        lines += [
            "",
            "| Dask loses | work | status | seconds to the end | what it says | same content in the end |",
            "|---|---|---|---|---|---|",
        ]
        for name, days in clusters.items():
            for day in days:
                cells = [day["loss"], name, *(day[key] for key in ("status", "seconds", "said", "same"))]
                lines.append(_row(cells))
    if disks := records.get("disks"):
        lines += [
            "",
            "| a disk that fills | sizes [kB] | full at | said so with the path | said how much was "
            "needed and is free | half looks whole | same content with room | what it says |",
            "|---|---|---|---|---|---|---|---|",
        ]
        for name, days in disks.items():
            full = [day for day in days if day["status"]]
            sizes = ", ".join(str(int(str(day["size"])) // 1000) for day in days)
            cells = [name, sizes, f"{len(full)} of {len(days)}", f"{_count(full, 'told')} of {len(full)}"]
            cells += [
                f"{_count(full, 'reckoned')} of {len(full)}",
                _count(full, "whole"),
                f"{_count(days, 'same')} of {len(days)}",
            ]
            lines.append(_row([*cells, full[-1]["said"] if full else ""]))
    return lines


def _row(cells: list[object]) -> str:
    named = {True: "yes", False: "no"}
    texts = [named[cell] if isinstance(cell, bool) else str(cell) for cell in cells]
    return "| " + " | ".join(text.replace("|", "/").replace("\n", " ") for text in texts) + " |"


def _count(days: list[dict[str, object]], key: str) -> int:
    return sum(bool(day[key]) for day in days)


def _total(days: list[dict[str, object]], key: str) -> int:
    return sum(int(str(day[key])) for day in days)


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
            fill_block(options.text, MARK, "\n".join(lines))
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

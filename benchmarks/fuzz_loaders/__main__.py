"""``python -m benchmarks.fuzz_loaders``: hostile files for every loader, for a while, and the record of it.

Each format has a process of its own, which may die of what it is given: the file stays, and is a finding.
"""

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from random import Random

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from benchmarks.fuzz_loaders.attempt import BYTES, SECONDS, attempt
from benchmarks.fuzz_loaders.formats import FORMATS
from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.errors import SailnetError

ROUND = 100
"""Files of one run of hypothesis."""

MARK = "fuzz"


def fuzz(name: str, first_seed: int, seconds: float, folder: Path) -> dict[str, object]:
    """Hostile files of one format for so many seconds: how many, how many were taken, and what was found.

    Args:
        name: of the format.
        first_seed: of hypothesis; the next round has the next.
        seconds: after which no round begins.
        folder: where the file lies that is tried, and stays if this process dies.
    """
    limit = 4 * BYTES + _size()
    resource.setrlimit(resource.RLIMIT_DATA, (limit, limit))
    kind, tried, taken, findings = FORMATS[name], 0, 0, dict[str, int]()
    whole = folder / "whole"
    whole.mkdir()
    path = kind.make(whole)
    kind.load(path)

    def try_one(random: Random) -> None:
        nonlocal tried, taken
        outcome = attempt(kind, path, random, folder / "tried")
        tried, taken = tried + 1, taken + outcome.taken
        if outcome.finding:
            findings[outcome.finding] = findings.get(outcome.finding, 0) + 1

    end = time.monotonic() + seconds
    rules = settings(
        max_examples=ROUND, deadline=None, database=None, phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )  # fmt: skip
    while time.monotonic() < end:
        seed(first_seed)(rules(given(st.randoms(use_true_random=False))(try_one)))()
        first_seed += 1
    return {"tried": tried, "taken": taken, "findings": findings}


def _size() -> int:
    return int(Path("/proc/self/statm").read_text().split()[5]) * resource.getpagesize()


def _in_a_process(name: str, first_seed: int, seconds: float, kept: Path) -> dict[str, object]:
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [sys.executable, "-m", "benchmarks.fuzz_loaders", "--only", name, "--seed", str(first_seed),
             "--minutes", str(seconds / 60.0), "--folder", folder],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        if done.returncode == 0:
            found: dict[str, object] = json.loads(done.stdout.splitlines()[-1])
            return found
        kept.mkdir(parents=True, exist_ok=True)
        for file in (Path(folder) / "tried").glob("*"):
            if file.is_file():
                (kept / f"{name} {file.name}").write_bytes(file.read_bytes())
        last = (done.stderr.splitlines() or [""])[-1]
        return {"tried": "?", "taken": "?", "findings": {f"ended with {done.returncode}: {last:.100}": 1}}


def table(records: dict[str, dict[str, object]], minutes: float, first_seed: int) -> list[str]:
    """The record as Markdown."""
    made = software()
    lines = [
        f"`python -m benchmarks.fuzz_loaders --minutes {minutes:g} --seed {first_seed}` on "
        f"{made['machine']}, {made['date']}, revision {made['revision']}. A finding is any exception but "
        f"the project's, more than {BYTES >> 30} GB or more than {SECONDS:g} s. Libraries are not loaded.",
        "",
        "| format | hostile files | taken | findings |",
        "|---|---|---|---|",
    ]
    for name, record in records.items():
        findings = record["findings"]
        assert isinstance(findings, dict)
        said = "; ".join(f"{what} ({count})" for what, count in findings.items()).replace("|", "/") or "0"
        lines.append(f"| {name} | {record['tried']} | {record['taken']} | {said} |")
    return lines


def main() -> int:
    """Run the command; the exit status is 1 where something was found."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.fuzz_loaders", description=__doc__)
    parser.add_argument("--minutes", type=float, default=9.0, help="for all formats together (%(default)g)")
    parser.add_argument("--seed", type=int, default=1, help="of the first round (%(default)s)")
    parser.add_argument("--only", choices=FORMATS, help="one format, in this process; prints JSON")
    parser.add_argument("--folder", type=Path, help="of that: an empty one")
    parser.add_argument("--text", type=Path, help=f"file with marks <!-- {MARK} --> for the record")
    parser.add_argument(
        "--kept",
        type=Path,
        default=Path("build/fuzz_loaders"),
        help="for files that end a process (%(default)s)",
    )
    options = parser.parse_args()
    if options.only:
        print(json.dumps(fuzz(options.only, options.seed, 60.0 * options.minutes, options.folder)))
        return 0
    seconds = 60.0 * options.minutes / len(FORMATS)
    records: dict[str, dict[str, object]] = {}
    for name in FORMATS:
        records[name] = _in_a_process(name, options.seed, seconds, options.kept)
        print(f"{name}: {json.dumps(records[name])}", file=sys.stderr, flush=True)
    lines = table(records, options.minutes, options.seed)
    print("\n".join(lines))
    try:
        if options.text:
            fill_block(options.text, MARK, "\n".join(lines))
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return int(any(record["findings"] for record in records.values()))


if __name__ == "__main__":
    sys.exit(main())

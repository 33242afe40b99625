"""The table of scores and the list of survivors, with what is said about each by hand."""

import datetime
import platform
import subprocess
import tomllib
from pathlib import Path

from benchmarks.mutation.runner import ROOT, Outcome, Package, known

PAGE = ROOT / "tests" / "MUTATION.md"
EXPLANATIONS = Path(__file__).parent / "survivors.toml"

HEAD = """# Mutation testing

Written by `make mutation` (`python -m benchmarks.mutation`); `benchmarks/mutation/packages.toml` says what is
mutated, and by which tests it has to be noticed. Faults are put in one by one, at places drawn at random from
all places of a package: Python's by cosmic-ray's operators, C's by a table of replacements and by leaving out
statements. A fault that the tests notice, or that makes them run three times as long, is killed; one that
does not compile does not count.
"""


def explanations() -> dict[tuple[str, str, str], str]:
    """What is said about survivors, by source, line and what the line became."""
    entries = tomllib.loads(EXPLANATIONS.read_text("utf-8")).get("survivor", [])
    return {(entry["path"], entry["before"], entry["after"]): entry["why"] for entry in entries}


def page(packages: list[Package]) -> str:
    """The whole page, from the outcomes that are known of these packages."""
    lines = [HEAD, _when(), "", "| package | places | tried | killed | survived | explained | score |"]
    lines.append("|---|---:|---:|---:|---:|---:|---:|")
    said, survivors = explanations(), []
    for package in packages:
        outcomes = _of(package)
        counted = [outcome for outcome in outcomes if outcome.how != "not compiled"]
        alive = [outcome for outcome in counted if outcome.how == "survived"]
        explained = sum(_key(outcome) in said for outcome in alive)
        killed = len(counted) - len(alive)
        score = f"{100.0 * killed / len(counted):.0f} %" if counted else "none yet"
        numbers = [package.places, len(counted), killed, len(alive), explained]
        lines.append(f"| {package.name} | {' | '.join(map(str, numbers))} | {score} |")
        survivors += alive
    lines += ["", "## Survivors", ""]
    for outcome in sorted(survivors, key=lambda outcome: (outcome.package, outcome.path, outcome.line)):
        why = said.get(_key(outcome), "**not explained**")
        lines.append(f"- {outcome.package}, `{outcome.path}:{outcome.line}`: `{outcome.before}` became")
        lines.append(f"  `{outcome.after}`. {why}")
    return "\n".join([*lines, ""])


def _key(outcome: Outcome) -> tuple[str, str, str]:
    return outcome.path, outcome.before, outcome.after


def _of(package: Package) -> list[Outcome]:
    # A survivor of earlier tests counts as one until it is tried again.
    earlier = known()
    found = [earlier.get((package.name, mutant.digest)) for mutant in package.mutants]
    return [outcome for outcome in found if outcome is not None]


def _when() -> str:
    revision = subprocess.run(
        ["git", "describe", "--always", "--dirty", "--abbrev=10"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    ).stdout.strip()  # fmt: skip
    today = datetime.datetime.now(datetime.UTC).date().isoformat()
    return f"{today}, revision {revision}, {platform.machine()}, Python {platform.python_version()}."

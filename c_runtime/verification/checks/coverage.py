"""Line and branch coverage of the exported guidance from gcov, against the gaps that have a reason.

Fails on a line or branch that nothing reaches and that is not listed, and on a listed one that is reached. A
condition that compiles to no branch has no counts: it is a gap too.
"""

import json
import re
import subprocess
import sys
import tomllib
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from c_runtime.builds import BUILDS
from c_runtime.verification.checks.flight_file import tags

_PRECISION = re.compile(r"_f(32|64)$")
_CONDITION = re.compile(r"\bif \(| \? |&&|\|\|")


@dataclass(frozen=True)
class Gap:
    """What is not seen of a line: ``lines`` 1 if nothing reaches it, how many of its branches nothing takes,
    and ``uncounted`` if it is a condition without branches.
    """

    function: str
    text: str
    lines: int = 0
    branches: int = 0
    uncounted: bool = False

    def __str__(self) -> str:
        if self.uncounted:
            return f"{self.function}: a condition that compiles to no branch: {self.text}"
        reached = f"{self.lines} line(s), {self.branches} branch(es)"
        return f"{self.function}: nothing reaches {reached} of: {self.text}"


@dataclass
class Coverage:
    """Sums over all runs of one build: executions of each line and of each of its branches."""

    lines: Counter[tuple[str, int]] = field(default_factory=Counter)
    branches: Counter[tuple[str, int, int]] = field(default_factory=Counter)

    def add(self, report: str, name: str) -> None:
        """Add what one object file's JSON reports about the file of this name."""
        files = [file for file in json.loads(report)["files"] if Path(file["file"]).name == name]
        if not files:
            raise ValueError(f"gcov reports nothing about {name}: was it compiled with --coverage?")
        for line in files[0]["lines"]:
            # As the source has it: symbols end in the precision.
            key = (_PRECISION.sub("", line.get("function_name", "")), line["line_number"])
            self.lines[key] += line["count"]
            for i, branch in enumerate(line["branches"]):
                self.branches[(*key, i)] += branch["count"]

    def gaps(self, source: list[str]) -> list[Gap]:
        """The lines with a part that nothing reaches or counts."""
        branching = {(function, number) for function, number, _ in self.branches}
        missing = Counter((function, number) for (function, number, _), n in self.branches.items() if n == 0)
        gaps = []
        for key, count in sorted(self.lines.items(), key=lambda item: item[0][1]):
            function, number = key
            text = source[number - 1].strip()
            uncounted = key not in branching and bool(_CONDITION.search(text.split("/*")[0]))
            if count == 0 or missing[key] or uncounted:
                gaps.append(Gap(function, text, int(count == 0), missing[key], uncounted))
        return gaps


def measured(folder: Path, name: str) -> Coverage:
    """Coverage of the file of this name by every program that ran in the folder."""
    coverage = Coverage()
    for data in sorted(folder.glob("*.gcda")):
        run = subprocess.run(
            ["gcov", "--json-format", "--stdout", "--branch-probabilities", data.name],
            cwd=folder,
            capture_output=True,
            text=True,
            check=True,
        )
        coverage.add(run.stdout, name)
    if not coverage.lines:
        raise ValueError(f"no program left its counts in {folder}: run make coverage-c")
    return coverage


@dataclass(frozen=True)
class Explained:
    """A gap that has a reason.

    Attributes:
        gap: what is not seen.
        builds: tags of the builds it is in.
        rare: whether the networks decide if it is seen: then it need be no gap, nor miss as much.
    """

    gap: Gap
    builds: frozenset[str]
    rare: bool = False

    def covers(self, found: Gap) -> bool:
        """Whether it explains what was found."""
        if self.rare:
            return (found.function, found.text) == (self.gap.function, self.gap.text)
        return found == self.gap


def explained(text: str) -> list[Explained]:
    """The gaps that have a reason.

    Raises:
        ValueError: a gap without a reason.
    """
    found = []
    for entry in tomllib.loads(text).get("gap", []):
        if not entry.get("reason"):
            raise ValueError(f"the gap in {entry['function']} needs a reason")
        del entry["reason"]
        builds = frozenset(entry.pop("in", []))
        rare = bool(entry.pop("rare", False))
        found.append(Explained(Gap(**entry), builds, rare))
    return found


def judge(found: list[Gap], listed: list[Explained], build: frozenset[str]) -> list[str]:
    """Complaints about one build: gaps without a reason, and reasons without a gap."""
    expected = [one for one in listed if one.builds <= build]
    return [str(gap) for gap in found if not any(one.covers(gap) for one in expected)] + [
        f"listed with a reason, but not so any more: {one.gap}"
        for one in expected
        if not one.rare and one.gap not in found
    ]


def main(arguments: list[str]) -> int:
    """Arguments: exported folder, gaps with reasons, ``build=folder`` for each. Returns the exit status."""
    exported, gaps, *runs = arguments
    listed = explained(Path(gaps).read_text())
    failed = False
    for run in runs:
        build, folder = run.split("=", 1)
        path = Path(exported) / BUILDS[build].source
        coverage = measured(Path(folder), path.name)
        found = coverage.gaps(path.read_text().splitlines())
        complaints = judge(found, listed, tags(build, path.parent))
        failed = failed or bool(complaints)
        for complaint in complaints:
            print(f"coverage {build}: {complaint}")
        lines, branches = len(coverage.lines), len(coverage.branches)
        print(
            f"coverage {build}: {lines - sum(gap.lines for gap in found)} of {lines} lines, "
            f"{branches - sum(gap.branches for gap in found)} of {branches} branches"
            + ("" if complaints else f"; {len(found)} gap(s), with a reason")
        )
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

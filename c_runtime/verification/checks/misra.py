"""cppcheck and its MISRA C:2012 add-on over the flight file, against the deviations that MISRA.md lists.

Fails on whatever else cppcheck finds, on a violation that is not listed, and on a listed one that is gone.
"""

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

from c_runtime.builds import BUILDS, HEADER
from c_runtime.verification.checks.flight_file import places, tags

# The flight file is a library: nothing here calls it. Headers of the system are not read.
OPTIONS = (
    "--quiet",
    "--std=c99",
    "--enable=all",
    "--addon=misra",
    "--inline-suppr",
    "--suppress=missingIncludeSystem",
    "--suppress=unusedFunction",
    "--template={file}|{line}|{id}|{message}",
)
HEADINGS = ["Rule", "Category", "Where", "In", "Why"]
MISRA = "misra-c2012-"


@dataclass(frozen=True)
class Deviation:
    """One place of a row of MISRA.md: a glob of function names, and the tags of the builds it is about."""

    rule: str
    where: str
    builds: frozenset[str]

    def covers(self, rule: str, place: str, build: frozenset[str]) -> bool:
        """Whether the row is about this violation."""
        return rule == self.rule and self.applies(build) and fnmatchcase(place, self.where)

    def applies(self, build: frozenset[str]) -> bool:
        """Whether the row is about this build."""
        return self.builds <= build


@dataclass(frozen=True)
class Finding:
    """What cppcheck says about one line."""

    file: str
    line: int
    what: str
    message: str
    place: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line} (in {self.place}): {self.what} {self.message}"


def read_deviations(text: str) -> list[Deviation]:
    """The places of each row of the table in MISRA.md.

    Raises:
        ValueError: a row without a reason, or of another shape.
    """
    rows = [
        [cell.strip() for cell in line.strip().strip("|").split("|")]
        for line in text.splitlines()
        if line.startswith("|")
    ]
    if not rows or rows[0] != HEADINGS:
        raise ValueError(f"MISRA.md needs one table with the columns {', '.join(HEADINGS)}")
    deviations = []
    for row in rows[2:]:
        if len(row) != len(HEADINGS) or not all(row):
            raise ValueError(f"MISRA.md: a row needs all of {', '.join(HEADINGS)}: {row}")
        rule, _, where, builds, _ = row
        tagged = frozenset(set(builds.split()) - {"all"})
        deviations += [Deviation(rule, glob.strip(" `"), tagged) for glob in where.split(",")]
    return deviations


def findings(exported: Path, build: str) -> list[Finding]:
    """What cppcheck finds in one build of what is in a folder.

    Raises:
        RuntimeError: cppcheck, or its add-on, did not run through.
    """
    with tempfile.TemporaryDirectory() as folder:
        # A copy: the add-on works on files that it writes beside the source.
        for name in (BUILDS[build].source, HEADER):
            shutil.copy(exported / name, folder)
        undefined = [] if BUILDS[build].defines else ["-USAILNET_FLOAT64"]
        command = ["cppcheck", *OPTIONS, *BUILDS[build].defines, *undefined, BUILDS[build].source]
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    found = []
    for line in (run.stdout + run.stderr).splitlines():
        name, number, what, message = (*line.split("|", 3), "", "", "")[:4]
        if not number or what == "internalError":
            raise RuntimeError(f"cppcheck did not run through: {line}")
        place = places((exported / name).read_text())[int(number) - 1]
        found.append(Finding(name, int(number), what, "" if what.startswith(MISRA) else message, place))
    if run.returncode != 0:
        raise RuntimeError(f"cppcheck ended with {run.returncode}: {run.stderr}")
    return found


def judge(
    found: dict[str, list[Finding]], deviations: Iterable[Deviation], tags_of: dict[str, frozenset[str]]
) -> list[str]:
    """Complaints: what is found and not listed, and what is listed and not found.

    Args:
        found: findings of each build.
        deviations: those that are listed.
        tags_of: tags of each build.
    """
    listed = dict.fromkeys(deviations, False)
    complaints = []
    for build, of_build in found.items():
        for finding in of_build:
            rule = finding.what.removeprefix(MISRA)
            rows = [row for row in listed if row.covers(rule, finding.place, tags_of[build])]
            listed.update(dict.fromkeys(rows, True))
            if not rows:
                complaints.append(f"{build}: {finding}")
    complaints += [
        f"MISRA.md lists a deviation from rule {row.rule} in {row.where}, but there is none"
        for row, seen in listed.items()
        if not seen and any(row.applies(build) for build in tags_of.values())
    ]
    return complaints


def main(arguments: list[str]) -> int:
    """Arguments: exported folder, MISRA.md, builds. Returns the exit status."""
    folder, listed, *builds = arguments
    path = Path(folder)
    deviations = read_deviations(Path(listed).read_text())
    with ThreadPoolExecutor(2) as pool:
        found = dict(zip(builds, pool.map(lambda build: findings(path, build), builds), strict=True))
    complaints = judge(found, deviations, {build: tags(build, path) for build in builds})
    for complaint in complaints:
        print(complaint)
    if not complaints:
        counts = ", ".join(f"{build} {len(of_build)}" for build, of_build in found.items())
        print(f"misra: every deviation is listed ({counts}); cppcheck finds nothing else")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""``python -m benchmarks.evidence``: which generated figures are older than the sources they depend on.

Every block between ``<!-- name -->`` marks, and every text that a command writes whole, is declared in
``evidence.toml`` with the sources that its figures depend on. A block names its revision. It is stale when
the code of one of these sources has changed since, comments apart, unless it is exempt with a reason, until a
date. Needs git.
"""

import argparse
import ast
import json
import re
import subprocess
import sys
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from datetime import UTC, date, datetime
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

from sailnet.artefacts.files import split_at_block
from sailnet.campaign.tables import Table
from sailnet.errors import SailnetError
from sailnet.mission.mission import shipped_missions

ROOT = Path(__file__).resolve().parents[1]

DECLARED = Path(__file__).with_name("evidence.toml")

MARK = re.compile(r"^<!-- ([^/].*?) -->$", re.M)

REVISION = re.compile(r"revision ([0-9a-f]{7,40})(-dirty)?")

MAIN = "earth_mars"
"""The mission of a block that names none."""

WHOLE = ""
"""Name of the block of a text that a command writes whole."""


@dataclass(frozen=True)
class Evidence:
    """A generated block and what is known of its age.

    Attributes:
        file: path of the text in the repository.
        block: name of its marks; ``WHOLE`` for all of it.
        revisions: that it names.
        made: date of the oldest of them; empty without any.
        state: ``fresh``, ``empty`` and ``exempt`` are valid; ``stale``, ``dirty``, ``undeclared``,
            ``no revision`` and ``unknown revision`` are not.
        detail: the first source that changed; the reason of an exemption and the day it ends.
    """

    file: str
    block: str
    revisions: tuple[str, ...]
    made: str
    state: str
    detail: str = ""

    @property
    def valid(self) -> bool:
        """Whether the figures may stand."""
        return self.state in ("fresh", "empty", "exempt")


def git(root: Path, *arguments: str) -> str:
    """What git prints.

    Raises:
        SailnetError: git fails, or is not there.
    """
    try:
        done = subprocess.run(
            ["git", "-C", str(root), *arguments], capture_output=True, text=True, check=True
        )
    except (OSError, subprocess.CalledProcessError) as error:
        raise SailnetError(f"git {' '.join(arguments)} fails: {getattr(error, 'stderr', error)}") from error
    return done.stdout


def examine(root: Path, declared: Mapping[str, Any], today: date) -> list[Evidence]:
    """Every generated block of a repository, in order of file and place.

    Args:
        root: of the repository.
        declared: content of ``evidence.toml``.
        today: exemptions that ended before it do not count.

    Raises:
        SailnetError: git fails, or the declarations are not understood.
    """
    tracked = [name for name in git(root, "ls-files", "*.md").splitlines() if (root / name).exists()]
    found = []
    for name in tracked:
        text = (root / name).read_text("utf-8")
        blocks = MARK.findall(text)
        whole = _declaration(declared, name, WHOLE)
        if whole is not None:
            found.append(_examined(root, declared, whole, name, WHOLE, text, today))
        for block in blocks:
            if f"<!-- /{block} -->" in text:
                content = split_at_block(root / name, block)[1]
                one = _declaration(declared, name, block)
                found.append(_examined(root, declared, one, name, block, content, today))
    return found


def _declaration(declared: Mapping[str, Any], file: str, block: str) -> Mapping[str, Any] | None:
    for one in declared["block"]:
        name = one.get("name", WHOLE)
        if fnmatch(file, one["file"]) and (fnmatch(block, name) if block and name else block == name):
            return dict(one)
    return None


def _examined(
    root: Path,
    declared: Mapping[str, Any],
    one: Mapping[str, Any] | None,
    file: str,
    block: str,
    content: str,
    today: date,
) -> Evidence:
    named = REVISION.findall(content)
    revisions = tuple(dict.fromkeys(f"{revision}{dirty}" for revision, dirty in named))
    known = [_date(root, revision) for revision, _ in named]
    made = min((day for day in known if day), default="")

    def is_(state: str, detail: str = "") -> Evidence:
        return Evidence(file, block, revisions, made, state, detail)

    if one is None:
        return is_("undeclared")
    if "|" not in content:
        return is_("empty")
    if any(dirty for _, dirty in named):
        return is_("dirty")
    if exempt := one.get("exempt"):
        until = exempt["until"]
        if until >= today:
            return is_("exempt", f"until {until}: {exempt['reason']}")
    if one.get("derived"):
        return is_("fresh", f"derived: {one['derived']}")
    if not named:
        return is_("no revision")
    if None in known:
        return is_(
            "unknown revision", next(r for (r, _), day in zip(named, known, strict=True) if day is None)
        )
    paths = [path for group in one["sources"] for path in declared["sources"][group]]
    paths = [path.replace("{mission}", _mission(file, block)) for path in paths]
    for revision in {revision for revision, _ in named}:
        differing = git(root, "diff", "--name-only", revision, "--", *paths).splitlines()
        if changed := [name for name in differing if not _is_same_code(root, revision, name)]:
            more = f" and {len(changed) - 1} more" if len(changed) > 1 else ""
            return is_("stale", f"{changed[0]}{more} changed since {revision}")
    return is_("fresh")


def _is_same_code(root: Path, revision: str, name: str) -> bool:
    """Whether a file differs from that of a revision by comments, docstrings and layout alone."""
    if not (root / name).is_file() or not git(root, "ls-tree", revision, "--", name):
        return False
    if not name.endswith((".py", ".c", ".h", ".inc")):
        return False
    before, now = git(root, "show", f"{revision}:{name}"), (root / name).read_text("utf-8")
    return code_of(name, before) == code_of(name, now)


def code_of(name: str, text: str) -> str:
    """What decides figures in a source of Python or C: all but comments, docstrings and layout.

    Args:
        name: of the file, which tells the language.
        text: its content.
    """
    if not name.endswith(".py"):
        # A comment within a string of C would be taken for one: none of ours has one.
        return " ".join(re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.S).split())
    tree = ast.parse(text)
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            node.body = [line for line in body if not _is_text(line)]  # type: ignore[attr-defined]
    return ast.dump(tree)


def _is_text(line: ast.AST) -> bool:
    """A docstring, or what stands below a constant and tells its meaning."""
    return (
        isinstance(line, ast.Expr)
        and isinstance(line.value, ast.Constant)
        and isinstance(line.value.value, str)
    )


def _mission(file: str, block: str) -> str:
    """The mission that a block is of: the last word of its name, or the folder of its text."""
    last = (block.split() or [""])[-1]
    if last in shipped_missions():
        return last
    folder = Path(file).parent.name
    return folder if folder in shipped_missions() else MAIN


def _date(root: Path, revision: str) -> str | None:
    try:
        return git(root, "show", "-s", "--format=%cs", f"{revision}^{{commit}}").strip()
    except SailnetError:
        return None


def load_declared(path: Path = DECLARED) -> dict[str, Any]:
    """The declarations."""
    return tomllib.loads(path.read_text("utf-8"))


def table(found: Sequence[Evidence]) -> Table:
    """A row for each block."""
    cells = [
        [one.file, one.block or "(whole)", ", ".join(one.revisions[:2]), one.made, one.state, one.detail]
        for one in found
    ]
    return Table("Evidence", ["file", "block", "revision", "date", "state", ""], cells)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; 0, or 1 if a block is not valid."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.evidence", description=__doc__,
        epilog="example: python -m benchmarks.evidence --json",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    options = parser.parse_args(arguments)
    try:
        found = examine(ROOT, load_declared(), datetime.now(UTC).date())
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    invalid = [one for one in found if not one.valid]
    if options.json:
        print(json.dumps({"blocks": [asdict(one) for one in found], "invalid": len(invalid)}))
    else:
        print(
            "\n".join([*table(found).lines(), "", f"{len(found)} blocks, {len(invalid)} of them not valid"])
        )
    return int(bool(invalid))


if __name__ == "__main__":
    sys.exit(main())

"""Figures are younger than the sources they depend on, and one that is not is found."""

import subprocess
from datetime import UTC, date, datetime
from pathlib import Path
from typing import Any

import pytest

from benchmarks.evidence import Evidence, code_of, examine, load_declared
from tests.paths import ROOT

pytestmark = pytest.mark.repository

TODAY = date(2026, 11, 27)
DECLARED: dict[str, Any] = {
    "sources": {"law": ["law.c"], "networks": ["{mission}/weights"]},
    "block": [{"file": "README.md", "name": "table*", "sources": ["law"]}],
}


def git(folder: Path, *arguments: str) -> str:
    command = ["git", "-C", str(folder), "-c", "user.name=t", "-c", "user.email=t@t", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def commit(folder: Path) -> str:
    git(folder, "add", "-A")
    git(folder, "commit", "-qm", "step")
    return git(folder, "rev-parse", "--short", "HEAD")


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    git(tmp_path, "init", "-q")
    (tmp_path / "law.c").write_text("1")
    write(tmp_path, commit(tmp_path))
    commit(tmp_path)
    return tmp_path


def write(folder: Path, revision: str, mark: str = "table", content: str = "| 1 |") -> None:
    text = f"<!-- {mark} -->\nrevision {revision}\n{content}\n<!-- /{mark} -->\n"
    (folder / "README.md").write_text(text)


def only(folder: Path, declared: dict[str, Any] = DECLARED, today: date = TODAY) -> Evidence:
    (found,) = examine(folder, declared, today)
    return found


def test_a_block_is_stale_once_a_source_of_its_figures_has_changed(repository: Path) -> None:
    assert only(repository).state == "fresh"
    (repository / "other.c").write_text("2")
    commit(repository)
    assert only(repository).state == "fresh"
    (repository / "law.c").write_text("2")  # not committed yet
    assert only(repository).state == "stale"
    revision = commit(repository)
    assert only(repository).state == "stale"
    assert "law.c" in only(repository).detail
    assert not only(repository).valid
    write(repository, revision)
    assert only(repository).valid


def test_a_comment_changes_no_figure(repository: Path) -> None:
    (repository / "law.c").write_text("/* One. */\n1  // again\n")
    commit(repository)
    assert only(repository).state == "fresh"
    (repository / "law.c").unlink()
    commit(repository)
    assert only(repository).state == "stale"


@pytest.mark.parametrize(
    ("name", "before", "same", "other"),
    [
        (
            "a.py",
            'X = 1\n"""One."""\n\n\ndef f():\n    """Of x."""\n    return X\n',
            'X = 1  # one\n"""Another."""\ndef f():\n    return (X)\n',
            'X = 2\n"""One."""\n\n\ndef f():\n    """Of x."""\n    return X\n',
        ),
        ("a.c", "int x; /* one\nline */ int y;", "int x;\n\nint y; // two", "int x; int z;"),
        ("a.inc", "#define A 1", "#define  A 1 /* one */", "#define A 1u"),
    ],
)
def test_code_is_what_is_left_without_texts(name: str, before: str, same: str, other: str) -> None:
    assert code_of(name, before) == code_of(name, same)
    assert code_of(name, before) != code_of(name, other)


def test_what_does_not_name_a_clean_known_revision_is_not_valid(repository: Path) -> None:
    clean = only(repository).revisions[0]
    for revision, state in (
        (f"{clean}-dirty", "dirty"),
        ("0123456", "unknown revision"),
        ("", "no revision"),
    ):
        write(repository, revision)
        assert (only(repository).state, only(repository).valid) == (state, False)
    write(repository, clean, mark="another")
    assert (only(repository).state, only(repository).valid) == ("undeclared", False)
    write(repository, "", content="not measured")
    assert (only(repository).state, only(repository).valid) == ("empty", True)


def test_an_exemption_ends_on_its_day_and_excuses_no_dirty_tree(repository: Path) -> None:
    block = {**DECLARED["block"][0], "exempt": {"reason": "slow", "until": TODAY}}
    declared = {**DECLARED, "block": [block]}
    (repository / "law.c").write_text("2")
    assert only(repository, declared).state == "exempt"
    assert only(repository, declared, date(2026, 11, 28)).state == "stale"
    write(repository, f"{only(repository).revisions[0]}-dirty")
    assert only(repository, declared).state == "dirty"


def test_the_mission_of_a_block_says_which_networks_it_depends_on(repository: Path) -> None:
    declared = {**DECLARED, "block": [{"file": "README.md", "name": "table *", "sources": ["networks"]}]}
    write(repository, only(repository).revisions[0], mark="table earth_venus")
    for mission, state in (("earth_mars", "fresh"), ("earth_venus", "stale")):
        (repository / mission).mkdir()
        (repository / mission / "weights").write_text("1")
        commit(repository)
        assert only(repository, declared).state == state


def test_no_figure_of_this_repository_is_older_than_its_sources() -> None:
    found = examine(ROOT, load_declared(), datetime.now(UTC).date())
    assert len(found) > 30
    assert [f"{one.file} {one.block}: {one.state}, {one.detail}" for one in found if not one.valid] == []

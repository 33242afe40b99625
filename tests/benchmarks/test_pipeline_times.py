"""Times of the pipeline: a clone of the revision asked for, every stage by make, and a table of them."""

import subprocess
from pathlib import Path

import pytest

from benchmarks.pipeline_times import MARK, STAGES, Stage, clone, lines, main, measure
from sailnet.errors import SailnetError
from tests.tools import missing, needs

pytestmark = needs("repository", missing("git"), "git")

MAKEFILE = "{}:\n\t@echo $(MISSION) $(SIZE) $@ >> made\n\t@sleep 0.1\n\t@[ $@ != {} ]\n"


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """Of two commits; the first's `train` fails."""
    folder = tmp_path / "given"
    folder.mkdir()
    git(folder, "init", "--quiet")
    for failing in ("train", "none"):
        (folder / "Makefile").write_text(MAKEFILE.format(" ".join(STAGES), failing))
        git(folder, "add", "Makefile")
        git(folder, "-c", "user.name=a", "-c", "user.email=a@b", "commit", "--quiet", "-m", failing)
    return folder


def git(folder: Path, *arguments: str) -> None:
    subprocess.run(["git", "-C", str(folder), *arguments], check=True)


def test_every_stage_is_made_in_a_clone_of_the_revision(repository: Path, tmp_path: Path) -> None:
    (repository / "Makefile").write_text("not committed")
    there = tmp_path / "there"
    assert clone(repository, there, "HEAD")
    stages = measure(there, ["MISSION=x", "SIZE=quick"])
    assert (there / "made").read_text().splitlines() == [f"x quick {stage}" for stage in STAGES]
    assert [stage.target for stage in stages] == list(STAGES)
    assert all(stage.wall >= 0.1 > stage.processor > 0.0 for stage in stages)


def test_a_stage_that_fails_ends_it(repository: Path, tmp_path: Path) -> None:
    there = tmp_path / "there"
    clone(repository, there, "HEAD~1")
    with pytest.raises(SailnetError, match="make train ended with status 2"):
        measure(there, [])
    assert not main(["--repository", str(repository)])
    assert main(["--repository", str(repository), "--revision", "HEAD~1"]) == 1
    assert main(["--repository", str(repository), "--revision", "none"]) == 1


def test_the_table_ends_with_the_sum_and_goes_into_a_text(repository: Path, tmp_path: Path) -> None:
    assert lines([Stage("setup", 60.4, 30.0), Stage("all", 1.2, 0.3)])[-3:] == [
        "| setup | 60 | 30 |",
        "| all | 1 | 0 |",
        "| together | 62 | 30 |",
    ]
    text = tmp_path / "RESULTS.md"
    text.write_text(f"# Times\n\n<!-- {MARK} -->\n<!-- /{MARK} -->\n")
    assert main(["--repository", str(repository), "--text", str(text), "--size", "quick"]) == 0
    assert "--mission earth_mars --size quick --revision" in text.read_text()
    assert text.read_text().count("\n| ") == 2 + len(STAGES) + 1

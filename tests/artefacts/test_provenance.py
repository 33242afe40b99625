"""The revision that artefacts name: that of the sources, whatever was written into texts."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.paths import ROOT

pytestmark = pytest.mark.repository

ASK = "from sailnet.artefacts.provenance import software; print(software()['revision'])"


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    for name in ("__init__.py", "errors.py"):
        (tmp_path / "sailnet").mkdir(exist_ok=True)
        shutil.copy(ROOT / "sailnet" / name, tmp_path / "sailnet")
    shutil.copytree(ROOT / "sailnet/artefacts", tmp_path / "sailnet/artefacts")
    (tmp_path / "RESULTS.md").write_text("before\n")
    git(tmp_path, "init", "-q")
    git(tmp_path, "add", "-A")
    git(tmp_path, "commit", "-qm", "all of it")
    return tmp_path


def git(folder: Path, *arguments: str) -> str:
    command = ["git", "-C", str(folder), "-c", "user.name=t", "-c", "user.email=t@t", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def revision(checkout: Path) -> str:
    command = [sys.executable, "-c", f"import sys; sys.path.insert(0, {str(checkout)!r}); {ASK}"]
    return subprocess.run(command, cwd=checkout, capture_output=True, text=True, check=True).stdout.strip()


def test_a_changed_text_is_the_same_revision_and_a_changed_source_is_not(checkout: Path) -> None:
    head = git(checkout, "rev-parse", "--short", "HEAD")
    assert revision(checkout) == head
    (checkout / "RESULTS.md").write_text("a table\n")
    assert revision(checkout) == head
    (checkout / "sailnet" / "errors.py").write_text((checkout / "sailnet/errors.py").read_text() + "# more\n")
    assert revision(checkout) == f"{head}-dirty"


def test_without_a_repository_it_is_not_known(checkout: Path) -> None:
    shutil.rmtree(checkout / ".git")
    assert revision(checkout) == "unknown"

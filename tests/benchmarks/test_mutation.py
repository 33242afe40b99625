"""Mutation testing: what is mutated, what is tried again, and what the page says."""

import subprocess
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

from benchmarks.mutation import report, runner
from benchmarks.mutation.mutants import Mutant, places, sample
from benchmarks.mutation.runner import MutationError, Outcome, Package, holds, known, try_all
from tests.tools import missing, needs, needs_peer

needs_git = needs("analyser", missing("git"), "git")

C = """/* a + b < c */
#include "x + y.h"
#define LIMIT 3
double f(double a)
{
    a = a + 1.5;
    return a < LIMIT ? a : 0.0;
}
"""
PYTHON = '''"""1 + 2"""
def f(a: int | None = 3) -> int | None:
    return None if a is None else a + 1  # 4 + 5
'''


def faults(root: Path, name: str, text: str) -> set[tuple[int, str]]:
    (root / name).write_text(text)
    found = places(root, [name])
    made = [changed(text, fault.mutated()) for at in found.values() for fault in at]
    assert len(set(made)) == len(made)
    return set(made)


def changed(text: str, mutated: str | None) -> tuple[int, str]:
    assert mutated is not None
    ((line, after),) = [
        (i, new.strip())
        for i, (old, new) in enumerate(zip(text.splitlines(), mutated.splitlines(), strict=True), 1)
        if old != new
    ]
    return line, after


def test_faults_of_c_are_in_its_code_alone(tmp_path: Path) -> None:
    assert faults(tmp_path, "x.c", C) == {
        (3, "#define LIMIT (3 + 1)"),
        (6, "a = a - 1.5;"),
        (6, "a = a + (1.5 + 1);"),
        (6, ";"),
        (7, "return a <= LIMIT ? a : 0.0;"),
        (7, "return a >= LIMIT ? a : 0.0;"),
        (7, "return a < LIMIT ? a : (0.0 + 1);"),
    }


@needs_peer("cosmic_ray")
def test_faults_of_python_leave_types_and_comments_alone(tmp_path: Path) -> None:
    found = faults(tmp_path, "x.py", PYTHON)
    assert {line for line, _ in found} == {2, 3}
    assert (2, "def f(a: int | None = 4) -> int | None:") in found
    assert (3, "return None if a is not None else a + 1  # 4 + 5") in found
    assert (3, "return None if a is None else a - 1  # 4 + 5") in found
    assert not [after for _, after in found if "int & None" in after or "# 4 - 5" in after]


def test_a_sample_is_of_places_and_the_same_for_a_seed(tmp_path: Path) -> None:
    (tmp_path / "x.c").write_text(C)
    found = places(tmp_path, ["x.c"])
    drawn = sample(tmp_path, found, 4, "1 x")
    assert len({(mutant.line, mutant.before) for mutant in drawn}) >= 2
    assert drawn == sample(tmp_path, found, 4, "1 x")
    assert drawn != sample(tmp_path, found, 4, "2 x")
    assert len(sample(tmp_path, found, 99, "1 x")) == len(found) == 6
    # A line more, and another folder, leave the rest of the sample alone.
    (tmp_path / "moved").mkdir()
    (tmp_path / "moved" / "y.c").write_text(C.replace("    return", "    a = -a;\n    return"))
    moved = sample(tmp_path, places(tmp_path, ["moved/y.c"]), 99, "1 x")
    order = [(mutant.before, mutant.after) for mutant in sample(tmp_path, found, 99, "1 x")]
    assert [(m.before, m.after) for m in moved if m.before != "a = -a;"] == order


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A library of one function, its tests, and where outcomes go."""
    (tmp_path / "double.py").write_text("def double(x):\n    return 2 * x + 0\n")
    (tmp_path / "test_double.py").write_text(
        "from double import double\ndef test_it():\n    assert double(2) == 4\n"
    )
    (tmp_path / "pyproject.toml").write_text("[tool.pytest.ini_options]\npythonpath = ['.']\n")
    (tmp_path / "sailnet").mkdir()
    for command in (
        ["init", "-q"],
        ["add", "."],
        ["-c", "user.name=x", "-c", "user.email=x", "commit", "-qm", "x"],
    ):
        subprocess.run(["git", *command], cwd=tmp_path, check=True)
    monkeypatch.setattr(runner, "ROOT", tmp_path)
    monkeypatch.setattr(runner, "WORK", tmp_path / "build")
    monkeypatch.setattr(report, "ROOT", tmp_path)
    monkeypatch.setattr(report, "EXPLANATIONS", tmp_path / "survivors.toml")
    (tmp_path / "survivors.toml").write_text("")
    (tmp_path / "build").mkdir()
    return tmp_path


def fault(after: str) -> Mutant:
    before = "return 2 * x + 0"
    return Mutant("double.py", 2, before, after, f"def double(x):\n    {after}\n")


def package(*mutants: Mutant) -> Package:
    return Package("double", ("test_double.py",), "", 7, mutants)


@needs_git
def test_mutants_are_tried_and_what_is_known_is_not_tried_again(repository: Path) -> None:
    killed, survivor, slow = map(fault, ("return 3 * x + 0", "return x + x + 0", "while True: pass"))
    wanted = package(killed, survivor, slow)
    assert "| double | 7 | 0 | 0 | 0 | 0 | none yet |" in report.page([wanted])
    try_all([wanted], 2, 10.0)
    outcomes = known()
    assert [outcomes["double", m.digest].how for m in wanted.mutants] == ["killed", "survived", "timeout"]
    page = report.page([wanted])
    assert "| double | 7 | 3 | 2 | 1 | 0 | 67 % |" in page
    assert "`return x + x + 0`. **not explained**" in page
    (repository / "survivors.toml").write_text(
        "[[survivor]]\npath = 'double.py'\nbefore = 'return 2 * x + 0'\n"
        "after = 'return x + x + 0'\nwhy = 'The same.'\n"
    )
    page = report.page([wanted])
    assert "| double | 7 | 3 | 2 | 1 | 1 | 67 % |" in page
    assert "`return x + x + 0`. The same." in page
    # Nothing is left to do: the tests are not even run without a fault.
    lines = (repository / "build" / "outcomes.jsonl").read_text()
    try_all([wanted], 2, 10.0)
    assert (repository / "build" / "outcomes.jsonl").read_text() == lines


@needs_git
def test_tests_that_fail_anyway_say_nothing(repository: Path) -> None:
    (repository / "test_double.py").write_text("def test_it():\n    assert False\n")
    with pytest.raises(MutationError, match="tests fail without a fault: double"):
        try_all([package(fault("return 3 * x"))], 1, 10.0)
    assert known() == {}


def test_a_survivor_of_other_tests_is_tried_again() -> None:
    outcome = Outcome("p", "d", "tests", "x.py", 1, "a", "b", "survived", 1.0)
    assert holds(outcome, "tests")
    assert not holds(outcome, "other tests")
    assert holds(replace(outcome, how="killed"), "other tests")
    assert not holds(None, "tests")


def test_the_tests_that_have_to_notice_exist() -> None:
    """A test that is renamed would end a run that takes an hour."""
    table = tomllib.loads(runner.CONFIGURATION.read_text("utf-8"))
    named = [test for package in table.values() if isinstance(package, dict) for test in package["tests"]]
    assert len(named) > 10
    for test in named:
        path, _, function = test.partition("::")
        assert (runner.ROOT / path).exists(), test
        assert not function or f"\ndef {function}(" in (runner.ROOT / path).read_text("utf-8"), test

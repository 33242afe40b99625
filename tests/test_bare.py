"""What a bare machine has, and that each test which needs more says so."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from tests.paths import ROOT


def bare(*command: str, **variables: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [ROOT / ".ci" / "bare", *command],
        env={**os.environ, **variables}, capture_output=True, text=True, check=False,
    )  # fmt: skip


def test_a_bare_machine_has_a_compiler_and_hides_the_rest(tmp_path: Path) -> None:
    hidden = tmp_path / "frama-c"
    hidden.write_text("#!/bin/sh\n")
    hidden.chmod(0o755)
    path = f"{tmp_path}{os.pathsep}{os.environ['PATH']}"
    assert shutil.which("frama-c", path=path) == str(hidden)
    tools = "cc make python3 frama-c clang g++ qemu-system-arm chromium git"
    script = f"for tool in {tools}; do command -v $tool; done; echo $PATH $SECRET"
    found = bare("sh", "-c", script, PATH=path, SECRET="told").stdout.split()
    folder = Path(found[-1])
    assert found[:-1] == [str(folder / name) for name in ("cc", "make", "python3")]
    assert not folder.exists()


@pytest.mark.slow
def test_a_bare_machine_compiles_and_has_this_python(tmp_path: Path) -> None:
    source = tmp_path / "answer.c"
    source.write_text("int main(void) { return 42; }\n")
    assert bare("sh", "-c", f"cc -o {tmp_path}/answer {source} && {tmp_path}/answer").returncode == 42
    program = "import os, sys; print(os.path.realpath(sys.executable))"
    found = bare("python3", "-c", program, PYTHON3=sys.executable).stdout.strip()
    assert found == str(Path(sys.executable).resolve())


def test_what_continuous_integration_runs_apart_is_every_marker_of_a_tool() -> None:
    markers = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["pytest"]["ini_options"]["markers"]
    (left_out,) = re.findall(r"^TOOLS +:= (.*)$", (ROOT / "Makefile").read_text(), re.MULTILINE)
    assert ["slow", "long", *left_out.split(" or ")] == [text.split(":")[0] for text in markers]


A_TEST = """
import pytest
from tests.tools import needs

@needs("analyser", {absent}, "a-package")
def test_with_a_tool():
    pass

@pytest.mark.mount
def test_that_may_be_skipped():
    pytest.skip("no right")

def test_that_may_not():
    pytest.skip("for whatever reason")
"""


@pytest.mark.parametrize(
    ("ci", "absent", "expected"),
    [
        ("", ["a-tool"], {"skipped": 3}),
        ("", [], {"passed": 1, "skipped": 2}),
        ("true", ["a-tool"], {"failed": 1, "skipped": 1, "error": 1}),
        ("true", [], {"passed": 1, "failed": 1, "skipped": 1}),
    ],
)
def test_a_missing_tool_is_named_and_fails_where_nobody_looks(
    tmp_path: Path, ci: str, absent: list[str], expected: dict[str, int]
) -> None:
    (tmp_path / "test_it.py").write_text(A_TEST.format(absent=absent))
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-c",
        str(ROOT / "pyproject.toml"),
        "--rootdir",
        str(tmp_path),
        "-rfs",
    ]
    done = subprocess.run(
        [*command, "-n0", "-p", "tests.tools", "-p", "no:cacheprovider", tmp_path], cwd=ROOT,
        env={**os.environ, "CI": ci}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    counts = {
        what: int(count) for count, what in re.findall(r"(\d+) (passed|failed|skipped|error)", done.stdout)
    }
    assert counts == expected, done.stdout + done.stderr
    assert ("a-tool not found: apt-get install a-package" in done.stdout) == bool(absent)

"""Markers of tests that need more than Python, make and a C compiler; pyproject.toml says what each is.

``make test`` leaves them out, ``make test-tools`` runs them alone. A test whose tool is not here is skipped
with the line that installs it; where ``CI=true`` it fails.
"""

import importlib.util
import os
import shutil
from collections.abc import Generator, Sequence
from typing import Any

import pytest

from benchmarks.driven_browser import CHROMIUM
from c_runtime.shared_library import find_compiler


def missing(*programs: str) -> list[str]:
    """Those of some programs that are not on PATH."""
    return [program for program in programs if shutil.which(program) is None]


def needs(marker: str, absent: Sequence[str], *packages: str) -> pytest.MarkDecorator:
    """Mark a test by the kind of tool it needs: those that are not here, and Debian's packages of them."""
    return _marked(marker, absent, f"apt-get install {' '.join(packages)}")


def needs_browser() -> pytest.MarkDecorator:
    """Under any of Chromium's names."""
    return needs("browser", CHROMIUM[:1] if missing(*CHROMIUM) == list(CHROMIUM) else [], CHROMIUM[0])


def needs_peer(module: str) -> pytest.MarkDecorator:
    """Mark a test that needs a Python module of the extras ``benchmarks`` and ``mutation``."""
    absent = [module] if importlib.util.find_spec(module) is None else []
    return _marked("peer", absent, "pip install -c constraints.txt -e '.[benchmarks,mutation]'")


def needs_docs() -> pytest.MarkDecorator:
    """Mark a test that needs the extra ``docs``."""
    modules = ("sphinx", "myst_nb", "furo", "pandas")
    absent = [module for module in modules if importlib.util.find_spec(module) is None]
    return _marked("docs", absent, "pip install -c constraints.txt -e '.[docs]'")


def needs_playground() -> pytest.MarkDecorator:
    """Mark a test that compiles to WebAssembly or runs it outside of a browser: the extra ``playground``."""
    absent = [module for module in ("ziglang", "wasmtime") if importlib.util.find_spec(module) is None]
    return _marked("docs", absent, "pip install -c constraints.txt -e '.[playground]'")


def _marked(marker: str, absent: Sequence[str], install: str) -> pytest.MarkDecorator:
    mark: pytest.MarkDecorator = getattr(pytest.mark, marker)
    return mark(absent=tuple(absent), install=install)


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Skip a test whose tool is not here."""
    for mark in item.iter_markers():
        if mark.kwargs.get("absent"):
            pytest.skip(f"{', '.join(mark.kwargs['absent'])} not found: {mark.kwargs['install']}")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Nobody reads what continuous integration skips: there it fails, unless no package could bring it."""
    report = yield
    may_skip = item.get_closest_marker("mount") or item.get_closest_marker("cuda")
    if report.skipped and not may_skip and os.environ.get("CI") == "true":
        report.outcome = "failed"
        report.longrepr = f"where CI=true no test is skipped: {report.longreprtext}"
    return report


LEFT_OUT = pytest.StashKey[int]()


def pytest_deselected(items: Sequence[pytest.Item]) -> None:
    """Processes of xdist do not say how many tests an expression left out."""
    output = getattr(items[0].config, "workeroutput", None)
    if output is not None:
        output["left out"] = output.get("left out", 0) + len(items)


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    """Each process of xdist has collected, and left out, the same."""
    node.config.stash[LEFT_OUT] = getattr(node, "workeroutput", {}).get("left out", 0)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """How many tests were left out."""
    config = terminalreporter.config
    if config.stash.get(LEFT_OUT, 0):
        terminalreporter.write_line(f"{config.stash[LEFT_OUT]} tests deselected")


every_compiler = pytest.mark.parametrize(
    "compiler",
    [
        pytest.param(find_compiler(), id="cc"),
        pytest.param(["clang"], id="clang", marks=needs("analyser", missing("clang"), "clang")),
    ],
)
"""The command of the compiler that the package is built with, and of another."""

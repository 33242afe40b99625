"""Signals end a command within seconds, with one line that says how to go on."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable

import pytest

from sailnet.workers.interruption import run_command
from tests.paths import ROOT
from tests.workers.interrupted import FOREVER, TIDY

AGAIN = "the same command begins again"


def busy(how: str, before: Callable[[], object] | None = None) -> "subprocess.Popen[str]":
    """A command in the middle of its work."""
    run = subprocess.Popen(
        [sys.executable, "-m", "tests.workers.interrupted", how],
        cwd=ROOT, env=os.environ | {"PYTHONPATH": str(ROOT)}, text=True, preexec_fn=before,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip
    assert run.stdout is not None
    assert run.stdout.readline() == "busy\n"
    return run


SOON = {"plain": AGAIN, "telling": "so it goes on", "after an error": AGAIN}
LATE = {"in C": AGAIN, "losing it": AGAIN, "stubborn": AGAIN}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("how", "way_on", "number"),
    [
        *(
            (how, way_on, number)
            for how, way_on in SOON.items()
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
        ),
        *((how, way_on, signal.SIGTERM) for how, way_on in LATE.items()),
    ],
)
def test_one_line_and_no_traceback(how: str, way_on: str, number: signal.Signals) -> None:
    run = busy(how)
    run.send_signal(number)
    out, said = run.communicate(timeout=0.9 * FOREVER)
    # What has to be ended where it is has no time to tidy up.
    assert (out, said) == (TIDY if how in SOON else "", f"interrupted by {number.name}: {way_on}\n")
    assert run.returncode == 128 + number


@pytest.mark.slow
def test_a_second_signal_ends_it_at_once() -> None:
    run = busy("patient")
    run.send_signal(signal.SIGINT)
    time.sleep(0.3)
    assert run.poll() is None
    run.send_signal(signal.SIGINT)
    _, said = run.communicate(timeout=0.9 * FOREVER)
    assert said == f"interrupted by SIGINT: {AGAIN}\n"
    assert run.returncode == 128 + signal.SIGINT


@pytest.mark.slow
def test_what_is_ignored_stays_ignored() -> None:
    """As under nohup."""
    run = busy("plain", lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    run.send_signal(signal.SIGHUP)
    time.sleep(0.5)
    assert run.poll() is None
    run.send_signal(signal.SIGTERM)
    assert run.communicate(timeout=0.9 * FOREVER)[1] == f"interrupted by SIGTERM: {AGAIN}\n"


def test_a_command_that_ends_leaves_no_trace() -> None:
    def state() -> tuple[object, ...]:
        handlers = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)]
        return *handlers, sys.unraisablehook, signal.pthread_sigmask(signal.SIG_BLOCK, ())

    before, during = state(), []

    def command() -> int:
        during.append(state())
        return 7

    assert run_command(command, AGAIN) == 7
    assert state() == before
    assert during[0][:3] != before[:3]

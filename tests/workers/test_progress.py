"""Bars of progress."""

import io
import os
import select
import time

import pytest

from sailnet.workers.progress import progress


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.slow
def test_the_clock_goes_on_while_the_first_piece_is_under_way(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal()
    monkeypatch.setattr("sys.stderr", terminal)
    began = time.monotonic()
    with progress(3, "flight", "toy") as bar:
        while "[00:02<" not in terminal.getvalue() and time.monotonic() - began < 60.0:
            time.sleep(0.05)
        before = terminal.getvalue()
        bar.update(3)
    assert "toy:   0%" in before
    assert "[00:01<" in before
    assert "[00:02<" in before
    assert "3/3" in terminal.getvalue()
    after = terminal.getvalue()
    time.sleep(1.5)
    assert terminal.getvalue() == after


@pytest.mark.slow
@pytest.mark.parametrize(("quiet", "stream"), [(True, Terminal()), (False, io.StringIO())])
def test_there_is_no_bar_where_nobody_looks(
    quiet: bool, stream: io.StringIO, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stderr", stream)
    with progress(2, "flight", quiet=quiet) as bar:
        time.sleep(1.2)
        bar.update()
    assert stream.getvalue() == ""


def test_a_terminal_that_does_not_say_how_wide_it_is_has_a_bar(monkeypatch: pytest.MonkeyPatch) -> None:
    """As a new one does not, until somebody sets its size."""
    reader, writer = os.openpty()
    with os.fdopen(reader, "rb") as seen, os.fdopen(writer, "w") as terminal:
        monkeypatch.setattr("sys.stderr", terminal)
        assert os.get_terminal_size(writer).columns == 0
        with progress(3, "flight", "toy"):
            terminal.flush()
            assert select.select([seen], [], [], 5.0)[0]
            assert b"toy:   0%" in os.read(seen.fileno(), 4096)

"""Nobody waits for a cluster without a word, and not for ever."""

from collections.abc import Callable

import pytest

from sailnet.errors import SailnetError
from sailnet.workers import presence
from sailnet.workers.presence import PATIENCE, Presence

SCHEDULER = "tcp://host:8786"


class Clock:
    def __init__(self) -> None:
        self.now = 5.0

    def monotonic(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    made = Clock()
    monkeypatch.setattr(presence, "time", made)
    return made


def counts(*numbers: int | None) -> Callable[[], int]:
    """So many workers, look by look; None: the scheduler does not answer."""
    left = list(numbers)

    def count() -> int:
        if (number := left.pop(0)) is None:
            raise OSError("refused")
        return number

    return count


def test_it_says_once_who_is_missing_and_once_that_they_are_back(
    clock: Clock, capsys: pytest.CaptureFixture[str]
) -> None:
    looked = Presence(counts(2, 0, 0, 0, 0, 3, 3, 0), SCHEDULER, wait=100.0)
    heard = []
    for later in (0.0, 1.0, PATIENCE - 1.0, 2.0, 2.0, 2.0, 2.0, 2.0):
        clock.now += later
        there = looked.look()
        heard.append((there, capsys.readouterr().err))
    missing = f"no workers at {SCHEDULER}: waiting up to 100 s; start some with `dask worker {SCHEDULER}`\n"
    again = f"workers at {SCHEDULER} again: going on\n"
    assert heard == [
        (True, ""), (False, ""), (False, ""), (False, missing), (False, ""), (True, again), (True, ""),
        (False, ""),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("number", "missing"), [(0, "no workers at"), (None, "no answer from the scheduler at")]
)
def test_it_gives_up(number: int | None, missing: str, clock: Clock) -> None:
    looked = Presence(counts(number, 1, *[number] * 4), SCHEDULER, wait=30.0)
    assert not looked.look()
    assert looked.look()
    for _ in range(3):
        assert not looked.look()
        clock.now += 10.0
    with pytest.raises(SailnetError, match=rf"{missing} {SCHEDULER} for 30 s: .* the same command again"):
        looked.look()

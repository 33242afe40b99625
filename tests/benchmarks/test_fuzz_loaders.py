"""Hostile files, a few of every format: taken, or refused in the project's words, in time and memory."""

from pathlib import Path
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from benchmarks.fuzz_loaders.attempt import BYTES, attempt
from benchmarks.fuzz_loaders.formats import FORMATS, Format

FEW = {"data set": 15, "results": 15, "graph": 25, "network": 40}
"""Of formats that take some tens of milliseconds to load; of the others a hundred."""


@pytest.fixture(scope="module", params=FORMATS)
def whole(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """A format and a good file of it."""
    name: str = request.param
    return name, FORMATS[name].make(tmp_path_factory.mktemp("whole"))


@pytest.mark.slow
def test_a_hostile_file_is_taken_or_refused_in_words(whole: tuple[str, Path]) -> None:
    name, path = whole

    @settings(
        max_examples=FEW.get(name, 100), deadline=None, suppress_health_check=list(HealthCheck), database=None
    )
    @given(st.randoms(use_true_random=False))
    def try_one(random: Random) -> None:
        assert attempt(FORMATS[name], path, random).finding == ""

    FORMATS[name].load(path)  # before it is spoilt
    try_one()


def _does(what: str) -> Format:
    def load(_: Path) -> object:
        if what == "raises":
            raise KeyError("mission")
        return len(b"x" * (BYTES + (1 << 28)))

    return Format(lambda folder: folder, lambda _, __: None, load)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("what", "said"), [("raises", "KeyError: 'mission' (test_fuzz"), ("fills memory", " GB")]
)
def test_what_a_loader_may_not_do_is_a_finding(what: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    assert said in attempt(_does(what), tmp_path / "file", Random(0)).finding

"""The proof of bounded, finite commands holds for every form of networks, and guards taken away break it."""

import itertools
import shutil
from collections.abc import Iterable
from pathlib import Path

import pytest

from c_runtime.builds import BUILDS, Build
from c_runtime.shared_library import TRACKER
from c_runtime.verification.proof.__main__ import main
from c_runtime.verification.proof.eva import FRAMA_C, ProofError, analyse, analyse_tracker
from c_runtime.verification.proof.lemmas import check_lemmas
from c_runtime.verification.proof.mutants import MUTANTS, Mutant, caught, mutate
from sailnet.mission.mission import Mission
from tests.conftest import Exported
from tests.guidance.space_export import AGEING, write_only
from tests.random_networks import random_guidance_in_space
from tests.tools import missing, needs

with_frama_c = needs("analyser", missing(FRAMA_C), "frama-c-base")


def write_in_space(mission: Mission, folder: Path) -> Path:
    """Of small networks, for what is proved of one weight is proved of all; of a sail that ages."""
    networks = random_guidance_in_space(*[(4, 4)] * 4, mission=mission)
    return write_only(networks, folder).folder


@pytest.fixture(scope="module")
def in_space(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_in_space(AGEING, tmp_path_factory.mktemp("space"))


# The form that ships is proved in every build by `make checks`, and so is the tracker: the others are long.
@with_frama_c
@pytest.mark.parametrize(
    ("exported_of_any_sail", "build"),
    [
        pytest.param(*pair, marks=() if pair in (("paper", "f32"), ("jpl", "f64")) else pytest.mark.long)
        for pair in itertools.product(("paper", "approach", "jpl"), ("f32", "f64", "f32_host"))
    ],
    indirect=["exported_of_any_sail"],
)
def test_commands_are_bounded_and_finite(exported_of_any_sail: Exported, build: str) -> None:
    assert analyse(exported_of_any_sail.folder, BUILDS[build]) == []


@with_frama_c
@pytest.mark.parametrize(
    "build",
    [pytest.param(name, marks=() if name in ("f32", "f64_host") else pytest.mark.long) for name in BUILDS],
)
def test_commands_in_space_are_bounded_and_finite(in_space: Path, build: str) -> None:
    assert analyse(in_space, BUILDS[build]) == []


BROKEN_TRACKERS = {
    "any component is the largest": (
        "prove_take_plan",
        "sailnet_plan.c",
        "((plan->largest >= 0) && (plan->largest < STATES)) ? plan->largest : largest",
        "plan->largest",
    ),
    "no budget": (
        "prove_tracker",
        "sailnet_plan.c",
        "return count < limit ? count : limit;",
        "return count;",
    ),
    "a step before it is known": (
        "prove_take_plan",
        "sailnet_plan.c",
        "double step[STATES] = {0.0};\n        step[k] = DIFFERENCE",
        "double step[STATES];\n        step[k] = DIFFERENCE",
    ),
    "a search that begins anywhere": (
        "prove_take_plan",
        "sailnet_plan.c",
        "    (void)memset(at, 0, sizeof *at);\n",
        "",
    ),
    "a budget that is overdrawn": (
        "prove_tracker",
        "sailnet_plan.c",
        "sailnet_correct_plan(&next, state, moves - count, &moved)",
        "sailnet_correct_plan(&next, state, most + most, &moved)",
    ),
    "a plan that is flown before it is known": (
        "prove_tracker",
        "sailnet_tracker.c",
        "    if (flown != 0) {\n",
        "    if (flown > 1) {\n",
    ),
}
"""Guards of the tracker taken away: entry that needs it, file, what stands there, what in its place."""


IN_BRIEF = "no budget", "a search that begins anywhere"
"""Of each entry one; the others are long."""


@with_frama_c
@pytest.mark.parametrize(
    "guard",
    [pytest.param(name, marks=() if name in IN_BRIEF else pytest.mark.long) for name in BROKEN_TRACKERS],
)
def test_without_its_guards_the_tracker_is_not_proved(guard: str, tmp_path: Path) -> None:
    entry, name, before, after = BROKEN_TRACKERS[guard]
    folder = shutil.copytree(TRACKER, tmp_path / "tracker")
    source = (folder / name).read_text()
    assert source.count(before) == 1
    (folder / name).write_text(source.replace(before, after))
    assert analyse_tracker(folder, in_space=False, entries=[entry])


def named(mutants: Iterable[Mutant]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("mutant", list(mutants), ids=lambda mutant: mutant.name)


def one_of(mutant: Mutant) -> Build:
    """A build that it changes."""
    builds = (BUILDS[name] for name in ("f64", "f64_host", "f32_host", "f32"))
    return next(build for build in builds if mutant.concerns(build))


@with_frama_c
@named(mutant for mutant in MUTANTS if mutant.form != "space")
def test_a_guard_less_breaks_the_proof(
    request: pytest.FixtureRequest, tmp_path: Path, mutant: Mutant
) -> None:
    exported: Exported = request.getfixturevalue("jpl_exported" if mutant.ages else "approach_exported")
    assert mutate(exported.folder, mutant, tmp_path)
    assert caught(tmp_path, one_of(mutant))


@with_frama_c
@named(mutant for mutant in MUTANTS if mutant.form == "space")
def test_a_guard_less_breaks_the_proof_in_space(in_space: Path, tmp_path: Path, mutant: Mutant) -> None:
    """Guards of both forms are taken away above."""
    assert mutate(in_space, mutant, tmp_path)
    assert caught(tmp_path, one_of(mutant))


@with_frama_c
def test_a_file_that_does_not_compile_is_an_error_not_a_proof(exported: Exported, tmp_path: Path) -> None:
    assert mutate(
        exported.folder, Mutant("", "sailnet_status sailnet_guidance(", "sailnet_status ("), tmp_path
    )
    with pytest.raises(ProofError, match="frama-c failed"):
        analyse(tmp_path, BUILDS["f32"])


DOUBLE, SINGLE = (
    [name for name, build in BUILDS.items() if build.suffix == suffix] for suffix in ("f64", "f32")
)


@pytest.mark.parametrize("name", DOUBLE)
def test_what_the_proof_assumes_is_so(exported: Exported, name: str) -> None:
    assert check_lemmas(exported.folder, BUILDS[name]) == "0 failures"


@pytest.mark.slow
@pytest.mark.parametrize("name", DOUBLE)
def test_what_the_proof_assumes_is_so_in_space(in_space: Path, name: str) -> None:
    assert check_lemmas(in_space, BUILDS[name]) == "0 failures"


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", SINGLE)
def test_what_the_proof_assumes_is_so_of_every_float(paper_exported: Exported, name: str) -> None:
    """Of networks in approach coordinates ``make checks`` says the same."""
    assert check_lemmas(paper_exported.folder, BUILDS[name]) == "0 failures"


@pytest.mark.exhaustive
def test_a_sigmoid_out_of_bounds_is_noticed(paper_exported: Exported, tmp_path: Path) -> None:
    broken = Mutant("", "return (rest - scaled) / (rest + scaled);", "return R(1.001) - scaled / rest;")
    assert mutate(paper_exported.folder, broken, tmp_path)
    with pytest.raises(ProofError, match="outside its bounds"):
        check_lemmas(tmp_path, BUILDS["f32"])


def test_without_frama_c_it_says_how_to_get_it(
    exported: Exported, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("PATH", "")
    assert main([str(exported.folder)]) == 0
    assert "apt install frama-c-base" in capsys.readouterr().out
    assert main([str(exported.folder), "--require"]) == 1

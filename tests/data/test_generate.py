"""Generation follows the recipe, whoever does the work, and the command says what went wrong."""

import io
import json
import os
import subprocess
import sys
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from functools import partial
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest

import data.command
import data.generate
from data.box import CANDIDATES, box_shard
from data.command import watched
from data.generate import generate
from sailnet.dataset import (
    JUMP_FLAG,
    NEGATIVE_ARRIVAL_FLAG,
    Block,
    open_dataset,
    write_dataset,
)
from sailnet.errors import DatasetError, SolveError
from sailnet.mission.mission import Mission
from sailnet.physics.jumps import restore
from sailnet.physics.pontryagin import guidance_law
from sailnet.workers.executors import Workers
from tests.paths import ROOT
from tests.reference import fly
from tests.small_datasets import INVENTED, NOMINAL, Inline, invented_shard, with_recipe


def _only(executor: Executor, ahead: int = 4) -> Workers:
    return Workers(lambda: executor, ahead)


@pytest.mark.slow
def test_the_executor_leaves_no_trace(mission: Mission, tmp_path: Path) -> None:
    wanted = with_recipe(mission, samples_per_trajectory=21)
    shard_of = partial(box_shard, wanted, NOMINAL)
    processes = ProcessPoolExecutor(2, get_context("spawn"))
    executors: list[Executor] = [Inline(), ThreadPoolExecutor(4), processes]
    digests = []
    for i, executor in enumerate(executors):
        path = tmp_path / f"{i}.h5"
        with executor:
            write_dataset(path, wanted, generate(shard_of, 700, _only(executor)), {})
        with open_dataset(path, wanted) as found:
            found.verify()
            assert found.trajectories == 700
            digests.append(found.digest)
    assert len(set(digests)) == 1


def test_a_shard_follows_the_recipe(small: Mission, shard: Block) -> None:
    recipe = small.dataset.box
    assert recipe is not None
    rows = shard.trajectories
    first = np.cumsum(shard.lengths) - shard.lengths
    assert 0 < len(rows["flags"]) < CANDIDATES
    assert shard.samples["r"].max() <= recipe.max_radius
    assert shard.samples["r"].max() > 1.55  # the bound is reached, so it was what excluded the others
    for name, low, high in (("lambda_r0", -23, -20), ("lambda_u0", 5, 11)):
        assert rows[name].min() >= low
        assert rows[name].max() <= high
        assert np.ptp(rows[name]) > 0.9 * (high - low)
    assert (rows["lambda_v0"] < 0).all()
    assert (shard.lengths == 31).all()
    grid = np.tile(np.linspace(0, 10, 31), len(first))
    np.testing.assert_allclose(shard.samples["tau"], grid, atol=1e-14)
    for name, value in zip("ruv", small.problem.target_state, strict=True):
        np.testing.assert_allclose(shard.samples[name][first], value, atol=1e-15)
    jumps = np.isfinite(rows["jump_time"])
    assert 0 < jumps.sum() < len(jumps)
    np.testing.assert_array_equal(rows["flags"], JUMP_FLAG * jumps)


def test_the_columns_belong_together(small: Mission, shard: Block) -> None:
    s = {name: column.reshape(-1, 31) for name, column in shard.samples.items()}
    at = shard.trajectories["jump_time"][:, None]
    law = guidance_law(small.problem, s["lambda_u"], s["lambda_v"])
    np.testing.assert_array_equal(s["alpha"], law)
    before = np.isfinite(at) & (s["tau"] > at)
    np.testing.assert_array_equal(s["alpha_pre"], np.where(before, -law, law))  # Eq. (23)
    np.testing.assert_array_equal(restore(s["alpha_pre"], s["lambda_v"]), s["alpha"])  # Eq. (25)
    jumping = int(np.flatnonzero(np.isfinite(at))[0])
    smooth = int(np.flatnonzero(np.isnan(at))[0])
    for row in (jumping, smooth):
        names = ("lambda_r0", "lambda_u0", "lambda_v0")
        costates = [shard.trajectories[name][row] for name in names]
        flown = fly(small.problem, [*small.problem.target_state, *costates], s["tau"][row])
        for i, name in enumerate(("r", "u", "v", "lambda_r", "lambda_u", "lambda_v")):
            np.testing.assert_allclose(s[name][row], flown.states[:, i], rtol=1e-7, atol=1e-7)
        jump_time = float(at[row, 0])
        assert flown.jump_times == ([] if row == smooth else [pytest.approx(jump_time, abs=1e-7)])


def test_a_negative_arrival_is_the_mirrored_root(small: Mission, shard: Block) -> None:
    mirrored = box_shard(with_recipe(small, arrival_cone_angle="negative", max_radius=4.0), NOMINAL, 0)
    assert len(mirrored.trajectories["flags"])
    assert (mirrored.trajectories["lambda_v0"] > 0).all()
    assert (mirrored.trajectories["flags"].astype(int) & NEGATIVE_ARRIVAL_FLAG).all()
    assert (mirrored.samples["alpha"][::31] < 0).all()
    assert (shard.samples["alpha"][::31] > 0).all()


def test_the_nominal_is_left_out(small: Mission, shard: Block) -> None:
    rows = shard.trajectories
    victim = (float(rows["lambda_r0"][4]), float(rows["lambda_u0"][4]))
    without = box_shard(small, victim, 0).trajectories
    assert victim[0] not in without["lambda_r0"]
    assert len(without["flags"]) == len(rows["flags"]) - 1
    exclusion = with_recipe(small, nominal_exclusion=0.3)
    wider = box_shard(exclusion, NOMINAL, 0).trajectories
    distance = np.hypot(wider["lambda_r0"] - NOMINAL[0], wider["lambda_u0"] - NOMINAL[1])
    assert distance.min() > 0.3
    assert len(wider["flags"]) < len(rows["flags"])


def test_at_most_the_recipe_s_number_of_jumps(small: Mission, shard: Block) -> None:
    assert (shard.trajectories["flags"] == JUMP_FLAG).any()
    none = box_shard(with_recipe(small, max_jumps=0), NOMINAL, 0)
    assert np.isnan(none.trajectories["jump_time"]).all()
    assert len(none.trajectories["flags"]) == (shard.trajectories["flags"] == 0).sum()
    wide = with_recipe(small, duration=30.0, max_radius=9.0, max_jumps=9)
    several = box_shard(wide, NOMINAL, 0)
    lv, lu = (several.samples[name].reshape(-1, 31) for name in ("lambda_v", "lambda_u"))
    found = ((np.diff(np.sign(lv), axis=1) != 0) & (lu[:, 1:] > 0) & (lu[:, :-1] > 0)).sum(axis=1)
    assert found.max() > 1  # so that the limit had something to exclude
    limited = box_shard(with_recipe(small, duration=30.0, max_radius=9.0), NOMINAL, 0)
    assert len(limited.trajectories["flags"]) < len(several.trajectories["flags"])


def test_seeds_and_shards_differ(small: Mission, shard: Block) -> None:
    again = box_shard(small, NOMINAL, 0)
    np.testing.assert_array_equal(again.samples["lambda_r"], shard.samples["lambda_r"])
    next_one = box_shard(small, NOMINAL, 1).trajectories["lambda_r0"]
    reseeded = box_shard(with_recipe(small, seed=1), NOMINAL, 0).trajectories["lambda_r0"]
    for other in (next_one, reseeded):
        assert not set(other) & set(shard.trajectories["lambda_r0"])


def test_work_is_asked_for_as_it_is_needed(small: Mission) -> None:
    executor = Inline()
    blocks = generate(partial(box_shard, small, NOMINAL), 10**6, _only(executor, ahead=3))
    next(blocks)
    assert executor.submitted <= 3
    next(blocks)
    assert executor.submitted <= 4


def test_a_recipe_that_admits_nothing_ends(small: Mission, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(data.generate, "FUTILE", 2)
    futile = with_recipe(small, max_radius=1.53)
    with pytest.raises(DatasetError, match="no trajectory in 2 shards in a row: widen the recipe"):
        list(generate(partial(box_shard, futile, NOMINAL), 5, _only(Inline(), 1)))
    rootless = with_recipe(small, lambda_u=(-30.0, -20.0))
    with pytest.raises(SolveError, match="no root"):
        list(generate(partial(box_shard, rootless, NOMINAL), 5, _only(Inline(), 1)))


def command(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["data", *arguments])
    return data.command.main()


@pytest.mark.slow
def test_the_command_makes_a_data_set(
    mission: Mission, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "made.h5"
    box = ("--recipe", "box", "--trajectories", "20", "--workers", "1", "--quiet")
    assert command(monkeypatch, str(path), *box) == 0
    assert "20 trajectories" in capsys.readouterr().out
    with open_dataset(path, mission) as found:
        found.verify()
        assert found.trajectories == 20
        assert found.mission == mission
        nominal = found.provenance["nominal"]
        assert isinstance(nominal, dict)
        assert nominal["smoothed"]["time_of_flight"] == pytest.approx(7.018384, abs=1e-5)
        assert {"sailnet", "revision", "heyoka", "tolerance", "machine", "date"} <= set(found.provenance)
    assert str(ROOT) not in json.dumps(found.provenance)
    serial = tmp_path / "serial.h5"
    shard_of = partial(box_shard, mission, NOMINAL)
    write_dataset(serial, mission, generate(shard_of, 20, _only(Inline())), {})
    with open_dataset(serial) as expected:
        assert found.digest == expected.digest  # one worker process or none


def test_the_command_reports_a_target_that_cannot_be_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("in the way")
    target = str(tmp_path / "file" / "x.h5")
    assert command(monkeypatch, target, "--trajectories", "5", "--workers", "1", "--quiet") == 1
    streams = capsys.readouterr()
    assert streams.err.startswith("error: cannot write data set")
    assert streams.out == ""


@pytest.mark.slow
def test_python_m_data_fails_in_words(tmp_path: Path) -> None:
    run = subprocess.run(
        [sys.executable, "-m", "data", str(tmp_path / "x.h5"), "--mission", "earth_pluto"],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
    )
    assert run.returncode == 1
    assert run.stderr.startswith("error: no mission named 'earth_pluto'")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("option", ["--trajectories", "--workers"])
@pytest.mark.parametrize("value", ["0", "-5", "many"])
def test_counts_below_one_are_refused(
    tmp_path: Path,
    option: str,
    value: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit) as caught:
        command(monkeypatch, str(tmp_path / "x.h5"), option, value)
    assert caught.value.code == 2
    assert option in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_the_bar_says_from_the_first_on_which_shard_is_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """Trajectories come by the shard, so that their number stands still for long."""

    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setattr("sys.stderr", terminal := Terminal())
    shards = (invented_shard(0.0, number) for number in range(2))
    seen = [terminal.getvalue() for _ in watched(shards, 2 * INVENTED, 2, quiet=False)]
    assert "shard 1 of 2" in seen[0]
    assert "shard 2 of 2" in seen[1].removeprefix(seen[0])
    assert "shard 3" not in terminal.getvalue()

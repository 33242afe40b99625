"""`sailnet info` summarises a sound data set, and finds what checksums cannot: wrong content."""

import dataclasses
import io
import json
import math
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest
from tqdm import tqdm

import sailnet.artefacts.column_files
from data.domain import flights_block
from sailnet.cli import main
from sailnet.dataset import Block, open_dataset, write_dataset
from sailnet.dataset.inspection import ORIGIN, inspect_dataset
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.pontryagin import evaluate_hamiltonian, guidance_law, hamiltonian_bound
from sailnet.physics.transfer import Transfer
from tests.reference import Array
from tests.small_datasets import pieces

PROVENANCE = dict.fromkeys(ORIGIN, "known")
Columns = dict[str, Array]


@pytest.fixture
def sound(small: Mission, shard: Block, tmp_path: Path) -> Path:
    path = tmp_path / "sound.h5"
    write_dataset(path, small, pieces(shard, 12), PROVENANCE)
    return path


def test_the_summary_is_the_file_s(sound: Path, shard: Block, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", str(sound), "--json"]) == 0
    summary = json.loads(capsys.readouterr().out)
    with open_dataset(sound) as data:
        assert summary["digest"] == data.digest
    assert (summary["trajectories"], summary["samples"]) == (12, 12 * 31)
    assert summary["mission"] == "earth_mars: Earth orbit to Mars orbit"
    assert summary["recipe"] == summary["date"] == "known"
    assert summary["software"] == dict.fromkeys(ORIGIN[2:-1], "known")
    jumps = np.isfinite(shard.trajectories["jump_time"][:12])
    assert 0 < jumps.sum() < 12
    assert summary["jump_share"] == jumps.mean()
    r = shard.samples["r"][: 12 * 31]
    assert summary["ranges"]["samples/r"] == [r.min(), r.max()]
    assert summary["ranges"]["samples/trajectory"] == [0, 11]
    assert 1e-4 < summary["largest_hamiltonian"] < 0.01
    assert main(["info", str(sound)]) == 0
    assert summary["digest"] in capsys.readouterr().out


def test_arrivals_from_either_side_are_told_apart(small: Mission, tmp_path: Path) -> None:
    """The cone angle at arrival has the sign of -lambda_v; three of eight arrive with a negative one."""
    costates = np.random.default_rng(3).normal(size=(200, 3))
    gain = arrival_gain(small.problem, costates)
    costates = costates[gain < -1e-2] / -gain[gain < -1e-2, None]
    sides = [costates[costates[:, 2] > 0.0][:3], costates[costates[:, 2] < 0.0][:5]]
    block = flights_block(small.problem, np.concatenate(sides), np.full(8, 0.5), 0.05)
    write_dataset(tmp_path / "both.h5", small, iter([block]), PROVENANCE)
    summary = inspect_dataset(tmp_path / "both.h5")
    assert summary["negative_arrival_share"] == 3 / 8
    assert summary["trajectories"] == 8


def test_progress_ends_at_its_end(sound: Path) -> None:
    with tqdm(disable=False, file=io.StringIO()) as bar:
        inspect_dataset(sound, bar)
        assert bar.n == bar.total > 0


def test_the_size_of_what_is_read_at_once_leaves_no_trace(
    sound: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = inspect_dataset(sound)
    monkeypatch.setattr(sailnet.artefacts.column_files, "VERIFY_ROWS", 7)
    assert inspect_dataset(sound) == whole


def put(name: str, row: int, value: float) -> Callable[[Columns, Columns], None]:
    def change(samples: Columns, rows: Columns) -> None:
        (samples if name in samples else rows)[name][row] = value

    return change


def wrong_costate(samples: Columns, _: Columns) -> None:
    samples["lambda_r"] *= 1.3


def swap(samples: Columns, _: Columns) -> None:
    for column in samples.values():
        column[[40, 41]] = column[[41, 40]]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "said"),
    [
        (put("u", 100, math.nan), "samples/u of row 100, nan, is not finite"),
        (put("lambda_v", 3, math.inf), "samples/lambda_v of row 3, inf, is not finite"),
        (put("lambda_r0", 2, math.nan), "trajectories/lambda_r0 of row 2, nan, is not finite"),
        (put("r", 50, -1.0), "samples/r of row 50, -1.0, is not positive"),
        (put("alpha", 50, 1.05), "samples/alpha of row 50, 1.05, is beyond the bound 1.047198"),
        (put("alpha_pre", 50, -1.05), "samples/alpha_pre of row 50, -1.05, is beyond"),
        (put("tau", 62, 0.1), "samples/tau of row 62, 0.1, does not rise from 0"),
        (put("tau", 70, 0.0), "samples/tau of row 70, 0.0, does not rise"),
        (swap, r"samples/tau of row 41, .*, does not rise"),
        (put("v", 31, 0.82), "samples/v of row 31, 0.82, is not on the target orbit, where it is 0.810042"),
        (put("flags", 0, 2.0), "trajectories/flags of row 0, 2, contradicts"),
        (put("alpha", 200, 0.3), "the commands of trajectory 6 are not the law's"),
        (put("alpha_pre", 200, 0.3), "the commands of trajectory 6 are not the law's"),
        (put("beta", 200, 0.17), "beta changes along trajectory 6"),
        (wrong_costate, r"along trajectory 0 \|H\| reaches"),
    ],
)
def test_wrong_content_under_right_checksums_is_found(
    change: Callable[[Columns, Columns], None],
    said: str,
    small: Mission,
    shard: Block,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    block = next(pieces(shard, 12))
    samples = {name: np.array(column) for name, column in block.samples.items()}
    rows = {name: np.array(column, float) for name, column in block.trajectories.items()}
    change(samples, rows)
    path = tmp_path / "x.h5"
    write_dataset(path, small, iter([Block(samples, rows, block.lengths)]), PROVENANCE)
    with open_dataset(path) as data:
        data.verify()
    with pytest.raises(DatasetError, match=said):
        inspect_dataset(path)
    assert main(["info", str(path)]) == 1
    assert capsys.readouterr().err.startswith(f"error: {path}")


def test_a_trajectory_without_samples_is_found(
    small: Mission, shard: Block, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    block = next(pieces(shard, 12))
    lengths = block.lengths.copy()
    lengths[3] = 0
    samples = {name: np.delete(column, slice(93, 124)) for name, column in block.samples.items()}
    path = tmp_path / "x.h5"
    without = dataclasses.replace(block, samples=samples, lengths=lengths)
    write_dataset(path, small, iter([without]), PROVENANCE)
    for read_at_once in (sailnet.artefacts.column_files.VERIFY_ROWS, 4):
        monkeypatch.setattr(sailnet.artefacts.column_files, "VERIFY_ROWS", read_at_once)
        with pytest.raises(DatasetError, match="first_sample of row 3, 93, leaves its trajectory without"):
            inspect_dataset(path)


def test_a_damaged_file_and_an_unknown_origin(
    sound: Path, stored: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(DatasetError, match="does not say where it comes from: recipe, tolerance"):
        inspect_dataset(stored)
    with h5py.File(sound) as file:
        position = file["samples/u"].id.get_chunk_info(0).byte_offset + 99
    raw = bytearray(sound.read_bytes())
    raw[position] ^= 1
    damaged = tmp_path / "damaged.h5"
    damaged.write_bytes(raw)
    for path in (damaged, tmp_path / "nowhere.h5"):
        assert main(["info", str(path), "--json"]) == 1
        streams = capsys.readouterr()
        assert streams.out == ""
        assert str(path) in streams.err


@pytest.mark.slow
@pytest.mark.parametrize("delta", [1e-2, 1e-3, 1e-5, 0.0])
@pytest.mark.parametrize(("target_radius", "beta"), [(1.524, 0.16892), (0.723, 0.16892), (1.524, 0.05)])
def test_the_bound_on_h_holds_and_is_tight_enough(target_radius: float, beta: float, delta: float) -> None:
    """Also for trajectories that the shipped mission does not hold; wrong costates break it."""
    transfer = Transfer(beta, math.radians(60.0), delta, target_radius)
    directions = np.random.default_rng(1).normal(size=(48, 3))
    gain = arrival_gain(transfer, directions)
    costates = directions[gain < -1e-2] / -gain[gain < -1e-2, None]
    extremals = propagate_extremals(transfer, costates, np.linspace(0.0, 10.0, 301))
    r = extremals.states[:, :, 0]
    with np.errstate(invalid="ignore"):
        kept = (r.min(axis=1) > 0.25 * target_radius) & (r.max(axis=1) < 3.3)
    assert kept.sum() >= 5
    for x in extremals.states[kept]:
        alpha = guidance_law(transfer, x[:, 4], x[:, 5])
        size = np.abs(evaluate_hamiltonian(transfer, x[:, :3], x[:, 3:], alpha)).max()
        bound = hamiltonian_bound(transfer, x[:, :3], x[:, 3:])
        assert size <= bound
        wrong = evaluate_hamiltonian(transfer, x[:, :3], x[:, 3:] * [1.0, 1.0, -1.0], -alpha)
        assert np.abs(wrong).max() > bound

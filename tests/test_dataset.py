"""The data set file: complete, unchanged and of the right mission, or refused."""

import dataclasses
import gc
import json
import os
import random
import signal
import subprocess
import sys
import weakref
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

import data.__main__
import data.generate
from data.generate import CANDIDATES, compute_shard, generate
from sailnet.dataset import (
    INTEGER,
    JUMP_FLAG,
    NEGATIVE_ARRIVAL_FLAG,
    SAMPLES,
    TRAJECTORIES,
    Block,
    open_dataset,
    write_dataset,
)
from sailnet.errors import DatasetError, SolveError
from sailnet.files import write_whole
from sailnet.jumps import restore
from sailnet.mission import Mission
from sailnet.pontryagin import guidance_law
from tests.reference import Array, fly

ROOT = Path(__file__).parent.parent
NOMINAL = (-21.5117, 8.5435)


class Inline(Executor):
    """Runs everything at once in this process, and counts what it was given."""

    def __init__(self) -> None:
        self.submitted = 0

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        self.submitted += 1
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


def with_recipe(mission: Mission, **changes: object) -> Mission:
    return mission.model_copy(update={"dataset": mission.dataset.model_copy(update=changes)})


@pytest.fixture(scope="module")
def small(mission: Mission) -> Mission:
    return with_recipe(mission, trajectories=12, samples_per_trajectory=31)


@pytest.fixture(scope="module")
def shard(small: Mission) -> Block:
    return compute_shard(small, NOMINAL, 0)


def pieces(shard: Block, *sizes: int) -> Iterator[Block]:
    start = 0
    for size in sizes:
        rows = slice(start, start + size)
        yield Block(
            {name: column[rows] for name, column in shard.samples.items()},
            {name: column[rows] for name, column in shard.trajectories.items()},
        )
        start += size


@pytest.fixture(scope="module")
def stored(small: Mission, shard: Block, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("dataset") / "small.h5"
    write_dataset(path, small, pieces(shard, 5, 7), {"seed": 1, "made": "here"})
    return path


def content(path: Path) -> dict[str, object]:
    """Everything the reader gives, verified."""
    with open_dataset(path) as found:
        found.verify()
        columns = found.read(list(SAMPLES), 0, found.samples)
        columns |= found.read_trajectories(list(TRAJECTORIES))
        return {
            "mission": found.mission.to_json(),
            "provenance": found.provenance,
            "digest": found.digest,
            "counts": (found.trajectories, found.samples, found.first_sample.tolist()),
            **{name: (column.shape, column.tobytes()) for name, column in columns.items()},
        }


def test_what_was_written_is_read(small: Mission, shard: Block, stored: Path) -> None:
    with open_dataset(stored, small) as found:
        found.verify()
        assert found.mission == small
        assert found.provenance == {"seed": 1, "made": "here"}
        assert (found.trajectories, found.samples) == (12, 12 * 31)
        assert found.first_sample.tolist() == list(range(0, 12 * 31 + 1, 31))
        columns = found.read(list(SAMPLES), 0, found.samples)
        for name, values in shard.samples.items():
            np.testing.assert_array_equal(columns[name], values[:12].ravel())
        np.testing.assert_array_equal(columns["trajectory"], np.repeat(np.arange(12), 31))
        rows = found.read_trajectories(list(TRAJECTORIES))
        for name, values in shard.trajectories.items():
            np.testing.assert_array_equal(rows[name], values[:12])
        part = found.read(["tau", "r"], 40, 50)
        np.testing.assert_array_equal(part["tau"], columns["tau"][40:50])
        assert list(part) == ["tau", "r"]


def test_every_column_says_what_it_is_in_which_unit(stored: Path) -> None:
    with h5py.File(stored) as file:
        assert set(file) == {"samples", "trajectories"}
        for group, schema in (("samples", SAMPLES), ("trajectories", TRAJECTORIES)):
            assert set(file[group]) == set(schema)
            for name, (unit, meaning) in schema.items():
                column = file[group][name]
                assert column.attrs["unit"] == unit
                assert column.attrs["meaning"] == meaning
                assert unit
                assert meaning
                assert column.dtype == np.dtype(INTEGER.get(name, "<f8"))
                assert column.chunks
                assert column.compression == "gzip"
                assert column.fletcher32
                assert len(column.attrs["sha256"]) == 64
        assert json.loads(file.attrs["mission"])["name"] == "earth_mars"
        assert file.attrs["samples"] == 12 * 31
        assert file.attrs["trajectories"] == 12


def test_the_readme_documents_every_column() -> None:
    text = (ROOT / "data" / "README.md").read_text()
    for schema in (SAMPLES, TRAJECTORIES):
        for name, (unit, _) in schema.items():
            assert any(f"`{name}`" in line and unit in line for line in text.splitlines()), name


def test_the_block_size_leaves_no_trace(small: Mission, shard: Block, stored: Path, tmp_path: Path) -> None:
    other = tmp_path / "other.h5"
    write_dataset(other, small, pieces(shard, 1, 0, 11), {"seed": 2})
    with open_dataset(other) as found, open_dataset(stored) as expected:
        found.verify()
        assert found.digest == expected.digest  # provenance is no content


def test_the_digest_knows_the_content(small: Mission, shard: Block, stored: Path, tmp_path: Path) -> None:
    samples = {name: np.array(column) for name, column in shard.samples.items()}
    samples["u"][3, 7] = np.nextafter(samples["u"][3, 7], 1.0)
    other = tmp_path / "other.h5"
    write_dataset(other, small, pieces(Block(samples, shard.trajectories), 12), {})
    with open_dataset(other) as found, open_dataset(stored) as expected:
        assert found.digest != expected.digest


def test_the_executor_leaves_no_trace(mission: Mission, tmp_path: Path) -> None:
    wanted = with_recipe(mission, trajectories=700, samples_per_trajectory=21)
    spawn = get_context("spawn")
    executors: list[Executor] = [
        Inline(),
        ThreadPoolExecutor(4),
        ProcessPoolExecutor(1, spawn),
        ProcessPoolExecutor(2, spawn),
    ]
    digests = []
    for i, executor in enumerate(executors):
        path = tmp_path / f"{i}.h5"
        with executor:
            write_dataset(path, wanted, generate(wanted, NOMINAL, executor), {})
        with open_dataset(path, wanted) as found:
            found.verify()
            assert found.trajectories == 700
            digests.append(found.digest)
    assert len(set(digests)) == 1


def test_a_shard_follows_the_recipe(small: Mission, shard: Block) -> None:
    recipe = small.dataset
    rows = shard.trajectories
    assert 0 < len(rows["flags"]) < CANDIDATES
    assert shard.samples["r"].max() <= recipe.max_radius
    assert shard.samples["r"].max() > 1.55  # the bound is reached, so it was what excluded the others
    for name, low, high in (("lambda_r0", -23, -20), ("lambda_u0", 5, 11)):
        assert rows[name].min() >= low
        assert rows[name].max() <= high
        assert np.ptp(rows[name]) > 0.9 * (high - low)
    assert (rows["lambda_v0"] < 0).all()
    tau = shard.samples["tau"]
    np.testing.assert_allclose(tau, np.broadcast_to(np.linspace(0, 10, 31), tau.shape), atol=1e-14)
    for name, value in zip("ruv", small.problem.target_state, strict=True):
        np.testing.assert_allclose(shard.samples[name][:, 0], value, atol=1e-15)
    jumps = np.isfinite(rows["jump_time"])
    assert 0 < jumps.sum() < len(jumps)
    np.testing.assert_array_equal(rows["flags"], JUMP_FLAG * jumps)


def test_the_columns_belong_together(small: Mission, shard: Block) -> None:
    s, at = shard.samples, shard.trajectories["jump_time"][:, None]
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
    mirrored = compute_shard(with_recipe(small, arrival_cone_angle="negative", max_radius=4.0), NOMINAL, 0)
    assert len(mirrored.trajectories["flags"])
    assert (mirrored.trajectories["lambda_v0"] > 0).all()
    assert (mirrored.trajectories["flags"].astype(int) & NEGATIVE_ARRIVAL_FLAG).all()
    assert (mirrored.samples["alpha"][:, 0] < 0).all()
    assert (shard.samples["alpha"][:, 0] > 0).all()


def test_the_nominal_is_left_out(small: Mission, shard: Block) -> None:
    rows = shard.trajectories
    victim = (float(rows["lambda_r0"][4]), float(rows["lambda_u0"][4]))
    without = compute_shard(small, victim, 0).trajectories
    assert victim[0] not in without["lambda_r0"]
    assert len(without["flags"]) == len(rows["flags"]) - 1
    exclusion = with_recipe(small, nominal_exclusion=0.3)
    wider = compute_shard(exclusion, NOMINAL, 0).trajectories
    distance = np.hypot(wider["lambda_r0"] - NOMINAL[0], wider["lambda_u0"] - NOMINAL[1])
    assert distance.min() > 0.3
    assert len(wider["flags"]) < len(rows["flags"])


def test_at_most_the_recipe_s_number_of_jumps(small: Mission, shard: Block) -> None:
    assert (shard.trajectories["flags"] == JUMP_FLAG).any()
    none = compute_shard(with_recipe(small, max_jumps=0), NOMINAL, 0)
    assert np.isnan(none.trajectories["jump_time"]).all()
    assert len(none.trajectories["flags"]) == (shard.trajectories["flags"] == 0).sum()
    wide = with_recipe(small, duration=30.0, max_radius=9.0, max_jumps=9)
    several = compute_shard(wide, NOMINAL, 0)
    lv, lu = several.samples["lambda_v"], several.samples["lambda_u"]
    found = ((np.diff(np.sign(lv), axis=1) != 0) & (lu[:, 1:] > 0) & (lu[:, :-1] > 0)).sum(axis=1)
    assert found.max() > 1  # so that the limit had something to exclude
    limited = compute_shard(with_recipe(small, duration=30.0, max_radius=9.0), NOMINAL, 0)
    assert len(limited.trajectories["flags"]) < len(several.trajectories["flags"])


def test_seeds_and_shards_differ(small: Mission, shard: Block) -> None:
    again = compute_shard(small, NOMINAL, 0)
    np.testing.assert_array_equal(again.samples["lambda_r"], shard.samples["lambda_r"])
    next_one = compute_shard(small, NOMINAL, 1).trajectories["lambda_r0"]
    reseeded = compute_shard(with_recipe(small, seed=1), NOMINAL, 0).trajectories["lambda_r0"]
    for other in (next_one, reseeded):
        assert not set(other) & set(shard.trajectories["lambda_r0"])


def test_work_is_asked_for_as_it_is_needed(small: Mission) -> None:
    executor = Inline()
    blocks = generate(with_recipe(small, trajectories=10**6), NOMINAL, executor)
    next(blocks)
    assert executor.submitted <= data.generate.AHEAD
    next(blocks)
    assert executor.submitted <= data.generate.AHEAD + 1


def test_memory_holds_one_block_at_a_time(small: Mission, shard: Block, tmp_path: Path) -> None:
    alive: list[weakref.ref[Block]] = []

    def blocks() -> Iterator[Block]:
        for _ in range(6):
            gc.collect()
            assert sum(reference() is not None for reference in alive) <= 1
            block = next(pieces(shard, 12))
            alive.append(weakref.ref(block))
            yield block
            del block

    write_dataset(tmp_path / "x.h5", small, blocks(), {})
    assert len(alive) == 6


def test_a_recipe_that_admits_nothing_ends(small: Mission, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(data.generate, "FUTILE", 2)
    monkeypatch.setattr(data.generate, "AHEAD", 1)
    futile = with_recipe(small, max_radius=1.53)
    with pytest.raises(DatasetError, match="none of 1024 extremals meets mission 'earth_mars'"):
        list(generate(futile, NOMINAL, Inline()))
    with pytest.raises(SolveError, match="no root"):
        list(generate(with_recipe(small, lambda_u=(-30.0, -20.0)), NOMINAL, Inline()))


def test_a_truncated_file_is_refused(stored: Path, tmp_path: Path) -> None:
    raw = stored.read_bytes()
    path = tmp_path / "short.h5"
    lengths = [0, 1, 8, 100, 2048, *range(5000, len(raw), len(raw) // 40), len(raw) - 100, len(raw) - 1]
    for length in lengths:
        path.write_bytes(raw[:length])
        with pytest.raises(DatasetError, match=r"short\.h5"):
            content(path)


def test_a_flipped_bit_is_refused_or_harmless(stored: Path, tmp_path: Path) -> None:
    raw = stored.read_bytes()
    expected = content(stored)
    path = tmp_path / "flipped.h5"
    rng = random.Random(5)
    # Half anywhere (headers for the most part), half in the columns' chunks.
    with h5py.File(stored) as file:
        chunks = [
            file[group][name].id.get_chunk_info(0)
            for group, schema in (("samples", SAMPLES), ("trajectories", TRAJECTORIES))
            for name in schema
        ]
    inside = [rng.choice(chunks) for _ in range(150)]
    positions = [chunk.byte_offset + rng.randrange(chunk.size) for chunk in inside]
    refused = 0
    for position in positions:
        refused += _flipped(raw, position, rng.randrange(8), path, expected)
    assert refused == len(positions)  # every bit of a column counts
    for _ in range(250):
        refused += _flipped(raw, rng.randrange(len(raw)), rng.randrange(8), path, expected)
    assert refused > len(positions) + 50


def _flipped(raw: bytes, position: int, bit: int, path: Path, expected: dict[str, object]) -> bool:
    damaged = bytearray(raw)
    damaged[position] ^= 1 << bit
    path.write_bytes(damaged)
    try:
        found = content(path)
    except DatasetError:
        return True
    assert found == expected, f"bit {bit} of byte {position} changed the content unnoticed"
    return False


def edited(stored: Path, path: Path, edit: Callable[[Any], object]) -> Path:
    """A copy of a data set changed through HDF5 itself, so that every chunk's checksum is right."""
    path.write_bytes(stored.read_bytes())
    with h5py.File(path, "r+") as file:
        edit(file)
    return path


def test_another_value_in_a_column_is_noticed(stored: Path, tmp_path: Path) -> None:
    def edit(file: Any) -> None:
        file["samples/alpha"][17] += 1e-15

    path = edited(stored, tmp_path / "edited.h5", edit)
    with open_dataset(path) as found, pytest.raises(DatasetError, match="samples/alpha does not match"):
        found.verify()


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("mission", None),
        ("provenance", '{"seed": 2}'),
        ("sha256", "0" * 64),
        ("provenance_sha256", "0" * 64),
        ("provenance", "no JSON"),
        ("mission", "[]"),
        ("mission", 5),
    ],
)
def test_another_header_is_noticed(stored: Path, tmp_path: Path, name: str, value: object) -> None:
    def edit(file: Any) -> None:
        other = file.attrs[name].replace("0.16892", "0.16893") if value is None else value
        file.attrs[name] = other

    with pytest.raises(DatasetError, match="damaged"):
        content(edited(stored, tmp_path / "edited.h5", edit))


@pytest.mark.parametrize("name", ["mission", "provenance", "sha256", "provenance_sha256", "schema"])
def test_a_missing_header_is_noticed(stored: Path, tmp_path: Path, name: str) -> None:
    with pytest.raises(DatasetError):
        content(edited(stored, tmp_path / "edited.h5", lambda file: file.attrs.__delitem__(name)))


@pytest.mark.parametrize(
    "column", ["samples/u", "trajectories/flags", "trajectories/first_sample", "samples"]
)
def test_a_missing_column_is_noticed(stored: Path, tmp_path: Path, column: str) -> None:
    with pytest.raises(DatasetError, match="damaged or no sailnet data set"):
        content(edited(stored, tmp_path / "edited.h5", lambda file: file.__delitem__(column)))


def test_counts_do_not_hang_on_attributes_without_a_checksum(stored: Path, tmp_path: Path) -> None:
    def edit(file: Any) -> None:
        file.attrs["samples"] = file.attrs["trajectories"] = 10**6

    assert content(edited(stored, tmp_path / "edited.h5", edit)) == content(stored)


def test_a_longer_column_is_noticed(stored: Path, tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="header does not match its checksum"):
        content(edited(stored, tmp_path / "edited.h5", lambda file: file["samples/r"].resize(400, axis=0)))


def test_another_schema_version_is_refused(stored: Path, tmp_path: Path) -> None:
    path = edited(stored, tmp_path / "new.h5", lambda file: file.attrs.modify("schema", "sailnet-dataset/2"))
    with pytest.raises(DatasetError, match=r"schema 'sailnet-dataset/2', this version reads '.*/1'"):
        content(path)


def test_another_mission_is_refused(small: Mission, stored: Path) -> None:
    sail = small.sail.model_copy(update={"beta": 0.17})
    other = small.model_copy(update={"sail": sail})
    with (
        pytest.raises(DatasetError, match="another problem than mission 'earth_mars'"),
        open_dataset(stored, other),
    ):
        pass
    training = small.training.model_copy(update={"epochs": 3})
    with open_dataset(stored, small.model_copy(update={"training": training})):
        pass  # the networks' recipe is none of the data set's business


def test_no_data_set_at_all_is_refused(tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="cannot open data set"):
        content(tmp_path / "nowhere.h5")
    with pytest.raises(DatasetError, match="cannot open data set"):
        content(tmp_path)
    foreign = tmp_path / "foreign.h5"
    with h5py.File(foreign, "w") as file:
        file["x"] = 1.0
    with pytest.raises(DatasetError, match="schema None"):
        content(foreign)


def test_a_failure_half_way_leaves_the_old_file(
    small: Mission, shard: Block, stored: Path, tmp_path: Path
) -> None:
    path = tmp_path / "kept.h5"
    path.write_bytes(stored.read_bytes())

    def failing() -> Iterator[Block]:
        yield from pieces(shard, 5)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_dataset(path, small, failing(), {})
    assert path.read_bytes() == stored.read_bytes()
    assert list(tmp_path.iterdir()) == [path]


def test_a_killed_process_leaves_the_old_file(stored: Path, tmp_path: Path) -> None:
    path = tmp_path / "kept.h5"
    path.write_bytes(stored.read_bytes())
    code = """
import sys, time
import numpy as np
from pathlib import Path
from sailnet.dataset import SAMPLES, TRAJECTORIES, Block, write_dataset
from sailnet.mission import load_mission
def blocks():
    samples = {name: np.zeros((100, 351)) for name in SAMPLES if name != "trajectory"}
    rows = {name: np.zeros(100) for name in TRAJECTORIES if name != "first_sample"}
    while True:
        yield Block(samples, rows)
        print("one more", flush=True)
write_dataset(Path(sys.argv[1]), load_mission("earth_mars"), blocks(), {})
"""
    for target in (path, tmp_path / "new.h5"):
        process = subprocess.Popen(
            [sys.executable, "-c", code, str(target)], cwd=ROOT, stdout=subprocess.PIPE, text=True
        )
        assert process.stdout is not None
        for _ in range(3):
            assert process.stdout.readline() == "one more\n"
        process.send_signal(signal.SIGKILL)
        process.wait()
        process.stdout.close()
    assert path.read_bytes() == stored.read_bytes()
    assert not (tmp_path / "new.h5").exists()


def test_a_whole_file_replaces_the_old_one(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "file"
    write_whole(path, lambda beside: beside.write_text("one"))
    write_whole(path, lambda beside: beside.write_text("two"))
    assert path.read_text() == "two"
    assert list(path.parent.iterdir()) == [path]
    assert path.stat().st_mode & 0o777 == 0o644


def test_a_target_that_cannot_be_written_is_reported(small: Mission, shard: Block, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    (tmp_path / "folder").mkdir()
    for target in (tmp_path / "file" / "x.h5", tmp_path / "folder"):
        with pytest.raises(DatasetError, match="cannot write data set"):
            write_dataset(target, small, pieces(shard, 5), {})
    assert (tmp_path / "file").read_text() == "in the way"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "folder"]


def command(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["data", *arguments])
    return data.__main__.main()


def test_the_command_makes_a_data_set(
    mission: Mission, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "made.h5"
    assert command(monkeypatch, str(path), "--trajectories", "20", "--workers", "1", "--quiet") == 0
    assert "20 trajectories, 7020 samples" in capsys.readouterr().out
    with open_dataset(path, mission) as found:
        found.verify()
        assert found.trajectories == 20
        assert found.mission.dataset.trajectories == 20
        nominal = found.provenance["nominal"]
        assert isinstance(nominal, dict)
        assert nominal["smoothed"]["time_of_flight"] == pytest.approx(7.018384, abs=1e-5)
        assert {"sailnet", "revision", "heyoka", "tolerance", "machine", "date"} <= set(found.provenance)
    assert str(ROOT) not in json.dumps(found.provenance)


def test_the_command_reports_a_target_that_cannot_be_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("in the way")
    target = str(tmp_path / "file" / "x.h5")
    assert command(monkeypatch, target, "--trajectories", "5", "--workers", "1", "--quiet") == 1
    streams = capsys.readouterr()
    assert streams.err.startswith("error: cannot write data set")
    assert streams.out == ""


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


def test_blocks_are_not_changed_by_writing(small: Mission, shard: Block, tmp_path: Path) -> None:
    block = next(pieces(shard, 12))
    before = dataclasses.replace(
        block, samples={name: np.array(column) for name, column in block.samples.items()}
    )
    write_dataset(tmp_path / "x.h5", small, iter([block]), {})
    columns: list[tuple[Array, Array]] = [(block.samples[n], before.samples[n]) for n in before.samples]
    for found, expected in columns:
        np.testing.assert_array_equal(found, expected)

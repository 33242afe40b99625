"""Checkpoints that somebody made to do harm: refused in words before much is read."""

import io
import json
import os
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch

from sailnet.errors import NetworkError
from training.checkpoint import Progress, load_checkpoint, run_of, save_checkpoint
from training.levenberg_marquardt import Iterate

CPU = torch.device("cpu")


@pytest.fixture
def stored(tmp_path: Path) -> Path:
    iterate = Iterate(torch.arange(3.0), torch.ones(3), 0.1, 4, 0.5)
    save_checkpoint(
        Progress(iterate, torch.zeros(3), 2, 0.5, 1.5, [{"epoch": 1.0}]), "run", tmp_path / "x.npz"
    )
    return tmp_path / "x.npz"


def members(path: Path) -> dict[str, Any]:
    with np.load(path) as found:
        return dict(found)


def state(path: Path, **changes: Any) -> dict[str, Any]:
    arrays = members(path)
    return arrays | {"state": np.array(json.dumps(json.loads(str(arrays["state"])) | changes))}


def test_what_was_saved_is_loaded(stored: Path) -> None:
    found = load_checkpoint(stored, "run", CPU)
    assert found.iterate.parameters.tolist() == [0.0, 1.0, 2.0]
    assert (found.iterate.steps, found.best_epoch, found.history) == (4, 2, [{"epoch": 1.0}])
    assert run_of(stored) == "run"


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"steps": "many"}, "steps is 'many'"),
        ({"loss": None}, "loss is None"),
        ({"history": [1]}, "its history is no list of records"),
        ({"history": [{"epoch": "x"}]}, "something else than numbers"),
        ({"more": 1}, "its state has the keys"),
        ({"run": 5}, "does not say what run"),
    ],
)
def test_another_state_is_refused(stored: Path, changes: dict[str, Any], said: str) -> None:
    np.savez(stored, **state(stored, **changes))
    with pytest.raises(NetworkError, match=said):
        load_checkpoint(stored, "run", CPU)
    assert run_of(stored) is None


@pytest.mark.parametrize(
    ("name", "array", "said"),
    [
        ("best", np.zeros(5), "not of the same length"),
        ("best", np.full(3, np.nan), "rows of finite numbers"),
        ("best", np.zeros((3, 1)), "rows of finite numbers"),
        ("scale", np.array(["a", "b", "c"]), "scale is an array of <U1"),
        ("other", np.zeros(3), "does not hold a state"),
    ],
)
def test_another_array_is_refused(stored: Path, name: str, array: Any, said: str) -> None:
    np.savez(stored, **(members(stored) | {name: array}))
    with pytest.raises(NetworkError, match=said):
        load_checkpoint(stored, "run", CPU)


def test_a_compressed_one_and_one_that_claims_more_than_it_holds_are_refused(stored: Path) -> None:
    arrays = members(stored)
    np.savez_compressed(stored, **arrays)
    with pytest.raises(NetworkError, match="it is compressed"):
        load_checkpoint(stored, "run", CPU)
    with zipfile.ZipFile(stored, "w") as archive:
        for name, array in arrays.items():
            member = io.BytesIO()
            np.save(member, array)
            content = member.getvalue()
            if name == "best":
                content = content.replace(b"(3,)", b"(1099511627776,)").replace(b" " * 12, b"", 1)
            archive.writestr(f"{name}.npy", content)
    with pytest.raises(NetworkError, match=r"best is an array of float32 of shape \(1099511627776,\)"):
        load_checkpoint(stored, "run", CPU)


def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "x.npz")
    with pytest.raises(NetworkError, match="it is no file"):
        load_checkpoint(tmp_path / "x.npz", "run", CPU)

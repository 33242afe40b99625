"""What becomes of networks and checkpoints that are there already."""

import errno
from dataclasses import replace
from pathlib import Path

import pytest
import torch

from sailnet.errors import NetworkError
from sailnet.networks.network import save_network
from tests.random_networks import random_network
from training.checkpoint import Progress, save_checkpoint
from training.folder import make_room
from training.levenberg_marquardt import Iterate

RUN = {"tau": "this"}


def leave(folder: Path, *, network: str | None = None, checkpoint: str | None = None) -> None:
    """As runs of these names left it."""
    if network is not None:
        made = random_network("tau")
        save_network(
            replace(made, provenance={**made.provenance, "run": network}), folder / "tau.safetensors"
        )
    if checkpoint is not None:
        save_checkpoint(
            Progress(Iterate(torch.zeros(2), torch.ones(2), 1.0, 0, 1.0), torch.zeros(2), 0, 1.0, 0.0, []),
            checkpoint,
            folder / "tau.checkpoint.npz",
        )


def there(folder: Path) -> set[str]:
    return {path.name.removeprefix("tau.") for path in folder.iterdir()}


BOTH = {"checkpoint.npz", "safetensors"}


@pytest.mark.parametrize(
    ("network", "checkpoint", "resume", "overwrite", "left"),
    [
        (None, None, False, False, set()),
        ("this", None, False, False, None),
        (None, "this", False, False, None),
        ("this", None, True, False, {"safetensors"}),
        (None, "this", True, False, {"checkpoint.npz"}),
        ("another", None, True, False, None),
        (None, "another", True, False, None),
        ("another", "this", True, False, None),
        ("this", None, False, True, set()),
        (None, "this", False, True, set()),
        ("another", "another", False, True, {"safetensors"}),
        ("this", None, True, True, {"safetensors"}),
        ("another", "this", True, True, BOTH),
        ("another", "another", True, True, {"safetensors"}),
    ],
)
def test_nothing_is_replaced_unasked(
    network: str | None,
    checkpoint: str | None,
    resume: bool,
    overwrite: bool,
    left: set[str] | None,
    tmp_path: Path,
) -> None:
    """A finished network of another run stays until the new one takes its place; None: refused."""
    leave(tmp_path, network=network, checkpoint=checkpoint)
    before = there(tmp_path)
    half_written = tmp_path / ".tau.checkpoint.npz.abc.part"
    half_written.touch()
    if left is None:
        with pytest.raises(NetworkError, match="--overwrite"):
            make_room(tmp_path, RUN, resume=resume, overwrite=overwrite)
        half_written.unlink()
        assert there(tmp_path) == before
    else:
        make_room(tmp_path, RUN, resume=resume, overwrite=overwrite)
        assert there(tmp_path) == left


@pytest.mark.parametrize("name", ["tau.safetensors", "tau.checkpoint.npz"])
def test_what_cannot_be_read_is_another_s(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_bytes(b"no network")
    with pytest.raises(NetworkError, match=f"{name} is of a run with another"):
        make_room(tmp_path, RUN, resume=True, overwrite=False)
    make_room(tmp_path, {"lambda_v": "x"}, resume=False, overwrite=False)
    assert (tmp_path / name).exists()


@pytest.mark.parametrize("what", ["network", "checkpoint"])
def test_a_full_disk_is_told_with_the_file(
    what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    said = rf"cannot write {what} .*tau\.\S+: no space left on device: [0-9.]+ kB needed, .* free"
    with pytest.raises(NetworkError, match=said):
        leave(tmp_path, **{what: "this"})
    assert list(tmp_path.iterdir()) == []

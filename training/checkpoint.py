"""The state of an unfinished training run, as an npz file that executes nothing when loaded."""

import io
import json
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from sailnet.artefacts.files import write_bytes, writing
from sailnet.errors import NetworkError, reason
from training.checkpoint_checks import read_members
from training.levenberg_marquardt import Iterate

SCHEMA = "sailnet-checkpoint/1"

FAULTS = (OSError, ValueError, KeyError, EOFError, NotImplementedError, RuntimeError, zipfile.BadZipFile)
"""What reading a file that is no checkpoint may raise; zipfile has several words for it."""

History = list[dict[str, float]]


@dataclass
class Progress:
    """A training run between two epochs.

    Attributes:
        iterate: where Levenberg-Marquardt stands.
        best: parameters with the lowest validation error so far.
        best_epoch: the epoch they were reached in.
        best_validation: that error.
        seconds: time spent, earlier sessions included.
        history: one record an epoch: epoch, train, validation, test, mu, seconds.
    """

    iterate: Iterate
    best: Tensor
    best_epoch: int
    best_validation: float
    seconds: float
    history: History


def save_checkpoint(progress: Progress, run: str, path: Path) -> None:
    """Write a checkpoint of the run identified by ``run``; whole or not at all.

    Raises:
        NetworkError: it cannot be written (full disk, no permission).
    """
    at = progress.iterate
    numbers = {
        "schema": SCHEMA,
        "run": run,
        "damping": at.damping,
        "steps": at.steps,
        "loss": at.loss,
        "best_epoch": progress.best_epoch,
        "best_validation": progress.best_validation,
        "seconds": progress.seconds,
        "history": progress.history,
    }

    stream = io.BytesIO()
    # JSON keeps every float64 exactly.
    np.savez(
        stream,
        state=np.array(json.dumps(numbers)),
        parameters=at.parameters.cpu().numpy(),
        scale=at.scale.cpu().numpy(),
        best=progress.best.cpu().numpy(),
    )
    content = stream.getvalue()
    with writing(f"checkpoint {path}", NetworkError):
        write_bytes(path, content)


def run_of(path: Path) -> str | None:
    """The run a checkpoint belongs to; None if it cannot be read."""
    try:
        return str(read_members(path)[0]["run"])
    except FAULTS:
        return None


def load_checkpoint(path: Path, run: str, device: torch.device) -> Progress:
    """Read a checkpoint.

    Raises:
        NetworkError: missing, damaged, or of a run with other data, recipe or seed.
    """
    try:
        state, arrays = read_members(path)
        tensors = {name: torch.from_numpy(array).to(device) for name, array in arrays.items()}
        if state["schema"] != SCHEMA or state["run"] != run:
            raise NetworkError(
                f"{path} belongs to a run with another data set, recipe, seed or device: "
                "say --overwrite to start again"
            )
        iterate = Iterate(
            tensors["parameters"], tensors["scale"], state["damping"], state["steps"], state["loss"]
        )
        return Progress(
            iterate,
            tensors["best"],
            state["best_epoch"],
            state["best_validation"],
            state["seconds"],
            state["history"],
        )
    except FAULTS as error:
        raise NetworkError(
            f"cannot read checkpoint {path}: {reason(error)}; say --overwrite to start again"
        ) from error

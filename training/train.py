"""One network's training run: early stopping, checkpoints, history, and the finished file."""

import hashlib
import json
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from sailnet.artefacts.files import write_text, writing
from sailnet.artefacts.provenance import software
from sailnet.dataset import open_dataset
from sailnet.errors import NetworkError
from sailnet.mission.mission import Mission
from sailnet.mission.recipes import TrainingRecipe
from sailnet.networks.network import Network, load_network, save_network
from training.bounded import bounded
from training.checkpoint import Progress, load_checkpoint, save_checkpoint
from training.judged import float32_error, judge, network_of
from training.layers import Layers
from training.least_squares import LeastSquares
from training.levenberg_marquardt import advance, begin
from training.samples import Part, SampleSet, load_samples
from training.targets import Target
from training.warm_start import begins_with, first_parameters

SCHEMA = "sailnet-training/4"
"""Part of what identifies a run: changes when the algorithm does, so that no old run is resumed."""

CHECKPOINT_EVERY = 10
"""Epochs between two checkpoints."""

TEST_SUBSET = 30_000
"""Test samples behind the history's test curve; the final test error uses all of them."""

Watcher = Callable[[dict[str, float]], None]
"""Called after every epoch with its record of the history."""


@dataclass(frozen=True)
class Problems:
    """The three sums of squares of a run, on one device."""

    train: LeastSquares
    validation: LeastSquares
    test: LeastSquares


def problems(samples: SampleSet, hidden: tuple[int, ...], device: torch.device) -> Problems:
    """Scale the samples and move them to the device."""

    def of(part: Part, every: int = 1) -> LeastSquares:
        columns = [column[::every].T for column in samples.scaled(part)]
        inputs, factors, values = (torch.from_numpy(np.ascontiguousarray(x)).to(device) for x in columns)
        return LeastSquares.of(layers, inputs, values, factors=factors)

    layers = Layers((len(samples.input_min), *hidden, samples.outputs))
    every = max(1, len(samples.test.values) // TEST_SUBSET)
    return Problems(of(samples.train), of(samples.validation), of(samples.test, every))


def start(run: Problems, parameters: Tensor) -> Progress:
    """The state before the first epoch, from parameters on any device."""
    parameters = bounded(run.train.layers, parameters).to(run.train.targets.device)
    return Progress(begin(run.train, parameters), parameters, 0, run.validation.loss(parameters), 0.0, [])


def epochs(
    run: Problems,
    recipe: TrainingRecipe,
    progress: Progress,
    watch: Watcher | None = None,
    save: Callable[[Progress], None] | None = None,
) -> str:
    """Train in place until a stop rule holds, and return the rule's name."""
    reason = _stop(recipe, progress)
    while reason is None:
        started = time.perf_counter()
        reached = advance(run.train, progress.iterate, recipe.curvature_samples)
        if reached is None:
            return "minimum"
        validation, test = run.validation.loss(reached.parameters), run.test.loss(reached.parameters)
        progress.iterate = reached
        if validation < progress.best_validation:
            progress.best, progress.best_epoch = reached.parameters, reached.steps
            progress.best_validation = validation
        progress.seconds += time.perf_counter() - started
        record = {
            "epoch": reached.steps,
            "train": reached.loss,
            "validation": validation,
            "test": test,
            "mu": reached.damping,
            "seconds": progress.seconds,
        }
        progress.history.append(record)
        if watch is not None:
            watch(record)
        if save is not None and reached.steps % CHECKPOINT_EVERY == 0:
            save(progress)
        reason = _stop(recipe, progress)
    return reason


def _stop(recipe: TrainingRecipe, progress: Progress) -> str | None:
    steps = progress.iterate.steps
    if progress.best_validation <= recipe.goal:
        return "goal"
    if steps - progress.best_epoch >= recipe.patience:
        return "patience"
    return "epochs" if steps >= recipe.epochs else None


def run_digest(target: Target, dataset: str, mission: Mission, device: str, threads: int) -> str:
    """What a run's weights depend on, to the last bit: equal means the same weights.

    Args:
        target: what is learnt.
        dataset: the data set's digest.
        mission: the recipe.
        device: type of the torch device.
        threads: that torch computes with.
    """
    identity: list[object] = [SCHEMA, target.definition, dataset, mission.digest("training"), device]
    identity += [torch.__version__, threads, begins_with(target, target.recipe(mission.training))]
    return hashlib.sha256(json.dumps(identity).encode()).hexdigest()


def train_network(
    dataset: Path,
    mission: Mission | None,
    target: Target,
    folder: Path,
    device_name: str = "cpu",
    resume: bool = False,
    watch: Watcher | None = None,
) -> Network:
    """Train one network into ``<folder>/<name>.safetensors`` and ``<name>.history.json``.

    Args:
        dataset: the HDF5 file.
        mission: the recipe, and the problem the data set must belong to; None takes the data set's.
        target: what to learn.
        folder: where the files go; ``<name>.checkpoint.npz`` stands there until they are complete.
        device_name: a torch device, ``cpu`` or ``cuda``.
        resume: go on from a checkpoint, or return a network already finished by the same run;
            the weights are the same, bit for bit, as those of an undisturbed run.
        watch: called after every epoch, if given.

    Raises:
        DatasetError: the data set cannot be used.
        NetworkError: the checkpoint or the device cannot be used.
    """
    device = _device(device_name)
    finished, checkpoint = folder / f"{target.name}.safetensors", folder / f"{target.name}.checkpoint.npz"
    with open_dataset(dataset, mission) as data:
        mission, digest = mission or data.mission, data.digest
        recipe = target.recipe(mission.training)
        identity = run_digest(target, digest, mission, device.type, torch.get_num_threads())
        if resume and not checkpoint.exists() and finished.exists():
            network = load_network(finished)
            if network.provenance.get("run") == identity:
                return network
        data.verify()
        counts = recipe.train_samples, recipe.validation_samples
        samples = load_samples(data, target, recipe.seed, *counts, recipe.emphasis)
    run = problems(samples, recipe.hidden, device)
    layers = run.train.layers
    progress = start(run, first_parameters(layers, target, recipe, samples))
    if resume and checkpoint.exists():
        size = progress.best.shape
        progress = load_checkpoint(checkpoint, identity, device)
        if progress.best.shape != size:
            raise NetworkError(
                f"{checkpoint} is of a network of another size: say --overwrite to start again"
            )
    reason = epochs(run, recipe, progress, watch, lambda state: save_checkpoint(state, identity, checkpoint))
    provenance = {
        "run": identity,
        "dataset": digest,
        "definition": target.definition,
        "state_min": samples.state_min.tolist(),
        "state_max": samples.state_max.tolist(),
        "seed": recipe.seed,
        "start": begins_with(target, recipe),
        "split": "70/15/15 by family",
        "train_samples": run.train.samples,
        "validation_samples": run.validation.samples,
        "test_samples": len(samples.test.values),
        "epochs": progress.iterate.steps,
        "best_epoch": progress.best_epoch,
        "stopped_by": reason,
        "seconds": progress.seconds,
        "device": device.type,
        "torch": torch.__version__,
        "train_mse": run.train.loss(progress.best),
        "validation_mse": progress.best_validation,
        "float32_error": float32_error(run.test, progress.best) * (samples.output_max - samples.output_min),
        **software(),
    }
    network = network_of(target, samples, mission, layers, progress.best, provenance)
    judged = provenance | judge(network, target, samples)
    network = network_of(target, samples, mission, layers, progress.best, judged)
    text = json.dumps({"network": target.name, "stopped_by": reason, "epochs": progress.history})
    history = folder / f"{target.name}.history.json"
    with writing(history, NetworkError):
        write_text(history, text)
    save_network(network, finished)
    checkpoint.unlink(missing_ok=True)
    return network


def _device(name: str) -> torch.device:
    try:
        device = torch.device(name)
        torch.zeros(1, device=device)
    except (RuntimeError, AssertionError) as error:
        raise NetworkError(f"torch device {name!r} cannot be used: {error}") from error
    return device

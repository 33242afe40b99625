"""One network's training run: early stopping, checkpoints, history, and the finished file."""

import hashlib
import json
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
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
from training.checkpoint import Progress, load_checkpoint, save_checkpoint
from training.layers import Layers
from training.least_squares import LeastSquares
from training.levenberg_marquardt import advance, begin
from training.samples import Part, SampleSet, load_samples
from training.targets import Target, command_error

SCHEMA = "sailnet-training/3"
"""Part of what identifies a run: changes when the algorithm does, so that no old run is resumed."""

CHECKPOINT_EVERY = 10
"""Epochs between two checkpoints."""

TEST_SUBSET = 30_000
"""Test samples behind the history's test curve; the final test error uses all of them."""

NEAR_ARRIVAL = 0.3
"""Time to go [TU] below which the test error is reported apart: it decides the terminal error."""

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


def start(run: Problems, seed: int) -> Progress:
    """The state before the first epoch."""
    parameters = run.train.layers.initial(seed).to(run.train.targets.device)
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
    identity += [torch.__version__, threads]
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
        samples = load_samples(data, target, recipe.seed, recipe.train_samples, recipe.validation_samples)
    run = problems(samples, recipe.hidden, device)
    progress = start(run, recipe.seed)
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
        "float32_error": _float32_error(run.test, progress.best) * (samples.output_max - samples.output_min),
        **software(),
    }
    network = _network(target, samples, mission, run.train.layers, progress.best, provenance)
    network = _network(
        target,
        samples,
        mission,
        run.train.layers,
        progress.best,
        provenance | judge(network, target, samples),
    )
    text = json.dumps({"network": target.name, "stopped_by": reason, "epochs": progress.history})
    history = folder / f"{target.name}.history.json"
    with writing(history, NetworkError):
        write_text(history, text)
    save_network(network, finished)
    checkpoint.unlink(missing_ok=True)
    return network


def judge(network: Network, target: Target, samples: SampleSet) -> dict[str, float]:
    """Errors over the whole test split, through the very evaluation that is stored and exported.

    Returns:
        ``test_mse`` of the scaled output (as Table 1), the same near arrival, and for command
        networks ``command_mse``: that of |alpha| in units of 2 phi_max, the same for every target.
    """
    test = samples.test
    near = test.tau < NEAR_ARRIVAL
    output = network(test.inputs)
    squared = ((output - test.values) / (network.output_max - network.output_min)) ** 2
    errors = {"test_mse": squared, "test_mse_near_arrival": squared[near]}
    if target.size is not None:
        command = command_error(target, output, test.alpha, network.mission.problem.phi_max) ** 2
        errors |= {"command_mse": command, "command_mse_near_arrival": command[near]}
    return {name: float(values.mean()) for name, values in errors.items()}


def _network(
    target: Target,
    samples: SampleSet,
    mission: Mission,
    layers: Layers,
    parameters: Tensor,
    provenance: dict[str, object],
) -> Network:
    matrices = [matrix.numpy() for matrix in layers.matrices(parameters.cpu())]
    return Network(
        name=target.name,
        inputs=target.inputs,
        weights=tuple(matrix[:, :-1].copy() for matrix in matrices),
        biases=tuple(matrix[:, -1].copy() for matrix in matrices),
        input_min=samples.input_min,
        input_max=samples.input_max,
        output_min=samples.output_min,
        output_max=samples.output_max,
        mission=mission,
        provenance=provenance,
        factors=target.factors,
    )


def _float32_error(problem: LeastSquares, parameters: Tensor) -> float:
    """Largest difference of the scaled output between float32 and float64 arithmetic."""
    in_single = replace(problem, inputs=problem.inputs.float(), factors=problem.factors.float())
    single, double = in_single.value(parameters.float()), problem.value(parameters)
    return float((single.double() - double).abs().max())


def _device(name: str) -> torch.device:
    try:
        device = torch.device(name)
        torch.zeros(1, device=device)
    except (RuntimeError, AssertionError) as error:
        raise NetworkError(f"torch device {name!r} cannot be used: {error}") from error
    return device

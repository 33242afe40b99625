"""``python -m training.compare_targets``: which single-valued target the command network learns best.

Around a pinch (lambda_u = lambda_v = 0) any even, 2 pi-periodic function of the direction chi of
(-3 lambda_u, -sqrt(8) lambda_v) is single-valued, and |alpha| follows from it. All candidates get
the same samples, network size, start and number of epochs, and are judged by the error of |alpha|
they lead to on the same test trajectories.
"""

import argparse
import math
import sys
from functools import partial
from pathlib import Path

import numpy as np
import torch
from tqdm import tqdm

from sailnet.dataset import Dataset, open_dataset
from sailnet.errors import SailnetError
from sailnet.mission.recipes import TrainingRecipe
from sailnet.networks.guidance_networks import COMMAND_INPUTS
from sailnet.physics.arrays import Array
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.transfer import Transfer
from sailnet.workers.interruption import run_command
from training.judged import NEAR_ARRIVAL
from training.layers import augment, forward
from training.samples import SampleSet, load_samples
from training.targets import TARGETS, Target, command_error
from training.train import epochs, problems, start


def cone_direction(lambda_u: Array, lambda_v: Array) -> Array:
    """|chi| [rad]: angle of (-3 lambda_u, sqrt(8) lambda_v), on which |alpha| alone depends."""
    return np.arctan2(math.sqrt(8.0) * np.abs(lambda_v), -3.0 * lambda_u)


def candidates(problem: Transfer) -> list[Target]:
    """The targets compared; the first three are read without any change to the guidance."""

    def size_at(direction: Array) -> Array:
        return np.abs(guidance_law(problem, -np.cos(direction) / 3.0, np.sin(direction) / np.sqrt(8.0)))

    paper = TARGETS["box"]
    costates = ("lambda_u", "lambda_v")
    return [
        paper["alpha_pre"],
        paper["alpha_pre_eq23"],
        paper["alpha"],
        Target(
            "direction",
            COMMAND_INPUTS,
            costates,
            lambda columns: cone_direction(columns["lambda_u"], columns["lambda_v"]),
            "|chi|, read by Eqs. (11) and (12)",
            lambda output, _: size_at(np.clip(np.abs(output), 0.0, np.pi)),
        ),
        Target(
            "cos_direction",
            COMMAND_INPUTS,
            costates,
            lambda columns: np.cos(cone_direction(columns["lambda_u"], columns["lambda_v"])),
            "cos chi, read by arccos and Eqs. (11) and (12)",
            lambda output, _: size_at(np.arccos(np.clip(output, -1.0, 1.0))),
        ),
    ]


def trained_output(data: Dataset, target: Target, recipe: TrainingRecipe) -> tuple[SampleSet, Array]:
    """Train one candidate; its samples, and its output in physical units on the test part."""
    samples = load_samples(data, target, recipe.seed, recipe.train_samples, recipe.validation_samples)
    run = problems(samples, recipe.hidden, torch.device("cpu"))
    progress = start(run, run.train.layers.initial(recipe.seed))
    with tqdm(total=recipe.epochs, desc=target.name, disable=None, file=sys.stderr) as bar:
        epochs(run, recipe, progress, watch=partial(_show, bar))
    scaled = augment(torch.from_numpy(samples.scaled(samples.test)[0].T.copy()))
    output = forward(run.train.layers.matrices(progress.best), scaled)[1][0].numpy()
    return samples, samples.output_min + (samples.output_max - samples.output_min) * output


def _show(bar: tqdm, record: dict[str, float]) -> None:
    bar.update(int(record["epoch"]) - bar.n)


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m training.compare_targets",
        description=__doc__,
        epilog="example: python -m training.compare_targets build/earth_mars/box.h5 --epochs 200",
    )
    parser.add_argument("dataset", type=Path)
    parser.add_argument("--epochs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=7)
    options = parser.parse_args()
    print(f"{'target':16}{'all':>10}{'tau<0.3':>10}{'largest':>10}   MSE and error of |alpha| / (2 phi_max)")
    try:
        with open_dataset(options.dataset) as data:
            changes = {"epochs": options.epochs, "patience": options.epochs, "seed": options.seed}
            recipe = data.mission.training.paper.model_copy(update=changes)
            problem = data.mission.problem
            for target in candidates(problem):
                samples, output = trained_output(data, target, recipe)
                error = command_error(target, output, samples.test.alpha, problem.phi_max)
                near = samples.test.tau < NEAR_ARRIVAL
                numbers = (np.mean(error**2), np.mean(error[near] ** 2), np.abs(error).max())
                print(f"{target.name:16}" + "".join(f"{x:10.2e}" for x in numbers), flush=True)
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

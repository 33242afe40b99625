"""``python -m training.compare_inputs``: the same networks with other inputs, at the same size and data.

On the paper's box: the rows of Table 1. On wide data: the cone angle's size, for guidance. Each row is
trained with the inputs it has and with others. All get the same samples, hidden layers, start and number
of epochs. The error is Table 1's, over all samples of the test trajectories but their arrivals: there
every trajectory is in one and the same state with another command and another costate, which no
function of the state tells apart.
"""

import argparse
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from sailnet.dataset import open_dataset
from sailnet.errors import SailnetError
from sailnet.networks.approach import APPROACH_INPUTS
from sailnet.networks.guidance_networks import COMMAND_INPUTS, STATE_INPUTS
from sailnet.physics.arrays import Array
from sailnet.workers.interruption import run_command
from training.compare_targets import trained_output
from training.samples import Part
from training.targets import TARGETS, Target, command_error

INTEGRAL_INPUTS = (*STATE_INPUTS, "momentum", "energy")
APPROACH_TIME_INPUTS = ("x_r", "x_u", "x_v", "s", "tau")
DIRECTED_INPUTS = (*COMMAND_INPUTS, "x_r", "x_u", "x_v")

TABLE_1 = {"tau": 1e-8, "lambda_v_printed": 5.07e-6, "alpha_pre": 7.70e-7}
"""Test errors the paper prints; |alpha| is judged as its alpha_pre, in units of 2 phi_max."""


WIDE_INPUTS = (
    (*STATE_INPUTS, "beta"),
    (*COMMAND_INPUTS, "beta"),
    (*INTEGRAL_INPUTS, "beta"),
    (*STATE_INPUTS, "s", "beta"),
    (*APPROACH_INPUTS, "r"),
    (*APPROACH_INPUTS, "tau"),
    APPROACH_INPUTS,
)
"""What the command network could read on wide data; the last is what it does."""


def candidates(kind: str) -> list[Target]:
    """The paper's rows, each followed by its like with other inputs; on wide data ``WIDE_INPUTS``."""
    if kind == "wide":
        return [replace(TARGETS["wide"]["alpha_pre"], inputs=inputs) for inputs in WIDE_INPUTS]
    paper = TARGETS["box"]
    return [
        paper["tau"],
        replace(paper["tau"], inputs=INTEGRAL_INPUTS),
        paper["lambda_v_printed"],
        replace(paper["lambda_v_printed"], inputs=APPROACH_TIME_INPUTS),
        paper["alpha_pre"],
        replace(paper["alpha_pre"], inputs=DIRECTED_INPUTS),
    ]


def squared_errors(
    target: Target, output: Array, test: Part, span: float, phi_max: float
) -> tuple[float, float | None]:
    """Mean squared errors without arrivals: of the scaled output, and of |alpha| in units of 2 phi_max.

    Args:
        target: what was learned.
        output: (n,) in physical units.
        test: the n samples it is for.
        span: range of the target.
        phi_max: bound on the cone angle [rad].

    Returns:
        The second is None for networks that are no command.
    """
    flown = test.tau > 0.0
    own = float(np.mean(((output - test.values)[flown] / span) ** 2))
    if target.size is None:
        return own, None
    return own, float(np.mean(command_error(target, output, test.alpha, phi_max)[flown] ** 2))


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m training.compare_inputs",
        description=__doc__,
        epilog="example: python -m training.compare_inputs build/earth_mars/box.h5 --epochs 200",
    )
    parser.add_argument("dataset", type=Path, help="the paper's box, or wide data")
    parser.add_argument("--epochs", type=int, default=200, help="(%(default)s)")
    parser.add_argument("--seed", type=int, default=7, help="(%(default)s)")
    parser.add_argument("--network", action="append", choices=list(TABLE_1), help="this one; repeatable")
    options = parser.parse_args()
    print("| network | inputs | Table 1 | test MSE | of &#124;alpha&#124; / (2 phi_max) |")
    print("|---|---|---|---|---|")
    try:
        with open_dataset(options.dataset) as data:
            changes = {"epochs": options.epochs, "patience": options.epochs, "seed": options.seed}
            training = data.mission.training
            recipe = (training.wide if data.kind == "wide" else training.paper).model_copy(update=changes)
            phi_max = data.mission.problem.phi_max
            for target in candidates(data.kind):
                if target.name not in (options.network or TABLE_1):
                    continue
                samples, output = trained_output(data, target, recipe)
                span = samples.output_max - samples.output_min
                own, command = squared_errors(target, output, samples.test, span, phi_max)
                judged = "" if command is None else f"{command:.2e}"
                read = ", ".join(target.inputs)
                printed = "" if data.kind == "wide" else f"{TABLE_1[target.name]:.2e}"
                row = f"| {target.name} | {read} | {printed} | {own:.2e} | {judged} |"
                print(row, flush=True)
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

"""``python -m export.agreement``: the exported C against onnxruntime against PyTorch, state by state.

Two sets of states: samples of the data set, where the networks were trained, and uniform states of the
box around them, most of which no trajectory passes.
"""

import argparse
import json
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

import numpy as np
import torch

from export.torch_networks import torch_guidance
from sailnet import SailnetError
from sailnet.dataset import open_dataset
from sailnet.guidance.backends import Backend, load_guidance
from sailnet.guidance.facts import describe
from sailnet.guidance.interface import Precision
from sailnet.mission.mission import Mission
from sailnet.networks.approach import approach_coordinates
from sailnet.networks.guidance_networks import GuidanceNetworks, load_guidance_networks
from sailnet.physics.arrays import Array
from sailnet.workers.interruption import run_command

PRECISIONS: tuple[Precision, ...] = ("float64", "float32")
BACKENDS: Mapping[str, Backend] = {"C": "c", "onnxruntime": "onnx"}

SIGN_MARGIN: Mapping[str, float] = {"float64": 1e-9, "float32": 1e-3}
"""Output of the sign network [1] below which rounding may decide the sign of the command."""


GOAL: Mapping[str, float] = {"float64": 1e-12, "float32": 1e-6}
"""Difference of the cone angle [rad] that is aimed at."""


@dataclass(frozen=True)
class Sails:
    """Where commands are compared.

    Attributes:
        states: (n, 3) rows r, u, v.
        beta: (n,) normalised characteristic accelerations; without effect on networks that read none.
    """

    states: Array
    beta: Array

    def rounded(self, precision: Precision) -> "Sails":
        """The nearest sails of a precision."""
        return Sails(*(values.astype(precision).astype(float) for values in (self.states, self.beta)))


def sails_of_dataset(path: Path, mission: Mission, count: int, seed: int) -> Sails:
    """Samples drawn evenly from a data set of a mission.

    Raises:
        DatasetError: it cannot be read, or is another mission's.
    """
    with open_dataset(path, mission) as data:
        data.verify()
        rows = np.sort(np.random.default_rng(seed).choice(data.samples, count))
        columns = data.read(["r", "u", "v", "beta"], 0, data.samples)
        return Sails(
            np.column_stack([columns[name][rows] for name in ("r", "u", "v")]), columns["beta"][rows]
        )


def sails_of_box(networks: GuidanceNetworks, count: int, seed: int) -> Sails:
    """Uniform in the box of trained states and the range of trained beta."""
    rng = np.random.default_rng(seed)
    facts = describe(networks, networks.mission)
    states = rng.uniform(facts.state_min, facts.state_max, (count, 3))
    return Sails(states, rng.uniform(*networks.beta_range, count))


def sign_network(networks: GuidanceNetworks, sails: Sails) -> Array:
    """(n,) output of the network whose sign is the command's."""
    if networks.approach:
        return networks.lambda_v(approach_coordinates(networks.mission.problem, sails.states, sails.beta))
    return networks.lambda_v(np.column_stack([sails.states, networks.tau(sails.states)]))


def in_torch(networks: GuidanceNetworks, sails: Sails, precision: Precision) -> tuple[Array, Array]:
    """Cone angle [rad] and time of flight [TU] as PyTorch computes them, (n,) each."""
    module = torch_guidance(networks, describe(networks, networks.mission))
    module = module.in_float32() if precision == "float32" else module
    given = (sails.states, sails.beta)[: 2 if networks.approach else 1]
    with torch.inference_mode():
        alpha, tau, _ = module(*(torch.tensor(values, dtype=getattr(torch, precision)) for values in given))
    return alpha.double().numpy(), tau.double().numpy()


def compare(networks: GuidanceNetworks, exported: Path, sails: Sails) -> list[dict[str, object]]:
    """Differences of the cone angle between every pair of evaluations, in both precisions.

    Returns:
        One record a precision and pair: largest difference [rad], its 99.9 % quantile and median, and
        the share within ``GOAL``, over the states where the sign network is not within rounding of
        zero; and the share of those states.
    """
    records: list[dict[str, object]] = []
    for precision in PRECISIONS:
        given = sails.rounded(precision)
        angles = {
            name: load_guidance(networks.mission, backend, precision, exported)
            .command(given.states, given.beta)
            .cone_angle
            for name, backend in BACKENDS.items()
        }
        angles["PyTorch"] = in_torch(networks, given, precision)[0]
        certain = np.abs(sign_network(networks, given)) > SIGN_MARGIN[precision]
        for one, other in combinations(angles, 2):
            difference = np.abs(angles[one] - angles[other])[certain]
            records.append(
                {
                    "precision": precision,
                    "pair": f"{one} - {other}",
                    "largest": float(difference.max()),
                    "quantile_999": float(np.quantile(difference, 0.999)),
                    "median": float(np.median(difference)),
                    "share_within_goal": float((difference <= GOAL[precision]).mean()),
                    "share_compared": float(certain.mean()),
                }
            )
    return records


def main() -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m export.agreement",
        description=__doc__,
        epilog="example: python -m export.agreement build/earth_mars/networks build/earth_mars/export "
        "--dataset build/earth_mars/box.h5",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("networks", type=Path, help="folder of the weights")
    parser.add_argument("exported", type=Path, help="folder written by python -m export")
    parser.add_argument("--dataset", type=Path, required=True, help="the HDF5 file they were trained on")
    parser.add_argument("--states", type=int, default=100_000, help="of each kind (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the draws (%(default)s)")
    options = parser.parse_args()
    try:
        networks = load_guidance_networks(options.networks)
        kinds = {
            "samples of the data set": sails_of_dataset(
                options.dataset, networks.mission, options.states, options.seed
            ),
            "uniform in the box": sails_of_box(networks, options.states, options.seed),
        }
        records = [
            {"states": kind, "count": options.states, **record}
            for kind, sails in kinds.items()
            for record in compare(networks, options.exported, sails)
        ]
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print(json.dumps(records, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

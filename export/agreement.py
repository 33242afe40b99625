"""``python -m export.agreement``: the exported C against onnxruntime against PyTorch, state by state.

Two sets of states: samples of the data set, where the networks were trained, and uniform states of the
box around them, most of which no trajectory passes.
"""

import argparse
import json
import sys
from collections.abc import Mapping
from itertools import combinations
from pathlib import Path

import numpy as np
import torch

from export.torch_networks import TorchGuidance
from sailnet import SailnetError
from sailnet.backends import load_guidance
from sailnet.dataset import open_dataset
from sailnet.dynamics import Array
from sailnet.guidance import Precision
from sailnet.networks import GuidanceNetworks, load_guidance_networks

PRECISIONS: tuple[Precision, ...] = ("float64", "float32")

SIGN_MARGIN: Mapping[str, float] = {"float64": 1e-9, "float32": 1e-3}
"""Output of the sign network [1] below which rounding may decide the sign of the command."""


GOAL: Mapping[str, float] = {"float64": 1e-12, "float32": 1e-6}
"""Difference of the cone angle [rad] that is aimed at."""


def states_of_dataset(path: Path, count: int, seed: int) -> Array:
    """(count, 3) samples drawn evenly from a data set."""
    with open_dataset(path) as data:
        data.verify()
        rows = np.sort(np.random.default_rng(seed).choice(data.samples, count))
        columns = data.read(["r", "u", "v"], 0, data.samples)
        return np.column_stack([columns[name][rows] for name in ("r", "u", "v")])


def states_of_box(networks: GuidanceNetworks, count: int, seed: int) -> Array:
    """(count, 3) uniform states of the trained range."""
    tau = networks.tau
    return np.random.default_rng(seed).uniform(tau.input_min, tau.input_max, (count, 3))


def compare(networks: GuidanceNetworks, exported: Path, states: Array) -> list[dict[str, object]]:
    """Differences of the cone angle between every pair of evaluations, in both precisions.

    Returns:
        One record a precision and pair: largest difference [rad], its 99.9 % quantile and median, and
        the share within ``GOAL``, over the states where the sign network is not within rounding of
        zero; and the share of those states.
    """
    records: list[dict[str, object]] = []
    for precision in PRECISIONS:
        given = states.astype(precision).astype(float)
        module = TorchGuidance(networks)
        module = module.in_float32() if precision == "float32" else module
        with torch.inference_mode():
            torch_angle = module(torch.tensor(given, dtype=getattr(torch, precision)))[0].double().numpy()
        angles = {
            "C": load_guidance(networks.mission, "c", precision, exported).command(given).cone_angle,
            "onnxruntime": load_guidance(networks.mission, "onnx", precision, exported)
            .command(given)
            .cone_angle,
            "PyTorch": torch_angle,
        }
        sign = networks.lambda_v(np.column_stack([given, networks.tau(given)]))
        certain = np.abs(sign) > SIGN_MARGIN[precision]
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
            "samples of the data set": states_of_dataset(options.dataset, options.states, options.seed),
            "uniform in the box": states_of_box(networks, options.states, options.seed),
        }
        records = [
            {"states": kind, "count": options.states, **record}
            for kind, states in kinds.items()
            for record in compare(networks, options.exported, states)
        ]
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print(json.dumps(records, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())

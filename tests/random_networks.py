"""Untrained networks with the scaling of the Earth-Mars box, whose outputs cover their range."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from scipy.special import expit

from sailnet import Mission, load_mission
from sailnet.networks import COMMAND_INPUTS, STATE_INPUTS, GuidanceNetworks, Network, save_network

STATE_MIN, STATE_MAX = (0.35, -0.45, 0.59), (1.56, 0.45, 1.85)
OUTPUT_RANGE = {
    "tau": (0.0, 10.0),
    "alpha_pre": (-1.05, 1.05),
    "alpha": (-1.05, 1.05),
    "lambda_v": (-50.0, 14.0),
}


def random_network(
    name: str, hidden: Sequence[int] = (20, 20, 20), seed: int = 0, mission: Mission | None = None
) -> Network:
    """A network whose output covers its range, and a little more, over its box of inputs."""
    rng = np.random.default_rng([seed, len(name), *name.encode()])
    inputs = STATE_INPUTS if name == "tau" else COMMAND_INPUTS
    extra = () if name == "tau" else (0.0,), () if name == "tau" else (10.0,)
    sizes = [len(inputs), *hidden]
    shapes = list(zip(sizes[1:], sizes[:-1], strict=True))
    weights = [rng.normal(scale=3.0 if i == 0 else 6.0 / np.sqrt(s[1]), size=s) for i, s in enumerate(shapes)]
    biases = [-w.sum(axis=1) / 2 + rng.normal(scale=0.5, size=len(w)) for w in weights]
    layer = rng.uniform(size=(4000, len(inputs)))
    for weight, bias in zip(weights, biases, strict=True):
        layer = expit(layer @ weight.T + bias)
    last = rng.normal(size=hidden[-1])
    lowest, highest = (layer @ last).min(), (layer @ last).max()
    return Network(
        name=name,
        inputs=inputs,
        weights=(*weights, 1.02 * last[None, :] / (highest - lowest)),
        biases=(*biases, np.array([-1.02 * lowest / (highest - lowest) - 0.01])),
        input_min=np.array([*STATE_MIN, *extra[0]]),
        input_max=np.array([*STATE_MAX, *extra[1]]),
        output_min=OUTPUT_RANGE[name][0],
        output_max=OUTPUT_RANGE[name][1],
        mission=mission or load_mission("earth_mars"),
        provenance={"dataset": "random */ weights"},
    )


def random_guidance(
    tau: Sequence[int] = (20, 20, 20),
    alpha_pre: Sequence[int] = (20, 20, 20),
    lambda_v: Sequence[int] = (20, 20, 20),
    seed: int = 0,
    mission: Mission | None = None,
) -> GuidanceNetworks:
    """Three random networks with these hidden sizes."""
    return GuidanceNetworks(
        random_network("tau", tau, seed, mission),
        random_network("alpha_pre", alpha_pre, seed, mission),
        random_network("lambda_v", lambda_v, seed, mission),
    )


def save_guidance(networks: GuidanceNetworks, folder: Path) -> None:
    """Write the three files that ``load_guidance_networks`` reads."""
    for network in (networks.tau, networks.alpha_pre, networks.lambda_v):
        save_network(network, folder / f"{network.name}.safetensors")

"""Where training begins: with random weights, or with the networks of another mission, that ship.

In approach coordinates the laws of all missions are alike, so that another's is learnt anew in a third of the
steps, and without the plateau on which |alpha| stays for up to a hundred of them
(docs/notebook/training-algorithm.md).
"""

import numpy as np
import torch
from torch import Tensor

from sailnet.errors import NetworkError
from sailnet.guidance.backends import exported_folder
from sailnet.mission.mission import load_mission
from sailnet.mission.recipes import TrainingRecipe
from sailnet.networks.network import Network, load_network, weights_digest
from sailnet.physics.arrays import Array
from training.layers import Layers
from training.samples import SampleSet
from training.targets import Target

OWN = ("s", "beta")
"""Inputs that are compared within the range of each mission: the strongest of its sails, its longest way."""


def begins_with(target: Target, recipe: TrainingRecipe) -> str:
    """The weights that training begins with, in words that tell them apart.

    Raises:
        SailnetError: no networks of that mission come with the package, or they do not fit.
    """
    network = _network(target, recipe)
    return "random weights" if network is None else f"{recipe.start}, SHA-256 {weights_digest([network])}"


def first_parameters(layers: Layers, target: Target, recipe: TrainingRecipe, samples: SampleSet) -> Tensor:
    """(p,) parameters before the first step; float64, on the CPU.

    Of another mission's networks: the same law of the inputs that both have, scaled as the samples are.

    Raises:
        SailnetError: no networks of that mission come with the package, or they do not fit.
    """
    network = _network(target, recipe)
    if network is None:
        return layers.initial(recipe.seed)
    weights, biases = list(network.weights), list(network.biases)
    weights[0], biases[0] = _rescaled(network, target, samples)
    span = samples.output_max - samples.output_min
    share = (network.output_max - network.output_min) / span
    weights[-1] = share * weights[-1]
    biases[-1] = share * biases[-1] + (network.output_min - samples.output_min) / span
    matrices = [np.column_stack(pair).ravel() for pair in zip(weights, biases, strict=True)]
    return torch.from_numpy(np.concatenate(matrices)).to(torch.float64)


def _network(target: Target, recipe: TrainingRecipe) -> Network | None:
    """The one of this name that ships for the mission that training begins with, if there is one."""
    if recipe.start is None:
        return None
    file = exported_folder(load_mission(recipe.start)) / f"{target.name}.safetensors"
    if not file.exists():
        return None
    network = load_network(file)
    if network.hidden != recipe.hidden or not set(network.inputs) <= set(target.inputs) or network.factors:
        raise NetworkError(
            f"training cannot start with {target.name} of {recipe.start}: that has layers of "
            f"{network.hidden} and reads {', '.join(network.inputs)}, here they are {recipe.hidden} and "
            f"{', '.join(target.inputs)}: leave out `start`"
        )
    return network


def _rescaled(network: Network, target: Target, samples: SampleSet) -> tuple[Array, Array]:
    """Weights and biases of the first layer."""
    weight, bias = np.zeros((len(network.biases[0]), len(target.inputs))), network.biases[0].copy()
    for column, name in enumerate(network.inputs):
        here, steep = target.inputs.index(name), network.weights[0][:, column]
        low, high = network.input_min[column], network.input_max[column]
        if name not in OWN:
            bias += steep * (samples.input_min[here] - low) / (high - low)
            steep = steep * (samples.input_max[here] - samples.input_min[here]) / (high - low)
        weight[:, here] = steep
    return weight, bias

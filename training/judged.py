"""What a finished network is worth, and how it is stored."""

from dataclasses import replace

from torch import Tensor

from sailnet.mission.mission import Mission
from sailnet.networks.network import Network
from training.layers import Layers
from training.least_squares import LeastSquares
from training.samples import SampleSet
from training.targets import Target, command_error

NEAR_ARRIVAL = 0.3
"""Time to go [TU] below which the test error is reported apart: it decides the terminal error."""


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


def network_of(
    target: Target,
    samples: SampleSet,
    mission: Mission,
    layers: Layers,
    parameters: Tensor,
    provenance: dict[str, object],
) -> Network:
    """The network with these parameters, scaled as its samples were."""
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


def float32_error(problem: LeastSquares, parameters: Tensor) -> float:
    """Largest difference of the scaled output between float32 and float64 arithmetic."""
    in_single = replace(problem, inputs=problem.inputs.float(), factors=problem.factors.float())
    single, double = in_single.value(parameters.float()), problem.value(parameters)
    return float((single.double() - double).abs().max())

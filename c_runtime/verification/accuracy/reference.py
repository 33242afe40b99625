"""What a command should be: the reference in NumPy, and the same in extended precision to judge it by."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from c_runtime.verification.bench.compiled import Reals
from sailnet.networks.approach import SMALLEST_SCALE, approach_coordinates
from sailnet.networks.guidance_networks import GuidanceNetworks
from sailnet.networks.network import EXTRAPOLATION, Network
from sailnet.physics.arrays import Array

Extended = NDArray[np.longdouble]


@dataclass(frozen=True)
class Answers:
    """Commands at n states and sails; arrays of length n.

    Attributes:
        cone_angle: [rad], with its sign.
        time_of_flight: [TU].
        lambda_v: output of the network that gives the sign.
        scale: s of the approach coordinates [TU], what times of flight are measured by; 1 in the paper's
            form, which has none.
    """

    cone_angle: Reals
    time_of_flight: Reals
    lambda_v: Reals
    scale: Reals


def reference(networks: GuidanceNetworks, inputs: Array) -> Answers:
    """The reference that everything is tested against, in double precision.

    Args:
        networks: whose commands.
        inputs: (n, 4) rows r [AU], u, v [AU/TU] and beta.
    """
    states, beta = inputs[:, :3], inputs[:, 3]
    cone_angle, tau = networks.command(states, beta)
    if not networks.approach:
        lambda_v = networks.lambda_v(np.column_stack([states, tau]))
        return Answers(cone_angle, tau, lambda_v, np.ones(len(inputs)))
    coordinates = approach_coordinates(networks.mission.problem, states, np.clip(beta, *networks.beta_range))
    return Answers(cone_angle, tau, networks.lambda_v(coordinates), coordinates[:, 3])


def extended(networks: GuidanceNetworks, inputs: Array) -> Answers:
    """The same definitions once more, in ``numpy.longdouble``: 64 bits of mantissa on x86.

    States have to be within the clamps of the networks, as all of the trained domain are.
    """
    given = inputs.astype(np.longdouble)
    scale = np.ones(len(given), np.longdouble)
    if networks.approach:
        read, scale = _coordinates(networks, given)
        tau = scale * np.exp(_network(networks.tau, read))
    else:
        tau = _network(networks.tau, given[:, :3])
        read = np.column_stack([given[:, :3], tau])
    size = np.minimum(np.abs(_network(networks.alpha_pre, read)), networks.mission.problem.phi_max)
    lambda_v = _network(networks.lambda_v, read)
    return Answers(np.where(lambda_v > 0, -size, size), tau, lambda_v, scale)


def _coordinates(networks: GuidanceNetworks, given: Extended) -> tuple[Extended, Extended]:
    problem = networks.mission.problem
    beta = np.clip(given[:, 3], *networks.beta_range)
    missing = (given[:, :3] - np.array(problem.target_state, np.longdouble)).T
    dr, du, dv = missing * np.longdouble(problem.target_radius) ** 2 / beta
    s4 = np.maximum((du * du + dv * dv) ** 2 + 4 * dr * dr, np.longdouble(SMALLEST_SCALE) ** 4)
    s = np.sqrt(np.sqrt(s4))
    return np.column_stack([dr / (s * s), du / s, dv / s, s, beta]), s


def _network(network: Network, inputs: Extended) -> Extended:
    # The clamps are numbers of double precision, which the reference computes in just that precision.
    margin = EXTRAPOLATION * (network.input_max - network.input_min)
    layer = np.clip(inputs, network.input_min - margin, network.input_max + margin)
    lowest = network.input_min.astype(np.longdouble)
    layer = (layer - lowest) / (network.input_max.astype(np.longdouble) - lowest)
    for weight, bias in zip(network.weights[:-1], network.biases[:-1], strict=True):
        layer = 1 / (1 + np.exp(-(layer @ weight.T.astype(np.longdouble) + bias)))
    scaled = (layer @ network.weights[-1].T.astype(np.longdouble) + network.biases[-1])[:, 0]
    result: Extended = network.output_min + (np.longdouble(network.output_max) - network.output_min) * scaled
    return result

"""What a network in approach coordinates reads of a state: clamped to the trained range, then transformed."""

import numpy as np
from numpy.typing import ArrayLike

from sailnet.networks.approach import approach_coordinates, approach_coordinates_in_space
from sailnet.networks.network import EXTRAPOLATION, Network, trained_box
from sailnet.physics.arrays import Array

LATERAL = [1, 4]
"""Components of a state in space that change their sign in a mirror at the target plane."""


def trained_states(network: Network) -> tuple[Array, Array]:
    """(3,) or (5,) lowest and highest state a network was trained on; in space, that or its mirror image.

    Raises:
        NetworkError: its provenance does not hold them.
    """
    recorded = [network.provenance.get(name) for name in ("state_min", "state_max")]
    lowest, highest = trained_box(recorded, network.mission.components, network.name)
    if network.mission.inclined:  # a state south of the target plane is known as its mirror image
        highest[LATERAL] = np.maximum(highest, -lowest)[LATERAL]
        lowest[LATERAL] = -highest[LATERAL]
    return lowest, highest


def trained_betas(network: Network) -> tuple[float, float]:
    """Smallest and largest beta that a network in approach coordinates was trained for."""
    return float(network.input_min[-1]), float(network.input_max[-1])


def approach_inputs(network: Network, states: ArrayLike, beta: ArrayLike | None = None) -> Array:
    """Inputs of the networks that were trained with one in approach coordinates, at some states.

    Args:
        network: any of them: all have the same ranges.
        states: (n, 3) rows r [AU], u, v [AU/TU], or (n, 5) r, latitude [rad], u, v, w; clamped to the trained
            range, widened on each side by ``EXTRAPOLATION`` times its width.
        beta: (n,) or one normalised characteristic acceleration, clamped to the trained range; by default the
            mission's.

    Returns:
        (n, 5) ``APPROACH_INPUTS``; or (n, 10) ``APPROACH_INPUTS_IN_SPACE``, then ``LATERAL_INPUTS``.

    Raises:
        NetworkError: the trained range of the states is not recorded.
    """
    lowest, highest = trained_states(network)
    margin = EXTRAPOLATION * (highest - lowest)
    within = np.clip(np.asarray(states, float), lowest - margin, highest + margin)
    sail = np.clip(network.mission.sail.beta if beta is None else beta, *trained_betas(network))
    coordinates = approach_coordinates_in_space if network.mission.inclined else approach_coordinates
    return coordinates(network.mission.problem, within, sail)


def time_of_flight(tau: Network, inputs: Array) -> Array:
    """(n,) optimal time of flight [TU] by a network that gives log(tau / s).

    Args:
        tau: the network.
        inputs: of :func:`approach_inputs`.
    """
    return np.asarray(inputs[:, tau.inputs.index("s")] * np.exp(tau(inputs)))

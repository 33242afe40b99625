"""The networks of the arrival costates' direction: with the time of flight, a whole plan from any state.

An optimal extremal is the direction of its arrival costates and the time to go (docs/tracking.md). Each
network gives one component of that direction, with the costates of position scaled by
k = s / (s + ``ARRIVAL_SCALE``), where s is the time scale of the approach coordinates.

Towards arrival an extremal of a given deviation from the target has costates of position that grow as 1 / s
beside those of speed: the unscaled direction would turn into that of position, whatever the command is.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from sailnet.errors import NetworkError
from sailnet.mission.mission import Mission
from sailnet.networks.approach import APPROACH_INPUTS, APPROACH_INPUTS_IN_SPACE, LATERAL_INPUTS
from sailnet.networks.approach_inputs import LATERAL, approach_inputs
from sailnet.networks.known_plans import KnownPlans, load_known_plans
from sailnet.networks.network import Network, load_network, weights_digest
from sailnet.physics.arrays import Array

ARRIVAL_NAMES = {
    3: ("arrival_lambda_r", "arrival_lambda_u", "arrival_lambda_v"),
    5: (
        "arrival_lambda_r",
        "arrival_lambda_latitude",
        "arrival_lambda_u",
        "arrival_lambda_v",
        "arrival_lambda_w",
    ),
}
"""Names of the networks by the components of a state, in the order of the costates."""


ARRIVAL_SCALE = 1.0
"""Time scale s [TU] of the approach below which the costates of position are scaled down."""


def position_scale(s: Array) -> Array:
    """(n,) what the costates of position are multiplied by in the networks' outputs, for (n,) s [TU]."""
    return np.asarray(s / (s + ARRIVAL_SCALE))


def factors_of_arrival(components: int) -> tuple[tuple[str, ...], ...]:
    """What each network's outputs are multiplied by: latitude's and w's change their sign in a mirror.

    Args:
        components: of a state, 3 or 5.
    """
    lateral = LATERAL if components == 5 else []
    return tuple(LATERAL_INPUTS if row in lateral else () for row in range(components))


@dataclass(frozen=True)
class PlanNetworks:
    """Three networks in the plane, five in space, which together give the direction of the arrival costates.

    Attributes:
        all: the networks, in the order of ``ARRIVAL_NAMES``.
        known: plans for where theirs leads nowhere, if there are any.
    """

    all: tuple[Network, ...]
    known: KnownPlans | None = None

    def __post_init__(self) -> None:
        names = tuple(network.name for network in self.all)
        if not self.all or names != ARRIVAL_NAMES[self.all[0].mission.components]:
            raise NetworkError(f"these are no networks of the arrival costates: {', '.join(names)}")
        inputs = APPROACH_INPUTS_IN_SPACE if self.components == 5 else APPROACH_INPUTS
        factors = factors_of_arrival(self.components)
        for network, expected in zip(self.all, factors, strict=True):
            if network.inputs != inputs or network.factors != expected:
                raise NetworkError(
                    f"network {network.name} is none of the arrival costates: it reads "
                    f"{', '.join((*network.inputs, *network.factors))}"
                )
            if network.mission.digest() != self.mission.digest():
                raise NetworkError(f"networks do not belong together: {network.name} is of another mission")
        if self.known is not None and self.known.mission.digest() != self.mission.digest():
            raise NetworkError("networks and known plans do not belong together: they are of other missions")

    @property
    def mission(self) -> Mission:
        """The mission the networks were trained for."""
        return self.all[0].mission

    @property
    def components(self) -> int:
        """Of a state, and of a direction."""
        return self.mission.components

    @property
    def digest(self) -> str:
        """See :func:`sailnet.networks.network.weights_digest`."""
        return weights_digest(self.all, self.tables)

    @property
    def tables(self) -> dict[str, Array]:
        """What flies beside the networks."""
        return {} if self.known is None else {"known_plans": self.known.rows}

    def direction(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array:
        """Direction of the arrival costates of the optima from some states: the reference in NumPy.

        It is not made sure that an extremal with this direction exists (H = 0 at arrival).

        Args:
            states: (n, 3) rows r [AU], u, v [AU/TU], or (n, 5) r, latitude [rad], u, v, w; clamped
                as those of the guidance networks.
            beta: (n,) or one normalised characteristic acceleration, clamped to the trained range; by
                default the mission's.

        Returns:
            (n, 3) unit vectors along (lambda_r0, lambda_u0, lambda_v0), or (n, 5) in space.

        Raises:
            NetworkError: the networks do not record their trained range of states.
        """
        first = self.all[0]
        inputs = approach_inputs(first, states, beta)
        scaled = np.column_stack([network(inputs) for network in self.all])
        # The other way about, nothing is divided by what may vanish.
        scaled[:, self.components // 2 :] *= position_scale(inputs[:, first.inputs.index("s")])[:, None]
        return unit_vectors(scaled)


def unit_vectors(vectors: Array) -> Array:
    """(n, k) unit vectors along (n, k) others; zero along zero."""
    sizes = np.sqrt((vectors**2).sum(axis=1, keepdims=True))
    return np.asarray(vectors / np.where(sizes > 0.0, sizes, 1.0))


def load_plan_networks(folder: Path, mission: Mission) -> PlanNetworks | None:
    """Read the networks of the arrival costates (``.safetensors``), and known plans, from a folder.

    Args:
        folder: of a mission's networks.
        mission: that they must belong to.

    Returns:
        None if the folder has none of them, as for the paper's own recipe.

    Raises:
        NetworkError: some are there but not all, one is damaged, or they are of another mission.
    """
    files = {name: folder / f"{name}.safetensors" for name in ARRIVAL_NAMES[mission.components]}
    missing = [name for name, file in files.items() if not file.exists()]
    if len(missing) == len(files):
        return None
    if missing:
        raise NetworkError(f"{folder} lacks {', '.join(missing)} of the networks of the arrival costates")
    loaded = tuple(load_network(file) for file in files.values())
    networks = PlanNetworks(loaded, load_known_plans(folder, loaded[0].mission))
    if networks.mission.digest() != mission.digest():
        raise NetworkError(
            f"the networks of the arrival costates in {folder} are of mission {networks.mission.name!r} with "
            f"other parameters than mission {mission.name!r}"
        )
    return networks

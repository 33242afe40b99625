"""What every exported guidance says about itself, whatever the back end that flies it."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import DTypeLike

from sailnet import __version__
from sailnet.dynamics import Array
from sailnet.errors import GuidanceError
from sailnet.mission import Mission
from sailnet.networks import Network

METADATA_KEY = "sailnet_guidance"
"""The key of an ONNX file's ``metadata_props`` that holds the facts as JSON."""


@dataclass(frozen=True)
class GuidanceFacts:
    """Where an exported guidance comes from, and the constants its status codes depend on.

    Attributes:
        version: of the sailnet that exported it.
        mission: name of the mission.
        mission_digest: ``Mission.digest()``; another digest is another problem.
        networks_digest: SHA-256 over the weights and scaling of all networks, hex.
        datasets: digest of the data set of each network, as its trainer recorded it.
        phi_max: bound on the cone angle [rad], Eq. (3).
        arrival_threshold: a shorter predicted time of flight is an arrival [TU].
        largest_time_of_flight: the longest the networks were trained on [TU].
        state_min, state_max: box of states (r, u, v) the time-of-flight network was trained on.
    """

    version: str
    mission: str
    mission_digest: str
    networks_digest: str
    datasets: Mapping[str, str]
    phi_max: float
    arrival_threshold: float
    largest_time_of_flight: float
    state_min: tuple[float, float, float]
    state_max: tuple[float, float, float]

    def to_json(self) -> str:
        """One line of JSON."""
        return json.dumps(asdict(self), sort_keys=True)

    @classmethod
    def from_json(cls, text: str) -> "GuidanceFacts":
        """Read what ``to_json`` wrote.

        Raises:
            GuidanceError: it is not that.
        """
        try:
            content = json.loads(text)
            content["state_min"] = tuple(content["state_min"])
            content["state_max"] = tuple(content["state_max"])
            return cls(**content)
        except (ValueError, KeyError, TypeError) as error:
            raise GuidanceError(f"the guidance does not say what it is: {error}; export it again") from error


def describe(networks: Mapping[str, Network], mission: Mission) -> GuidanceFacts:
    """Facts of ``networks`` (one of them named ``tau``), flown by the rules of ``mission``."""
    tau = networks["tau"]
    r_min, u_min, v_min = (float(x) for x in tau.input_min)
    r_max, u_max, v_max = (float(x) for x in tau.input_max)
    return GuidanceFacts(
        version=__version__,
        mission=mission.name,
        mission_digest=mission.digest(),
        networks_digest=_digest(networks),
        datasets={name: str(n.provenance.get("dataset", "not recorded")) for name, n in networks.items()},
        phi_max=mission.problem.phi_max,
        arrival_threshold=mission.flight.arrival_threshold,
        largest_time_of_flight=tau.output_max,
        state_min=(r_min, u_min, v_min),
        state_max=(r_max, u_max, v_max),
    )


def round_down(value: float, precision: DTypeLike) -> float:
    """The largest number of this precision that does not exceed ``value``."""
    nearest = np.asarray(value, precision)
    below = np.nextafter(nearest, np.asarray(-np.inf, precision))
    return float(nearest if float(nearest) <= value else below)


def _digest(networks: Mapping[str, Network]) -> str:
    content = hashlib.sha256()
    for name, network in sorted(networks.items()):
        scaling = np.array([network.output_min, network.output_max])
        arrays: tuple[Array, ...] = (*network.weights, *network.biases, network.input_min, network.input_max)
        for array in (*arrays, scaling):
            content.update(f"{name} {array.shape}".encode())
            content.update(np.ascontiguousarray(array, dtype="<f8").tobytes())
    return content.hexdigest()

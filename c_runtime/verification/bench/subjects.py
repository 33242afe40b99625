"""What every candidate is asked: the same states, all in the trained domain, and the right answers."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import onnxruntime
from numpy.typing import ArrayLike

from c_runtime.verification.bench.compiled import Library, Reals
from c_runtime.verification.bench.exported_c import COMMAND_OUTPUTS
from sailnet.errors import GuidanceError
from sailnet.guidance.exported_files import graph_name
from sailnet.guidance.facts import METADATA_KEY, GuidanceFacts
from sailnet.guidance.interface import GuidanceStatus
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks, network_inputs, network_outputs
from sailnet.physics.arrays import Array

TRIES = 400_000


@dataclass(frozen=True)
class Subjects:
    """States and sails, exact in single precision.

    Attributes:
        inputs: (n, 4) rows r [AU], u, v [AU/TU] and beta; in three dimensions (n, 6), of r, latitude [rad],
            u, v, w and beta.
    """

    inputs: Array

    @property
    def components(self) -> int:
        """Of a state."""
        return int(self.inputs.shape[1]) - 1

    def network_inputs(self, networks: AnyGuidanceNetworks) -> Array:
        """What they read of these, see the function of this name."""
        return network_inputs(networks, self.inputs[:, :-1], self.inputs[:, -1])

    def network_outputs(self, networks: AnyGuidanceNetworks) -> Array:
        """What they give for these, see the function of this name."""
        return network_outputs(networks, self.inputs[:, :-1], self.inputs[:, -1])


def seamless(told: Reals) -> Reals:
    """Angles and times to be compared: behind the first two numbers of a row, angles as cosines and sines."""
    return np.column_stack([told[:, :2], np.cos(told[:, 2:]), np.sin(told[:, 2:])])


def agree(given: ArrayLike, expected: ArrayLike) -> bool:
    """Whether the same is computed, but for rounding, which may decide the sign of a command or two."""
    right = np.asarray(expected, float)
    close = np.abs(np.asarray(given, float) - right) <= 1e-3 * (1.0 + np.abs(right))
    return bool(close.mean(axis=0).min() >= 0.99)


def read_facts(exported: Path) -> GuidanceFacts:
    """What the exported guidance says about itself.

    Raises:
        GuidanceError: there is no exported graph, or it does not say.
    """
    graph = exported / graph_name("float64")
    try:
        session = onnxruntime.InferenceSession(graph, providers=["CPUExecutionProvider"])
        stored = session.get_modelmeta().custom_metadata_map[METADATA_KEY]
    except Exception as error:  # onnxruntime's exceptions share no other base
        raise GuidanceError(f"cannot load {graph}: {error}; export it again") from error
    return GuidanceFacts.from_json(stored)


def draw(facts: GuidanceFacts, guidance: Library, count: int, seed: int) -> Subjects:
    """Uniform in the box of trained states and the range of beta, less what the guard rejects.

    Args:
        facts: of the exported guidance.
        guidance: says which states are in the domain.
        count: how many, or fewer where few of many tries are in the domain.
        seed: of the draws.

    Raises:
        GuidanceError: not one state of many was in the domain.
    """
    rng = np.random.default_rng(seed)
    lowest, highest = (*facts.state_min, facts.beta_min), (*facts.state_max, facts.beta_max)
    tried = rng.uniform(lowest, highest, (TRIES, len(lowest))).astype(np.float32).astype(float)
    at = COMMAND_OUTPUTS[facts.components].index("status")
    inside: list[Array] = []
    for block in np.array_split(tried, 100):
        status = guidance.evaluate(block)[:, at]
        inside.extend(block[np.isin(status, [GuidanceStatus.OK, GuidanceStatus.ARRIVED])])
        if len(inside) >= count:
            break
    if not inside:
        raise GuidanceError(f"none of {TRIES:,} states of the trained box is in the domain: export again")
    return Subjects(np.array(inside[:count]))

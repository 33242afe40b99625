"""The merged ONNX graph in onnxruntime: the second back end, held equal to the C by test."""

from pathlib import Path

import numpy as np
import onnxruntime
from numpy.typing import ArrayLike

from sailnet.artefacts.checksums import verify_checksum
from sailnet.errors import GuidanceError
from sailnet.guidance.facts import METADATA_KEY, GuidanceFacts
from sailnet.guidance.interface import Commands, Precision, as_betas, as_states
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import Mission

_PRECISIONS: dict[str, Precision] = {"tensor(float)": "float32", "tensor(double)": "float64"}


class OnnxGuidance:
    """Flies an exported graph: ``state`` and, where the networks read it, ``beta`` to a command.

    Args:
        mission: the mission to fly.
        graph: the ONNX file, beside its list of checksums.

    Raises:
        GuidanceError: the graph is missing, damaged, of another mission or cannot be loaded.
    """

    def __init__(self, mission: Mission, graph: Path) -> None:
        verify_checksum(graph, graph.parent / "SHA256SUMS")
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        try:
            self._session = onnxruntime.InferenceSession(graph, options, providers=["CPUExecutionProvider"])
            self.precision = _PRECISIONS[self._session.get_inputs()[0].type]
            stored = self._session.get_modelmeta().custom_metadata_map[METADATA_KEY]
        except Exception as error:  # onnxruntime's exceptions share no other base
            raise GuidanceError(f"cannot load {graph}: {error}; export it again") from error
        facts = GuidanceFacts.from_json(stored)
        if facts.mission_digest != mission.digest():
            raise GuidanceError(
                f"{graph} was exported for another mission than {mission.name!r} as it is now"
                f"{mission.another_sail(facts.optics.description)}"
            )
        self.mission = mission
        self._graph = graph
        self.networks_digest = facts.networks_digest
        self._facts = facts
        self.beta_range = (facts.beta_min, facts.beta_max)
        self._reads_beta = "beta" in [entry.name for entry in self._session.get_inputs()]
        self._outputs = [entry.name for entry in self._session.get_outputs()]
        kind = np.dtype(self.precision).type
        self._state_min = np.array(facts.state_min, kind)

    def __reduce__(self) -> tuple[type["OnnxGuidance"], tuple[Mission, Path]]:
        # A worker in another process loads, and checks, the graph itself.
        return OnnxGuidance, (self.mission, self._graph)

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """Command the sails at (n, 3) states; see ``sailnet.guidance.interface.Guidance``."""
        array = as_states(states, self.precision)
        betas = as_betas(beta, len(array), self.mission.sail.beta, self.precision)
        valid = np.isfinite(array).all(axis=1)
        # A NaN never enters the graph: what its operators make of one is not defined.
        entered = np.where(valid[:, None], array, self._state_min)
        inputs = {"state": entered, "beta": betas} if self._reads_beta else {"state": entered}
        given = dict(zip(self._outputs, self._session.run(self._outputs, inputs), strict=True))
        return self._facts.commands(array, betas, **given)

    def steering(self, count: int) -> ReferenceSteering:
        """Steering by the reference rules; see ``sailnet.guidance.interface.Guidance``."""
        return ReferenceSteering(self, count)

"""The merged ONNX graph in onnxruntime: the second back end, held equal to the C by test."""

from pathlib import Path
from typing import Any

import numpy as np
import onnxruntime
from numpy.typing import ArrayLike, NDArray

from sailnet.artefacts.checksums import verify_checksum
from sailnet.errors import GuidanceError
from sailnet.guidance.facts import METADATA_KEY, GuidanceFacts
from sailnet.guidance.graph_checks import refuse_foreign
from sailnet.guidance.graph_file import DOUBLE, FLOAT, ROWS, GraphFile, Value, read_graph
from sailnet.guidance.interface import Commands, Precision, as_betas, as_states
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array

_PRECISIONS: dict[int, Precision] = {FLOAT: "float32", DOUBLE: "float64"}
_SILENT = 4
"""Of onnxruntime's levels: what is wrong is said here."""


DIRECTION = "arrival_direction"
"""The output of a graph that holds networks of a plan, beside the command."""


class OnnxGuidance:
    """Flies an exported graph: ``state`` and, where the networks read it, ``beta`` to a command.

    Args:
        mission: the mission to fly.
        graph: the ONNX file, beside its list of checksums.

    Raises:
        GuidanceError: the graph is missing, damaged, of another mission or cannot be loaded.
    """

    def __init__(self, mission: Mission, graph: Path) -> None:
        content = verify_checksum(graph, graph.parent / "SHA256SUMS")
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        options.log_severity_level = _SILENT
        try:
            self.precision, found = _checked(content, mission.components)
            self._session = onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])
        except Exception as error:  # onnxruntime's exceptions share no other base
            raise GuidanceError(f"cannot load {graph}: {error}; export it again") from error
        if METADATA_KEY not in found.metadata:
            raise GuidanceError(f"cannot load {graph}: it says nothing of its networks; export it again")
        try:
            facts = GuidanceFacts.from_json(found.metadata[METADATA_KEY])
        except GuidanceError as error:
            raise GuidanceError(f"cannot load {graph}: {error}") from error
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
        self._reads_beta = "beta" in found.inputs
        self._proposes = DIRECTION in found.outputs
        self._command = [name for name in found.outputs if name != DIRECTION]
        kind = np.dtype(self.precision).type
        self._state_min = np.array(facts.state_min, kind)

    def __reduce__(self) -> tuple[type["OnnxGuidance"], tuple[Mission, Path]]:
        # A worker in another process loads, and checks, the graph itself.
        return OnnxGuidance, (self.mission, self._graph)

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """Command the sails at (n, 3) or (n, 5) states; see ``sailnet.guidance.interface.Guidance``."""
        array = as_states(states, self.precision, self._facts.components)
        betas = as_betas(beta, len(array), self.mission.sail.beta, self.precision)
        return self._facts.commands(array, betas, **self._given(self._command, array, betas))

    def arrival_directions(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array | None:
        """See ``sailnet.guidance.interface.Guidance``; zeros where a state is not finite."""
        if not self._proposes:
            return None
        array = as_states(states, self.precision, self._facts.components)
        betas = as_betas(beta, len(array), self.mission.sail.beta, self.precision)
        directions = self._given([DIRECTION], array, betas)[DIRECTION]
        finite = np.isfinite(array).all(axis=1)
        return np.where(finite[:, None], directions, 0.0).astype(np.float64)

    @property
    def known_plans(self) -> Array:
        """See :class:`sailnet.guidance.interface.FirstPlans`."""
        return self._facts.known

    def _given(self, names: list[str], states: NDArray[Any], betas: NDArray[Any]) -> dict[str, NDArray[Any]]:
        """Some outputs of the graph, by their names."""
        valid = np.isfinite(states).all(axis=1)
        # A NaN never enters the graph: what its operators make of one is not defined.
        entered = np.where(valid[:, None], states, self._state_min)
        inputs = {"state": entered, "beta": betas} if self._reads_beta else {"state": entered}
        try:
            found = self._session.run(names, inputs)
        except Exception as error:  # as above: shapes that do not fit may show only with so many rows
            raise GuidanceError(f"cannot run {self._graph}: {str(error).strip()}; export it again") from error
        return dict(zip(names, found, strict=True))

    def steering(self, count: int) -> ReferenceSteering:
        """Steering by the reference rules; see ``sailnet.guidance.interface.Guidance``."""
        return ReferenceSteering(self, count)


def _checked(content: bytes, components: int) -> tuple[Precision, GraphFile]:
    """The precision of a graph that is as sailnet exports them for such states, and what its file holds."""
    graph = read_graph(content)
    state = graph.inputs.get("state")
    if state is None or state.kind not in _PRECISIONS:
        raise ValueError(f"its inputs are {', '.join(graph.inputs)!r:.100}, and no state in floating point")
    one = Value(state.kind, (ROWS,))
    inputs = {"state": Value(state.kind, (ROWS, components))} | (
        {"beta": one} if "beta" in graph.inputs else {}
    )
    outputs = dict.fromkeys(("cone_angle", "time_of_flight"), one)
    outputs |= {"lambda_v": one} if "lambda_v" in graph.outputs else {}
    outputs |= dict.fromkeys(("clock_angle", "lambda_w"), one) if components > 3 else {}
    directions = Value(state.kind, (ROWS, components))
    outputs |= {DIRECTION: directions} if DIRECTION in graph.outputs else {}
    refuse_foreign(graph, inputs, outputs)
    return _PRECISIONS[state.kind], graph

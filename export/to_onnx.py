"""ONNX graphs: one self-contained file a graph, physical units in and out, any number of rows."""

import logging
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import onnx
import torch
from torch import nn

from sailnet.guidance.facts import METADATA_KEY, GuidanceFacts

OPSET = 18

Inputs = Mapping[str, int | None]


@dataclass(frozen=True)
class Graph:
    """A module to export.

    Attributes:
        file: name of the file.
        module: maps its inputs to one (n,) or (n, k) tensor for each output.
        inputs: name and number of columns k of each input, (n, k), or (n,) where k is None. ``state`` is
            (r, u, v), ``state_and_tau`` (r, u, v, tau), ``approach`` ``APPROACH_INPUTS``, ``beta`` itself; in
            space (r, latitude, u, v, w), ``APPROACH_INPUTS_IN_SPACE``, and ``lateral`` ``LATERAL_INPUTS``.
        outputs: names of the outputs.
    """

    file: str
    module: nn.Module
    inputs: Inputs
    outputs: Sequence[str]


def write_onnx(graph: Graph, facts: GuidanceFacts, folder: Path) -> None:
    """Export one graph, check it and add what it is to its metadata."""
    dtype = next(graph.module.parameters()).dtype
    examples = tuple(torch.ones((2, k) if k else (2,), dtype=dtype) for k in graph.inputs.values())
    rows = {0: torch.export.Dim("n")}
    with warnings.catch_warnings(), _quiet():
        # Deprecations inside the exporter, which a caller can do nothing about.
        warnings.simplefilter("ignore")
        program = torch.onnx.export(
            graph.module.eval(),
            examples,
            dynamo=True,
            input_names=list(graph.inputs),
            output_names=list(graph.outputs),
            dynamic_shapes=(rows,) * len(examples),
            opset_version=OPSET,
            verbose=False,
        )
    assert program is not None
    model = program.model_proto
    for node in (*model.graph.node, *model.graph.initializer):
        # The exporter records where its own sources lie on this machine.
        del node.metadata_props[:]
        node.doc_string = ""
    del model.graph.metadata_props[:]
    onnx.helper.set_model_props(model, {METADATA_KEY: facts.to_json()})
    model.doc_string = f"Exported by sailnet {facts.version} for mission {facts.mission}"
    onnx.checker.check_model(model, full_check=True)
    onnx.save_model(model, folder / graph.file, save_as_external_data=False)


class _quiet:  # noqa: N801, a context manager reads as a verb
    """Keeps the exporter's informational messages out of the log."""

    def __enter__(self) -> None:
        self._loggers = [logging.getLogger(name) for name in ("torch.onnx", "onnxscript", "onnx_ir")]
        self._levels = [logger.level for logger in self._loggers]
        for logger in self._loggers:
            logger.setLevel(logging.ERROR)

    def __exit__(self, *exception: object) -> None:
        for logger, level in zip(self._loggers, self._levels, strict=True):
            logger.setLevel(level)

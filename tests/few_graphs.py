"""Exports with fewer ONNX graphs, each of which takes seconds to make."""

import pytest

from export.write import _graphs as every_graph


def only_whole_graphs(patch: pytest.MonkeyPatch) -> None:
    """Of the whole guidance, which back ends load; not those of single networks."""
    patch.setattr("export.write._graphs", lambda *given: every_graph(*given)[-2:])


def no_graphs(patch: pytest.MonkeyPatch) -> None:
    """The C alone."""
    patch.setattr("export.write._graphs", lambda *_: [])

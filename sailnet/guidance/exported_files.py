"""Names of the files of an export and of the libraries compiled from them: ``exported_files.toml``."""

import tomllib
from collections.abc import Mapping
from importlib import resources

from sailnet.guidance.interface import Layout, Precision

_NAMES = tomllib.loads((resources.files("sailnet") / "guidance" / "exported_files.toml").read_text("utf-8"))

SUFFIXES: Mapping[Precision, str] = _NAMES["suffixes"]
"""What each precision is called in names of files and at the end of every symbol of a library."""


def header_and_source(layout: Layout) -> tuple[str, str]:
    """The two files of the exported C."""
    return _NAMES["header"], _NAMES["layouts"][layout]["source"]


def library_name(precision: Precision, layout: Layout) -> str:
    """What the exported C is compiled into."""
    build = _NAMES["layouts"][layout]["build"].format(suffix=SUFFIXES[precision])
    return str(_NAMES["library"].format(build=build))


def graph_name(precision: Precision) -> str:
    """The merged ONNX graph."""
    return str(_NAMES["graph"].format(suffix=SUFFIXES[precision]))

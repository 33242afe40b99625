"""Where the stages of the pipeline are: the packages ``data``, ``training``, ``export`` and ``c_runtime``.

What ``c_runtime`` makes of an export for other simulators is found in the same way.

In a checkout they lie beside ``sailnet``. An installation must not bring packages of such general names, so
there they lie in a folder of our own, which is put on ``sys.path`` when a stage is to run; processes that
multiprocessing starts take the path over. The library imports none of them.
"""

import importlib
import sys
from argparse import ArgumentParser
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from sailnet.errors import SailnetError

INSTALLED = "sailnet_stages"
"""Folder of an installation, beside ``sailnet``."""

NEEDS = {"data": (), "training": ("torch",), "export": ("torch", "onnx", "onnxscript"), "fmi": ("fmpy",)}
"""Packages that a stage imports, of the extra ``train`` or of its own."""

EXTRAS = {"fmi": "fmi"}
"""The extra that brings a stage's packages, where it is not those of the pipeline."""

COMPILE = frozenset({"export", "fmi"})
"""Stages that call the C compiler."""


def make_importable() -> None:
    """Put the folder of the stages on ``sys.path``, first: there may be a ``data`` of someone else's."""
    beside = Path(__file__).resolve().parents[2]
    folder = str(beside / INSTALLED if (beside / INSTALLED).is_dir() else beside)
    if folder not in sys.path[:1]:
        sys.path.insert(0, folder)


def need(*stages: str) -> None:
    """Make sure, before any work, that stages can run here.

    Raises:
        SailnetError: a package, or the compiler that the export calls, is not installed.
    """
    wanted = dict.fromkeys(package for stage in stages for package in NEEDS[stage])
    if missing := [package for package in wanted if find_spec(package) is None]:
        extras = ",".join(dict.fromkeys(EXTRAS.get(stage, "train,report") for stage in stages))
        raise SailnetError(f"no {' and no '.join(missing)} here: pip install 'sailnet[{extras}]'")
    if COMPILE.intersection(stages):
        shared_library = _module("c_runtime.shared_library")
        try:
            shared_library.find_compiler()
        except shared_library.CompilerError as error:
            raise SailnetError(str(error)) from error


def run_stage(stage: str, arguments: Sequence[str]) -> int:
    """Run a stage's command in this process; returns its exit status.

    Args:
        stage: ``data``, ``training`` or ``export``.
        arguments: of its command line.

    Raises:
        SailnetError: a package that it imports is not installed.
    """
    need(stage)
    status: int = _module(f"{stage}.command").main(list(arguments))
    return status


def parser_of(stage: str) -> ArgumentParser:
    """What a stage's command understands, for those who explain or complete it."""
    made: ArgumentParser = _module(f"{stage}.command").parser()
    return made


def write_fmu(*arguments: Any) -> dict[str, object]:
    """Call :func:`c_runtime.fmi.write.write_fmu`, with its arguments.

    Raises:
        SailnetError: as that; or FMPy, or a compiler, is not installed.
    """
    need("fmi")
    written: dict[str, object] = _module("c_runtime.fmi.write").write_fmu(*arguments)
    return written


def _module(name: str) -> Any:
    make_importable()
    return importlib.import_module(name)

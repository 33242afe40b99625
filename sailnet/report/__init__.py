"""The report: Section 5 of the paper flown with what was trained, beside the paper's figures; pages."""

from importlib import import_module
from typing import Any

from sailnet.errors import SailnetError


def report(module: str) -> Any:
    """A module of :mod:`sailnet.report`, whose packages are not installed by default.

    Raises:
        SailnetError: they are not.
    """
    try:
        return import_module(f"sailnet.report.{module}")
    except ImportError as error:
        raise SailnetError(f"no pictures here ({error}): pip install 'sailnet[report]'") from error

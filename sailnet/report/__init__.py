"""Pages and pictures of results: campaigns, single flights, the paper reproduced, other papers' problems."""

from importlib import import_module
from importlib.util import find_spec
from typing import Any

from sailnet.errors import SailnetError

PACKAGES = ("jinja2", "matplotlib")
"""What the extra ``report`` installs."""


def need_pictures() -> None:
    """Make sure that pages and pictures can be made, before the work that they would show.

    Raises:
        SailnetError: a package is not installed.
    """
    if missing := [name for name in PACKAGES if find_spec(name) is None]:
        raise SailnetError(f"no pictures here without {' and '.join(missing)}: pip install 'sailnet[report]'")


def report(module: str) -> Any:
    """A module of :mod:`sailnet.report`, whose packages are not installed by default.

    Raises:
        SailnetError: they are not.
    """
    need_pictures()
    return import_module(f"sailnet.report.{module}")

"""The C templates in ``c_runtime``: include lines expanded, and values put in the places named ``@KEY@``."""

import re
from collections.abc import Mapping
from pathlib import Path

C_RUNTIME = Path(__file__).parent.parent / "c_runtime"
FOLDERS = (C_RUNTIME / "flight", C_RUNTIME / "simulation", C_RUNTIME / "simulation" / "host")
"""Where templates, and the parts they include, are looked for, in this order."""

_INCLUDE = re.compile(r'^#include "(\w+\.inc)"$', re.MULTILINE)
_PLACE = re.compile(r"@([A-Z_0-9]+)@")


def filled(template: str, values: Mapping[str, str]) -> str:
    """The text of a template, with each included part in the place of its line, and the values in theirs.

    Lines that include headers stay as they are: what is exported is C.

    Args:
        template: file name.
        values: what comes in the place of each ``@KEY@``; places in what is included count, too.

    Raises:
        KeyError: a place without a value.
    """
    text = read(template)
    while _INCLUDE.search(text):
        text = _INCLUDE.sub(lambda line: read(line[1]).rstrip("\n"), _put(text, values))
    return _put(text, values)


def read(name: str) -> str:
    """A template or a part, as it is.

    Raises:
        FileNotFoundError: there is none of this name.
    """
    for folder in FOLDERS:
        if (folder / name).is_file():
            return (folder / name).read_text(encoding="utf-8")
    raise FileNotFoundError(f"no part {name} in {', '.join(map(str, FOLDERS))}")


def _put(text: str, values: Mapping[str, str]) -> str:
    return _PLACE.sub(lambda place: values[place[1]], text)

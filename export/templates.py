"""The C templates in ``c_runtime``: include lines expanded, and values put in the places named ``@KEY@``.

Of what stands between ``#if SAILNET_IN_SPACE`` (or ``!SAILNET_IN_SPACE``), ``#else`` and ``#endif`` only what
is of the mission's dimensions is exported: a flight file holds nothing that it does not fly.
"""

import re
from collections.abc import Collection, Mapping
from pathlib import Path

C_RUNTIME = Path(__file__).parent.parent / "c_runtime"
FOLDERS = (
    C_RUNTIME / "flight",
    C_RUNTIME / "flight" / "tracker",
    C_RUNTIME / "simulation",
    C_RUNTIME / "simulation" / "host",
)
"""Where templates, and the parts they include, are looked for, in this order."""

_INCLUDE = re.compile(
    r'^#include "(\w+\.inc|sailnet_(?:extremal|plan|candidate|tracker|tracker_types)\.[ch])"$', re.MULTILINE
)
_PLACE = re.compile(r"@([A-Z_0-9]+)@")


IN_SPACE = {"#if SAILNET_IN_SPACE": True, "#if !SAILNET_IN_SPACE": False}
"""What opens lines that are of three dimensions alone, or of the plane alone, until its ``#else``."""


def filled(
    template: str, values: Mapping[str, str], *, in_space: bool = False, without: Collection[str] = ()
) -> str:
    """The text of a template, with each included part in the place of its line, and the values in theirs.

    Of the tracker, which compiles where it lies, headers and sources are parts like any other, each put in
    once. Lines that include other headers stay as they are: what is exported is C.

    Args:
        template: file name.
        values: what comes in the place of each ``@KEY@``; places in what is included count, too.
        in_space: whether it is of three dimensions.
        without: parts that the file has already, by another that it includes.

    Raises:
        KeyError: a place without a value.
    """
    text = _of_dimensions(read(template), in_space)
    expanded: set[str] = set(without)

    def part(line: re.Match[str]) -> str:
        name = line[1]
        if not name.endswith(".inc") and name in expanded:
            return ""
        expanded.add(name)
        return _of_dimensions(read(name), in_space).rstrip("\n")

    while _INCLUDE.search(text):
        text = _INCLUDE.sub(part, _put(text, values))
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


def _of_dimensions(text: str, in_space: bool) -> str:
    """Without the lines that are of other dimensions, and those that tell them apart."""
    kept: list[str] = []
    opened: list[bool | None] = []  # of each #if: whether its lines count, or None if they are not told apart
    for line in text.splitlines(keepends=True):
        if line.startswith("#if"):
            wanted = IN_SPACE.get(line.strip())
            opened.append(None if wanted is None else wanted == in_space)
            tells = wanted is not None
        elif line.startswith("#else") and (counts := opened[-1]) is not None:
            opened[-1], tells = not counts, True
        else:
            tells = line.startswith("#endif") and opened.pop() is not None
        if not tells and False not in opened:
            kept.append(line)
    return "".join(kept)

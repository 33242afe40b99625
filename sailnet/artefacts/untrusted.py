"""Files that a stranger may have made: what is read of them is bounded before it is read."""

import json
from pathlib import Path
from typing import Any

DEEPEST = 32
"""Tables within tables, or lists within lists, that anything of ours has fewer of."""


def read_bounded(path: Path, most: int) -> bytes:
    """The bytes of a file of at most so many.

    Raises:
        OSError: it cannot be read, is longer, or is no file: a pipe would be waited for.
    """
    if path.exists() and not path.is_file():
        raise OSError("it is no file")
    with path.open("rb") as file:
        content = file.read(most + 1)
    if len(content) > most:
        raise OSError(f"it is longer than {most} bytes, which none of sailnet's is")
    return content


def parsed_json(text: str | bytes) -> Any:
    """What a text of JSON holds, of finite numbers and at most ``DEEPEST`` levels.

    Raises:
        ValueError: it is not that.
    """
    try:
        content = json.loads(text, parse_constant=_refuse)
    except RecursionError:
        raise ValueError("it is nested without end") from None
    refuse_deep(content)
    return content


def refuse_deep(content: object) -> None:
    """Raise ``ValueError`` where tables and lists lie within each other more than ``DEEPEST`` times."""
    level = [content]
    for _ in range(DEEPEST):
        level = [
            part
            for whole in level
            if isinstance(whole, list | dict)
            for part in (whole.values() if isinstance(whole, dict) else whole)
        ]
        if not level:
            return
    raise ValueError(f"it is nested more than {DEEPEST} times")


def table_of(text: str | bytes) -> dict[str, Any]:
    """What a text of JSON holds, which is a table.

    Raises:
        ValueError: it is not that.
    """
    content = parsed_json(text)
    if not isinstance(content, dict):
        raise ValueError(f"it holds {content!r:.40}, not a table")
    return content


def _refuse(constant: str) -> float:
    raise ValueError(f"it holds {constant}, which is no finite number")

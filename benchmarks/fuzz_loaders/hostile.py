"""Values that no file of ours holds, and where they are put in a table of tables, lists and values."""

import json
from collections.abc import Mapping
from copy import deepcopy
from random import Random
from typing import Any

ENDLESS, LONG = "@endless@", "@long@"
"""Places of what Python does not write: lists within lists, and a number of many digits."""

VALUES: tuple[Any, ...] = (
    *(
        None,
        True,
        "",
        "x" * 300,
        "../../x",
        "\0",
        "a'\"\\ $(x); <b>",
        "é" * 2000,
        0,
        -1,
        1,
        2**70,
        10**400,
        10**12,
    ),
    *(1e308, -1e308, 5e-324, float("inf"), float("nan"), -0.0, [], {}, [[1.0, 2.0]], {"a": {"b": []}}),
    *(ENDLESS, LONG, list(range(5000)), [0.0] * 50_000),
)


def edited(tree: Any, random: Random) -> Any:
    """A copy of a table in which one to three things are others, missing or added."""
    copy = json.loads(json.dumps(tree))
    for _ in range(random.randint(1, 3)):
        places = [(copy, key) for key in copy]
        for holder, key in places:
            inner = holder[key]
            if isinstance(inner, dict):
                places += [(inner, key) for key in inner]
            elif isinstance(inner, list) and len(inner) < 100:
                places += [(inner, at) for at in range(len(inner))]
        if not places:
            return copy
        holder, key = random.choice(places)
        match random.choice(("replace", "replace", "replace", "scale", "drop", "add", "wrap", "swap")):
            case "replace":
                holder[key] = deepcopy(random.choice(VALUES))
            case "scale" if type(holder[key]) in (int, float) and abs(holder[key]) < 1e15:
                holder[key] *= random.choice((-1, 1e-300, 1e300, 0, 10**9, 0.999))
            case "drop":
                del holder[key]
            case "add" if isinstance(holder, dict):
                holder[random.choice(("", "a" * 300, "schema", "name", "sail"))] = deepcopy(
                    random.choice(VALUES)
                )
            case "wrap":
                holder[key] = [deepcopy(holder[key]) for _ in range(random.choice((1, 2, 100)))]
            case "swap":
                other, place = random.choice(places)
                holder[key] = json.loads(json.dumps(other.get(place) if isinstance(other, dict) else 1))
    return copy


def edited_text(text: str | bytes, random: Random) -> str:
    """JSON of a table, edited; of what is no table, as where it was spoilt before, another text."""
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError):
        tree = None
    if isinstance(tree, dict):
        return as_json(edited(tree, random))
    return random.choice(("", "[]", "null", "x" * 5000))


def spliced(text: str) -> str:
    """A text with what Python does not write itself."""
    endless = "[" * 50_000 + "]" * 50_000
    return text.replace(f'"{ENDLESS}"', endless).replace(f'"{LONG}"', "9" * 5000)


def as_json(tree: Any) -> str:
    """A tree as JSON, with all that is hostile in it."""
    return spliced(json.dumps(tree))


def as_toml(table: Mapping[str, Any]) -> str:
    """A table as TOML, every table in it on one line."""
    lines = [f"{json.dumps(key)} = {_value(value)}" for key, value in table.items() if value is not None]
    return spliced("\n".join(lines) + "\n")


def _value(value: Any) -> str:
    if isinstance(value, dict):
        pairs = (f"{json.dumps(key)} = {_value(part)}" for key, part in value.items() if part is not None)
        return "{ " + ", ".join(pairs) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(_value(part) for part in value if part is not None) + "]"
    if isinstance(value, float):
        return repr(value)
    return json.dumps(value)


def flipped(content: bytes, random: Random) -> bytes:
    """Bytes of which some are others, missing or said twice."""
    changed = bytearray(content)
    for _ in range(random.randint(1, 4)):
        at = random.randrange(len(changed)) if changed else 0
        match random.randint(0, 3):
            case 0:
                changed[at : at + 1] = bytes([random.randrange(256)])
            case 1:
                changed[at : at + 8] = random.choice((b"\xff" * 8, b"\0" * 8, b""))
            case 2:
                del changed[at:]
            case _:
                changed[at:at] = changed[at : at + random.randint(1, 64)]
    return bytes(changed)

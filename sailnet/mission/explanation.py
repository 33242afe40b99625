"""What is wrong with a TOML table, in the words of someone who wrote it."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, get_args

from pydantic import BaseModel, ValidationError

from sailnet.errors import did_you_mean
from sailnet.mission.sections import Section

WORDS = (
    (r"^Value error, ", ""),
    (r"^(Input|Tuple|List|String|Dictionary) should ", "must "),
    (r"^must be a valid (tuple|list).*", "must be a list"),
    (r"^must be a valid dictionary.*", "must be a table"),
    (r"^must be a valid string$", "must be text"),
    (r"^must be a valid integer.*", "must be a whole number"),
    (r"^must be a valid number.*", "must be a number"),
    (r"^must be a valid boolean$", "must be true or false"),
    (r" after validation,", ","),
    (r"^must match pattern '\^(.*)\$'$", r"must be of the form \1"),
)
"""From pydantic's words, which speak of Python, to those of the file."""

MOST_LINES = 50
LONGEST = 400
"""Characters that are shown of a value."""


@dataclass(frozen=True)
class _Problem:
    """What is wrong at one key.

    Attributes:
        key: as in the file, rows of lists by number.
        table: whose keys the last part is one of, or would be.
        choice: whether the value may be of several types, and this is what one of them finds wrong.
        inside: of such a type, wrong is something within the value, and not the value's own type.
        kind, given, message: pydantic's.
    """

    key: str
    table: type[BaseModel]
    choice: bool
    inside: bool
    kind: str
    given: object
    message: str

    @staticmethod
    def of(found: Mapping[str, Any], model: type[BaseModel]) -> "_Problem":
        path: list[str] = []
        table, within, choice, inside = model, [model], False, False
        for part in found["loc"]:
            if isinstance(part, int):
                path.append(str(part))
                inside = choice
            elif within:
                path.append(part)
                table, within = within[0], _tables_of(within[0], part)
            else:  # not a key: the type that was tried, as pydantic calls it
                choice = True
        message = str(found["msg"])
        for theirs, ours in WORDS:
            message = re.sub(theirs, ours, message)
        return _Problem(".".join(path), table, choice, inside, found["type"], found["input"], message)

    def __str__(self) -> str:
        name = self.key.rpartition(".")[2]
        instead = self.table.instead if issubclass(self.table, Section) else {}
        retired = self.table.retired if issubclass(self.table, Section) else {}
        if self.kind == "extra_forbidden" and name in retired:
            return f"{self.key} is no longer a key: {retired[name]}; delete the line"
        if self.kind == "extra_forbidden":
            known = sorted(
                [
                    *(field.alias or name for name, field in self.table.model_fields.items()),
                    *sum(instead.values(), ()),
                ]
            )
            return f"{self.key}: unknown key; allowed here are {', '.join(known)}{did_you_mean(name, known)}"
        if self.kind == "missing":
            others = f", or one of {', '.join(instead[name])}" if name in instead else ""
            return f"{self.key}: this {'number' if name.isdigit() else 'key'} is missing{others}"
        return f"{self.key} = {_shown(self.given)}: {self.message}"


def explain(error: ValidationError, model: type[BaseModel]) -> str:
    """What is wrong with a table, a line each: key, value, what is allowed."""
    problems = [_Problem.of(dict(item), model) for item in error.errors()]
    # A hostile file has tens of thousands: each is looked at once.
    paths = [problem.key.split(".") for problem in problems]
    beyond = {".".join(path[:depth]) for path in paths for depth in range(1, len(path))}
    of_one_key: dict[str, list[_Problem]] = {}
    for problem in problems:
        if problem.choice:
            of_one_key.setdefault(problem.key, []).append(problem)
    lines: dict[str, None] = {}  # a set that keeps the order
    for problem in problems:
        of_its_whole = problem.kind == "too_short" or (problem.choice and not problem.inside)
        if of_its_whole and problem.key in beyond:
            continue  # Wrong is what is within: without it a list is too short, and of no other type either.
        types = of_one_key.get(problem.key, [])
        if problem.choice and len(types) > 1:
            allowed = " or ".join(other.message.removeprefix("must be ") for other in types)
            lines[f"{problem.key} = {_shown(problem.given)}: must be {allowed}"] = None
        else:
            lines[str(problem)] = None
    if len(lines) > MOST_LINES:
        return "\n  ".join([*list(lines)[:MOST_LINES], f"and {len(lines) - MOST_LINES} more"])
    return "\n  ".join(lines)


def _shown(given: object) -> str:
    try:
        text = repr(given)
    except ValueError:  # a number of thousands of digits
        text = f"a number of {given.bit_length() if isinstance(given, int) else 'many'} bits"
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}..."


def _tables_of(table: type[BaseModel], key: str) -> list[type[BaseModel]]:
    """The table that is the value of a key, or the rows of it; empty where it holds none."""
    fields = {name: field for key_, field in table.model_fields.items() for name in (key_, field.alias)}
    return _tables_in(fields[key].annotation) if key in fields else []


def _tables_in(annotation: object) -> list[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [table for option in get_args(annotation) for table in _tables_in(option)]

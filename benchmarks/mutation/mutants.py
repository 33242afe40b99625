"""Small faults in Python and in C, and which of them are tried.

Python's come from cosmic-ray's operators, a place in the code being as likely as any other. C's are a table
of replacements below, and statements left out.
"""

import ast
import hashlib
import random
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

ARITHMETIC = (
    ("Add", "Sub"), ("Sub", "Add"), ("Mul", "Div"), ("Div", "Mul"), ("Pow", "Mul"), ("FloorDiv", "Div"),
    ("Mod", "Mul"), ("BitOr", "BitAnd"), ("BitAnd", "BitOr"),
)  # fmt: skip
COMPARISONS = (
    ("Eq", "NotEq"), ("NotEq", "Eq"), ("Lt", "LtE"), ("Lt", "GtE"), ("LtE", "Lt"), ("LtE", "Gt"),
    ("Gt", "GtE"), ("Gt", "LtE"), ("GtE", "Gt"), ("GtE", "Lt"), ("Is", "IsNot"), ("IsNot", "Is"),
)  # fmt: skip
OPERATORS = (
    *(f"ReplaceBinaryOperator_{old}_{new}" for old, new in ARITHMETIC),
    *(f"ReplaceComparisonOperator_{old}_{new}" for old, new in COMPARISONS),
    "ReplaceUnaryOperator_USub_UAdd",
    "ReplaceUnaryOperator_Delete_USub",
    "ReplaceUnaryOperator_Delete_Invert",
    "ReplaceUnaryOperator_Delete_Not",
    "AddNot",
    "ReplaceTrueWithFalse",
    "ReplaceFalseWithTrue",
    "ReplaceAndWithOr",
    "ReplaceOrWithAnd",
    "ReplaceBreakWithContinue",
    "ReplaceContinueWithBreak",
    "NumberReplacer",
    "ZeroIterationForLoop",
)
"""Of cosmic-ray's: the rest hardly compiles, or says the same again."""

C_REPLACEMENTS = (
    (" < ", " <= "), (" < ", " >= "), (" <= ", " < "), (" <= ", " > "), (" > ", " >= "), (" > ", " <= "),
    (" >= ", " > "), (" >= ", " < "), (" == ", " != "), (" != ", " == "), (" && ", " || "), (" || ", " && "),
    (" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "), (" += ", " -= "), (" -= ", " += "),
    (" *= ", " /= "), (" % ", " * "), (" ^ ", " & "), (" >> ", " << "),
    ("fmax(", "fmin("), ("fmin(", "fmax("), ("cos(", "sin("), ("sin(", "cos("), ("!(", "("),
    ("= -", "= "), ("(-", "("),
)  # fmt: skip
_C_NUMBER = re.compile(r"(?<![\w.])(?:0x[0-9A-Fa-f]+|\d+(?:\.\d+)?(?:e-?\d+)?)u?(?![\w.])")
_C_STATEMENT = re.compile(r"^ +(?:[\w\->.\[\]*]+ (?:[-+*]?=) .*|[a-z_]\w*\(.*\)|[\w\->.\[\]]+(?:\+\+|--));$")
_C_LEFT_ALONE = re.compile(r"/\*.*?\*/|\"[^\"\n]*\"|^#(?!define)[^\n]*", re.S | re.M)


@dataclass(frozen=True)
class Mutant:
    """One fault.

    Attributes:
        path: of the source, from the root of the repository.
        line: where, from 1.
        before, after: that line, or what became of it.
        source: the whole file with the fault.
    """

    path: str
    line: int
    before: str
    after: str
    source: str

    @property
    def digest(self) -> str:
        """SHA-256 of the file and what is in it."""
        return hashlib.sha256(f"{self.path}\n{self.source}".encode()).hexdigest()


@dataclass(frozen=True)
class Fault:
    """A mutant that is not made yet.

    Attributes:
        path: of the source.
        line, column: its place.
        mutated: makes the source with the fault; none if nothing can be changed after all.
    """

    path: str
    line: int
    column: int
    mutated: Callable[[], str | None]


Place = tuple[str, int, int]
"""Source, line and column."""


def places(root: Path, sources: list[str]) -> dict[Place, list[Fault]]:
    """Every fault of some sources by its place, in order."""
    found: dict[Place, list[Fault]] = {}
    for path in sources:
        text = (root / path).read_text("utf-8")
        for fault in _c(path, text) if path.endswith(".c") else _python(path, text):
            found.setdefault((path, fault.line, fault.column), []).append(fault)
    return dict(sorted(found.items()))


def sample(root: Path, found: dict[Place, list[Fault]], count: int, seed: str) -> list[Mutant]:
    """A mutant of each of ``count`` places, or of all if there are no more."""
    rng = random.Random(seed)
    made = []
    for place in rng.sample(list(found), min(count, len(found))):
        text = (root / place[0]).read_text("utf-8")
        mutated = rng.choice(found[place]).mutated()
        changed = None if mutated is None else _changed(text, mutated)
        if mutated is not None and changed is not None:
            made.append(Mutant(place[0], *changed, mutated))
    return made


def _changed(text: str, mutated: str) -> tuple[int, str, str] | None:
    """The first line that differs, and what it and its like became."""
    old, new = text.splitlines(), mutated.splitlines()
    pairs = [(i, a, b) for i, (a, b) in enumerate(zip(old, new, strict=False), 1) if a != b]
    return None if not pairs else (pairs[0][0], pairs[0][1].strip(), pairs[0][2].strip())


def _python(path: str, text: str) -> Iterator[Fault]:
    from cosmic_ray.ast import ast_nodes, get_ast
    from cosmic_ray.mutating import mutate_code
    from cosmic_ray.plugins import get_operator

    typed, nodes = list(_annotations(text)), list(ast_nodes(get_ast(text)))
    for name in OPERATORS:
        operator = get_operator(f"core/{name}")()
        starts = [start for node in nodes for start, _ in operator.mutation_positions(node)]
        for occurrence, at in enumerate(starts):
            if not any(begin <= at < end for begin, end in typed):
                yield Fault(path, at[0], at[1], partial(mutate_code, text, operator, occurrence))


def _annotations(text: str) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    """Where types are written: a fault there is found by the type checker, or by nobody's need."""
    for node in ast.walk(ast.parse(text)):
        types = [getattr(node, name, None) for name in ("annotation", "returns")]
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Subscript | ast.BinOp):
            target = node.targets[0]
            if isinstance(target, ast.Name) and target.id[0].isupper() and not target.id.isupper():
                types.append(node.value)
        for kind in types:
            if kind is not None:
                yield (kind.lineno, kind.col_offset), (kind.end_lineno, kind.end_col_offset)


def _c(path: str, text: str) -> Iterator[Fault]:
    comments = [match.span() for match in _C_LEFT_ALONE.finditer(text)]

    def at(start: int, end: int, instead: str) -> Iterator[Fault]:
        if not any(begin <= start < stop for begin, stop in comments):
            line, column = text.count("\n", 0, start) + 1, start - text.rfind("\n", 0, start) - 1
            yield Fault(path, line, column, partial("".join, (text[:start], instead, text[end:])))

    for old, new in C_REPLACEMENTS:
        for match in re.finditer(re.escape(old), text):
            yield from at(match.start(), match.end(), new)
    for match in _C_NUMBER.finditer(text):
        yield from at(match.start(), match.end(), f"({match[0]} + 1)")
    position = 0
    for line in text.splitlines(keepends=True):
        if _C_STATEMENT.match(line.rstrip()):
            start = position + len(line) - len(line.lstrip())
            yield from at(start, position + len(line.rstrip()), ";")
        position += len(line)

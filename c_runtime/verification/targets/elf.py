"""What a compiled file holds: bytes of code and constants, addresses, and the stack its functions need."""

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

HELPERS_STACK = {"memcpy": 0, "memset": 0}
"""Of functions outside the file, by name, which compilers call."""
ARITHMETIC_STACK = 24
"""Of any other: libgcc's arithmetic of doubles, of which comparisons on ARM push most."""


@dataclass(frozen=True)
class Sizes:
    """Bytes of an object file by what happens to them.

    Attributes:
        code: executed.
        constants: read.
        static: written.
        helpers: functions it calls that are elsewhere.
        functions: code of each of its own.
    """

    code: int
    constants: int
    static: int
    helpers: tuple[str, ...]
    functions: dict[str, int]


def sizes(object_file: Path) -> Sizes:
    """Sizes of all sections that are loaded, whatever their names."""
    code = constants = static = 0
    for line in _readelf("-SW", object_file).splitlines():
        #  [Nr] Name  Type  Address  Offset  Size  EntrySize  Flags ...
        columns = re.match(r"\s*\[ *\d+\] \S+ +\S+ +\w+ \w+ (\w+) \w+ +([A-Z]+) ", line)
        if columns is None or "A" not in columns[2]:
            continue
        size = int(columns[1], 16)
        if "X" in columns[2]:
            code += size
        elif "W" in columns[2]:
            static += size
        else:
            constants += size
    symbols = _symbols(object_file)
    unknown = sorted(symbol.name for symbol in symbols if symbol.section == "UND")
    functions = {symbol.name: symbol.size for symbol in symbols if symbol.kind == "FUNC"}
    return Sizes(code, constants, static, tuple(unknown), functions)


def address(program: Path, function: str) -> int:
    """Where a function begins; without the bit by which ARM marks Thumb."""
    for symbol in _symbols(program):
        if symbol.name == function and symbol.section != "UND":
            return symbol.value & ~1
    raise ValueError(f"{program} has no function {function}")


def deepest_stack(callgraph: Path, function: str) -> int:
    """Bytes of stack of a function and whatever it calls, from what ``gcc -fcallgraph-info=su`` wrote.

    Raises:
        ValueError: the function is not there, or one of unknown stack or a recursion is called.
    """
    frames, calls = _read_callgraph(callgraph, function)

    def depth(name: str, above: tuple[str, ...] = ()) -> int:
        frame = frames.get(name, HELPERS_STACK.get(name, ARITHMETIC_STACK))
        if frame is None or name in above:
            raise ValueError(f"{name} needs an amount of stack that is not fixed")
        return frame + max((depth(called, (*above, name)) for called in calls.get(name, ())), default=0)

    return depth(function)


def reached(callgraph: Path, function: str) -> set[str]:
    """A function and all of the same file that it calls, by the same account.

    Raises:
        ValueError: the function is not there.
    """
    frames, calls = _read_callgraph(callgraph, function)
    found, new = set(), {function}
    while new:
        found |= new
        new = {called for name in new for called in calls.get(name, ())} & frames.keys() - found
    return found


def _read_callgraph(callgraph: Path, function: str) -> tuple[dict[str, int | None], dict[str, set[str]]]:
    """Frames [bytes] by function, at most, None if there is no bound, and whom each calls."""
    text = callgraph.read_text(encoding="utf-8")
    frames = {
        _plain(title): int(size) if kind in ("static", "dynamic,bounded") else None
        for title, size, kind in re.findall(
            r'node: \{ title: "([^"]+)" label: "[^"]*\\n(\d+) bytes \(([^)]*)\)', text
        )
    }
    calls: dict[str, set[str]] = {}
    for source, target in re.findall(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', text):
        calls.setdefault(_plain(source), set()).add(_plain(target))
    if function not in frames:
        raise ValueError(f"{callgraph} does not know {function}")
    return frames, calls


def _plain(title: str) -> str:
    """Static functions are titled with their file."""
    return title.rsplit(":", 1)[-1]


@dataclass(frozen=True)
class _Symbol:
    name: str
    kind: str
    section: str
    value: int
    size: int


def _symbols(file: Path) -> list[_Symbol]:
    # Number: Value Size Type Bind Visibility [other] Section Name
    rows = [line.split() for line in _readelf("-sW", file).splitlines()]
    named = [row for row in rows if len(row) > 7 and row[0][:-1].isdigit()]
    return [_Symbol(row[-1], row[3], row[-2], int(row[1], 16), int(row[2], 0)) for row in named]


def _readelf(option: str, file: Path) -> str:
    return subprocess.run(["readelf", option, str(file)], capture_output=True, text=True, check=True).stdout

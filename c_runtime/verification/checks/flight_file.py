"""What a build of the flight file is, and where in it a line lies."""

import re
from pathlib import Path

_FUNCTION = re.compile(r"^\w[\w \*]*?\b(\w+)\((?!\()")
_READS_BETA = re.compile(r"^#define SAILNET_READS_BETA (\d)$", re.MULTILINE)


def tags(build: str, flight_file: Path) -> frozenset[str]:
    """Precision and layout of a build such as ``f32_compact``, and the form of the networks in the file."""
    header = flight_file.with_suffix(".h")
    found = _READS_BETA.search(header.read_text())
    if found is None:
        raise ValueError(f"{header} does not define SAILNET_READS_BETA: export it anew")
    layout = "compact" if build.endswith("_compact") else "simd"
    return frozenset((build.split("_")[0], layout, "approach" if found[1] == "1" else "paper"))


def defines(build: str) -> list[str]:
    """Options for an analyser of a build such as ``f64_compact``: the layout for hosts on single numbers."""
    compact = build.endswith("_compact")
    chosen = {
        "SAILNET_FLOAT64": build.startswith("f64"),
        "SAILNET_COMPACT": compact,
        "SAILNET_PLAIN": not compact,
    }
    return [f"-{'D' if given else 'U'}{name}" for name, given in chosen.items()]


def places(source: str) -> list[str]:
    """For each line, from the first, the function it belongs to, or ``file``."""
    found, inside, name = [], False, "file"
    for line in source.splitlines():
        if not inside and (match := _FUNCTION.match(line)) and not line.startswith("#"):
            name = match[1]
        inside = inside or (line == "{" and name != "file")
        found.append(name)
        if line == "}" or (not inside and line.endswith(";")):
            inside, name = False, "file"
    return found

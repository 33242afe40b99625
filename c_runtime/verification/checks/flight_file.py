"""What a build of the exported guidance is, by tags, and where in a C file a line lies."""

import re
from pathlib import Path

from c_runtime.builds import BUILDS, in_space, reads_beta

_FUNCTION = re.compile(r"^\w[\w \*]*?\b(\w+)\((?!\()")


def tags(build: str, exported: Path) -> frozenset[str]:
    """Precision, layout, form of the networks and dimensions of a build such as ``f32_host``."""
    chosen = BUILDS[build]
    form = "approach" if reads_beta(exported) else "paper"
    return frozenset((chosen.suffix, chosen.layout, form, "space" if in_space(exported) else "plane"))


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

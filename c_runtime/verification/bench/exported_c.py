"""The exported C in every layout, precision and set of instructions of this host."""

import platform
from collections.abc import Sequence
from pathlib import Path

from c_runtime.builds import Build, in_space
from c_runtime.verification.bench.compiled import HERE, Library, Reals, Shape, Unit
from sailnet.guidance.exported_c import COMMAND_FIELDS

NATIVE = "native"
AVX2, SSE2 = "AVX2", "SSE2"

COMMAND_OUTPUTS = {
    components: tuple("status" if name == "hold" else name for name in members)
    for components, members in COMMAND_FIELDS.items()
}
"""What ``candidate_sailnet.c`` writes, in order, by the components of a state."""

TOLD = {
    components: tuple(name for name in ("cone_angle", "time_of_flight", "clock_angle") if name in members)
    for components, members in COMMAND_FIELDS.items()
}
"""What others have to give: the attitude and the time of flight."""


def told(commands: Reals, components: int) -> Reals:
    """(n, k) ``TOLD`` of (n, m) ``COMMAND_OUTPUTS``."""
    return commands[:, [COMMAND_OUTPUTS[components].index(name) for name in TOLD[components]]]


def instruction_sets() -> dict[str, tuple[str, ...]]:
    """Flags for what this host has, by name: all of it and, on x86-64, with AVX2 or SSE2 only."""
    sets: dict[str, tuple[str, ...]] = {NATIVE: ("-march=native",)}
    if platform.machine().lower() in ("x86_64", "amd64"):
        cpuinfo = Path("/proc/cpuinfo")
        has = set(cpuinfo.read_text(encoding="utf-8").split()) if cpuinfo.exists() else {"avx2", "fma"}
        if {"avx2", "fma"} <= has:
            sets[AVX2] = ("-mavx2", "-mfma")
        sets[SSE2] = ()
    return sets


def compile_exported(
    compiler: Sequence[str],
    exported: Path,
    folder: Path,
    *,
    build: Build,
    flags: Sequence[str],
    steers: bool = False,
) -> Library:
    """The guidance law, or a step of steering, of the C in ``exported``.

    It reads a state and beta, and writes ``COMMAND_OUTPUTS``.

    Raises:
        CompilerError: the compiler refused.
    """
    defines = (*build.defines, f"-I{exported}")
    if steers:
        defines = (*defines, "-DCANDIDATE_STEERS")
    units = [
        Unit(HERE / "candidate_sailnet.c", defines),
        Unit(exported / build.source, (*defines, *build.optimisation, *flags)),
    ]
    components = 5 if in_space(exported) else 3
    outputs = COMMAND_OUTPUTS[components]
    # The status is no number that a next state could depend on.
    chained = outputs.index("status")
    return Library(compiler, units, Shape(build.precision, components + 1, len(outputs), chained), folder)

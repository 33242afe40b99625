"""Compiles the flight file with the golden vectors for a target."""

import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from c_runtime.builds import Build
from c_runtime.verification.targets.elf import Sizes, deepest_stack, reached, sizes
from c_runtime.verification.targets.golden import COMMAND_BOUNDS, STEERING_BOUNDS, Bounds, Golden
from c_runtime.verification.targets.machines import Target
from sailnet.errors import SailnetError
from sailnet.guidance.interface import Precision

HERE = Path(__file__).parent
FLIGHT = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", "-fcallgraph-info=su")
FIRMWARE = ("-std=gnu99", "-O1", "-Wall", "-Wextra", "-Werror")
# No tables for exceptions, which count as constants otherwise; memset is not made of itself.
EVERYWHERE = (
    "-fno-pie",
    "-fno-asynchronous-unwind-tables",
    "-fno-unwind-tables",
    "-fno-tree-loop-distribute-patterns",
)
# Without the second, the first turns every memcpy by which bits are read into a call.
FREESTANDING = ("-ffreestanding", "-fbuiltin")
BARE_LINKING = ("-nostdlib", "-Wl,--build-id=none", "-Wl,--no-warn-rwx-segments")


class TargetError(SailnetError):
    """A target could not be built or run; the message says why."""


@dataclass(frozen=True)
class Main:
    """A program around the flight file: its ``main``, and options of the compiler for that."""

    source: Path
    options: tuple[str, ...] = ()


def golden_main(golden: Path) -> Main:
    """Runs the golden vectors of a ``golden.h``, of the flight file's precision."""
    return Main(HERE / "firmware" / "firmware.c", (f"-I{golden.parent}",))


FLY = Main(HERE / "firmware" / "fly.c")
"""Steers a flight, told of it over the console."""


@dataclass(frozen=True)
class Program:
    """A linked program.

    Attributes:
        path: of it.
        flags: that the flight file was compiled with, beside warnings.
        sizes: of the flight file alone.
        law: bytes of code of what ``sailnet_guidance`` needs: what a linker keeps that drops the rest.
        stack: bytes that ``sailnet_guidance`` and ``sailnet_steer`` need, by the compiler's account.
    """

    path: Path
    flags: tuple[str, ...]
    sizes: Sizes
    law: int
    stack: tuple[int, int]


def write_golden(path: Path, precision: Precision, commands: Golden, steering: Golden) -> None:
    """Write golden vectors as a C header, every number by its bits."""
    bits = np.dtype(precision).itemsize * 8
    lines = [
        "#include <stdint.h>",
        '#include "sailnet_guidance.h"',
        f"typedef uint{bits}_t golden_bits;",
        "typedef struct {",
        "    golden_bits input[4], expected[4];",
        "    int32_t status, starts;",
        "} golden_row;",
        f"#define GOLDEN_COMMANDS {len(commands.status)}",
        f"#define GOLDEN_STEPS {len(steering.status)}",
        *_rows("golden_commands", commands, precision),
        *_rows("golden_steps", steering, precision),
        *_bounds("golden_command_bounds", COMMAND_BOUNDS[precision]),
        *_bounds("golden_step_bounds", STEERING_BOUNDS[precision]),
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _rows(name: str, golden: Golden, precision: Precision) -> list[str]:
    unsigned = f"u{np.dtype(precision).itemsize}"
    suffix = "u" if precision == "float32" else "ull"

    def words(values: np.ndarray[tuple[int, ...], np.dtype[np.floating]]) -> str:
        return ", ".join(
            f"{word:#x}{suffix}" for word in np.ascontiguousarray(values).view(unsigned).tolist()
        )

    expected = golden.expected.astype(precision)
    rows = [
        f"    {{{{{words(given)}}}, {{{words(wanted)}}}, {status}, {int(starts)}}},"
        for given, wanted, status, starts in zip(
            golden.inputs, expected, golden.status, golden.starts, strict=True
        )
    ]
    return [f"static const golden_row {name}[] = {{", *rows, "};"]


def _bounds(name: str, bounds: Bounds) -> list[str]:
    return [f"static const sailnet_real {name}[4] = {{{', '.join(map(repr, bounds))}}};"]


def flight_flags(target: Target, chosen: Build, contract: bool) -> tuple[str, ...]:
    """Options of the compiler that make a difference to the code."""
    contraction = f"-ffp-contract={'fast' if contract else 'off'}"
    freestanding = () if target.hosted else FREESTANDING
    return (
        *target.machine,
        *target.optimisation,
        *freestanding,
        contraction,
        *chosen.defines,
    )


def build(
    target: Target,
    exported: Path,
    chosen: Build,
    main: Main,
    flags: tuple[str, ...],
    folder: Path,
) -> Program:
    """Compile and link in ``folder``.

    Args:
        target: the processor.
        exported: folder written by ``python -m export``.
        chosen: the build of it.
        main: what calls it.
        flags: for the flight file, from ``flight_flags``.
        folder: for what is compiled; made if need be.

    Raises:
        TargetError: the compiler refused.
    """
    folder.mkdir(parents=True, exist_ok=True)
    common = [*_common(target), f"-I{exported}"]
    flight = folder / "sailnet_guidance.o"
    _run([*common, *FLIGHT, *flags, "-c", str(exported / chosen.source), "-o", str(flight)])
    defines = [flag for flag in flags if flag.startswith("-D")]
    program = folder / "program"
    link(
        target,
        [main.source, HERE / "firmware" / "console.c", flight],
        [*defines, f"-I{exported}", *main.options],
        program,
    )
    callgraph = flight.with_suffix(".ci")
    guidance, steer = (f"sailnet_{name}_{chosen.suffix}" for name in ("guidance", "steer"))
    stack = (deepest_stack(callgraph, guidance), deepest_stack(callgraph, steer))
    found = sizes(flight)
    law = sum(found.functions[name] for name in reached(callgraph, guidance))
    return Program(program, flags, found, law, stack)


def link(target: Target, sources: list[Path], options: list[str], program: Path) -> None:
    """Compile and link sources with the start-up code of the target.

    Raises:
        TargetError: the compiler refused.
    """
    own = HERE / target.folder
    files = [str(file) for file in (*sources, *sorted(own.glob("*.[cS]")))]
    linking: tuple[str, ...] = ("-static",)
    if not target.hosted:
        files += [str(HERE / "firmware" / "memory.c"), *(["-lgcc"] if target.arithmetic else [])]
        linking = ("-static", *BARE_LINKING, f"-Wl,-T,{own / 'memory.ld'}", *FREESTANDING)
    firmware = [*_common(target), *FIRMWARE, *target.machine, "-I", str(HERE / "firmware"), *options]
    _run([*firmware, *linking, *files, "-o", str(program)])


def _common(target: Target) -> list[str]:
    bare = [] if target.hosted else ["-isystem", str(HERE / "firmware" / "freestanding")]
    return [target.compiler, *EVERYWHERE, *bare]


def _run(command: list[str]) -> None:
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        raise TargetError(f"{command[0]} failed:\n{' '.join(command)}\n{run.stderr.strip()}")

"""Compile an exported guidance, the tracker and the plant into the shared libraries that simulation loads.

Standard library only: the installation of the package runs this before anything else is there.
"""

import hashlib
import os
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from c_runtime.builds import BATCH, BUILDS, Build

# Portable flags: what is installed may run on another machine than it was built on. The additions to -O3
# keep NaN and infinity as they are: gcc makes maxima of clamps, and may use FMA.
FLAGS = ("-std=c99", "-O3", "-fno-trapping-math", "-ffp-contract=fast")
SHARED = ("-fPIC", "-shared")
CHECKSUMS = "libraries.sha256"


class CompilerError(Exception):
    """There is no C compiler, or it refused; the message says what to do."""


@dataclass(frozen=True)
class Library:
    """C files that make a shared library, and options of the compiler beside the usual ones."""

    sources: Sequence[Path]
    options: tuple[str, ...] = ()


def find_compiler() -> list[str]:
    """Command of the C compiler: ``$CC``, otherwise ``cc``, ``gcc`` or ``clang``.

    Raises:
        CompilerError: there is none.
    """
    wanted = shlex.split(os.environ.get("CC", ""))
    if wanted:
        if shutil.which(wanted[0]) is None:
            raise CompilerError(f"$CC names {wanted[0]!r}, which is not a program: set CC to a C compiler")
        return wanted
    for name in ("cc", "gcc", "clang"):
        if shutil.which(name):
            return [name]
    raise CompilerError("no C compiler found: install gcc or clang (Debian: apt install gcc), or set $CC")


def compile_libraries(
    sources: Path, target: Path, builds: Iterable[Build] = tuple(BUILDS.values())
) -> list[Path]:
    """Compile the exported C in ``sources``, in every build unless some are named; returns the files written.

    Raises:
        CompilerError: there is no compiler, or it refused the source.
    """
    beside = [
        sources / BATCH,
        PLANT / "guidance" / "same_interface.c",
    ]  # refuses what the plant would misread
    libraries = {
        build.library: Library([sources / build.source, *beside], (*build.defines, *build.optimisation))
        for build in builds
    }
    return _compile(libraries, target)


PLANT = Path(__file__).parent / "simulation" / "plant"
PLANT_LIBRARY = "plant.so"


def plant_sources() -> list[Path]:
    """The C of the plant, in order."""
    return sorted(PLANT.glob("*.c"))


def plant_digest() -> str:
    """SHA-256 over the plant's C and header, which its library carries."""
    content = b"".join(file.read_bytes() for file in [*plant_sources(), *sorted(PLANT.glob("*.h"))])
    return hashlib.sha256(content).hexdigest()


def compile_plant(target: Path) -> list[Path]:
    """Compile the plant into the folder ``target``; returns the files written.

    Raises:
        CompilerError: there is no compiler, or it refused the source.
    """
    define = f'-DPLANT_SOURCES_DIGEST="{plant_digest()}"'
    return _compile({PLANT_LIBRARY: Library(plant_sources(), ("-fno-tree-vectorize", define))}, target)


TRACKER = Path(__file__).parent / "flight" / "tracker"
TRACKER_LIBRARIES = {3: "tracker_plane.so", 5: "tracker_space.so"}
"""Of the tracker, by the number of components of a state."""


def tracker_sources() -> list[Path]:
    """The C of the tracker, and of what calls it for many sails."""
    return [
        *sorted(TRACKER.glob("*.c")),
        Path(__file__).parent / "simulation" / "tracker" / "tracker_batch.c",
    ]


def compile_tracker(target: Path) -> list[Path]:
    """Compile the tracker, for the plane and for space, into ``target``; returns the files written.

    Raises:
        CompilerError: there is no compiler, or it refused the source.
    """
    libraries = {
        name: Library(tracker_sources(), (f"-DSAILNET_IN_SPACE={int(components == 5)}",))
        for components, name in TRACKER_LIBRARIES.items()
    }
    return _compile(libraries, target)


def compile_library(compiler: Sequence[str], file: Path, library: Library) -> None:
    """Compile one library into a file, with the options that all of them have.

    Raises:
        CompilerError: the compiler refused the source.
    """
    headers = [f"-I{folder}" for folder in (library.sources[0].parent, PLANT)]
    inputs = [*headers, "-o", str(file), *map(str, library.sources), "-lm"]
    command = [*compiler, *FLAGS, *SHARED, *library.options, *inputs]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        raise CompilerError(f"the C compiler failed: {shlex.join(command)}\n{run.stderr.strip()}")


def _compile(libraries: Mapping[str, Library], target: Path) -> list[Path]:
    """The libraries by their names, and the list of checksums.

    They are built beside the target and renamed into it.
    """
    compiler = find_compiler()
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target, prefix=".compile-") as name:
        beside = Path(name)
        made = [beside / library for library in libraries]
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(compile_library, [compiler] * len(made), made, libraries.values()))
        lines = [f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in made]
        (beside / CHECKSUMS).write_text("".join(lines))
        return [(beside / file).replace(target / file) for file in (*libraries, CHECKSUMS)]

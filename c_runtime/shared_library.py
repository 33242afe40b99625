"""Compile an exported guidance, and the plant, into the shared libraries that simulation loads.

Standard library only: the installation of the package runs this before anything else is there.
"""

import hashlib
import os
import shlex
import shutil
import subprocess
import tempfile
from pathlib import Path

PRECISIONS = {"f32": (), "f64": ("-DSAILNET_FLOAT64",)}
LAYOUTS = {"simd": (), "compact": ("-DSAILNET_COMPACT",)}
BUILDS = {
    f"{precision} {layout}": (*PRECISIONS[precision], *LAYOUTS[layout])
    for precision in PRECISIONS
    for layout in LAYOUTS
}
"""Every build of the flight file: what is tested is each of them."""

PROVED_BUILDS = {
    build: (*defines, *(("-DSAILNET_PLAIN",) if "simd" in build else ())) for build, defines in BUILDS.items()
}
"""The same, of single numbers where analysers cannot read vectors."""

# Portable flags: what is installed may run on another machine than it was built on. The additions to -O3
# keep NaN and infinity as they are: gcc makes maxima of clamps, makes no vectors but those that are written,
# and may use FMA.
FLAGS = ("-std=c99", "-O3", "-fno-trapping-math", "-fno-tree-vectorize", "-ffp-contract=fast")
SHARED = ("-fPIC", "-shared")
CHECKSUMS = "libraries.sha256"


class CompilerError(Exception):
    """There is no C compiler, or it refused; the message says what to do."""


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


def library_name(precision: str) -> str:
    """File name of the library of one precision, ``f32`` or ``f64``."""
    return f"guidance_{precision}.so"


def compile_libraries(sources: Path, target: Path) -> list[Path]:
    """Compile the exported C in ``sources`` in both precisions; returns the files written.

    Raises:
        CompilerError: there is no compiler, or it refused the source.
    """
    files = [sources / file for file in ("sailnet_guidance.c", "sailnet_batch.c")]
    options = {library_name(precision): defines for precision, defines in PRECISIONS.items()}
    return _compile(files, options, target)


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
    return _compile(plant_sources(), {PLANT_LIBRARY: (f'-DPLANT_SOURCES_DIGEST="{plant_digest()}"',)}, target)


def _compile(files: list[Path], options: dict[str, tuple[str, ...]], target: Path) -> list[Path]:
    """One library for each name with its own options, and the list of checksums.

    They are built beside the target and renamed into it.
    """
    compiler = find_compiler()
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target, prefix=".compile-") as name:
        beside = Path(name)
        lines = []
        for made, own in options.items():
            library = beside / made
            inputs = ["-I", str(files[0].parent), "-o", str(library), *map(str, files), "-lm"]
            command = [*compiler, *FLAGS, *SHARED, *own, *inputs]
            run = subprocess.run(command, capture_output=True, text=True, check=False)
            if run.returncode:
                raise CompilerError(f"the C compiler failed: {shlex.join(command)}\n{run.stderr.strip()}")
            lines.append(f"{hashlib.sha256(library.read_bytes()).hexdigest()}  {library.name}\n")
        (beside / CHECKSUMS).write_text("".join(lines))
        return [(beside / file).replace(target / file) for file in (*options, CHECKSUMS)]

"""Compile an exported guidance into the shared libraries that simulation loads.

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

# Portable flags: what is installed may run on another machine than it was built on. Both additions to
# -O3 keep NaN and infinity as they are; the first lets gcc vectorise clamps, the second allows FMA.
FLAGS = ("-std=c99", "-O3", "-fno-trapping-math", "-ffp-contract=fast")
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

    The libraries and their checksums are built beside the target and renamed into it.

    Raises:
        CompilerError: there is no compiler, or it refused the source.
    """
    compiler = find_compiler()
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target, prefix=".compile-") as name:
        beside = Path(name)
        lines = []
        for precision, defines in PRECISIONS.items():
            library = beside / library_name(precision)
            files = [str(sources / file) for file in ("sailnet_guidance.c", "sailnet_batch.c")]
            command = [*compiler, *FLAGS, *SHARED, *defines, "-I", str(sources), "-o", str(library), *files]
            run = subprocess.run(command, capture_output=True, text=True, check=False)
            if run.returncode:
                raise CompilerError(f"the C compiler failed: {shlex.join(command)}\n{run.stderr.strip()}")
            lines.append(f"{hashlib.sha256(library.read_bytes()).hexdigest()}  {library.name}\n")
        (beside / CHECKSUMS).write_text("".join(lines))
        written = [*(library_name(precision) for precision in PRECISIONS), CHECKSUMS]
        return [(beside / file).replace(target / file) for file in written]

"""Compile an exported flight file and the plant to WebAssembly, for a page in a browser.

``python -m c_runtime.web_assembly`` writes the module that ships with the pages, beside its checksum. The
compiler is zig's clang, which comes from the package index as ``ziglang``; the same version of it writes the
same bytes. The sources are those that are compiled for flights here: what differs is that nothing is
contracted to fused multiply-adds, which WebAssembly does not have, and that the plant's elementary functions
are musl's.
"""

import argparse
import hashlib
import shlex
import subprocess
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path

from c_runtime.builds import BATCH, BUILDS
from c_runtime.shared_library import PLANT, CompilerError, plant_sources

BROWSER = PLANT.parent / "browser" / "sailnet_browser.c"

BUILD = BUILDS["f64"]
"""What flies in a page: the file that goes on board, in double precision."""

FLAGS = ("-std=c99", "-O3", "-fno-trapping-math", "-ffp-contract=off")
"""As for the shared libraries, but for contraction."""

TARGET = ("-target", "wasm32-wasi", "-mexec-model=reactor", "-s")
"""Nothing of WASI is called: a module that would import something is refused."""

CHECKSUMS = "SHA256SUMS"


def sources_of(exported: Path) -> list[Path]:
    """The C of the module, in order.

    Args:
        exported: folder of an exported guidance.
    """
    return [BROWSER, *plant_sources(), exported / BUILD.source, exported / BATCH]


def sources_digest(exported: Path) -> str:
    """SHA-256 over all that the module is compiled from, headers and options too; the module carries it."""
    headers = [*sorted(PLANT.glob("*.h")), *sorted(exported.glob("*.h"))]
    content = b"".join(file.read_bytes() for file in [*sources_of(exported), *headers])
    options = " ".join((*FLAGS, *TARGET, *BUILD.defines))
    return hashlib.sha256(content + options.encode()).hexdigest()


def compile_module(exported: Path) -> bytes:
    """The module.

    Args:
        exported: folder of an exported guidance.

    Raises:
        CompilerError: there is no ziglang here, or it refused the source.
    """
    if find_spec("ziglang") is None:
        raise CompilerError(
            "no ziglang here, which compiles to WebAssembly: pip install 'sailnet[playground]'"
        )
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "sailnet.wasm"
        define = f'-DBROWSER_SOURCES_DIGEST="{sources_digest(exported)}"'
        headers = [f"-I{exported}", f"-I{PLANT}"]
        inputs = [*map(str, sources_of(exported)), "-o", str(made)]
        command = [sys.executable, "-m", "ziglang", "cc"]
        command += [*TARGET, *FLAGS, *BUILD.defines, define, *headers, *inputs]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        if run.returncode:
            raise CompilerError(f"ziglang failed: {shlex.join(command)}\n{run.stderr.strip()}")
        return made.read_bytes()


def main() -> int:
    """Compile, and write the module and its checksum."""
    root = Path(__file__).resolve().parents[1]
    parser = argparse.ArgumentParser(prog="python -m c_runtime.web_assembly", description=__doc__)
    parser.add_argument(
        "exported", type=Path, nargs="?", default=root / "sailnet/shipped/earth_mars", help="(%(default)s)"
    )
    parser.add_argument(
        "--output",
        type=Path,
        default=root / "sailnet/report/playground/earth_mars.wasm",
        metavar="FILE",
        help="(%(default)s)",
    )
    options = parser.parse_args()
    try:
        module = compile_module(options.exported)
    except (CompilerError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_bytes(module)
    digest = hashlib.sha256(module).hexdigest()
    (options.output.parent / CHECKSUMS).write_text(f"{digest}  {options.output.name}\n")
    print(f"{options.output}: {len(module)} bytes, sha256 {digest}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

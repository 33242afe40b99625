"""An exported guidance into one FMU: description, sources, and a library for this machine."""

import tempfile
import uuid
import zipfile
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path

import fmpy
from fmpy.validation import validate_fmu

from c_runtime.builds import HEADER, Build
from c_runtime.fmi.description import build_description, model_description
from c_runtime.fmi.variables import header, variables
from c_runtime.shared_library import CompilerError, Library, compile_library, find_compiler
from sailnet.artefacts.checksums import verify_checksum
from sailnet.artefacts.files import write_whole, writing
from sailnet.errors import SailnetError
from sailnet.guidance.interface import Precision
from sailnet.mission.mission import Mission

HERE = Path(__file__).parent
CHECKSUMS = "SHA256SUMS"
"""Of the exported files, beside them."""

DATE = (1980, 1, 1, 0, 0, 0)
"""Of everything in the archive: equal sources make equal files."""

BOUND = ("-Wl,-Bsymbolic",) if fmpy.system == "linux" else ()
"""Two FMUs in one process have functions of the same names: each calls its own."""


def write_fmu(mission: Mission, exported: Path, precision: Precision, target: Path) -> dict[str, object]:
    """Write the FMU of an exported guidance; returns what it holds, by name.

    Args:
        mission: that it was exported for.
        exported: folder written by ``python -m export``, or shipped.
        precision: of the arithmetic.
        target: the file, which appears whole or not at all.

    Raises:
        SailnetError: an exported file is missing or damaged; no compiler; FMPy finds fault with the FMU.
    """
    build = Build(precision, "flight")
    identifier = f"sailnet_{mission.name}"
    sources = {
        name: verify_checksum(exported / name, exported / CHECKSUMS) for name in (build.source, HEADER)
    }
    sources |= {file.name: file.read_bytes() for file in sorted(HERE.glob("*.[ch]"))}
    listed = variables(mission)
    model = header(listed, "").encode()
    named = b"\0".join([*(sources[name] for name in sorted(sources)), model, precision.encode()])
    token = f"{{{uuid.uuid5(uuid.NAMESPACE_OID, named.hex())}}}"
    sources["model.h"] = header(listed, token).encode()
    compiled = sorted(name for name in sources if name.endswith(".c"))
    sources["buildDescription.xml"] = build_description(identifier, compiled, build.defines)
    content = {"modelDescription.xml": model_description(mission, precision, listed, token, identifier)}
    content |= {f"sources/{name}": text for name, text in sources.items()}
    library = f"binaries/{fmpy.platform_tuple}/{identifier}{fmpy.sharedLibraryExtension}"
    with tempfile.TemporaryDirectory(prefix="sailnet-fmu-") as folder:
        made = Path(folder)
        _unpack(content, made)
        try:
            inputs = [made / "sources" / name for name in compiled]
            include = (f"-I{headers()}",)
            compile_library(
                find_compiler(),
                made / "library",
                Library(inputs, (*build.defines, *include, *BOUND)),
            )
        except CompilerError as error:
            raise SailnetError(str(error)) from error
        content[library] = (made / "library").read_bytes()
        whole = made / target.name
        _pack(content, whole)
        if problems := validate_fmu(str(whole)):
            raise SailnetError(f"FMPy finds fault with the FMU: {'; '.join(problems)}")
        with writing(target):
            write_whole(target, lambda beside: beside.write_bytes(whole.read_bytes()))
    return {
        "file": str(target),
        "mission": mission.name,
        "precision": precision,
        "fmi": "3.0, co-simulation",
        "binary": library,
        "sources": compiled,
        "token": token,
        "inputs": [variable.name for variable in listed if variable.causality == "input"],
        "parameters": [variable.name for variable in listed if variable.causality == "parameter"],
        "outputs": [variable.name for variable in listed if variable.causality == "output"],
    }


def headers() -> Path:
    """Folder of the standard's headers, as FMPy brings them."""
    return Path(str(files(fmpy))) / "c-code"


def _unpack(content: Mapping[str, bytes], folder: Path) -> None:
    for name, data in content.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)


def _pack(content: Mapping[str, bytes], file: Path) -> None:
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in content.items():
            entry = zipfile.ZipInfo(name, DATE)
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            archive.writestr(entry, data)

"""The shipped flight file and the plant, compiled to WebAssembly by ``python -m c_runtime.web_assembly``."""

from pathlib import Path

from sailnet.artefacts.checksums import verify_checksum

FOLDER = Path(__file__).parent
"""Where the page's parts are."""

MODULE = FOLDER / "earth_mars.wasm"
"""Of the shipped networks of ``earth_mars``, in double precision."""


def module() -> bytes:
    """The module.

    Raises:
        GuidanceError: it is missing or damaged.
    """
    return verify_checksum(MODULE, FOLDER / "SHA256SUMS")

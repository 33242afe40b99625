"""``export``: trained weights into C and ONNX, where the checkout and its extra are installed."""

from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.cli.api.missions import AnyMission, mission_of
from sailnet.errors import SailnetError

NEEDED = ("torch", "onnx", "onnxscript", "export", "c_runtime")
"""What the extra ``train`` installs, and the folders of the checkout."""


def export(
    networks: str | Path, target: str | Path, mission: AnyMission = "earth_mars", *, overwrite: bool = False
) -> list[Path]:
    """Trained weights into ONNX graphs, the C file with its header, and libraries compiled from it.

    Args:
        networks: folder of ``tau``, ``alpha_pre`` and ``lambda_v`` (``.safetensors``).
        target: folder to write to; it changes only if all succeeds.
        mission: a :class:`Mission`, its name or a TOML file; networks of another one are refused.
        overwrite: replace an export that is there.

    Returns:
        What was written.

    Raises:
        SailnetError: torch or the checkout is missing; networks that are missing, damaged or of another
            mission; an export that is there already.

    >>> import sailnet
    >>> files = sailnet.export("build/earth_mars/wide/networks", "build/mine")  # doctest: +SKIP
    """
    chosen = mission_of(mission)
    if missing := [name for name in NEEDED if find_spec(name) is None]:
        raise SailnetError(
            f"no export without {', '.join(missing)}: in a checkout of sailnet, "
            "pip install -c constraints.txt -e '.[train]', and run there"
        )
    write = import_module("export.write")
    folder = Path(target)
    with sole_owner(folder / LOCK, f"an export in {folder}", SailnetError):
        if not overwrite and (folder / write.CHECKSUMS).exists():
            raise SailnetError(f"{folder} holds an export: name another folder, or overwrite=True")
        written: list[Path] = write.export(Path(networks), folder, chosen)
    return written

"""What ``python -m export`` does: from trained weights to what flies."""

import argparse
import shutil
import sys
from pathlib import Path

from export.errors import ExportError
from sailnet.artefacts.files import write_text, writing
from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.cli.spelling import HelpfulParser
from sailnet.errors import SailnetError


def parser() -> argparse.ArgumentParser:
    """What the command understands."""
    made = HelpfulParser(
        prog="sailnet export",
        description="Export the guidance networks as ONNX graphs, as one C99 file with its header, "
        "and as the shared libraries compiled from it. The target folder changes only if all succeeds.",
        epilog="example: sailnet export build/earth_mars/wide/networks build/export --mission earth_mars",
    )
    made.add_argument(
        "networks",
        type=Path,
        metavar="NETWORKS_DIR",
        help="folder of tau, alpha_pre and lambda_v (.safetensors), in space also of lambda_w",
    )
    made.add_argument("target", type=Path, metavar="OUT_DIR", help="folder to write to")
    made.add_argument(
        "--mission",
        default="earth_mars",
        help="name of a shipped mission or a .toml file (default: %(default)s)",
    )
    made.add_argument(
        "--baseline",
        type=Path,
        metavar="FILE",
        help="alpha.safetensors: a network that gives the signed cone angle itself; adds baseline_f64.onnx",
    )
    made.add_argument(
        "--plain-law",
        action="store_true",
        help="for comparison: C without plan, thrust margin, tangential force and dead reckoning; "
        "sailnet evaluate --campaign law --networks OUT_DIR flies it",
    )
    made.add_argument(
        "--flight-only",
        action="store_true",
        help="the C and its library in double precision, no ONNX: for flights by which networks are chosen",
    )
    made.add_argument(
        "--degradation",
        type=float,
        metavar="LOSS",
        help="the sail is known to age: sunlight takes this share of beta in the end, half of it by each "
        "dose of 2 pi TU/AU^2; instead of the mission's [degradation]",
    )
    made.add_argument(
        "--resume", action="store_true", help="keep an export of the same networks by the same software"
    )
    made.add_argument("--overwrite", action="store_true", help="replace any other that is there")
    return made


def main(arguments: list[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    options = parser().parse_args(arguments)
    try:
        with sole_owner(options.target / LOCK, f"an export in {options.target}", ExportError):
            written = _export(options)
    except SailnetError as error:
        print(f"export: {error}", file=sys.stderr)
        return 1
    print("\n".join(str(path) for path in written))
    return 0


def _export(options: argparse.Namespace) -> list[Path]:
    # Torch takes seconds to load: whoever comes second into a folder has been sent away by now.
    from export.made_of import MADE_OF, made_of, same
    from export.write import CHECKSUMS, UNFINISHED, export
    from sailnet.guidance.rules import PLAIN, RULES
    from sailnet.mission.mission import load_mission

    mission = load_mission(options.mission)
    if options.degradation is not None:
        mission = mission.with_degradation(options.degradation)
    rules = PLAIN if options.plain_law else RULES
    origin = made_of(options.networks, mission, options.baseline, options.plain_law, options.flight_only)
    if options.resume and same(options.target, origin):
        print(f"{options.target} is there already, made by the same run", file=sys.stderr)
        return []
    if not options.overwrite and (options.target / CHECKSUMS).exists():
        raise ExportError(
            f"{options.target} holds an export: name another folder, or say --overwrite to replace it"
        )
    for leftover in options.target.glob(f"{UNFINISHED}*"):  # of a run that was killed
        shutil.rmtree(leftover)
    (options.target / MADE_OF).unlink(missing_ok=True)
    written = export(
        options.networks,
        options.target,
        mission,
        options.baseline,
        rules=rules,
        flight_only=options.flight_only,
        plans=not options.plain_law,
    )
    with writing(options.target / MADE_OF, ExportError):
        write_text(options.target / MADE_OF, origin)
    return written

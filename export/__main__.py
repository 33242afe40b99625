"""``python -m export``: from trained weights to what flies."""

import argparse
import sys
from pathlib import Path

from export.write import export
from sailnet import SailnetError, load_mission
from sailnet.guidance.rules import PLAIN, RULES


def main(arguments: list[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m export",
        description="Export the three guidance networks as ONNX graphs, as one C99 file with its header, "
        "and as the shared libraries compiled from it. The target folder changes only if all succeeds.",
        epilog="example: python -m export build/networks build/export --mission earth_mars",
    )
    parser.add_argument(
        "networks",
        type=Path,
        metavar="NETWORKS_DIR",
        help="folder of tau, alpha_pre and lambda_v (.safetensors)",
    )
    parser.add_argument("target", type=Path, metavar="OUT_DIR", help="folder to write to")
    parser.add_argument(
        "--mission",
        default="earth_mars",
        help="name of a shipped mission or a .toml file (default: %(default)s)",
    )
    parser.add_argument(
        "--baseline",
        type=Path,
        metavar="FILE",
        help="alpha.safetensors: a network that gives the signed cone angle itself; adds baseline_f64.onnx",
    )
    parser.add_argument(
        "--plain-law",
        action="store_true",
        help="for comparison: C without memory of side, reserve, tangential force and reckoning; "
        "sailnet evaluate --campaign law --networks OUT_DIR flies it",
    )
    options = parser.parse_args(arguments)
    rules = PLAIN if options.plain_law else RULES
    try:
        mission = load_mission(options.mission)
        written = export(options.networks, options.target, mission, options.baseline, rules=rules)
    except SailnetError as error:
        print(f"export: {error}", file=sys.stderr)
        return 1
    print("\n".join(str(path) for path in written))
    return 0


if __name__ == "__main__":
    sys.exit(main())

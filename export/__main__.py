"""``python -m export``: from trained weights to what flies."""

import argparse
import sys
from pathlib import Path

from export.write import export
from sailnet import SailnetError, load_mission


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
    options = parser.parse_args(arguments)
    try:
        written = export(options.networks, options.target, load_mission(options.mission), options.baseline)
    except SailnetError as error:
        print(f"export: {error}", file=sys.stderr)
        return 1
    print("\n".join(str(path) for path in written))
    return 0


if __name__ == "__main__":
    sys.exit(main())

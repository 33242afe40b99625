"""``python -m training``: train a mission's networks."""

import argparse
import os
import sys
import time
from pathlib import Path

from sailnet.dataset import open_dataset
from sailnet.errors import NetworkError, SailnetError
from sailnet.mission.mission import Mission, load_mission
from training.fit_domain import ensure_domain
from training.parallel import train_networks
from training.targets import TARGETS


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m training",
        description="Train guidance networks on a data set, by Levenberg-Marquardt.",
        epilog="examples: python -m training build/earth_mars/box.h5 build/earth_mars/networks\n"
        "          python -m training dataset.h5 out --network tau --network lambda_v --epochs 100\n"
        "          python -m training dataset.h5 out --resume",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("dataset", type=Path, help="the HDF5 file")
    parser.add_argument("output", type=Path, help="folder for NAME.safetensors and NAME.history.json")
    parser.add_argument(
        "--mission", help="mission whose training recipe to use (default: the data set's own)"
    )
    parser.add_argument(
        "--network",
        action="append",
        metavar="NAME",
        help="train this one; repeatable (default: all of the data set's kind)",
    )
    parser.add_argument("--epochs", type=int, help="instead of the mission's number")
    parser.add_argument("--seed", type=int, help="instead of the mission's seed")
    parser.add_argument("--device", default="cpu", help="torch device: cpu (default) or cuda")
    parser.add_argument("--resume", action="store_true", help="go on from checkpoints in the output folder")
    parser.add_argument(
        "--workers",
        type=int,
        default=os.cpu_count() or 1,
        help="networks trained at once (default: all cores)",
    )
    parser.add_argument("--quiet", action="store_true", help="no progress bars")
    return parser


def _recipe(options: argparse.Namespace) -> tuple[Mission, str]:
    """The mission with the options' changes to its recipes, and the kind of the data set."""
    with open_dataset(options.dataset) as data:
        mission = load_mission(options.mission) if options.mission else data.mission
        kind = data.kind
    changes = {
        name: getattr(options, name) for name in ("epochs", "seed") if getattr(options, name) is not None
    }
    return mission.with_training(**changes), kind


def _names(chosen: list[str] | None, kind: str) -> list[str]:
    names = list(dict.fromkeys(chosen or TARGETS[kind]))
    for name in names:
        if name not in TARGETS[kind]:
            known = ", ".join(TARGETS[kind])
            raise NetworkError(f"no network {name!r} learns from {kind} data: choose from {known}")
    return names


def main() -> int:
    """Run the command; returns the exit status."""
    parser = _parser()
    options = parser.parse_args()
    for name in ("epochs", "workers"):
        if getattr(options, name) is not None and getattr(options, name) < 1:
            parser.error(f"--{name} must be at least 1")
    if options.seed is not None and options.seed < 0:
        parser.error("--seed must not be negative")
    started = time.perf_counter()
    try:
        mission, kind = _recipe(options)
        networks = train_networks(
            options.dataset,
            mission,
            kind,
            _names(options.network, kind),
            options.output,
            workers=options.workers,
            device=options.device,
            resume=options.resume,
            quiet=options.quiet,
        )
        ensure_domain(networks, options.dataset, options.output, quiet=options.quiet)
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    for network in networks:
        record = network.provenance
        line = (
            f"{options.output / network.name}.safetensors: {record['epochs']} epochs "
            f"({record['stopped_by']}), {record['seconds']:.0f} s, MSE train {record['train_mse']:.2e}, "
            f"validation {record['validation_mse']:.2e}, test {record['test_mse']:.2e}"
        )
        if "command_mse" in record:
            line += f"; |alpha| against 2 phi_max {record['command_mse']:.2e}"
        print(line)
    print(f"{len(networks)} networks in {time.perf_counter() - started:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())

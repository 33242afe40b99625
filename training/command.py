"""What ``python -m training`` does: train a mission's networks."""

import argparse
import sys
import time
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.cli.spelling import HelpfulParser
from sailnet.errors import NetworkError, SailnetError
from sailnet.workers.interruption import going_on

if TYPE_CHECKING:
    from sailnet.mission.mission import Mission
    from sailnet.networks.network import Network


def parser() -> argparse.ArgumentParser:
    """What the command understands."""
    made = HelpfulParser(
        prog="sailnet train",
        description="Train guidance networks on a data set, by Levenberg-Marquardt.",
        epilog="examples: sailnet train build/earth_mars/box.h5 build/earth_mars/networks\n"
        "          sailnet train dataset.h5 out --network tau --network lambda_v --epochs 100\n"
        "          sailnet train dataset.h5 out --resume",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    made.add_argument("dataset", type=Path, help="the HDF5 file")
    made.add_argument("output", type=Path, help="folder for NAME.safetensors and NAME.history.json")
    made.add_argument("--mission", help="mission whose training recipe to use (default: the data set's own)")
    made.add_argument(
        "--network",
        action="append",
        metavar="NAME",
        help="train this one; repeatable (default: all of the data set's kind)",
    )
    made.add_argument("--epochs", type=int, help="instead of the mission's number")
    made.add_argument("--seed", type=int, help="instead of the mission's seed")
    made.add_argument("--device", default="cpu", help="torch device: cpu (default) or cuda")
    made.add_argument(
        "--resume",
        action="store_true",
        help="go on with what the same command left, and keep what it finished",
    )
    made.add_argument(
        "--overwrite",
        action="store_true",
        help="replace networks and checkpoints of other runs, or begin anew",
    )
    made.add_argument(
        "--workers",
        type=int,
        help="networks trained at once (all: on fewer cores they take turns, and none is left to the end)",
    )
    made.add_argument("--quiet", action="store_true", help="no progress bars")
    return made


def _recipe(options: argparse.Namespace) -> "tuple[Mission, str]":
    """The mission with the options' changes to its recipes, and the kind of the data set."""
    from sailnet.dataset import open_dataset
    from sailnet.mission.mission import load_mission

    given = load_mission(options.mission) if options.mission else None
    with open_dataset(options.dataset) as data:
        mission = given or data.mission
        kind = data.kind
    changes = {
        name: getattr(options, name) for name in ("epochs", "seed") if getattr(options, name) is not None
    }
    return mission.with_training(**changes), kind


def _names(chosen: list[str] | None, known: Collection[str], kind: str) -> list[str]:
    names = list(dict.fromkeys(chosen or known))
    for name in names:
        if name not in known:
            raise NetworkError(f"no network {name!r} learns from {kind} data: choose from {', '.join(known)}")
    return names


def _train(options: argparse.Namespace) -> "list[Network]":
    # Torch takes seconds to load: whoever comes second into a folder has been sent away by now.
    from training.fit_domain import ensure_domain
    from training.known_plans import ensure_known_plans
    from training.parallel import train_networks
    from training.targets import TARGETS

    mission, kind = _recipe(options)
    networks = train_networks(
        options.dataset,
        mission,
        kind,
        _names(options.network, TARGETS[kind], kind),
        options.output,
        workers=options.workers,
        device=options.device,
        resume=options.resume,
        overwrite=options.overwrite,
        quiet=options.quiet,
    )
    ensure_domain(networks, options.dataset, options.output, quiet=options.quiet)
    if (options.output / "tau.safetensors").exists():
        ensure_known_plans(options.dataset, options.output, quiet=options.quiet)
    return networks


def _way_on(options: argparse.Namespace) -> str:
    left = [*options.output.glob("*.checkpoint.npz"), *options.output.glob("*.safetensors")]
    flag = "" if options.resume else " with --resume"
    return f"the same command{flag} goes on with what is in {options.output}" if left else ""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    understood = parser()
    options = understood.parse_args(arguments)
    for name in ("epochs", "workers"):
        if getattr(options, name) is not None and getattr(options, name) < 1:
            understood.error(f"--{name} must be at least 1")
    if options.seed is not None and options.seed < 0:
        understood.error("--seed must not be negative")
    started = time.perf_counter()
    try:
        place = f"networks in {options.output}"
        with (
            going_on(lambda: _way_on(options)),
            sole_owner(options.output / LOCK, place, NetworkError),
        ):
            networks = _train(options)
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
    print(f"{len(networks)} network{'s'[: len(networks) != 1]} in {time.perf_counter() - started:.0f} s")
    return 0

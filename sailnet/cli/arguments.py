"""Options and arguments that several sub-commands share, and what they mean.

This module imports nothing that takes long: ``data`` reads its arguments with it before it loads the expert.
"""

import argparse
import math
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from sailnet.errors import SailnetError
from sailnet.guidance.rules import EXPERT_RULES
from sailnet.mission.disturbances import Disturbance, catalogue, disturbance_from
from sailnet.physics.optics import OPTICS
from sailnet.workers.executors import WAIT

if TYPE_CHECKING:
    from sailnet.guidance.interface import Guidance
    from sailnet.mission.mission import Mission
    from sailnet.workers.executors import Workers

Commands = Any
"""What ``add_subparsers`` gives; argparse does not name its type."""


def add_command(
    commands: Commands, name: str, run: Any, about: str, *parents: argparse.ArgumentParser, example: str
) -> argparse.ArgumentParser:
    """A sub-command with a mission, the options of ``parents`` and an example in its help."""
    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("--mission", default="earth_mars", help="mission name or TOML file (%(default)s)")
    common.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    made: argparse.ArgumentParser = commands.add_parser(
        name, parents=[*parents, common], help=about, description=about, epilog=f"example: {example}"
    )
    made.set_defaults(run=run)
    return made


def state_parser(nargs: Literal["?"] | None = None) -> argparse.ArgumentParser:
    """R U V, and what is off the plane; with ``nargs`` "?" R U V may be left out."""
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("r", metavar="R", type=float, nargs=nargs, help="distance from the Sun [AU]")
    parser.add_argument("u", metavar="U", type=float, nargs=nargs, help="radial speed [AU/TU]")
    parser.add_argument("v", metavar="V", type=float, nargs=nargs, help="transverse speed [AU/TU]")
    space = parser.add_argument_group("three dimensions")
    space.add_argument("--latitude", type=float, metavar="DEG", help="above the target's plane (0)")
    space.add_argument("--northward", type=float, metavar="W", help="northward speed [AU/TU] (0)")
    return parser


def count(text: str) -> int:
    """The value of an option that says how many: at least 1."""
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{number} is not a positive number")
    return number


def distribution(
    parser: argparse.ArgumentParser,
    workers: int = os.cpu_count() or 1,
    of_workers: str = "processes (all cores)",
) -> None:
    """Add options that say who does the work.

    Args:
        parser: of the command.
        workers: how many processes unless told.
        of_workers: what the help says of them.
    """
    parser.add_argument("--workers", type=count, default=workers, metavar="N", help=of_workers)
    parser.add_argument(
        "--scheduler", metavar="ADDRESS", help="of Dask, e.g. tcp://host:8786, whose workers work"
    )
    parser.add_argument(
        "--wait",
        type=float,
        default=WAIT,
        metavar="S",
        help="seconds that Dask may have no workers (%(default)g)",
    )


def existing_folder(option: str, file: Path) -> None:
    """Make sure, before any work, that the folder is there which an option's file is to be written to.

    Raises:
        SailnetError: it is not.
    """
    if not file.parent.is_dir():
        raise SailnetError(f"{option} writes into a folder that is there, and {file.parent} is not")


@contextmanager
def workers_of(options: argparse.Namespace, pieces: int) -> "Iterator[Workers | None]":
    """Who works on this many pieces; None where this process does alone.

    No more processes are started than have something to do: than there are pieces, or processor cores.

    Args:
        options: ``workers``, ``scheduler`` and ``wait``.
        pieces: that can be worked on side by side.

    Raises:
        SailnetError: as :func:`sailnet.workers.executors.workers`.
    """
    useful = max(1, min(options.workers, pieces, os.cpu_count() or 1))
    if useful == 1 and options.scheduler is None:
        yield None
        return
    from sailnet.workers.executors import workers

    with workers(useful, options.scheduler, wait=options.wait) as pool:
        yield pool


BOTH = "both"
"""A choice of precision: a campaign in one after the other."""


NETWORKS = "networks"
"""A choice of guidance, beside those of the optimal solver."""


def backend_parser(*more: str) -> argparse.ArgumentParser:
    """Which guidance flies; ``more`` are further choices of its precision."""
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--backend", choices=("c", "onnx"), default="c", help="what runs the networks")
    parser.add_argument("--precision", choices=("float64", "float32", *more), default="float64")
    parser.add_argument(
        "--layout",
        choices=("flight", "host"),
        default="flight",
        help="of the exported C: the file that goes on board, or the same on vectors (default: %(default)s)",
    )
    parser.add_argument("--networks", type=Path, metavar="DIR", help="exported networks (default: shipped)")
    parser.add_argument(
        "--guidance",
        choices=(NETWORKS, *EXPERT_RULES),
        default=NETWORKS,
        help="what flies: the networks, with the tracker of the optimal extremal; or the optimal solver, "
        "every day anew, with the same estimates or without their thrust margin: what guidance could get "
        "at all (default: %(default)s)",
    )
    return parser


def guidance_of(options: argparse.Namespace, mission: "Mission", *, many: bool = False) -> "Guidance":
    """The guidance that the options of :func:`backend_parser` name.

    Args:
        options: as parsed; its precision is one.
        mission: to be flown.
        many: it will be for many flights from the generalisation set.

    Raises:
        GuidanceError: it is missing, damaged or of another mission.
        SailnetError: options of networks that the optimal solver does not take.
    """
    if options.guidance in EXPERT_RULES:
        from sailnet.guidance.by_expert.pilot import ExpertGuidance

        if options.networks is not None or (options.backend, options.precision) != ("c", "float64"):
            raise SailnetError(
                "the optimal solver needs no networks, no back end, and computes in float64 alone"
            )
        return ExpertGuidance(mission, options.guidance, indexed=many)
    from sailnet.guidance.backends import load_guidance

    return load_guidance(mission, options.backend, options.precision, options.networks, layout=options.layout)


def loop_parser() -> argparse.ArgumentParser:
    """Period, seed and disturbances of closed-loop flights."""
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--period", type=float, metavar="TU", help="guidance period (default: the mission's)")
    parser.add_argument("--seed", type=int, help="of every random number (default: the mission's, or 0)")
    group = parser.add_argument_group(
        "disturbances", "All are off unless given here or in the mission file's table [disturbance]."
    )
    for quantity in catalogue():
        option, meaning = f"--{quantity.name.replace('_', '-')}", quantity.meaning
        if quantity.name == "optics":
            group.add_argument(option, choices=tuple(OPTICS), help="optical coefficients of the sail")
        else:
            unit = "X" if quantity.unit == "1" else quantity.unit
            default = f" (otherwise {quantity.default:g})" if quantity.default else ""
            group.add_argument(option, type=float, metavar=unit, help=meaning + default)
    return parser


def disturbance_of(options: argparse.Namespace, mission: "Mission") -> Disturbance:
    """What the options of :func:`loop_parser` say, on top of the mission's own."""
    names = ["seed", *(quantity.name for quantity in catalogue())]
    given = {name: getattr(options, name) for name in names}
    return disturbance_from(
        {name: value for name, value in given.items() if value is not None}, mission.disturbance
    )


def off_the_plane(options: argparse.Namespace) -> bool:
    """Whether a latitude or a northward speed is given."""
    return options.latitude is not None or options.northward is not None


def state_of(options: argparse.Namespace, *, in_space: bool) -> tuple[float, ...]:
    """The state that R U V give, in three dimensions with latitude [rad] and northward speed.

    Raises:
        SailnetError: R U V are of no sail, or what they complete is off the plane of a planar mission.
    """
    r, u, v = options.r, options.u, options.v
    if not all(math.isfinite(x) for x in (r, u, v)) or not r > 0.0:
        raise SailnetError(f"the state R U V must be three finite numbers with R > 0, not {(r, u, v)}")
    if not in_space:
        if off_the_plane(options):
            raise SailnetError(
                "--latitude and --northward are for missions of three dimensions, such as earth_mars_3d"
            )
        return r, u, v
    return r, math.radians(options.latitude or 0.0), u, v, options.northward or 0.0

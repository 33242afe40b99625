"""``sailnet mission``: write a new mission file, or show all that a short one amounts to."""

import argparse
from pathlib import Path

from sailnet.artefacts.files import write_text, writing
from sailnet.cli.arguments import Commands, existing_folder
from sailnet.errors import SailnetError
from sailnet.mission.derived import CONE_ANGLE
from sailnet.mission.mission import derived_for, load_mission
from sailnet.mission.written import short_text, whole_text
from sailnet.physics.optics import OPTICS

STRENGTHS = {
    "--beta": ("beta", "X", "normalised characteristic acceleration"),
    "--acceleration": ("characteristic_acceleration_mm_s2", "MM/S2", "characteristic acceleration"),
    "--loading": ("loading_g_m2", "G/M2", "mass of the craft over the area of its sail"),
}
"""Ways to say how strong a sail is: the key, the unit, and what it is."""


def add(commands: Commands) -> None:
    """Add the command and what it does."""
    about = "Write a new mission file, or show everything that a short one amounts to."
    mission = commands.add_parser("mission", help=about, description=about)
    tasks = mission.add_subparsers(title="tasks", required=True, metavar="TASK")
    new = tasks.add_parser(
        "new",
        help="write a short mission file with comments",
        epilog="example: sailnet mission new --target 0.9 --beta 0.12 --max-cone-angle 55 --output mine.toml",
    )
    new.add_argument("--target", type=float, metavar="AU", required=True, help="radius of the target orbit")
    new.add_argument("--departure", type=float, default=1.0, metavar="AU", help="of the departure orbit (1)")
    new.add_argument(
        "--inclination",
        type=float,
        default=0.0,
        metavar="DEG",
        help="of the departure orbit to the target's (0: in one plane)",
    )
    strength = new.add_mutually_exclusive_group(required=True)
    for option, (_, unit, meaning) in STRENGTHS.items():
        strength.add_argument(option, type=float, metavar=unit, help=meaning)
    new.add_argument(
        "--max-cone-angle",
        type=float,
        default=CONE_ANGLE,
        metavar="DEG",
        help="bound (%(default)g; 90: none)",
    )
    new.add_argument("--optics", choices=tuple(OPTICS), default="ideal", help="of the sail (%(default)s)")
    new.add_argument("--name", help="of the mission (the file's, or my_mission)")
    new.add_argument("--output", type=Path, metavar="FILE.toml", help="(default: print it)")
    new.add_argument("--overwrite", action="store_true", help="replace a file that is there")
    new.set_defaults(run=_new)
    show = tasks.add_parser("show", help="print the whole mission, and which values are derived")
    show.add_argument("mission", metavar="MISSION", help="mission name or TOML file")
    show.set_defaults(run=_show)


def _new(options: argparse.Namespace) -> int:
    output: Path | None = options.output
    if output is not None:
        if output.suffix != ".toml":
            raise SailnetError(f"--output writes FILE.toml, not {output}")
        existing_folder("--output", output)
        if output.exists() and not options.overwrite:
            raise SailnetError(f"{output} is there: name another file, or say --overwrite to replace it")
    (strength,) = (
        (key, value)
        for option, (key, _, _) in STRENGTHS.items()
        if (value := getattr(options, option.removeprefix("--"))) is not None
    )
    text = short_text(
        options.name or ("my_mission" if output is None else output.stem.lower().replace("-", "_")),
        options.target,
        departure_radius=options.departure,
        inclination=options.inclination,
        strength=strength,
        max_cone_angle=options.max_cone_angle,
        optics=options.optics,
    )
    if output is None:
        print(text, end="")
        return 0
    with writing(output):
        write_text(output, text)
    print(f"{output} is written; next: sailnet pipeline {output} --size quick")
    return 0


def _show(options: argparse.Namespace) -> int:
    print(whole_text(load_mission(options.mission)))
    if derived := derived_for(options.mission):
        print(f"\n# derived: {', '.join(derived)}")
    return 0

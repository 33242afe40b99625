"""``sailnet optics``: the force of sails that are not ideal, as a table and as a page."""

import argparse
from pathlib import Path

from sailnet.cli.arguments import Commands, existing_folder
from sailnet.cli.output import Result
from sailnet.errors import SailnetError, did_you_mean
from sailnet.mission.mission import load_mission
from sailnet.physics.optics import OPTICS, Optics


def add(commands: Commands) -> None:
    """Add the command."""
    about = "The force of sails by their optical coefficients, and which cone angles are of use."
    example = (
        "example: sailnet optics; sailnet optics ideal jpl --output optics.html; "
        "sailnet optics ideal --mission mine.toml"
    )
    optics = commands.add_parser("optics", help=about, description=about, epilog=example)
    optics.add_argument(
        "names",
        metavar="NAME",
        nargs="*",
        help=f"known sails: {', '.join(OPTICS)} (default: all, or the mission's)",
    )
    optics.add_argument("--mission", help="the sail of a mission: its name or TOML file, with its bound too")
    optics.add_argument("--output", type=Path, metavar="FILE.html", help="draw the curves as a page")
    optics.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    optics.set_defaults(run=run)


def run(options: argparse.Namespace) -> Result | int:
    """Print the table, or return the same numbers by sail; draw the page."""
    from sailnet.report import need_pictures, report
    from sailnet.report.optics_table import BOUNDS, facts_of, optics_lines, optics_record, optics_rows

    if options.output is not None and options.output.suffix != ".html":
        raise SailnetError(f"--output writes FILE.html, not {options.output}")
    if options.output is not None:
        need_pictures()
        existing_folder("--output", options.output)
    sails = {name: _known(name) for name in options.names}
    bounds = set(BOUNDS)
    if options.mission is not None:
        mission = load_mission(options.mission)
        optics = mission.sail.optics
        sails[optics.name or mission.name] = optics
        bounds.add(mission.sail.max_cone_angle)
    facts = facts_of(sails or OPTICS, sorted(bounds))
    records = {name: optics_record(one) for name, one in facts.items()}
    rows = optics_rows(records)
    if options.output is not None:
        report("optics_page").write_optics_page(options.output, facts, rows, options.command_line)
    if options.json:
        return dict(records)
    print("\n".join(optics_lines(list(records), rows)))
    return 0


def _known(name: str) -> Optics:
    if name not in OPTICS:
        raise SailnetError(
            f"there is no sail {name!r}: known are {', '.join(OPTICS)}; for coefficients of your own give "
            f"--mission FILE, whose [sail] has them as optics{did_you_mean(name, OPTICS)}"
        )
    return OPTICS[name]

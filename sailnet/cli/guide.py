"""``sailnet guide``: one guidance command."""

import argparse
import sys

from sailnet.cli.arguments import Commands, add_command, backend_parser, guidance_of, state_of, state_parser
from sailnet.cli.output import Line, Result, angle, time
from sailnet.errors import SailnetError
from sailnet.mission.mission import derived_for, load_mission

LINES = {
    "cone_angle": Line("cone angle", angle),
    "clock_angle": Line("clock angle, from v to the north", angle),
    "time_of_flight": Line("time of flight still to go, as predicted", time),
    "status": Line("status"),
    "source": Line("command of"),
}

TOLD = ("sail.", "transfer.", "flight.", "generalisation.")
"""Sections of a mission whose derived values a command depends on."""


def add(commands: Commands) -> None:
    """Add the command."""
    guide = add_command(
        commands,
        "guide",
        run,
        "One guidance command.",
        state_parser(),
        backend_parser(),
        example="sailnet guide 1.05 0.15 1.03 --beta 0.15 --json; sailnet guide 1 0 1 --law; "
        "sailnet guide 1 0 1 --latitude 1.5 --mission earth_mars_3d",
    )
    guide.set_defaults(lines=LINES)
    guide.add_argument(
        "--law",
        action="store_true",
        help="the command of the networks alone, as sailnet_guidance gives it; by default that of the "
        "optimal extremal through the state, which Newton's method finds from what the networks give, as "
        "sailnet_steer does over some guidance periods",
    )
    guide.add_argument("--beta", type=float, metavar="X", help="the sail's real one (default: the mission's)")


def run(options: argparse.Namespace) -> Result:
    """The command by name, with its status and its source.

    The source is ``plan``: an optimal extremal that passes through the state; else ``networks``, or the
    optimal solver by its name as an option. One command has no memory: its status is ok, arrived,
    outside_domain or invalid_input. What steering adds to these, ``sailnet fly`` counts.
    """
    from sailnet.guidance.interface import GuidanceStatus
    from sailnet.guidance.tracker.commands import planned_commands

    mission = load_mission(options.mission)
    state = state_of(options, in_space=mission.inclined)
    if derived := derived_for(options.mission):
        said = ", ".join(f"{key} = {derived[key]}" for key in derived if key.startswith(TOLD))
        print(f"note: derived, as `sailnet mission show {options.mission}` tells: {said}", file=sys.stderr)
    guidance = guidance_of(options, mission)
    low, high = guidance.beta_range
    if options.beta is not None and not low <= options.beta <= high:
        raise SailnetError(f"the networks know sails with beta from {low:g} to {high:g}, not {options.beta}")
    source = options.guidance
    if options.law:
        command = guidance.command([state], options.beta)
    else:
        command, flown = planned_commands(guidance, [state], options.beta)
        source = "plan" if flown[0] else source
    clock: Result = {}
    if command.clock_angle is not None:
        clock = {"clock_angle": float(command.clock_angle[0])}
    return {
        "cone_angle": float(command.cone_angle[0]),
        **clock,
        "time_of_flight": float(command.time_of_flight[0]),
        "status": GuidanceStatus(command.status[0]).name.lower(),
        "source": source,
    }

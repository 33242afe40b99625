"""``sailnet solve``: the indirect optimum."""

import argparse
import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from sailnet.artefacts.files import writing
from sailnet.cli.arguments import (
    Commands,
    add_command,
    existing_folder,
    off_the_plane,
    state_of,
    state_parser,
)
from sailnet.cli.output import (
    Line,
    Result,
    angle,
    components,
    number,
    readable,
    state,
    time,
    yes_or_no,
)
from sailnet.errors import SailnetError
from sailnet.mission import tested_range
from sailnet.mission.mission import load_mission
from sailnet.physics.geometry import attitude
from sailnet.physics.optics import OPTICS

if TYPE_CHECKING:
    from sailnet.expert.optima import Extremal
    from sailnet.mission.mission import Mission

Start = tuple[float, ...] | None
"""The state, if it is given."""

LINES = {
    "state": Line("state", state),
    "time_of_flight": Line("shortest time of flight", time),
    "cone_angle": Line("cone angle at the start", angle),
    "costates": Line(
        "costates", components(("lambda_r", "lambda_u", "lambda_v"), ("TU/AU", "TU^2/AU", "TU^2/AU"))
    ),
    "jumps": Line("jumps of the cone angle on the way", number),
    "residual": Line("largest error of r, u, v [AU, AU/TU]", number),
    "complete": Line("everything faster was looked for", yes_or_no),
    "next_time_of_flight": Line("next fastest extremal that was found", time, "none"),
    "unconstrained_time_of_flight": Line("shortest if nothing bounded the cone angle", time),
    "constrained_time_of_flight": Line("shortest with the exact law (delta = 0)", time),
    "plot": Line("shown in"),
    "output": Line("written to"),
}

LINES_IN_SPACE = LINES | {
    "clock_angle": Line("clock angle at the start, from v to the north", angle),
    "costates": Line(
        "costates",
        components(
            ("lambda_r", "lambda_latitude", "lambda_u", "lambda_v", "lambda_w"),
            ("TU/AU", "TU/rad", "TU^2/AU", "TU^2/AU", "TU^2/AU"),
        ),
    ),
    "jumps": Line("fast turns of the clock angle on the way", number),
    "residual": Line("largest error of the state [AU, rad, AU/TU]", number),
}
"""Of an optimum in three dimensions."""


def add(commands: Commands) -> None:
    """Add the command."""
    solve = add_command(
        commands,
        "solve",
        run,
        "The indirect optimum from a state; without one, the nominal from the mission's departure orbit.",
        state_parser("?"),
        _override_parser(),
        example="sailnet solve 1 0 1; sailnet solve --mission earth_venus; "
        "sailnet solve --phi-max 45 --beta 0.25 --target-radius 0.9 --smoothing 0; "
        "sailnet solve --optics jpl; sailnet solve 1.05 0.15 1.03 --plot optimum.html --output optimum.csv; "
        "sailnet solve --mission earth_mars_3d; "
        "sailnet solve 1.05 0.15 1.03 --latitude 1.5 --northward -0.02",
    )
    solve.set_defaults(lines=LINES)
    solve.add_argument("--plot", type=Path, metavar="FILE", help="show the optimum: FILE.png or FILE.html")
    solve.add_argument(
        "--output", type=Path, metavar="FILE.csv", help="write it: time, state, costates, cone angle"
    )


def _override_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(add_help=False)
    group = parser.add_argument_group("instead of the mission's own")
    for option, metavar, meaning, (low, high) in (
        ("--phi-max", "DEG", "bound on the cone angle, 90 for none", tested_range.CONE_ANGLE),
        ("--beta", "X", "normalised characteristic acceleration", tested_range.BETA),
        ("--target-radius", "AU", "radius of the target orbit", tested_range.TARGET_RADIUS),
        ("--smoothing", "X", "delta of Eq. (12), 0 for the exact law", tested_range.SMOOTHING),
    ):
        help_ = f"{meaning} (tested: {low:g} to {high:g})"
        group.add_argument(option, type=float, metavar=metavar, help=help_)
    group.add_argument(
        "--optics",
        choices=tuple(OPTICS),
        help="coefficients of the sail; if not ideal, --smoothing is 0",
    )
    return parser


def run(options: argparse.Namespace) -> Result:
    """Solve; the optimum by name."""
    from sailnet.report import need_pictures

    given = load_mission(options.mission)
    chosen = given if options.optics is None else given.with_optics(OPTICS[options.optics])
    mission = chosen.with_overrides(
        beta=options.beta,
        max_cone_angle=options.phi_max,
        smoothing=options.smoothing,
        target_radius=options.target_radius,
    )
    space = mission.inclined or off_the_plane(options)
    if options.plot is not None:
        if options.plot.suffix not in (".png", ".html"):
            raise SailnetError(f"--plot writes FILE.png or FILE.html, not {options.plot}")
        need_pictures()
    if options.output is not None and options.output.suffix != ".csv":
        raise SailnetError(f"--output writes FILE.csv, not {options.output}; --plot draws")
    for option in ("plot", "output"):
        if (file := getattr(options, option)) is not None:
            existing_folder(f"--{option}", file)
    known = [x is not None for x in (options.r, options.u, options.v)]
    if any(known) and not all(known):
        raise SailnetError("give all of R U V, or none of them to start from the mission's departure orbit")
    if off_the_plane(options) and not all(known):
        raise SailnetError("--latitude and --northward complete a state: give R U V as well")
    start = state_of(options, in_space=space) if all(known) else None
    if space:
        options.lines = LINES_IN_SPACE
    for remark in tested_range.beyond(mission.problem):
        print(f"note: {remark}", file=sys.stderr)
    extremal, result = _solved_in_space(mission, start) if space else _solved(mission, start)
    if not extremal.complete:
        print(f"note: {_BEYOND[space]}: this may not be the fastest", file=sys.stderr)
    return _write(options, mission, extremal, result)


_BEYOND = {
    False: "the search ended before every faster extremal was looked for",
    True: "in three dimensions only the extremals near those of the plane are looked for",
}


def _solved(mission: "Mission", start: Start) -> tuple["Extremal", Result]:
    """The optimum in the plane, and what is told of it."""
    from sailnet.expert.fastest import solve
    from sailnet.expert.nominal import solve_nominal

    if start:
        extremal = solve(mission.problem, start)
        return extremal, facts_of(extremal)
    nominal = solve_nominal(mission)
    extremal = nominal.smoothed
    return extremal, {
        "state": extremal.state.tolist(),
        **facts_of(extremal),
        "unconstrained_time_of_flight": nominal.unconstrained.time_of_flight,
        "constrained_time_of_flight": nominal.constrained.time_of_flight,
    }


def _solved_in_space(mission: "Mission", start: Start) -> tuple["Extremal", Result]:
    """The same in three dimensions."""
    from sailnet.expert.fastest_in_space import solve

    extremal = solve(mission.problem, start or mission.departure_state_in_space)
    return extremal, {"state": extremal.state.tolist(), **facts_of(extremal)}


def facts_of(extremal: "Extremal") -> Result:
    """What is known of an optimum, by the names of ``LINES`` or of ``LINES_IN_SPACE``."""
    angles: Result = {"cone_angle": extremal.cone_angle}
    if len(extremal.state) == 5:
        cone, clock = attitude(extremal.costates, np.array(extremal.cone_angle))
        angles = {"cone_angle": float(cone), "clock_angle": float(clock)}
    return {
        "time_of_flight": extremal.time_of_flight,
        **angles,
        "costates": extremal.costates.tolist(),
        "jumps": extremal.jumps,
        "residual": extremal.residual,
        "complete": extremal.complete,
        "next_time_of_flight": None if math.isnan(extremal.rival_time) else extremal.rival_time,
    }


def _write(options: argparse.Namespace, mission: "Mission", extremal: "Extremal", result: Result) -> Result:
    """Write the files that are asked for; the result with their names."""
    from sailnet.report import report
    from sailnet.report.optimum import Optimum

    if options.plot is not None:
        facts = readable({"state": extremal.state.tolist(), **result}, options.lines)
        report("optimum_charts").plot_optimum(options.plot, mission, extremal, facts, options.command_line)
        result["plot"] = str(options.plot)
    if options.output is not None:
        with writing(options.output):
            Optimum.of(mission.problem, extremal).named().write_csv(options.output)
        result["output"] = str(options.output)
    return result

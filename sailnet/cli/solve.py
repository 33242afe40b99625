"""``sailnet solve``: the indirect optimum."""

import argparse
import math
import sys
from typing import TYPE_CHECKING

from sailnet.cli.arguments import Commands, add_command, state_of, state_parser
from sailnet.cli.output import Result
from sailnet.errors import SailnetError
from sailnet.mission import tested_range
from sailnet.mission.mission import load_mission
from sailnet.physics.optics import OPTICS

if TYPE_CHECKING:
    from sailnet.expert.fastest import Extremal


def add(commands: Commands) -> None:
    """Add the command."""
    add_command(
        commands,
        "solve",
        run,
        "The indirect optimum from a state; without one, the nominal from the mission's departure orbit.",
        state_parser("?"),
        _override_parser(),
        example="sailnet solve 1 0 1; sailnet solve --mission earth_venus; "
        "sailnet solve --phi-max 45 --beta 0.25 --target-radius 0.9 --smoothing 0; "
        "sailnet solve --optics jpl",
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
    from sailnet.expert.fastest import solve
    from sailnet.expert.nominal import solve_nominal

    given = load_mission(options.mission)
    chosen = given if options.optics is None else given.with_optics(OPTICS[options.optics])
    mission = chosen.with_overrides(
        beta=options.beta,
        max_cone_angle=options.phi_max,
        smoothing=options.smoothing,
        target_radius=options.target_radius,
    )
    known = [x is not None for x in (options.r, options.u, options.v)]
    if any(known) and not all(known):
        raise SailnetError("give all of R U V, or none of them to start from the mission's departure orbit")
    state = state_of(options) if all(known) else None
    problem = mission.problem
    for remark in tested_range.beyond(problem):
        print(f"note: {remark}", file=sys.stderr)
    if state:
        return _facts(solve(problem, state))
    nominal = solve_nominal(mission)
    return {
        "state": nominal.smoothed.state.tolist(),
        **_facts(nominal.smoothed),
        "unconstrained_time_of_flight": nominal.unconstrained.time_of_flight,
        "constrained_time_of_flight": nominal.constrained.time_of_flight,
    }


def _facts(extremal: "Extremal") -> Result:
    if not extremal.complete:
        print(
            "note: the search ended before every faster extremal was looked for: this may not be the fastest",
            file=sys.stderr,
        )
    return {
        "time_of_flight": extremal.time_of_flight,
        "cone_angle": extremal.cone_angle,
        "costates": extremal.costates.tolist(),
        "jumps": extremal.jumps,
        "residual": extremal.residual,
        "complete": extremal.complete,
        "next_time_of_flight": None if math.isnan(extremal.rival_time) else extremal.rival_time,
    }

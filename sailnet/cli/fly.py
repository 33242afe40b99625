"""``sailnet fly``: one closed-loop flight."""

import argparse
import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from sailnet.cli.arguments import (
    Commands,
    add_command,
    backend_parser,
    disturbance_of,
    guidance_of,
    loop_parser,
    state_of,
    state_parser,
)
from sailnet.cli.output import Result, readable
from sailnet.errors import SailnetError, SolveError
from sailnet.mission.mission import load_mission

if TYPE_CHECKING:
    from sailnet.expert.fastest import Extremal


def add(commands: Commands) -> None:
    """Add the command."""
    fly = add_command(
        commands,
        "fly",
        run,
        "One closed-loop flight.",
        state_parser(),
        backend_parser(),
        loop_parser(),
        example="sailnet fly 1.1 0.18 0.93 --beta-noise 0.15 --seed 3 --plot flight.html",
    )
    fly.add_argument("--plot", type=Path, metavar="FILE", help="show the flight: FILE.png or FILE.html")


def run(options: argparse.Namespace) -> Result:
    """Fly; how it ended by name, and in how many periods the guidance said what."""
    from sailnet.campaign.scores import in_si
    from sailnet.expert.fastest import solve
    from sailnet.expert.real_sails import own_optima
    from sailnet.flight.closed_loop import Ending, fly_recorded
    from sailnet.guidance.interface import GuidanceStatus
    from sailnet.report import need_pictures, report

    mission = load_mission(options.mission)
    state = state_of(options)
    if options.plot is not None and options.plot.suffix not in (".png", ".html"):
        raise SailnetError(f"--plot writes FILE.png or FILE.html, not {options.plot}")
    if options.plot is not None:
        need_pictures()
    guidance = guidance_of(options, mission)
    disturbance = disturbance_of(options, mission)
    flight, (history,) = fly_recorded(
        mission, guidance, [state], disturbance=disturbance, period=options.period
    )
    try:
        optimum: Extremal | None = solve(mission.problem, state)
    except SolveError as error:
        print(f"note: {error}", file=sys.stderr)
        optimum = None
    own = None
    if optimum is not None:
        costates, times = optimum.arrival_costates[None], np.array([optimum.time_of_flight])
        beta = mission.problem.beta * (1.0 + flight.beta_error)
        optics = mission.optics_flown(disturbance)
        sails, _ = own_optima(mission.problem, flight.starts, costates, times, beta, optics)
        own = float(sails.time_of_flight[0]) if sails.found[0] else None
    result: Result = {
        "arrived": bool(flight.arrived[0]),
        "ending": Ending(flight.ending[0]).name.lower(),
        "time_of_flight": float(flight.time_of_flight[0]),
        "terminal_error": flight.terminal_error[0].tolist(),
        "nearest_error": float(flight.nearest_error[0]),
        "terminal_error_km_mps": in_si(flight.terminal_error[0]),
        "max_cone_angle": float(flight.max_cone_angle[0]),
        "max_attitude": float(flight.max_attitude[0]),
        "reversals": int(flight.reversals[0]),
        "command_slew_deg": math.degrees(flight.command_slew[0]),
        "statuses": {
            status.name.lower(): int(count)
            for status in GuidanceStatus
            if (count := (history.status == status).sum())
        },
        "beta_error": float(flight.beta_error[0]),
        "beta_estimate": float(flight.beta_estimate[0]),
        "optimal_time_of_flight": None if optimum is None else optimum.time_of_flight,
        "own_optimal_time_of_flight": own,
    }
    if options.plot is not None:
        said = {key: value for key, value in result.items() if key != "statuses"}
        facts = {key.replace("_", " "): readable(value) for key, value in said.items()}
        report("flight_page").plot_flight(options.plot, mission, history, optimum, facts)
        result["plot"] = str(options.plot)
    return result

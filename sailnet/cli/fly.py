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
    existing_folder,
    guidance_of,
    loop_parser,
    state_of,
    state_parser,
)
from sailnet.cli.output import (
    Line,
    Result,
    angle,
    counted,
    deviation,
    deviation_in_si,
    in_unit,
    number,
    percent,
    readable,
    state,
    table,
    time,
    yes_or_no,
)
from sailnet.errors import SailnetError, SolveError
from sailnet.mission.disturbances import worded
from sailnet.mission.mission import load_mission

if TYPE_CHECKING:
    from sailnet.expert.optima import Extremal
    from sailnet.flight.closed_loop import Flights, History


LINES = {
    "arrived": Line("arrived", yes_or_no),
    "ending": Line("how it ended"),
    "time_of_flight": Line("time flown, to within the tolerance on arrival", time),
    "terminal_error": Line("error at the end", deviation),
    "nearest_error": Line("smallest error at any time [AU, AU/TU]", number),
    "terminal_error_km_mps": Line("error at the end, in SI", deviation_in_si),
    "max_cone_angle": Line("largest cone angle commanded", angle),
    "max_attitude": Line("largest cone angle flown", angle),
    "reversals": Line("reversals of the command", number),
    "command_slew_deg": Line("slew of the command in all", in_unit("deg")),
    "statuses": Line("what the guidance said", table(counted("period"))),
    "beta_error": Line("constant error of the sail's beta", percent),
    "beta_estimate": Line("beta as estimated at the end", number),
    "optimal_time_of_flight": Line("shortest to the target, of the sail assumed", time),
    "own_optimal_time_of_flight": Line("shortest to the target, of the sail that flew", time),
    "plot": Line("shown in"),
}


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
        example="sailnet fly 1.1 0.18 0.93 --beta-noise 0.15 --seed 3 --plot flight.html; "
        "sailnet fly 1 0 1 --latitude 1.5 --northward -0.01 --mission earth_mars_3d",
    )
    fly.set_defaults(lines=LINES)
    fly.add_argument("--plot", type=Path, metavar="FILE", help="show the flight: FILE.png or FILE.html")


def run(options: argparse.Namespace) -> Result:
    """Fly; how it ended by name, and in how many periods the guidance said what."""
    from sailnet.expert.any_dimension import solve
    from sailnet.expert.real_sails import own_optima
    from sailnet.flight.closed_loop import fly_recorded
    from sailnet.flight.drawn_optics import optics_of_flights
    from sailnet.report import need_pictures, report

    mission = load_mission(options.mission)
    start = state_of(options, in_space=mission.inclined)
    if options.plot is not None and options.plot.suffix not in (".png", ".html"):
        raise SailnetError(f"--plot writes FILE.png or FILE.html, not {options.plot}")
    if options.plot is not None:
        need_pictures()
        existing_folder("--plot", options.plot)
    guidance = guidance_of(options, mission)
    disturbance = disturbance_of(options, mission)
    flight, (history,) = fly_recorded(
        mission, guidance, [start], disturbance=disturbance, period=options.period
    )
    try:
        optimum: Extremal | None = solve(mission.problem, start)
    except SolveError as error:
        print(f"note: {error}", file=sys.stderr)
        optimum = None
    own = None
    if optimum is not None:
        costates, times = optimum.arrival_costates[None], np.array([optimum.time_of_flight])
        beta = mission.problem.beta * (1.0 + flight.beta_error)
        optics = optics_of_flights(mission, disturbance, [0])
        sails, _ = own_optima(mission.problem, flight.starts, costates, times, beta, optics)
        own = float(sails.time_of_flight[0]) if sails.found[0] else None
        if own is not None and flight.arrived[0] and flight.time_of_flight[0] < own:
            within = mission.flight.arrival_tolerance
            print(
                "note: the flight is shorter than the shortest, which ends on the target and not within "
                f"{within:g} of it in each component [AU, AU/TU]",
                file=sys.stderr,
            )
    result: Result = {
        **facts_of(flight, history),
        "optimal_time_of_flight": None if optimum is None else optimum.time_of_flight,
        "own_optimal_time_of_flight": own,
    }
    if options.plot is not None:
        said = {key: value for key, value in result.items() if key != "statuses"}
        period = mission.flight.period if options.period is None else options.period
        facts = {
            "start": state(start),
            "disturbed by": worded(disturbance),
            "seed": str(disturbance.seed),
            "guidance period": time(period),
            **readable(said, LINES),
        }
        report("flight_page").plot_flight(
            options.plot, mission, history, optimum, facts, options.command_line
        )
        result["plot"] = str(options.plot)
    return result


def facts_of(flights: "Flights", history: "History") -> Result:
    """How the first of some flights went, by the names of ``LINES``."""
    from sailnet.campaign.scores import in_si
    from sailnet.flight.closed_loop import Ending
    from sailnet.guidance.interface import GuidanceStatus

    return {
        "arrived": bool(flights.arrived[0]),
        "ending": Ending(flights.ending[0]).name.lower(),
        "time_of_flight": float(flights.time_of_flight[0]),
        "terminal_error": flights.terminal_error[0].tolist(),
        "nearest_error": float(flights.nearest_error[0]),
        "terminal_error_km_mps": in_si(flights.terminal_error[0]),
        "max_cone_angle": float(flights.max_cone_angle[0]),
        "max_attitude": float(flights.max_attitude[0]),
        "reversals": int(flights.reversals[0]),
        "command_slew_deg": math.degrees(flights.command_slew[0]),
        "statuses": {
            status.name.lower(): int(count)
            for status in GuidanceStatus
            if (count := (history.status == status).sum())
        },
        "beta_error": float(flights.beta_error[0]),
        "beta_estimate": float(flights.beta_estimate[0]),
    }

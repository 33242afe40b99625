"""``sailnet evaluate``: many closed-loop flights, or a whole campaign."""

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING

from sailnet.cli.arguments import (
    BOTH,
    Commands,
    add_command,
    backend_parser,
    distribution,
    disturbance_of,
    guidance_of,
    loop_parser,
    workers_of,
)
from sailnet.cli.output import (
    Line,
    Result,
    counted,
    deviation,
    deviation_in_si,
    in_unit,
    number,
    over_flights,
    percent,
    table,
)
from sailnet.errors import SailnetError
from sailnet.mission.mission import load_mission

if TYPE_CHECKING:
    from sailnet.campaign.excess import Excess
    from sailnet.flight.closed_loop import Flights
    from sailnet.mission.mission import Mission

FLIGHTS, PERIODS = counted("flight"), counted("period")

LINES = {
    "flights": Line("flown from random starts", FLIGHTS),
    "time_above_own_optimum": Line("excess over the optimum for the true sail", over_flights(percent)),
    "days_above_own_optimum": Line("the same in days", over_flights(in_unit("days"))),
    "first_approach": Line("arrived without an extra revolution", FLIGHTS),
    "counted_at_longest": Line("failed, counted as the longest flight", FLIGHTS),
    "own_optimum_unknown": Line("without a known optimum, not counted", FLIGHTS),
    "reversals": Line("attitude reversals, a flight", over_flights(number)),
    "command_slew_deg": Line("slew of the command, a flight", over_flights(in_unit("deg"))),
    "attitude_slew_deg": Line("slew of the sail, a flight", over_flights(in_unit("deg"))),
    "command_rate_deg_per_hour": Line(
        "rate of 99 % of the steps of a command", over_flights(in_unit("deg/h"))
    ),
    "arrived_attitude_kept": Line("arrived, always within the bound", FLIGHTS),
    "attitude_beyond_bound": Line("cone angle flown ever beyond the bound", FLIGHTS),
    "attitude_beyond_bound_periods": Line("beyond the bound for", PERIODS),
    "largest_attitude_excess_deg": Line("beyond the bound by at most", in_unit("deg")),
    "outside_domain": Line("ever outside what was trained for", FLIGHTS),
    "outside_domain_periods": Line("outside for", PERIODS),
    "beta_at_limit": Line("estimate of beta ever at its limit", FLIGHTS),
    "beta_at_limit_periods": Line("at its limit for", PERIODS),
    "without_navigation": Line("ever without navigation", FLIGHTS),
    "without_navigation_periods": Line("without navigation for", PERIODS),
    "reckoned": Line("ever steered by dead reckoning", FLIGHTS),
    "reckoned_periods": Line("by dead reckoning for", PERIODS),
    "periods_flown": Line("flown in all", PERIODS),
    "arrived": Line("arrived", FLIGHTS),
    "success_share": Line("arrived, of all", percent),
    "confidence_interval": Line("95 % interval of that share", lambda ends: " to ".join(map(percent, ends))),
    "error_quantiles": Line("error at the end", over_flights(deviation)),
    "error_quantiles_km_mps": Line("error at the end, in SI", over_flights(deviation_in_si)),
    "attitude_violations": Line("ever commanded beyond the bound", FLIGHTS),
    "results": Line("results"),
    "report": Line("report"),
    "digest": Line("digest (SHA-256)"),
    "float32": Line("in float32", table(str)),
}

OF_CAMPAIGNS = ("output", "restart", "overwrite", "optima")
"""Options that say something about a campaign alone."""


def add(commands: Commands) -> None:
    """Add the command."""
    evaluate = add_command(
        commands,
        "evaluate",
        run,
        "Closed-loop flights from random starts of the generalisation set, or a whole campaign.",
        backend_parser(BOTH),
        loop_parser(),
        example="sailnet evaluate --flights 1000 --beta-noise 0.15 --rate-limit 5 --optics jpl; "
        "sailnet evaluate --campaign everything --precision both --workers 2; "
        "sailnet evaluate --campaign everything --guidance expert --flights 200",
    )
    evaluate.set_defaults(lines=LINES)
    evaluate.add_argument(
        "--campaign",
        metavar="NAME",
        help="a ready campaign or a TOML file; its results and its report are written to --output",
    )
    evaluate.add_argument("--output", type=Path, metavar="DIR", help="of a campaign (campaigns)")
    evaluate.add_argument("--restart", action="store_true", help="throw away what was flown before")
    evaluate.add_argument(
        "--overwrite",
        action="store_true",
        help="replace a finished campaign of the same name, but another mission, file, networks, options or "
        "software",
    )
    evaluate.add_argument(
        "--flights", type=int, metavar="N", help="how many (100, or what the campaign says for random starts)"
    )
    evaluate.add_argument(
        "--optima",
        type=Path,
        metavar="FILE",
        help="results of the same campaign by another guidance: the shortest times are taken from there",
    )
    evaluate.add_argument(
        "--without-optima",
        action="store_true",
        help="of random starts: do not ask the expert for the shortest times, which takes a minute",
    )
    distribution(evaluate, 1, "processes, at most one for each core and 500 flights (%(default)s)")


def run(options: argparse.Namespace) -> Result:
    """Fly them; shares, errors, times above the optimum and slews by name."""
    if options.campaign is not None:
        from sailnet.cli.campaign import evaluate_campaign

        if options.without_optima:
            raise SailnetError(
                "--without-optima is for random starts: put optima = 0 into the campaign's file"
            )
        options.output = options.output or Path("campaigns")
        return evaluate_campaign(options)
    if given := [f"--{name}" for name in OF_CAMPAIGNS if getattr(options, name)]:
        raise SailnetError(f"{', '.join(given)} is for campaigns: add --campaign NAME, or leave it out")
    if options.precision == BOTH:
        raise SailnetError("--precision both is for campaigns: say float64 or float32, or --campaign NAME")
    from sailnet.campaign.excess import excess_of
    from sailnet.campaign.own_optima import optimal_times_of
    from sailnet.campaign.random_flights import BATCH, fly_random_starts
    from sailnet.workers.progress import progress

    mission = load_mission(options.mission)
    guidance = guidance_of(options, mission, many=True)
    disturbance = disturbance_of(options, mission)
    wanted = 100 if options.flights is None else options.flights
    with workers_of(options, math.ceil(wanted / BATCH)) as pool:
        flights = fly_random_starts(
            mission, guidance, wanted, disturbance, period=options.period, workers=pool
        )
    excess = None
    if not options.without_optima:
        with progress(wanted, "flight", "shortest times"):
            optima = optimal_times_of(mission, flights, disturbance)
        excess = excess_of(mission, flights, optima)
    return facts_of(mission, flights, excess)


def facts_of(mission: "Mission", flights: "Flights", excess: "Excess | None") -> Result:
    """How many flights went, by the names of ``LINES``."""
    from sailnet.campaign.behaviour import behaviour_of, behaviour_record
    from sailnet.campaign.excess import excess_record
    from sailnet.campaign.scores import attitude_violations, component_quantiles, in_si
    from sailnet.campaign.shares import Share

    arrived = Share.where(flights.arrived)
    quantiles = component_quantiles(flights, (0.5, 0.9, 0.95, 0.99, 1.0))
    return {
        "flights": arrived.of,
        **excess_record(excess),
        **behaviour_record(behaviour_of(mission, flights)),
        "arrived": arrived.count,
        "success_share": arrived.share,
        "confidence_interval": list(arrived.interval),
        "error_quantiles": {f"{level:g}": values for level, values in quantiles.items()},
        "error_quantiles_km_mps": {f"{level:g}": in_si(values) for level, values in quantiles.items()},
        "attitude_violations": attitude_violations(flights, mission.problem.phi_max),
    }

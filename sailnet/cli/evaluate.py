"""``sailnet evaluate``: many closed-loop flights, or a whole campaign."""

import argparse
from contextlib import nullcontext
from pathlib import Path

from sailnet.cli.arguments import (
    BOTH,
    Commands,
    add_command,
    backend_parser,
    disturbance_of,
    guidance_of,
    loop_parser,
)
from sailnet.cli.output import Result
from sailnet.errors import SailnetError
from sailnet.mission.mission import load_mission


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
    evaluate.add_argument(
        "--campaign",
        metavar="NAME",
        help="a ready campaign or a TOML file; its results and its report are written to --output",
    )
    evaluate.add_argument(
        "--output", type=Path, default=Path("campaigns"), metavar="DIR", help="(%(default)s)"
    )
    evaluate.add_argument("--restart", action="store_true", help="throw away what was flown before")
    evaluate.add_argument(
        "--overwrite",
        action="store_true",
        help="replace a finished campaign of the same name, but another mission, file, networks or options",
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
    evaluate.add_argument("--workers", type=int, default=1, metavar="N", help="processes (%(default)s)")
    evaluate.add_argument("--scheduler", metavar="ADDRESS", help="Dask scheduler whose workers fly instead")


def run(options: argparse.Namespace) -> Result:
    """Fly them; shares, errors, times above the optimum and slews by name."""
    if options.campaign is not None:
        from sailnet.cli.campaign import evaluate_campaign

        return evaluate_campaign(options)
    if options.precision == BOTH:
        raise SailnetError("--precision both is for campaigns: say float64 or float32, or --campaign NAME")
    from sailnet.campaign.behaviour import behaviour_of, behaviour_record
    from sailnet.campaign.excess import excess_of, excess_record
    from sailnet.campaign.own_optima import optimal_times_of
    from sailnet.campaign.random_flights import fly_random_starts
    from sailnet.campaign.scores import attitude_violations, component_quantiles, in_si
    from sailnet.campaign.shares import Share
    from sailnet.workers.executors import workers

    mission = load_mission(options.mission)
    guidance = guidance_of(options, mission, many=True)
    disturbance = disturbance_of(options, mission)
    alone = options.workers == 1 and options.scheduler is None
    with nullcontext() if alone else workers(options.workers, options.scheduler) as pool:
        count = 100 if options.flights is None else options.flights
        flights = fly_random_starts(
            mission, guidance, count, disturbance, period=options.period, workers=pool
        )
    excess = None
    if not options.without_optima:
        optics = mission.optics_flown(disturbance)
        excess = excess_of(mission, flights, optimal_times_of(mission, flights, optics))
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

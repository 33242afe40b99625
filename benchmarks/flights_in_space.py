"""``python -m benchmarks.flights_in_space``: networks of three dimensions, flown from random starts.

Flown are the acceptance's random series, in the plant, by the flight file that was exported. Every flight
is compared with the expert's optimum of the very sail that flew. What was measured goes into ``IN_SPACE.md``.
"""

import argparse
import json
import sys
import time
from pathlib import Path

import numpy as np

from benchmarks.expert_in_space import RESULTS
from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.campaign.excess import above_own_optimum, excess_of
from sailnet.campaign.own_optima import Turns, assumed_optima, optimal_turns, own_optimal_times
from sailnet.campaign.plan import Series, load_plan
from sailnet.campaign.tables import Table
from sailnet.errors import SailnetError
from sailnet.expert.optima import Optima
from sailnet.flight.closed_loop import Flights, fly
from sailnet.flight.drawn_optics import optics_of_flights
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import Guidance
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_in_space import load_guidance_networks_in_space

TOGETHER = 1000
"""Flights side by side."""


def measure(
    guidance: Guidance, series: Series, flights: int, seed: int, assumed: Optima, optimum: Turns
) -> dict[str, float]:
    """Fly a series of random starts.

    Args:
        guidance: what flies.
        series: what disturbs.
        flights: how many.
        seed: of the disturbances.
        assumed: optima of the sail as assumed from the starts.
        optimum: what those ask of the sail.
    """
    mission, disturbance = guidance.mission, series.disturbances(guidance.mission, seed)
    began = time.process_time()
    parts = [
        fly(mission, guidance, assumed.state[first : first + TOGETHER], disturbance=disturbance, first=first)
        for first in range(0, flights, TOGETHER)
    ]
    flown, seconds = Flights.join(parts), time.process_time() - began
    optics = optics_of_flights(mission, disturbance, range(flights))
    own = own_optimal_times(mission.problem, assumed, flown.beta_error, optics)
    return scores(mission, flown, own, optimum) | {"processor time a flight [s]": seconds / flights}


def scores(mission: Mission, flown: Flights, own: np.ndarray, optimum: Turns) -> dict[str, float]:
    """Of all flights whose optimum is known; one that did not come near counts as the longest flight."""
    excess = excess_of(mission, flown, own)
    if excess is None:
        raise SailnetError("the expert knows no optimum of these flights")
    share = 100.0 * above_own_optimum(mission, flown, own)[np.isfinite(own)]
    turns = flown.attitude_slew / np.where(optimum.slew > 0.0, optimum.slew, np.nan)
    error = flown.terminal_error.max(axis=1)
    return {
        "flights": len(own),
        "do not arrive": int((~flown.arrived).sum()),
        "optimum unknown": excess.unknown,
        "at the first approach [%]": 100.0 * excess.first_approach.share,
        "time over the own optimum: mean [%]": float(share.mean()),
        "median": float(np.median(share)),
        "99 %": float(np.quantile(share, 0.99)),
        "largest": float(share.max()),
        "error at the end: median [AU, AU/TU]": float(np.median(error)),
        "99 % of errors": float(np.quantile(error, 0.99)),
        "turns of the sail, in optima: median": float(np.nanmedian(turns)),
        "99 % of turns": float(np.nanquantile(turns, 0.99)),
        "reversals: 99 %": float(np.quantile(flown.reversals, 0.99)),
        "of optima: 99 %": float(np.nanquantile(optimum.reversals, 0.99)),
    }


def main() -> int:
    """Fly and write."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.flights_in_space",
        description=__doc__,
        epilog="example: python -m benchmarks.flights_in_space NETWORKS EXPORTED --flights 1000",
    )
    parser.add_argument("networks", type=Path, help="folder of the four networks")
    parser.add_argument("exported", type=Path, help="folder of what sailnet export made of them")
    parser.add_argument(
        "--precision", choices=("float64", "float32"), default="float64", help="of the C (%(default)s)"
    )
    parser.add_argument("--flights", type=int, default=1_000, help="of each series (%(default)s)")
    parser.add_argument("--seed", type=int, default=2, help="of every random number (%(default)s)")
    parser.add_argument("--json", action="store_true", help="print only")
    parser.add_argument("--output", type=Path, default=RESULTS, help="(%(default)s)")
    options = parser.parse_args()
    try:
        networks = load_guidance_networks_in_space(options.networks)
        mission = networks.mission
        guidance = load_guidance(mission, "c", options.precision, options.exported)
        if guidance.networks_digest != networks.digest:
            raise SailnetError(f"{options.exported} was not made of {options.networks}")
        assumed = assumed_optima(mission, random_starts(mission, options.flights, options.seed))
        optimum = optimal_turns(mission.problem, assumed, mission.flight.period)
        plan = load_plan("acceptance").changed(options.flights, options.seed).flown_by(mission)
        measured = {
            series.name: measure(guidance, series, options.flights, options.seed, assumed, optimum)
            for series in plan.whole
        }
        if options.json:
            print(json.dumps(measured))
            return 0
        origin, recipe = software(), mission.dataset.wide
        names = list(next(iter(measured.values())))
        cells = [[name, *(f"{of_one[name]:.4g}" for of_one in measured.values())] for name in names]
        lines = [
            f"Written by `python -m benchmarks.flights_in_space` on {origin['machine']}, {origin['date']}, "
            f"revision {origin['revision']}: networks of `{mission.name}` (data of {recipe.levels} "
            f"sails, {recipe.starts} starts each; {networks.tau.provenance['epochs']} epochs), seed "
            f"{options.seed}, {options.precision}.",
            "",
            *Table("", ["quantity", *measured], cells).markdown(),
        ]
        fill_block(options.output, f"flights-{options.precision}", "\n".join(lines))
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())

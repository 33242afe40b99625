"""``python -m benchmarks.flights_in_space``: networks of three dimensions, flown from random starts.

Every flight is compared with the expert's optimum from its own start. Flown is the law alone, without memory:
the mission's own sail, with a share of beta kept in reserve. What was measured goes into ``IN_SPACE.md``.
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
from sailnet.errors import SailnetError
from sailnet.expert.fastest_in_space import solve_states
from sailnet.flight.in_space import FlightsInSpace, fly_in_space
from sailnet.networks.guidance_in_space import GuidanceNetworksInSpace, load_guidance_networks_in_space
from sailnet.physics.arrays import Array

MISSED = 1.2
"""Times the optimum from which on a flight has missed its first approach."""


def measure(networks: GuidanceNetworksInSpace, flights: int, seed: int, reserve: float) -> dict[str, object]:
    """Fly from the departure and from random states of the generalisation set."""
    mission = networks.mission
    region = mission.generalisation.corners_in_space
    starts = np.random.default_rng(seed).uniform(*region, (flights, 5))
    starts[0] = mission.departure_state_in_space
    optima = solve_states(mission.problem, starts, region)
    began = time.process_time()
    flown = fly_in_space(networks, starts, reserve=reserve)
    seconds = time.process_time() - began
    return scores(flown, optima.time_of_flight, mission.flight.arrival_tolerance) | {
        "from the departure [TU], optimum [TU]": [float(flown.time[0]), float(optima.time_of_flight[0])],
        "processor time a flight [s]": seconds / flights,
    }


def scores(flown: FlightsInSpace, optima: Array, tolerance: float) -> dict[str, object]:
    """Of all flights; those without an optimum, or that do not arrive, count as such."""
    arrived = flown.ended & (flown.error <= tolerance)
    known = np.isfinite(optima)
    share = 100.0 * (flown.time / optima - 1.0)[arrived & known]
    first = arrived & (flown.time <= MISSED * optima)
    degrees = np.degrees(flown.turned)
    return {
        "flights": len(optima),
        "without an optimum": int((~known).sum()),
        "arrive [%]": 100.0 * float(arrived.mean()),
        "at the first approach [%]": 100.0 * float(first[known].mean()),
        "time over the optimum, of those that arrive: mean [%]": float(share.mean()),
        "median, 99 %, largest [%]": np.quantile(share, [0.5, 0.99, 1.0]).tolist(),
        "error where they end: median, 99 %, largest [AU, AU/TU]": np.quantile(
            flown.error, [0.5, 0.99, 1.0]
        ).tolist(),
        "the normal turns by: median, 99 % [degrees]": np.quantile(degrees, [0.5, 0.99]).tolist(),
        "in one period at most: median, 99 % [degrees]": np.degrees(
            np.quantile(flown.largest_turn, [0.5, 0.99])
        ).tolist(),
    }


def _told(value: object) -> str:
    if isinstance(value, list):
        return ", ".join(map(_told, value))
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def main() -> int:
    """Fly and write."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.flights_in_space",
        description=__doc__,
        epilog="example: python -m benchmarks.flights_in_space build/earth_mars_3d/networks --flights 1000",
    )
    parser.add_argument("networks", type=Path, help="folder of the four networks")
    parser.add_argument("--flights", type=int, default=1_000, help="(%(default)s)")
    parser.add_argument("--seed", type=int, default=2, help="of the starts (%(default)s)")
    parser.add_argument("--reserve", type=float, default=0.003, help="share of beta (%(default)s)")
    parser.add_argument("--json", action="store_true", help="print only")
    parser.add_argument("--output", type=Path, default=RESULTS, help="(%(default)s)")
    options = parser.parse_args()
    try:
        networks = load_guidance_networks_in_space(options.networks)
        measured = measure(networks, options.flights, options.seed, options.reserve)
        if options.json:
            print(json.dumps(measured))
            return 0
        origin, recipe = software(), networks.mission.dataset.wide
        lines = [
            f"Written by `python -m benchmarks.flights_in_space` on {origin['machine']}, {origin['date']}, "
            f"revision {origin['revision']}: networks of `{networks.mission.name}` (data of {recipe.levels} "
            f"sails, {recipe.starts} starts each; {networks.tau.provenance['epochs']} epochs), seed "
            f"{options.seed} of the starts, {100.0 * options.reserve:g} % of beta in reserve.",
            "",
            "| quantity | value |",
            "|---|---|",
            *(f"| {name} | {_told(value)} |" for name, value in measured.items()),
        ]
        fill_block(options.output, "flights", "\n".join(lines))
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())

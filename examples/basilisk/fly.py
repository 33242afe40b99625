"""Flights in Basilisk beside the same flights in sailnet's own plant.

    python fly.py --flights 10 --seed 2

Both have the same starts and the same flight file; of the dynamics they share no line.
"""

import argparse
import json
import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from point_mass import Flown, fly
from tqdm import tqdm

from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.flight import closed_loop
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.exported_c import CGuidance
from sailnet.mission.mission import load_mission

MISSION = "earth_mars"
"""Whose sail is an ideal one: Basilisk's facet has no other optics that are ours too."""

LIMIT = 1e-6
"""On the difference of the ends, in r [AU], u and v [AU/TU]."""

ORIGIN = (
    "Written by `python examples/basilisk/fly.py --flights {flights} --seed {seed} --text "
    "examples/basilisk/README.md` on {machine}, {date}, revision {revision}, Basilisk {basilisk}."
)
ROWS = {
    "flights": "{flights:,}",
    "arrive in Basilisk": "{arrived:,}",
    "arrive in our plant": "{ours:,}",
    "same verdict": "{same:,}",
    "as many commands": "{periods:,}",
    "ends within 1e-6 of each other": "{within:,}",
    "largest difference of the ends: r [AU], u, v [AU/TU]": "{largest}",
    "largest difference of the times [TU]": "{time:.1e}",
}


def main(arguments: list[str] | None = None) -> int:
    """Fly and compare; returns the exit status: 1 where a verdict, or an end by ``LIMIT``, differs."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--flights", type=int, default=10, help="from random starts (%(default)s)")
    parser.add_argument("--seed", type=int, default=2, help="of the starts (%(default)s)")
    parser.add_argument("--workers", type=int, default=1, help="processes (%(default)s)")
    parser.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    parser.add_argument("--text", type=Path, metavar="FILE", help="a text whose table is to be rewritten")
    options = parser.parse_args(arguments)
    mission = load_mission(MISSION)
    guidance = load_guidance(mission)
    assert isinstance(guidance, CGuidance)
    starts = random_starts(mission, options.flights, options.seed)
    with ProcessPoolExecutor(options.workers) as pool:
        bar = tqdm(total=options.flights, desc="flight", delay=2.0, file=sys.stderr, disable=None)
        one = partial(fly, guidance, beta=mission.sail.beta)
        flown = []
        for flight in pool.map(one, [tuple(start) for start in starts.tolist()]):
            flown.append(flight)
            bar.update()
        bar.close()
    found = compared(flown, closed_loop.fly(mission, guidance, starts))
    found |= {"flights": options.flights, "seed": options.seed, "basilisk": version("bsk")}
    if options.text is not None:
        largest = ", ".join(f"{difference:.1e}" for difference in found["ends"])
        told = {**software(), **found, "largest": largest}
        rows = [f"| {name} | {row.format(**told)} |" for name, row in ROWS.items()]
        fill_block(
            options.text, "basilisk", "\n".join([ORIGIN.format(**told), "", "| | |", "|---|---|", *rows])
        )
    print(
        json.dumps(found)
        if options.json
        else "\n".join(f"{name:10s} {value}" for name, value in found.items())
    )
    return int(found["same"] != options.flights or found["within"] != options.flights)


def compared(flown: list[Flown], ours: closed_loop.Flights) -> dict[str, Any]:
    """Verdicts, ends and times of both."""
    target = np.array(load_mission(MISSION).problem.target_state)
    tolerance = load_mission(MISSION).flight.arrival_tolerance
    ends = np.array([flight.end for flight in flown])
    arrived = np.array([flight.stopped for flight in flown]) & (np.abs(ends - target) <= tolerance).all(
        axis=1
    )
    apart = np.abs(ends - ours.ends)
    times = np.abs(np.array([flight.time_of_flight for flight in flown]) - ours.time_of_flight)
    periods = np.array([flight.periods for flight in flown])
    return {
        "arrived": int(arrived.sum()),
        "ours": int(ours.arrived.sum()),
        "same": int((arrived == ours.arrived).sum()),
        "periods": int((periods == ours.periods).sum()),
        "within": int((apart <= LIMIT).all(axis=1).sum()),
        "ends": apart.max(axis=0).tolist(),
        "time": float(times.max()),
        "worst": int(apart.max(axis=1).argmax()),
    }


if __name__ == "__main__":
    sys.exit(main())

"""``python -m sailnet.acceptance``: fly a set of networks through everything it has to stand.

Random starts of the generalisation set with the nominal sail, with a constant unknown error of beta, with
white noise on top, and with a slow drift; and the paper's two cases at several guidance periods.
"""

import argparse
import json
import os
import sys
import time
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from sailnet.artefacts.files import write_whole
from sailnet.artefacts.provenance import software
from sailnet.errors import SailnetError
from sailnet.expert.fastest import solve_states
from sailnet.flight.closed_loop import fly
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import Guidance
from sailnet.mission.disturbances import Disturbance, disturbance_from, switched_on
from sailnet.mission.mission import Mission, load_mission
from sailnet.montecarlo import Campaign, fly_campaign
from sailnet.physics.arrays import Array
from sailnet.report.paper import CASES
from sailnet.workers.executors import Workers, workers

CAMPAIGNS: Mapping[str, Mapping[str, float]] = {
    "nominal": {},
    "unknown bias": {"beta_spread": 0.15},
    "unknown bias and white noise": {"beta_spread": 0.15, "beta_noise": 0.15},
    "unknown bias and slow drift": {"beta_spread": 0.05, "beta_drift": -0.003},
}
"""Disturbances of beta; a drift of -0.003 a TU is 2 % a year."""

PERIODS = (0.001, 0.002, 0.005, 0.01, 0.02)
"""Guidance periods [TU] for which the cases are repeated, so that no lucky stop counts."""

CLOSE = 1e-4
"""A terminal error that is reported apart."""

GAP_QUANTILES = (0.5, 0.9, 0.99, 1.0)
"""Of the time of flight above the optimum."""

Record = dict[str, object]


def optimality_gap(mission: Mission, campaign: Campaign) -> Array:
    """Time of flight of the flights that arrived above the expert's optimum, relative to it."""
    flights = campaign.flights
    optima = solve_states(mission.problem, flights.starts, region=mission.generalisation.corners)
    gap = flights.time_of_flight / optima.time_of_flight - 1.0
    return np.asarray(gap[flights.arrived & optima.found])


def _campaign(
    mission: Mission, guidance: Guidance, flights: int, disturbance: Disturbance, name: str, pool: Workers
) -> Record:
    started = time.perf_counter()
    campaign = fly_campaign(mission, guidance, flights, disturbance, workers=pool, title=name)
    record: Record = {
        "name": name,
        "disturbance": switched_on(disturbance),
        "flights": flights,
        "arrived": campaign.arrived,
        "confidence_interval": list(campaign.confidence_interval),
        "share_within_1e-4": campaign.share_within(CLOSE),
        "error_quantiles": campaign.error_quantiles(),
        "attitude_violations": campaign.attitude_violations(mission.problem.phi_max),
        "flown_seconds": time.perf_counter() - started,
        "did_not_arrive": np.flatnonzero(~campaign.flights.arrived)[:100].tolist(),
    }
    if name == "nominal" and campaign.arrived:
        gap = optimality_gap(mission, campaign)
        record["gap_quantiles"] = {f"{q:g}": float(np.quantile(gap, q)) for q in GAP_QUANTILES}
        record["gap_flights"] = len(gap)
    return record


def _cases(mission: Mission, guidance: Guidance) -> list[Record]:
    records: list[Record] = []
    for name, start in CASES.items():
        for period in PERIODS:
            flight = fly(mission, guidance, [start], period=period)
            records.append(
                {
                    "case": name,
                    "period": period,
                    "terminal_error": flight.terminal_error[0].tolist(),
                    "time_of_flight": float(flight.time_of_flight[0]),
                }
            )
    return records


def accept(mission: Mission, guidance: Guidance, flights: int, seed: int, pool: Workers) -> Record:
    """Fly everything and return what came of it, ready for JSON."""
    return {
        "mission": mission.name,
        "networks": guidance.networks_digest,
        "seed": seed,
        "period": mission.flight.period,
        "campaigns": [
            _campaign(mission, guidance, flights, disturbance_from({**error, "seed": seed}), name, pool)
            for name, error in CAMPAIGNS.items()
        ],
        "cases": _cases(mission, guidance) if mission.name == "earth_mars" else [],
        "software": software(),
    }


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m sailnet.acceptance",
        description=__doc__,
        epilog="example: python -m sailnet.acceptance --flights 10000 --seed 2 --output acceptance.json",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--mission", default="earth_mars", help="mission name or TOML file (%(default)s)")
    parser.add_argument("--networks", type=Path, metavar="DIR", help="exported networks (default: shipped)")
    parser.add_argument("--precision", choices=("float64", "float32"), default="float64")
    parser.add_argument("--flights", type=int, default=10_000, help="of each campaign (%(default)s)")
    parser.add_argument("--seed", type=int, default=2, help="of starts and disturbances (%(default)s)")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="processes (default: all)")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="Dask scheduler whose workers fly instead")
    parser.add_argument("--output", type=Path, help="also write everything here, as JSON")
    parser.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    options = parser.parse_args()
    try:
        mission = load_mission(options.mission)
        guidance = load_guidance(mission, "c", options.precision, options.networks)
        with workers(options.workers, options.scheduler) as pool:
            result = accept(mission, guidance, options.flights, options.seed, pool)
        if options.output is not None:
            text = json.dumps(result, indent=1)
            write_whole(options.output, lambda beside: beside.write_text(text, encoding="utf-8"))
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print(json.dumps(result) if options.json else "\n".join(acceptance_table(result)))
    return 0


def acceptance_table(result: Mapping[str, object]) -> list[str]:
    """The lines of a Markdown table of what :func:`accept` returned."""
    lines = [
        "| flights | arrive within 1e-3 | within 1e-4 | median error (r, u, v) | 99 % error "
        "| time above optimum: median, 99 %, largest |",
        "|---|---|---|---|---|---|",
    ]
    campaigns, cases = result["campaigns"], result["cases"]
    assert isinstance(campaigns, list)
    assert isinstance(cases, list)
    for record in campaigns:
        low, high = record["confidence_interval"]
        gap = record.get("gap_quantiles")
        above = ", ".join(f"{100 * gap[q]:.3f} %" for q in ("0.5", "0.99", "1")) if gap else ""
        lines.append(
            f"| {record['flights']}, {record['name']} | {record['arrived']} "
            f"({100 * low:.2f} to {100 * high:.2f} %) | {100 * record['share_within_1e-4']:.2f} % "
            f"| {_triple(record['error_quantiles']['0.5'])} | {max(record['error_quantiles']['0.99']):.1e} "
            f"| {above} |"
        )
    if cases:
        head = "| case | period [TU] | terminal error (r, u, v) | time of flight [TU] |"
        lines += ["", head, "|---|---|---|---|"]
    lines += [
        f"| {case['case']} | {case['period']:g} | {_triple(case['terminal_error'])} "
        f"| {case['time_of_flight']:.5f} |"
        for case in cases
    ]
    return lines


def _triple(values: list[float]) -> str:
    return "(" + ", ".join(f"{value:.1e}" for value in values) + ")"


if __name__ == "__main__":
    sys.exit(main())

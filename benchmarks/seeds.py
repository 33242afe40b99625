"""``python -m benchmarks.seeds``: how far the results depend on the seed of the training.

Trains the wide networks from other seeds than the mission's, exports and flies them, prints the spread.
"""

import argparse
import json
import os
import sys
from pathlib import Path
from typing import Any

from export.write import export
from sailnet.artefacts.files import write_whole
from sailnet.campaign.acceptance import CAMPAIGN
from sailnet.campaign.plan import load_plan
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import score_record, scores_of
from sailnet.campaign.tables import percent
from sailnet.dataset import open_dataset
from sailnet.errors import SailnetError
from sailnet.guidance.backends import load_guidance
from sailnet.workers.executors import Workers, workers
from training.parallel import train_networks
from training.targets import TARGETS


def measure(
    dataset: Path, folder: Path, seed: int, flights: int, flight_seed: int, pool: Workers
) -> dict[str, Any]:
    """Train from one seed (or take up what an earlier call finished), export, fly."""
    with open_dataset(dataset) as data:
        mission = data.mission.with_training(seed=seed)
    networks = train_networks(
        dataset, mission, "wide", list(TARGETS["wide"]), folder, workers=os.cpu_count() or 1, resume=True
    )
    export(folder, folder / "export", mission, progress=False)
    guidance = load_guidance(mission, "c", "float64", folder / "export")
    plan = load_plan(CAMPAIGN).changed(flights, flight_seed)
    results = fly_plan(mission, guidance, plan, folder / f"{CAMPAIGN}.h5", workers=pool, overwrite=True)
    return {
        "seed": seed,
        "test_mse": {network.name: network.provenance["test_mse"] for network in networks},
        "acceptance": [score_record(score) for score in scores_of(results)],
    }


def table(records: list[dict[str, Any]]) -> list[str]:
    """A line a seed."""
    lines = [
        "| seed | test MSE tau, alpha_pre, lambda_v | nominal: mean above own optimum, 99 %, first approach "
        "| arrived, within 1e-4 | bias | bias and noise | drift | Case 1, 2: largest error |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for record in records:
        nominal, bias, noisy, drift = record["acceptance"][:4]
        above = nominal["time_above_own_optimum"]
        close = 100 * nominal["within"]["0.0001"] / nominal["flights"]
        worst = [
            max(score["error_quantiles"]["1"] for score in record["acceptance"] if score["series"] == name)
            for name in ("Case 1", "Case 2")
        ]
        lines.append(
            f"| {record['seed']} | {', '.join(f'{value:.1e}' for value in record['test_mse'].values())} "
            f"| {percent(above['mean'])}, {percent(above['0.99'])}, {nominal['first_approach']} "
            f"| {nominal['arrived']} of {nominal['flights']}, {close:.2f} % "
            f"| {bias['arrived']} | {noisy['arrived']} | {drift['arrived']} "
            f"| {worst[0]:.1e}, {worst[1]:.1e} |"
        )
    return lines


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.seeds",
        description=__doc__,
        epilog="example: python -m benchmarks.seeds build/earth_mars/wide.h5 build/earth_mars/seeds",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("dataset", type=Path, help="the wide data set")
    parser.add_argument("folder", type=Path, help="for the networks of each seed, and spread.json")
    parser.add_argument("--seeds", type=int, nargs="+", default=[11, 12, 13, 14, 15], help="(%(default)s)")
    parser.add_argument("--flights", type=int, default=10_000, help="of each campaign (%(default)s)")
    parser.add_argument("--flight-seed", type=int, default=2, help="of starts and disturbances (%(default)s)")
    options = parser.parse_args()
    try:
        with workers(os.cpu_count() or 1) as pool:
            records = [
                measure(
                    options.dataset,
                    options.folder / f"seed{seed}",
                    seed,
                    options.flights,
                    options.flight_seed,
                    pool,
                )
                for seed in options.seeds
            ]
        text = json.dumps(records, indent=1)
        write_whole(options.folder / "spread.json", lambda beside: beside.write_text(text, encoding="utf-8"))
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print("\n".join(table(records)))
    return 0


if __name__ == "__main__":
    sys.exit(main())

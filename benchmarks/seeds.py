"""``python -m benchmarks.seeds``: how far the results depend on the seed of the training.

Trains the wide networks from other seeds than the mission's, exports them, flies the campaign `law` with
each, and writes what every seed gives, and the worst row of all, into texts, between marks.
"""

import argparse
import json
import os
import sys
from pathlib import Path
from typing import Any

from export.write import export
from sailnet.artefacts.files import fill_block, write_text
from sailnet.artefacts.provenance import software
from sailnet.campaign.plan import load_plan
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import score_record, scores_of
from sailnet.campaign.tables import Table
from sailnet.dataset import open_dataset
from sailnet.errors import SailnetError
from sailnet.guidance.backends import load_guidance
from sailnet.mission.mission import Mission, load_mission
from sailnet.workers.executors import Workers, workers
from training.fit_domain import ensure_domain
from training.parallel import train_networks
from training.targets import TARGETS

CAMPAIGN = "law"

RESULTS = f"{CAMPAIGN}.h5"

MARK = "seeds"


def measure(
    dataset: Path,
    folder: Path,
    seed: int,
    flights: int,
    pool: Workers,
    *,
    flown: Mission | None = None,
    optima: Path | None = None,
) -> dict[str, Any]:
    """Train from one seed (or take up what an earlier call finished), export, fly.

    Args:
        dataset: the wide data set.
        folder: for networks, export and results.
        seed: of the training.
        flights: of a series.
        pool: who flies.
        flown: the mission whose recipe trains and whose law flies; that of the data set where none is given.
        optima: results of the same flights with the networks of another seed.
    """
    with open_dataset(dataset) as data:
        mission = (flown or data.mission).with_training(seed=seed)
    networks = train_networks(
        dataset, mission, "wide", list(TARGETS["wide"]), folder,
        resume=True, overwrite=True,
    )  # fmt: skip
    ensure_domain(networks, dataset, folder)
    export(folder, folder / "export", mission, progress=False)
    guidance = load_guidance(mission, "c", "float64", folder / "export")
    plan = load_plan(CAMPAIGN).changed(flights, None)
    stored = folder / RESULTS
    results = fly_plan(mission, guidance, plan, stored, workers=pool, overwrite=True, optima=optima)
    return {
        "seed": seed,
        "test_mse": {network.name: network.provenance["test_mse"] for network in networks},
        CAMPAIGN: [score_record(score) for score in scores_of(results)],
    }


def known(score: dict[str, Any]) -> int:
    """Flights whose optimum is known: of the others nobody can say that they were late."""
    return int(score["flights"] - score["own_optimum_unknown"])


def missed(score: dict[str, Any]) -> int:
    """Of these, flights that are not home at the first approach."""
    return known(score) - int(score["first_approach"])


def table(records: list[dict[str, Any]]) -> list[str]:
    """What the networks of every seed do: a line a series, the numbers of the seeds side by side."""
    seeds = ", ".join(str(record["seed"]) for record in records)
    errors = "; ".join(
        ", ".join(f"{value:.1e}" for value in record["test_mse"].values()) for record in records
    )
    lines = [
        f"Seeds {seeds}, {records[0][CAMPAIGN][0]['flights']:,} flights a series. "
        f"Test MSE of tau, alpha_pre, lambda_v: {errors}.",
        "",
    ]
    rows = []
    for scores in zip(*(record[CAMPAIGN] for record in records), strict=True):
        cells = [
            [str(score["flights"] - score["arrived"]) for score in scores],
            [str(missed(score)) for score in scores],
            [f"{100.0 * score['time_above_own_optimum']['mean']:.3g}" for score in scores],
            [f"{score['reversals']['0.99']:.0f}" for score in scores],
        ]
        rows.append([scores[0]["series"], *map(", ".join, cells)])
    heads = ["series", "do not arrive", "not home at the first approach"]
    heads += ["mean above own optimum [%]", "reversals, 99 %"]
    return [*lines, *Table("", heads, rows).markdown()]


def headline(records: list[dict[str, Any]]) -> str:
    """The worst row of all seeds: that of the most flights that are not home at the first approach."""
    rows = [(record["seed"], score) for record in records for score in record[CAMPAIGN]]
    seed, worst = max(rows, key=lambda row: missed(row[1]))
    above = max(100.0 * score["time_above_own_optimum"]["mean"] for _, score in rows)
    arrived = min(score["arrived"] / score["flights"] for _, score in rows)
    seeds = ", ".join(str(record["seed"]) for record in records)
    return (
        f"The worst row of {len(records)} other trainings (seeds {seeds}; campaign `{CAMPAIGN}`, "
        f"{worst['flights']:,} flights a series): "
        f"{100 * arrived:.2f} % arrive, {100 * (1 - missed(worst) / known(worst)):.2f} % at the "
        f"first approach ({worst['series']}, seed {seed}), mean at most {above:.2f} % above the own optimum."
    )


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
    parser.add_argument("--mission", help="whose training and law, where the data set has older ones")
    parser.add_argument("--seeds", type=int, nargs="+", default=[7, 11, 12, 13, 15], help="(%(default)s)")
    parser.add_argument("--flights", type=int, default=10_000, help="of a series (%(default)s)")
    parser.add_argument("--text", type=Path, help=f"file with marks <!-- {MARK} --> for the table")
    parser.add_argument("--headline", type=Path, help="file with such marks for the worst row")
    options = parser.parse_args()
    try:
        flown = load_mission(options.mission) if options.mission else None
        with workers(os.cpu_count() or 1) as pool:
            records: list[dict[str, Any]] = []
            optima: Path | None = None
            for seed in options.seeds:
                folder = options.folder / f"seed{seed}"
                records.append(
                    measure(options.dataset, folder, seed, options.flights, pool, flown=flown, optima=optima)
                )
                optima = folder / RESULTS
        text = json.dumps(records, indent=1)
        write_text(options.folder / "spread.json", text)
        made = software()
        lines = [*table(records), "", f"{made['machine']}, {made['date']}, revision {made['revision']}."]
        if options.text:
            fill_block(options.text, MARK, "\n".join(lines))
        if options.headline:
            fill_block(options.headline, MARK, headline(records))
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print("\n".join([*lines, "", headline(records)]))
    return 0


if __name__ == "__main__":
    sys.exit(main())

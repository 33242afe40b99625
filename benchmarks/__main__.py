"""``python -m benchmarks``: measure, and write what was measured into ``benchmarks/RESULTS.md``."""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from benchmarks import expert, flights, generation, training
from sailnet.artefacts.provenance import software
from sailnet.mission.mission import load_mission

RESULTS = Path(__file__).parent / "RESULTS.md"


def _coverage(recipe: str, starts: int, seed: int) -> dict[str, object]:
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "dataset.h5")
        subprocess.run([sys.executable, "-m", "data", path, "--recipe", recipe, "--quiet"], check=True)
        arguments = [path, "--starts", str(starts), "--seed", str(seed), "--json"]
        run = [sys.executable, "-m", "data.coverage", *arguments]
        text = subprocess.run(run, check=True, capture_output=True, text=True).stdout
    result: dict[str, object] = json.loads(text)
    del result["dataset"]
    return result


def _training(seed: int, limit: float) -> str:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "dataset.h5"
        subprocess.run([sys.executable, "-m", "data", str(path), "--recipe", "box", "--quiet"], check=True)
        measured = training.measure(path, seed, limit)
    return "\n".join(["## Training, a network a core", "", training.NOTE, "", training.table(measured), ""])


def _table(title: str, note: str, values: dict[str, object]) -> str:
    rows = []
    for key, value in values.items():
        if isinstance(value, dict):
            value = ", ".join(f"{name}: {_short(entry)}" for name, entry in value.items())
        rows.append(f"| {key.replace('_', ' ')} | {_short(value)} |")
    return "\n".join([f"## {title}", "", note, "", "| quantity | value |", "|---|---|", *rows, ""])


def _short(value: object) -> str:
    if isinstance(value, list):
        return " to ".join(_short(entry) for entry in value)
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def main() -> int:
    """Run everything; some twenty minutes."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("--states", type=int, default=10_000, help="for the expert (%(default)s)")
    parser.add_argument("--peers", type=int, default=100, help="of them for fsolve (%(default)s)")
    parser.add_argument("--starts", type=int, default=1000, help="for the coverage (%(default)s)")
    parser.add_argument("--flights", type=int, default=10_000, help="of a campaign (%(default)s)")
    parser.add_argument("--training", type=float, default=180.0, help="seconds a network (%(default)s)")
    parser.add_argument("--seed", type=int, default=2, help="of every random number (%(default)s)")
    parser.add_argument("--output", type=Path, default=RESULTS, help="(%(default)s)")
    options = parser.parse_args()
    mission = load_mission("earth_mars")
    origin = software()
    parts = [
        "# Measured",
        "",
        f"Written by `python -m benchmarks` (`make benchmarks`) on {origin['machine']}, "
        f"{os.cpu_count()} cores, {origin['date']}, revision {origin['revision']}, "
        f"seed {options.seed}. The machine is shared: "
        "ratios within a table say more than times.",
        "",
        _table(
            "The expert, random states of the generalisation set, one core",
            "`fsolve` shoots with DOP853 in plain Python from a guess 1e-3 off in the arrival direction and "
            "0.01 TU in time; the expert finds its own.",
            {**expert.measure(mission, options.states, options.peers, options.seed)},
        ),
        _table(
            "Generation of the paper's box, microseconds a trajectory (351 samples, 10 TU), one core",
            "The same costates for all. `generated` includes jump events, the command and its preprocessing, "
            "not storage; `bare heyoka` has no events and throws its samples away; DOP853 at the same "
            "tolerance, its equations in plain floats or written with arrays. `aimed with expert` is a "
            "trajectory of the domain recipe, expert included.",
            {**generation.measure(mission, 12, options.seed)},
        ),
        _table(
            "The whole command, paper's box, all cores",
            "`python -m data --recipe box`: start-up, nominal, propagation, checksums, storage.",
            {**generation.command("box", 18_324)},
        ),
        _table(
            "The whole command, domain, all cores",
            "`python -m data`: start-up, index, expert, propagation, checksums, storage.",
            {**generation.command("domain", 20_000)},
        ),
    ]
    parts.append(
        _table(
            "Closed-loop flights: whole campaigns on all cores, and nanoseconds a guidance period on one",
            flights.NOTE,
            flights.measure(mission, options.flights, options.seed),
        )
    )
    parts.append(_training(options.seed, options.training))
    for recipe in ("domain", "box"):
        parts.append(
            _table(
                f"Coverage of the data set, recipe {recipe}",
                "Share of fresh random starts of the generalisation set whose whole optimal trajectory lies "
                "within a distance (largest difference in r [AU], u, v [AU/TU]) of samples, 95 % intervals.",
                _coverage(recipe, options.starts, options.seed),
            )
        )
    options.output.write_text("\n".join(parts))
    print(options.output.read_text())
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""``python -m sailnet.report``: fly Section 5 and write the page."""

import argparse
import json
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from tqdm import tqdm

from sailnet.artefacts.files import write_whole
from sailnet.artefacts.provenance import software
from sailnet.dataset import JUMP_FLAG, Dataset, open_dataset
from sailnet.errors import SailnetError
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.onnx_graphs import OnnxGuidance
from sailnet.mission.mission import Mission, load_mission
from sailnet.networks.network import Network, load_network
from sailnet.physics.arrays import Array
from sailnet.report import comparison, figures
from sailnet.report.evaluation import Section5, fly_section5
from sailnet.report.page import Picture, write_page
from sailnet.report.reproduction import FILE, reproduction_record

NETWORKS = ("tau", "lambda_v", "alpha_pre", "lambda_v_printed", "alpha_pre_eq23", "alpha")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m sailnet.report",
        description="Fly Section 5 of the paper with the exported networks and write the report.",
        epilog="example: python -m sailnet.report --build build/earth_mars --dataset build/earth_mars/box.h5 "
        "--output build/earth_mars/report",
    )
    parser.add_argument("--mission", default="earth_mars", help="mission name or TOML file (%(default)s)")
    parser.add_argument("--build", type=Path, required=True, help="folder with networks/ and export/")
    parser.add_argument("--dataset", type=Path, required=True, help="what the networks learned from")
    parser.add_argument(
        "--output", type=Path, required=True, help="folder for index.html, report.json and reproduction.json"
    )
    parser.add_argument(
        "--flights", type=int, default=1000, help="flights of the larger campaign (%(default)s)"
    )
    parser.add_argument("--seed", type=int, default=2, help="of noise and random starts (%(default)s)")
    return parser


def _example_of_a_jump(data: Dataset) -> tuple[dict[str, Array], float]:
    """The first trajectory of the data set that jumps."""
    columns = data.read_trajectories(["flags", "jump_time"])
    row = int(np.flatnonzero(columns["flags"].astype(int) & JUMP_FLAG)[0])
    names = ["tau", "lambda_u", "lambda_v", "alpha", "alpha_pre"]
    samples = data.read(names, int(data.first_sample[row]), int(data.first_sample[row + 1]))
    return samples, float(columns["jump_time"][row])


def _histories(networks: Iterable[str], folder: Path) -> dict[str, Any]:
    return {
        name: json.loads((folder / f"{name}.history.json").read_text(encoding="utf-8"))["epochs"]
        for name in networks
    }


def _write_json(path: Path, content: object, indent: int | None = None) -> None:
    text = json.dumps(content, indent=indent, ensure_ascii=False)
    write_whole(path, lambda beside: beside.write_text(text, encoding="utf-8"))


def _pictures(
    mission: Mission, section5: Section5, data: Dataset, networks: dict[str, Network], folder: Path
) -> list[Picture]:
    cases, noise = section5.three, section5.noise
    samples, jump_time = _example_of_a_jump(data)
    first = cases["Case 1"]
    inputs = np.column_stack([first.history.ruv, first.history.predicted_time_of_flight])
    histories = _histories(networks, folder)
    drawn = [
        (
            "trajectories",
            "Trajectories",
            "Case 1 and Case 2 of Table 2, and a flight with ±15 % white noise on β (Figs 9, 11 and 12).",
            figures.trajectories(
                mission,
                {name: (flown.history, flown.optimum) for name, flown in cases.items()}
                | {"β noise ±15 %": (noise.history, noise.optimum)},
            ),
        ),
        (
            "commands",
            "Commanded cone angle against the optimum",
            "Dashed: the bound ±φ_max. Two networks fly without preprocessing (Figs 8c, 8d, 10 and 13).",
            figures.commands(
                mission,
                {
                    name: (flown.history, section5.two[name].history, flown.optimum)
                    for name, flown in cases.items()
                }
                | {"β noise ±15 %": (noise.history, None, None)},
            ),
        ),
        (
            "predictions",
            "What the networks predict along Case 1",
            "Left: τ. Right: λ_v by the network of Table 1; the one that flies gives its sign (Figs 8a, 8b).",
            figures.predictions(first.history, networks["lambda_v_printed"](inputs), first.optimum),
        ),
        (
            "jump",
            "The jump and its preprocessing",
            "λ_v crosses zero while λ_u > 0 (dashed): the cone angle jumps; Eq. (23) removes the jump by a "
            "change of sign, |α| by forgetting it (Figs 4 and 5).",
            figures.jump(samples["tau"], samples, jump_time),
        ),
        (
            "training",
            "Training",
            "Levenberg-Marquardt; each network's error on training and validation samples (Fig. 7).",
            figures.training(histories),
        ),
        (
            "campaign",
            f"{len(section5.campaign.flights.arrived)} flights from random starts",
            "Starts of the generalisation set (Section 5.3, Fig. 14); dashed: the tolerance for arrival.",
            figures.campaign(mission, section5.campaign.flights),
        ),
    ]
    return [Picture(name, title, caption, figures.to_svg(figure)) for name, title, caption, figure in drawn]


def _facts(section5: Section5) -> list[tuple[str, str]]:
    campaign, case = section5.campaign, section5.three["Case 1"]
    late = case.time_of_flight - case.extremal.time_of_flight
    return [
        (f"{100 * campaign.success_share:.1f} %", f"of {len(campaign.flights.arrived)} random starts arrive"),
        (f"{max(case.error):.1e}", "largest component of ΔΦ, Case 1"),
        (f"{1e3 * late:+.1f} mTU", "Case 1, flight time against the optimum"),
        (f"{int(section5.generalisation.arrived.sum())} of 30", "paper-style random flights (paper: 20)"),
    ]


def _optional(path: Path) -> Any:
    """Content of a JSON file that a shorter run leaves out."""
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def _run(options: argparse.Namespace) -> None:
    mission = load_mission(options.mission)
    folder = options.build / "networks"
    names = [name for name in NETWORKS if (folder / f"{name}.safetensors").exists()]
    networks = {name: load_network(folder / f"{name}.safetensors") for name in names}
    guidance = load_guidance(mission, "c", "float64", options.build / "export")
    baseline = OnnxGuidance(mission, options.build / "export" / "baseline_f64.onnx")
    timings, agreement = _optional(options.build / "bench.json"), _optional(options.build / "agreement.json")
    with tqdm(total=3, desc="report", file=sys.stderr, disable=None) as bar:
        section5 = fly_section5(mission, guidance, baseline, options.seed, options.flights)
        bar.update()
        with open_dataset(options.dataset, mission) as data:
            rows = [
                *comparison.problem_rows(data),
                *comparison.error_rows(networks),
                *comparison.flight_rows(section5),
                *comparison.timing_rows(timings),
                *comparison.agreement_rows(agreement),
            ]
            pictures = _pictures(mission, section5, data, networks, folder)
            digest = data.digest
        bar.update()
        made_with = software()
        write_page(
            options.output / "index.html",
            pictures,
            mission=mission,
            facts=_facts(section5),
            rows=rows,
            section5=section5,
            timings=timings,
            dataset_digest=digest,
            software=made_with,
        )
        table = {"rows": [vars(row) for row in rows], "software": made_with, "seed": options.seed}
        _write_json(options.output / "report.json", table, 1)
        record = reproduction_record(
            networks,
            _histories(networks, folder),
            section5.three["Case 1"],
            section5.two["Case 1"],
            made_with,
        )
        _write_json(options.output / FILE, record)
        bar.update()
    print("\n".join(comparison.comparison_lines(rows)))


def main() -> int:
    """Run the command; returns the exit status."""
    try:
        _run(_parser().parse_args())
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""``python -m sailnet.report``: the paper's Section 5 by networks of its recipe, beside what it prints."""

import argparse
import json
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from sailnet.artefacts.files import write_text
from sailnet.artefacts.provenance import software
from sailnet.campaign.plan import load_plan
from sailnet.campaign.run import fly_plan
from sailnet.dataset import open_dataset
from sailnet.errors import SailnetError
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.onnx_graphs import OnnxGuidance
from sailnet.mission.mission import load_mission
from sailnet.networks.network import load_network
from sailnet.report import comparison, need_pictures
from sailnet.report.campaign_page import write_report
from sailnet.report.reproduction import FILE, Reproduction, reproduction_record
from sailnet.report.section5 import every_period, flown_cases, section5_of, two_network_plan
from sailnet.workers.interruption import run_command

NETWORKS = ("tau", "lambda_v", "alpha_pre", "lambda_v_printed", "alpha_pre_eq23", "alpha")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m sailnet.report",
        description="Fly the campaign `paper` with exported networks of the paper's recipe, its cases by two "
        "networks too, and write the page.",
        epilog="example: python -m sailnet.report --build build/earth_mars/box --dataset "
        "build/earth_mars/box.h5 --output build/earth_mars/box/report",
    )
    parser.add_argument("--mission", default="earth_mars", help="mission name or TOML file (%(default)s)")
    parser.add_argument("--build", type=Path, required=True, help="folder with networks/ and export/")
    parser.add_argument("--dataset", type=Path, required=True, help="what the networks learned from")
    parser.add_argument(
        "--output", type=Path, required=True, help="folder for index.html, report.json and reproduction.json"
    )
    parser.add_argument("--flights", type=int, metavar="N", help="random starts (default: 1000)")
    parser.add_argument("--seed", type=int, default=2, help="of noise and random starts (%(default)s)")
    parser.add_argument("--restart", action="store_true", help="throw away what was flown before")
    parser.add_argument(
        "--overwrite", action="store_true", help="replace flights of other networks, or of another seed"
    )
    return parser


def _histories(networks: Iterable[str], folder: Path) -> dict[str, Any]:
    return {
        name: json.loads((folder / f"{name}.history.json").read_text(encoding="utf-8"))["epochs"]
        for name in networks
    }


def _write_json(path: Path, content: object, indent: int | None = None) -> None:
    text = json.dumps(content, indent=indent, ensure_ascii=False)
    write_text(path, text)


def _optional(path: Path) -> Any:
    """Content of a JSON file that a shorter run leaves out."""
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def _remarks(dataset: str, timings: Any) -> list[str]:
    remarks = [f"The networks learned from data set {dataset[:16]}."]
    if timings is not None:
        remarks.append(
            f"Times of a command: all in one run on one machine, {timings['machine']}, {timings['date']}, "
            f"{timings['compiler']}, {timings['flags']}."
        )
    return remarks


def _run(options: argparse.Namespace) -> None:
    need_pictures()
    mission = load_mission(options.mission)
    plan = load_plan("paper").changed(options.flights, options.seed)
    folder, output = options.build / "networks", options.output
    anew = {"restart": options.restart, "overwrite": options.overwrite}
    names = [name for name in NETWORKS if (folder / f"{name}.safetensors").exists()]
    networks = {name: load_network(folder / f"{name}.safetensors") for name in names}
    guidance = load_guidance(mission, "c", "float64", options.build / "export")
    baseline = OnnxGuidance(mission, options.build / "export" / "baseline_f64.onnx")
    timings, agreement = _optional(options.build / "bench.json"), _optional(options.build / "agreement.json")
    results = fly_plan(mission, guidance, plan, output / f"{plan.name}.h5", **anew)
    cases = two_network_plan(plan)
    two_results = fly_plan(mission, baseline, cases, output / f"{cases.name}.h5", **anew)
    section5, two = section5_of(results), flown_cases(two_results)
    with open_dataset(options.dataset, mission) as data:
        rows = [
            *comparison.problem_rows(data),
            *comparison.error_rows(networks),
            *comparison.flight_rows(section5, two),
            *comparison.timing_rows(timings),
            *comparison.agreement_rows(agreement),
        ]
        digest = data.digest
    made_with = software()
    name = "Case 1"
    three = every_period(results, name, section5.cases[name], guidance)
    without = every_period(two_results, name, two[name], baseline)
    record = reproduction_record(networks, _histories(names, folder), three, without, made_with)
    table = {"rows": [vars(row) for row in rows], "software": made_with, "seed": options.seed}
    _write_json(output / "report.json", table, 1)
    _write_json(output / FILE, record)
    reproduction = Reproduction(section5, rows, record, _remarks(digest, timings))
    write_report(results, output, guidance, command="make paper", reproduction=reproduction)
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
    sys.exit(run_command(main, "the same command goes on"))

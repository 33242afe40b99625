"""``python -m export.ship``: make a finished run the networks that come with the package.

Copies the weights, exports them into the package, and writes their model card and the tables of results
from the files of the run: no figure is typed by hand.
"""

import argparse
import json
import shutil
import sys
from functools import partial
from pathlib import Path
from typing import Any

from export.errors import ExportError
from export.model_card import TRIO, Facts, accepted_by, made_by, model_card
from export.picture import draw_departure
from export.write import export
from sailnet import SailnetError, load_mission
from sailnet.artefacts.files import fill_block, write_text, write_whole
from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.campaign.acceptance import CAMPAIGN, acceptance_table, headline_table
from sailnet.campaign.results import open_results
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_networks import load_guidance_networks
from sailnet.workers.interruption import run_command

REPRODUCTION = "reproduction.json"
"""What the page of the paper's campaign draws of `make paper`; its report leaves it beside its table."""


def _paper_table(report: Facts) -> str:
    lines = ["| quantity | paper | here | |", "|---|---|---|---|"]
    for row in report["rows"]:
        cells = [str(row[key]).replace("|", "&#124;") for key in ("quantity", "paper", "here", "note")]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _read(path: Path, command: str) -> Any:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ExportError(f"{path} is missing or damaged: {error}; run {command} first") from error


def ship(
    build: Path,
    package: Path,
    mission: Mission,
    readme: Path | None = None,
    results: Path | None = None,
    paper: Path | None = None,
    picture: Path | None = None,
) -> None:
    """Fill ``package`` from the run in ``build``, and the tables of two texts if they are given.

    Args:
        build: folder with networks/, acceptance.h5, bench.json and agreement.json.
        package: where the networks, what is exported from them and their model card go.
        mission: whose rules of flight are built in.
        readme: file whose block ``summary`` is written anew: a few rows.
        results: file whose blocks ``acceptance MISSION`` and, with ``paper``, ``paper`` are written anew.
        paper: report.json of a reproduction of the paper; reproduction.json beside it is shipped too.
        picture: PNG of the flight from the mission's departure orbit.

    Raises:
        SailnetError: the run is incomplete, or not this mission's.
    """
    accepted = open_results(build / f"{CAMPAIGN}.h5")
    if accepted.mission.digest() != mission.digest():
        raise ExportError(f"{build} was flown for mission {accepted.mission.name!r}: run make accept again")
    timings, agreement = (_read(build / f"{name}.json", "make bench") for name in ("bench", "agreement"))
    folder = build / "networks"
    networks = load_guidance_networks(folder)
    export(folder, package, mission)
    for name in TRIO:
        source = folder / f"{name}.safetensors"
        write_whole(package / source.name, partial(shutil.copyfile, source))
    card = model_card(networks, accepted, timings, agreement)
    write_text(package / "MODEL_CARD.md", card)
    origin = accepted_by(accepted)
    if readme is not None:
        fill_block(readme, "summary", "\n".join([origin, "", *headline_table(accepted)]))
    if results is not None:
        fill_block(
            results, f"acceptance {mission.name}", "\n".join([origin, "", *acceptance_table(accepted)])
        )
    if paper is not None:
        report = _read(paper, "make paper")
        if results is not None:
            made = made_by("make paper", report["software"], report["seed"])
            fill_block(results, "paper", "\n".join([made, "", _paper_table(report)]))
        curves = paper.parent / REPRODUCTION
        if curves.exists():
            write_whole(package / curves.name, partial(shutil.copyfile, curves))
    if picture is not None:
        draw_departure(picture, mission, package)


def main() -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m export.ship",
        description=__doc__,
        epilog="example: python -m export.ship build/earth_mars/wide sailnet/shipped/earth_mars",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("build", type=Path, help="folder of a finished run")
    parser.add_argument("package", type=Path, help="folder in the package")
    parser.add_argument("--mission", default="earth_mars", help="mission name or TOML file (%(default)s)")
    parser.add_argument("--readme", type=Path, help="also write a few rows of results into this file")
    parser.add_argument("--results", type=Path, help="and the whole tables into this one")
    parser.add_argument("--paper", type=Path, help="and those of this report.json, of `make paper`")
    parser.add_argument("--picture", type=Path, help="also draw the flight from the departure orbit: a PNG")
    options = parser.parse_args()
    try:
        mission = load_mission(options.mission)
        with sole_owner(options.package / LOCK, f"networks in {options.package}", ExportError):
            ship(
                options.build, options.package, mission,
                options.readme, options.results, options.paper, options.picture,
            )  # fmt: skip
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

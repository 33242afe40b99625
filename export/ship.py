"""``python -m export.ship``: make a finished run the networks that come with the package.

Copies the weights, exports them into the package, and writes their model card and the README's tables
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
from export.model_card import TRIO, Facts, made_by, model_card
from export.write import export
from sailnet import SailnetError, load_mission
from sailnet.acceptance import acceptance_table
from sailnet.artefacts.files import fill_block, write_whole
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_networks import load_guidance_networks

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


def ship(build: Path, package: Path, mission: Mission, readme: Path | None, paper: Path | None) -> None:
    """Fill ``package`` from the run in ``build``, and the README's results if it is given.

    Args:
        build: folder with networks/, acceptance.json, bench.json and agreement.json.
        package: where the networks, what is exported from them and their model card go.
        mission: whose rules of flight are built in.
        readme: file whose blocks ``results`` and, with ``paper``, ``paper`` are written anew.
        paper: report.json of a reproduction of the paper; reproduction.json beside it is shipped too.

    Raises:
        ExportError: the run is incomplete.
    """
    acceptance = _read(build / "acceptance.json", "make")
    timings, agreement = (_read(build / f"{name}.json", "make bench") for name in ("bench", "agreement"))
    folder = build / "networks"
    networks = load_guidance_networks(folder)
    export(folder, package, mission)
    for name in TRIO:
        source = folder / f"{name}.safetensors"
        write_whole(package / source.name, partial(shutil.copyfile, source))
    card = model_card(networks, acceptance, timings, agreement)
    write_whole(package / "MODEL_CARD.md", lambda beside: beside.write_text(card, encoding="utf-8"))
    if readme is not None:
        fill_block(
            readme, "results", "\n".join([made_by("make", acceptance), "", *acceptance_table(acceptance)])
        )
        if paper is not None:
            report = _read(paper, "make paper")
            fill_block(readme, "paper", "\n".join([made_by("make paper", report), "", _paper_table(report)]))
            curves = paper.parent / REPRODUCTION
            if curves.exists():
                write_whole(package / curves.name, partial(shutil.copyfile, curves))


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
    parser.add_argument("--readme", type=Path, help="also write the results into this file")
    parser.add_argument("--paper", type=Path, help="and those of this report.json, of `make paper`")
    options = parser.parse_args()
    try:
        ship(options.build, options.package, load_mission(options.mission), options.readme, options.paper)
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""What ``python -m export.ship`` does."""

import json
import shutil
from functools import partial
from pathlib import Path
from typing import Any

from export.errors import ExportError
from export.model_card import Facts, accepted_by, made_by, model_card
from export.picture import draw_departure
from export.write import export
from sailnet.artefacts.files import fill_block, write_text, write_whole, writing
from sailnet.campaign.acceptance import CAMPAIGN, summary_table
from sailnet.campaign.criteria import criteria_of, missed
from sailnet.campaign.results import open_results
from sailnet.campaign.scores import scores_of
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_in_space import load_networks_of
from sailnet.networks.known_plans import FILE
from sailnet.networks.plan_networks import load_plan_networks

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


def _copy(source: Path, package: Path) -> None:
    with writing(package / source.name, ExportError):
        write_whole(package / source.name, partial(shutil.copyfile, source), size=source.stat().st_size)


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
        readme: file whose block ``summary`` is written anew: a few rows of what the model card has.
        results: file whose blocks ``acceptance MISSION``, the same rows, and, with ``paper``, ``paper`` are
            written anew.
        paper: report.json of a reproduction of the paper; reproduction.json beside it is shipped too.
        picture: PNG of the flight from the mission's departure orbit.

    Raises:
        SailnetError: the run is incomplete, not this mission's, or misses an acceptance criterion.
    """
    accepted = open_results(build / f"{CAMPAIGN}.h5")
    if accepted.mission.digest() != mission.digest():
        raise ExportError(f"{build} was flown for mission {accepted.mission.name!r}: run make accept again")
    if failed := missed(criteria_of(mission.acceptance, scores_of(accepted))):
        raise ExportError(f"not released, a criterion is missed: {'; '.join(map(str, failed))}")
    timings, agreement = (_read(build / f"{name}.json", "make bench") for name in ("bench", "agreement"))
    folder = build / "networks"
    networks, plan = load_networks_of(mission, folder), load_plan_networks(folder, mission)
    export(folder, package, mission)
    for network in (*networks.all, *(() if plan is None else plan.all)):
        _copy(folder / f"{network.name}.safetensors", package)
    (package / FILE).unlink(missing_ok=True)
    if plan is not None and plan.known is not None:
        _copy(folder / FILE, package)
    card = model_card(networks, accepted, timings, agreement, plan)
    with writing(package / "MODEL_CARD.md", ExportError):
        write_text(package / "MODEL_CARD.md", card)
    origin = accepted_by(accepted)
    summary = "\n".join([origin, "", *summary_table(accepted)])
    if readme is not None:
        fill_block(readme, "summary", summary)
    if results is not None:
        fill_block(results, f"acceptance {mission.name}", summary)
    if paper is not None:
        report = _read(paper, "make paper")
        if results is not None:
            made = made_by("make paper", report["software"], report["seed"])
            fill_block(results, "paper", "\n".join([made, "", _paper_table(report)]))
        curves = paper.parent / REPRODUCTION
        if curves.exists():
            _copy(curves, package)
    if picture is not None:
        draw_departure(picture, mission, package)

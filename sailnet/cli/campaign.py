"""``sailnet evaluate --campaign``: fly a campaign, write its report, print its scores."""

import argparse
import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sailnet.artefacts.ownership import LOCK, sole_owner, sweep
from sailnet.campaign.plan import Plan, guided_by, load_plan, single_precision
from sailnet.cli.arguments import BOTH, NETWORKS, guidance_of, workers_of
from sailnet.errors import CampaignError, SailnetError, reason
from sailnet.guidance.rules import EXPERT_RULES
from sailnet.mission.disturbances import catalogue
from sailnet.mission.mission import Mission, load_mission
from sailnet.report import need_pictures, report

if TYPE_CHECKING:
    from sailnet.campaign.tables import Table
    from sailnet.guidance.interface import Precision


def evaluate_campaign(options: argparse.Namespace) -> dict[str, object]:
    """Carry out the command; the tables are printed unless JSON is wanted.

    In both precisions the answer is that of float64, with that of float32 as ``float32``, whose results lie
    beside it under the campaign's name and ``-float32``; the tables are of both, side by side. Those of the
    expert lie there under its own; where those of the networks are, one table shows both.

    Raises:
        SailnetError: options that a campaign does not take; whatever stops the flights or the report.
    """
    names = ["period", *(quantity.name for quantity in catalogue())]
    if given := [name for name in names if getattr(options, name) is not None]:
        flags = ", ".join(f"--{name.replace('_', '-')}" for name in given)
        raise SailnetError(f"a campaign says itself what is flown: put {flags} into its TOML file")
    mission, plan = load_mission(options.mission), load_plan(options.campaign)
    plan = plan.changed(options.flights, options.seed)
    need_pictures()
    if options.guidance != NETWORKS:
        return _flown(options, mission, plan, guided_by(plan.name, options.guidance), options.precision)[0]
    if options.precision != BOTH:
        return _flown(options, mission, plan, plan.name, options.precision)[0]
    result, double = _flown(options, mission, plan, plan.name, "float64")
    options.optima = Path(str(result["results"]))
    result["float32"], single = _flown(options, mission, plan, single_precision(plan.name), "float32")
    _print_tables(options, {"float64": double, "float32": single})
    return result


def _print_tables(options: argparse.Namespace, tables: "Mapping[str, Sequence[Table]]") -> None:
    from sailnet.campaign.tables import side_by_side

    if options.json:
        return
    flown_by = " and ".join(tables)
    for table in side_by_side(tables) if len(tables) > 1 else tables[flown_by]:
        print("\n".join([f"{table.title}, {flown_by}:", *table.lines()]), end="\n\n")


def _flown(
    options: argparse.Namespace, mission: Mission, plan: Plan, name: str, precision: "Precision"
) -> "tuple[dict[str, object], list[Table]]":
    """Fly in one precision; results and report under a name. What to answer, and the tables."""
    lock, place = options.output / f".{name}{LOCK}", f"campaign {name} in {options.output}"
    with sole_owner(lock, place, CampaignError):
        return _flown_alone(options, mission, plan, name, precision)


def _flown_alone(
    options: argparse.Namespace, mission: Mission, plan: Plan, name: str, precision: "Precision"
) -> "tuple[dict[str, object], list[Table]]":
    # Plant and graphs take a second to load: whoever comes second has been sent away by now.
    from sailnet.campaign.batches import Job
    from sailnet.campaign.budget import refuse_too_large
    from sailnet.campaign.run import fly_plan
    from sailnet.campaign.scores import score_record, scores_of
    from sailnet.campaign.tables import score_tables
    from sailnet.campaign.upper_bound import upper_bounds
    from sailnet.guidance.backends import exported_digest

    chosen = argparse.Namespace(**{**vars(options), "precision": precision})
    guidance = guidance_of(chosen, mission, many=True)
    facts: dict[str, str] = {"precision": precision}
    if options.guidance not in EXPERT_RULES:
        facts["backend"] = options.backend
        if options.backend == "c":
            facts["layout"] = options.layout
            facts["exported C"] = exported_digest(mission, options.networks, options.layout)
    stored: Path = options.output / f"{name}.h5"
    folder: Path = options.output / name
    refuse_too_large(plan.flown_by(mission), mission, stored)  # the list of its batches alone may be
    job = Job(mission, guidance, plan.flown_by(mission), asks=options.optima is None)
    with workers_of(options, len(job.batches)) as pool:
        results = fly_plan(
            mission,
            guidance,
            plan,
            stored,
            workers=pool,
            restart=options.restart,
            overwrite=options.overwrite,
            facts=facts,
            optima=options.optima,
        )
    scores = scores_of(results)
    tables = score_tables(scores)
    if options.precision != BOTH:
        _print_tables(options, {precision: tables})
    sweep(folder)
    try:
        rows = report("campaign_page").write_report(
            results, folder, guidance, command=flown_again_by(options, precision)
        )
    except (SailnetError, OSError) as error:
        raise SailnetError(f"{stored} is written, but not its report: {reason(error)}") from error
    if options.guidance != NETWORKS and not options.json:
        for table in upper_bounds(options.output, [plan.name]):
            print("\n".join([f"{table.title}:", *table.lines()]), end="\n\n")
    if rows and not options.json:
        print("\n".join(report("comparison").comparison_lines(rows)), end="\n\n")
    result: dict[str, object] = {"results": str(stored), "report": str(folder / "index.html")}
    if options.json:
        result["scores"] = [score_record(score) for score in scores]
        result["paper"] = [vars(row) for row in rows]
    return result | {"digest": results.digest}, tables


def flown_again_by(options: argparse.Namespace, precision: "Precision") -> str:
    """What flies the same campaign again, wherever it writes to."""
    defaults = {"mission": "earth_mars", "guidance": NETWORKS, "backend": "c", "precision": "float64",
                "layout": "flight"}  # fmt: skip
    words = ["sailnet", "evaluate", "--campaign", options.campaign]
    for name in ("mission", "guidance", "backend", "precision", "layout", "networks", "flights", "seed"):
        value = precision if name == "precision" else getattr(options, name)
        if value is not None and value != defaults.get(name):
            words += [f"--{name}", str(value)]
    return shlex.join(words)

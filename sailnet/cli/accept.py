"""``sailnet accept``: the flights that networks have to pass before they are released, and the verdict."""

import argparse
import json
from pathlib import Path

from sailnet.artefacts.files import write_text, writing
from sailnet.cli import evaluate
from sailnet.cli.arguments import Commands, add_command, count, distribution
from sailnet.cli.output import Line, Result, printed
from sailnet.cli.spelling import HelpfulParser
from sailnet.mission.mission import load_mission

MISSED = 3
"""Exit status where flights were flown and a criterion is missed."""

VERDICT = "acceptance.json"
"""Beside the results: the criteria, what was flown, and whether each is met."""


def add(commands: Commands) -> None:
    """Add the command."""
    accept = add_command(
        commands,
        "accept",
        run,
        "The flights that networks must pass before they are released: nominal, unknown sails, noise, drift. "
        f"Exit status {MISSED} if a criterion of the mission's [acceptance] is missed.",
        example="sailnet accept build/mine/wide/export --mission mine.toml --output build/mine/wide",
    )
    accept.add_argument("networks", type=Path, metavar="EXPORT_DIR", help="what sailnet export wrote")
    accept.add_argument("--output", type=Path, metavar="DIR", required=True, help="for results and report")
    accept.add_argument("--flights", type=count, metavar="N", help="of each series (10,000)")
    accept.add_argument("--seed", type=int, help="of every random number (the campaign's)")
    accept.add_argument("--restart", action="store_true", help="throw away what was flown before")
    accept.add_argument("--overwrite", action="store_true", help="replace what others finished there")
    distribution(accept)


def run(options: argparse.Namespace) -> int:
    """Fly, or read what is flown already; print tables or JSON; 0, or ``MISSED``."""
    result = accepted(options)
    if options.json:
        print(json.dumps(result))
    else:
        shown = {key: result[key] for key in ("results", "report", "digest", "verdict")}
        print("\n".join([*verdict_lines(result), "", printed(shown, LINES)]))
    return status_of(result)


def accepted(options: argparse.Namespace) -> Result:
    """Fly, or read what is flown already, and apply the mission's criteria.

    Returns:
        What ``sailnet evaluate --campaign acceptance`` does, and ``criteria``, ``accepted`` and ``verdict``,
        the file that holds both.
    """
    from sailnet.campaign.criteria import criteria_of, missed
    from sailnet.campaign.results import open_results
    from sailnet.campaign.scores import scores_of

    words = ["evaluate", "--campaign", "acceptance"]
    for name in ("mission", "networks", "output", "flights", "seed", "workers", "scheduler", "wait"):
        if (value := getattr(options, name)) is not None:
            words += [f"--{name}", str(value)]
    words += [f"--{name}" for name in ("restart", "overwrite", "json") if getattr(options, name)]
    parser = HelpfulParser()
    evaluate.add(parser.add_subparsers())
    result: Result = evaluate.run(parser.parse_args(words))
    mission = load_mission(options.mission)
    criteria = criteria_of(mission.acceptance, scores_of(open_results(Path(str(result["results"])))))
    verdict = {
        "mission": mission.name,
        "results": str(result["results"]),
        "digest": result["digest"],
        "accepted": not missed(criteria),
        "criteria": [criterion.record() for criterion in criteria],
    }
    path = options.output / VERDICT
    with writing(path):
        write_text(path, json.dumps(verdict, indent=1) + "\n")
    return {**result, "accepted": verdict["accepted"], "criteria": verdict["criteria"], "verdict": str(path)}


def status_of(result: Result) -> int:
    """Exit status of a result of :func:`accepted`."""
    return 0 if result["accepted"] else MISSED


def verdict_lines(result: Result) -> list[str]:
    """The criteria of a result of :func:`accepted` as a table, and what is missed in words."""
    from sailnet.campaign.criteria import Criterion, criteria_table, missed

    records = result["criteria"]
    assert isinstance(records, list)
    criteria = [
        Criterion(**{key: record[key] for key in Criterion.__dataclass_fields__}) for record in records
    ]
    table = criteria_table(criteria)
    failed = missed(criteria)
    end = [f"not accepted: {criterion}" for criterion in failed] or ["accepted: all criteria are met"]
    return [f"{table.title}:", *table.lines(), "", *end]


LINES = {**evaluate.LINES, "verdict": Line("verdict")}

"""``python -m sailnet.campaign.score_tables``: scores of campaigns as tables of a text, between two marks.

A campaign that was flown in both precisions, or by another flight file of the same networks (into a folder of
``OTHER_LAWS`` beside the others), has one table of all, with a row of each under the other. Tables of
campaigns that are not in the folder stay as they are.
"""

import json
import re
import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from sailnet.campaign.plan import OTHER_LAWS, ready_campaigns, single_precision
from sailnet.campaign.tables import Table, side_by_side
from sailnet.campaign.text_command import fill_from_folder
from sailnet.errors import CampaignError
from sailnet.workers.interruption import run_command

MARK = "campaigns"

HEADING = re.compile(r"^\*\*.*\*\* \(`([^`]*)`, networks ", re.MULTILINE)
"""Of a campaign's tables, with its name."""

Record = Mapping[str, Any]
"""What a ``scores.json`` holds, with what flew as ``flown_by``."""


def campaign_tables(records: Sequence[Record]) -> str:
    """Markdown of some campaigns: one after the other, those of the same flights side by side."""
    blocks = []
    for several in _of_the_same_flights(records):
        first = several[0]
        blocks.append(
            f"**{first['title']}** (`{first['campaign']}`, networks `{first['networks'][:8]}`, "
            f"seed {first['seed']}; {'; '.join(map(_made, several))})"
        )
        tables = {record["flown_by"]: [Table(**table) for table in record["tables"]] for record in several}
        for table in side_by_side(tables) if len(tables) > 1 else next(iter(tables.values())):
            blocks.append(table.block())
    return "\n\n".join(blocks)


def beside_others(before: str, new: str) -> str:
    """Tables of some campaigns, and those of others that stood there before, in the order of their names."""
    written, kept = _by_campaign(new), _by_campaign(before)
    return "\n\n".join(text for _, text in sorted((kept | written).items()))


def _by_campaign(tables: str) -> dict[str, str]:
    """Everything of a campaign under its name."""
    starts = [*HEADING.finditer(tables)]
    ends = [*(match.start() for match in starts[1:]), len(tables)][: len(starts)]
    texts: dict[str, list[str]] = {}
    for match, end in zip(starts, ends, strict=True):
        texts.setdefault(match[1], []).append(tables[match.start() : end].strip("\n"))
    return {name: "\n\n".join(parts) for name, parts in texts.items()}


def _made(record: Record) -> str:
    software = record["software"]
    return f"{record['flown_by']}: {software['machine']}, {software['date']}, revision {software['revision']}"


def _of_the_same_flights(records: Iterable[Record]) -> list[list[Record]]:
    """Campaigns of one name with the same networks, seed, series, periods and numbers of flights together."""
    groups: dict[str, list[Record]] = {}
    for record in records:
        first = record["tables"][0]
        same = [record[name] for name in ("campaign", "networks", "seed")]
        same += [first["heads"][:3], *(row[:3] for row in first["cells"])]
        groups.setdefault(json.dumps(same), []).append(record)
    return list(groups.values())


def read_records(folder: Path) -> list[Record]:
    """What was flown, in the order of the ready campaigns' names, those of other flight files last.

    Raises:
        CampaignError: none was, or a file is damaged.
    """
    places = [
        (where / flown / "scores.json", law)
        for name in ready_campaigns()
        for where, law in ((folder, ""), *((folder / name, f", {law}") for name, law in OTHER_LAWS.items()))
        for flown in (name, single_precision(name))
    ]
    try:
        found = [(json.loads(path.read_text(encoding="utf-8")), law) for path, law in places if path.exists()]
        records: list[Record] = [{**record, "flown_by": record["precision"] + law} for record, law in found]
    except (OSError, ValueError, TypeError, KeyError) as error:
        raise CampaignError(f"cannot read the scores in {folder}: {error}; fly the campaign again") from error
    if not records:
        raise CampaignError(f"no campaign was flown into {folder}: run make campaigns first")
    return records


def main() -> int:
    """Run the command; returns the exit status."""
    return fill_from_folder(
        "sailnet.campaign.score_tables",
        __doc__,
        MARK,
        lambda folder: campaign_tables(read_records(folder)),
        beside_others,
    )


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

"""``python -m sailnet.campaign.score_tables``: scores of campaigns as tables of a text, between two marks."""

import argparse
import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sailnet.artefacts.files import fill_block
from sailnet.campaign.plan import ready_campaigns, single_precision
from sailnet.campaign.tables import Table
from sailnet.errors import CampaignError, SailnetError

MARK = "campaigns"


def campaign_tables(records: Sequence[Mapping[str, Any]]) -> str:
    """Markdown of what ``scores.json`` of some campaigns hold."""
    blocks = []
    for record in records:
        software = record["software"]
        made = f"{software['machine']}, {software['date']}, revision {software['revision']}"
        blocks.append(
            f"**{record['title']}** (`{record['campaign']}`, {record['precision']}, networks "
            f"`{record['networks'][:8]}`, seed {record['seed']}, {made})"
        )
        for table in record["tables"]:
            blocks.append("\n".join([f"*{table['title']}*", "", *Table(**table).markdown()]))
    return "\n\n".join(blocks)


def read_records(folder: Path) -> list[dict[str, Any]]:
    """What was flown, in the order of the ready campaigns' names.

    Raises:
        CampaignError: none was, or a file is damaged.
    """
    names = [each for name in ready_campaigns() for each in (name, single_precision(name))]
    paths = [folder / name / "scores.json" for name in names]
    try:
        records = [json.loads(path.read_text(encoding="utf-8")) for path in paths if path.exists()]
    except (OSError, ValueError) as error:
        raise CampaignError(f"cannot read the scores in {folder}: {error}; fly the campaign again") from error
    if not records:
        raise CampaignError(f"no campaign was flown into {folder}: run make campaigns first")
    return records


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m sailnet.campaign.score_tables",
        description=__doc__,
        epilog="example: python -m sailnet.campaign.score_tables build/earth_mars/campaigns "
        "sailnet/campaign/RESULTS.md",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("folder", type=Path, help="where campaigns were flown to")
    parser.add_argument("text", type=Path, help=f"file with the marks <!-- {MARK} --> and <!-- /{MARK} -->")
    options = parser.parse_args()
    try:
        fill_block(options.text, MARK, campaign_tables(read_records(options.folder)))
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

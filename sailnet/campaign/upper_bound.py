"""``python -m sailnet.campaign.upper_bound``: what the networks fly, beside what others would.

The same flights, from the same starts with the same random numbers, guided by the expert itself: what is left
to gain for any guidance that knows no more than the networks do.
"""

import sys
from collections.abc import Iterable
from pathlib import Path

from sailnet.campaign.plan import Series, guided_by, ready_campaigns
from sailnet.campaign.results import Results, open_results
from sailnet.campaign.scores import score_of_rows
from sailnet.campaign.tables import (
    ARRIVE,
    FLIGHTS,
    HOME,
    LATE,
    MEAN,
    PERIOD,
    REVERSALS,
    SERIES,
    Table,
    table_of,
)
from sailnet.campaign.text_command import fill_from_folder
from sailnet.errors import CampaignError
from sailnet.guidance.rules import EXPERT_RULES
from sailnet.workers.interruption import run_command

MARK = "upper bound"


def upper_bounds(folder: Path, campaigns: Iterable[str]) -> list[Table]:
    """A table for each campaign that the networks and others have flown, in float64.

    Args:
        folder: where campaigns were flown to.
        campaigns: their names.

    Raises:
        CampaignError: results that are damaged, or that are not of the same flights.
    """
    tables = []
    for name in campaigns:
        paths = {"networks": folder / f"{name}.h5"}
        paths |= {other: folder / f"{guided_by(name, other)}.h5" for other in EXPERT_RULES}
        flown = {guided: open_results(path) for guided, path in paths.items() if path.exists()}
        if "networks" in flown and len(flown) > 1:
            tables.append(side_by_side(flown))
    return tables


def side_by_side(flown: dict[str, Results]) -> Table:
    """One campaign as several guidances flew it: of every series the flights that all of them have.

    Args:
        flown: results by who guided, of the same mission and seed.

    Raises:
        CampaignError: another mission or seed, or no series in common.
    """
    first, *others = flown.values()
    for other in others:
        if other.plan.seed != first.plan.seed or other.mission.digest() != first.mission.digest():
            raise CampaignError(
                f"campaign {first.plan.name!r} was flown with another seed or mission by another guidance"
            )
    columns = [SERIES, PERIOD, FLIGHTS, MEAN, HOME, REVERSALS, LATE, ARRIVE]
    heads: list[str] = []
    rows: list[list[str]] = []
    for series in first.plan.whole:
        places = [place for results in flown.values() for place in _places(results, series)]
        if len(places) < len(flown):
            continue
        for period in first.plan.periods_of(series, first.mission):
            chosen = [
                results.rows(place, period) for results, place in zip(flown.values(), places, strict=True)
            ]
            common = min(map(len, chosen))
            for (guided, results), place, own in zip(flown.items(), places, chosen, strict=True):
                score = score_of_rows(results, own[:common], place, period)
                one = table_of("", columns, [score])
                heads, cells = one.heads, one.cells[0]
                rows.append([cells[0], guided, *cells[1:]])
    if not rows:
        raise CampaignError(
            f"no series of campaign {first.plan.name!r} was flown by all of {', '.join(flown)}"
        )
    return Table(f"{first.plan.title}: what guidance could get", [heads[0], "guided by", *heads[1:]], rows)


def _places(results: Results, series: Series) -> list[int]:
    """Number of the series under the same conditions, however many flights it has; none if there is not."""
    fewer = {"flights": None, "optima": None}
    wanted = series.model_copy(update=fewer)
    whole = [other.model_copy(update=fewer) for other in results.plan.whole]
    return [whole.index(wanted)] if wanted in whole else []


def _blocks(folder: Path) -> str:
    tables = upper_bounds(folder, ready_campaigns())
    if not tables:
        raise CampaignError(f"no campaign in {folder} was flown by both: see --guidance")
    return "\n\n".join(table.block() for table in tables)


def main() -> int:
    """Run the command; returns the exit status."""
    return fill_from_folder("sailnet.campaign.upper_bound", __doc__, MARK, _blocks)


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

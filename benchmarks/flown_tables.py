"""Tables of flights that compare networks or laws: the flights, their options, and a cell for each series."""

import argparse
from pathlib import Path

from sailnet.artefacts.provenance import software
from sailnet.campaign.results import open_results
from sailnet.campaign.scores import Score, scores_of
from sailnet.campaign.selection import fly_candidate
from sailnet.campaign.tables import percent
from sailnet.errors import SailnetError
from sailnet.mission.acceptance import Selection
from sailnet.mission.mission import Mission, load_mission
from sailnet.workers.executors import Workers

CELLS = (
    "Excess time over the optimum: mean, 99 %, largest; flights with an extra revolution, failed flights; "
    "attitude reversals, 99 %."
)
"""What ``cells_of`` writes."""


def add_options(parser: argparse.ArgumentParser, block: str, flights: int, seed: int) -> None:
    """Which flights: what ``mission_of`` reads; and ``--text``, for the block of that name.

    Args:
        parser: of the command.
        block: what comes before the mission's name in the marks of a text.
        flights: of a series, by default.
        seed: of the flights, by default.
    """
    parser.add_argument("--mission", default="earth_mars", help="mission name or TOML file (%(default)s)")
    parser.add_argument("--flights", type=int, default=flights, help="of a series (%(default)s)")
    parser.add_argument("--seed", type=int, default=seed, help="of the flights (%(default)s)")
    parser.add_argument("--text", type=Path, help=f"file with marks <!-- {block} MISSION --> for the table")


def mission_of(options: argparse.Namespace) -> Mission:
    """The mission, with the flights that were asked for as its ``[selection]``.

    Raises:
        MissionError: there is none of that name.
    """
    selection = Selection(flights=options.flights, seed=options.seed)
    return load_mission(options.mission).model_copy(update={"selection": selection})


def fly(mission: Mission, exported: Path, results: Path, pool: Workers, optima: Path | None) -> list[Score]:
    """What a flight file flies; flights that are there already are read.

    Args:
        mission: with its ``[selection]``.
        exported: folder of the C, compiled in double precision.
        results: HDF5 file of the flights.
        pool: processes or cluster.
        optima: results of other flights from the same starts.

    Raises:
        SailnetError: it cannot be flown.
    """
    fly_candidate(mission, exported, results, pool, optima=optima)
    return scores_of(open_results(results))


def cells_of(score: Score) -> str:
    """One series.

    Raises:
        SailnetError: no optimum is known.
    """
    excess = score.excess
    if excess is None:
        raise SailnetError(f"no optimum is known of {score.name!r}: fly more")
    spread = excess.relative
    again, failed = excess.first_approach.others.count, score.arrived.others.count
    return (
        f"{percent(spread.mean)}, {percent(spread.high)}, {percent(spread.worst)}; {again}, {failed}; "
        f"{score.behaviour.reversals.high:.0f}"
    )


def origin() -> str:
    """Machine, date and revision."""
    made = software()
    return f"{made['machine']}, {made['date']}, revision {made['revision']}."

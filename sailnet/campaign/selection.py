"""Networks chosen by flights: development flights of a training, and whether they meet the criteria.

Networks whose test errors are equal may fly forty times apart, so a training is judged by what it flies. The
flights are those of the campaign ``acceptance`` with fewer starts and a seed of their own.
"""

from collections.abc import Mapping
from pathlib import Path

from sailnet.campaign.criteria import Criterion, criteria_of
from sailnet.campaign.plan import Plan, load_plan
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import scores_of
from sailnet.guidance.backends import exported_digest, load_guidance
from sailnet.mission.acceptance import SERIES
from sailnet.mission.mission import Mission
from sailnet.workers.executors import Workers

DEVELOPMENT = "development"


def development_plan(mission: Mission) -> Plan:
    """The campaign ``acceptance`` as a mission's ``[selection]`` has it flown: series with criteria alone."""
    plan = load_plan("acceptance").changed(mission.selection.flights, mission.selection.seed)
    series = tuple(series for series in plan.series if series.name in SERIES)
    return plan.model_copy(update={"name": DEVELOPMENT, "series": series, "sample": 0, "failures": 0})


def fly_candidate(
    mission: Mission,
    exported: Path,
    results: Path,
    workers: Workers | None = None,
    *,
    restart: bool = False,
    optima: Path | None = None,
) -> list[Criterion]:
    """Fly one training's networks, or read what they flew, and apply the mission's criteria.

    Args:
        mission: with its criteria and its ``[selection]``.
        exported: folder of the candidate's C, compiled in double precision.
        results: HDF5 file of the flights.
        workers: processes or cluster; this process by default.
        restart: fly anew, whatever there is.
        optima: results of another candidate: the same flights have the same optima.

    Raises:
        SailnetError: as :func:`sailnet.campaign.run.fly_plan`.
    """
    guidance = load_guidance(mission, "c", "float64", exported)
    facts: Mapping[str, str] = {"precision": "float64", "exported C": exported_digest(mission, exported)}
    flown = fly_plan(
        mission,
        guidance,
        development_plan(mission),
        results,
        workers=workers,
        restart=restart,
        overwrite=True,
        facts=facts,
        optima=optima,
    )
    return criteria_of(mission.acceptance, scores_of(flown))

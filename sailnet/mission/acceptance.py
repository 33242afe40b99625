"""What networks must show before they are released, and the flights by which they are chosen."""

from collections.abc import Mapping
from typing import Annotated

from pydantic import Field

from sailnet.mission.sections import Count, NotNegative, Section, Seed

SERIES: Mapping[str, str] = {
    "nominal": "nominal",
    "unknown bias": "unknown_bias",
    "unknown bias and white noise": "white_noise",
    "unknown bias and slow drift": "slow_drift",
}
"""Tables of ``[acceptance]``, by the series of the campaign ``acceptance`` that each bounds."""

Percent = Annotated[float, Field(ge=0.0, le=100.0)]


class Bounds(Section):
    """Bounds for the flights of one series.

    Attributes:
        mean_excess: largest mean excess time over the optimum for the true sail parameters [%].
        without_extra_revolution: smallest share of the flights that arrive without an extra revolution [%].
        failed: largest share of the flights that fail [%].
        reversals: largest number of attitude reversals in 99 % of the flights.
    """

    mean_excess: NotNegative
    without_extra_revolution: Percent
    failed: Percent
    reversals: NotNegative


class Acceptance(Section):
    """Acceptance criteria of a mission: bounds for each series of random flights."""

    nominal: Bounds
    unknown_bias: Bounds
    white_noise: Bounds
    slow_drift: Bounds

    def of_series(self, name: str) -> Bounds | None:
        """Bounds for a series of the campaign; None for a series that has none, such as a single flight."""
        return getattr(self, SERIES[name]) if name in SERIES else None


class Selection(Section):
    """How networks are chosen among trainings: the first whose development flights meet the criteria.

    Attributes:
        flights: of each series of the campaign ``acceptance`` that has criteria.
        seed: of these flights; no reported campaign uses it.
        trainings: how many training seeds are tried at most, counted up from the recipe's.
    """

    flights: Count = 1000
    seed: Seed = 903
    trainings: Count = 4


FULL: Mapping[str, tuple[float, float, float, float]] = {
    "nominal": (0.5, 99.9, 0.1, 4.0),
    "unknown_bias": (1.0, 99.5, 0.1, 5.0),
    "white_noise": (3.0, 99.0, 0.2, 8.0),
    "slow_drift": (4.0, 99.0, 0.2, 8.0),
}
"""Criteria of a mission that states none, in the order of the attributes of :class:`Bounds`: what we ask of
missions in the plane to 0.9, 1.2 and 2 AU."""

QUICK: Mapping[str, tuple[float, float, float, float]] = {
    "nominal": (4.0, 99.0, 1.0, 12.0),
    "unknown_bias": (5.0, 98.5, 1.0, 12.0),
    "white_noise": (8.0, 97.0, 1.0, 20.0),
    "slow_drift": (8.0, 98.0, 1.0, 12.0),
}
"""Criteria of a quick run, where the mission's own are not wider."""


def as_tables(criteria: Mapping[str, tuple[float, float, float, float]]) -> dict[str, dict[str, float]]:
    """Criteria such as ``FULL`` as tables of a mission file."""
    return {name: dict(zip(Bounds.model_fields, values, strict=True)) for name, values in criteria.items()}


def widened(tables: Mapping[str, Mapping[str, float]]) -> dict[str, dict[str, float]]:
    """Criteria for a quick run: each bound, or that of ``QUICK`` where this is wider."""
    wider = dict.fromkeys(Bounds.model_fields, max) | {"without_extra_revolution": min}
    quick = as_tables(QUICK)
    return {
        series: {key: wider[key](value, quick[series][key]) for key, value in table.items()}
        for series, table in tables.items()
    }

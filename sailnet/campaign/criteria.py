"""Acceptance criteria applied to the scores of flights: which are met, which are missed, and by how much."""

from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass

from sailnet.campaign.scores import Score
from sailnet.campaign.tables import Table
from sailnet.mission.acceptance import Acceptance, Bounds

LOWER = ("without_extra_revolution",)
"""Criteria whose bound is a lower one; those of all others are upper bounds."""

NAMES = {
    "mean_excess": ("mean excess time over the optimum", "%"),
    "without_extra_revolution": ("arrived without an extra revolution", "%"),
    "failed": ("failed", "%"),
    "reversals": ("attitude reversals, 99 %", ""),
}


@dataclass(frozen=True)
class Criterion:
    """One bound and what was flown.

    Attributes:
        series: name of the series.
        quantity: attribute of :class:`sailnet.mission.acceptance.Bounds`.
        bound: of the mission.
        measured: over all flights of the series; None if the optimum of none of them is known.
    """

    series: str
    quantity: str
    bound: float
    measured: float | None

    @property
    def passed(self) -> bool:
        """Whether the bound is kept."""
        if self.measured is None:
            return False
        return self.measured >= self.bound if self.quantity in LOWER else self.measured <= self.bound

    def __str__(self) -> str:
        name, unit = NAMES[self.quantity]
        relation = "at least" if self.quantity in LOWER else "at most"
        return f"{self.series}: {name} {_number(self.measured, unit)}, {relation} {_number(self.bound, unit)}"

    def record(self) -> dict[str, object]:
        """Ready for JSON."""
        return {**asdict(self), "passed": self.passed}


def criteria_of(acceptance: Acceptance, scores: Iterable[Score]) -> list[Criterion]:
    """Every criterion of a mission, in order of series and quantity.

    Args:
        acceptance: the bounds.
        scores: of the campaign ``acceptance``; series without bounds, such as single flights, are left out.
    """
    found = []
    for score in scores:
        if (bounds := acceptance.of_series(score.name)) is not None:
            measured = _measured(score)
            found += [
                Criterion(score.name, quantity, getattr(bounds, quantity), measured[quantity])
                for quantity in Bounds.model_fields
            ]
    return found


def missed(criteria: Iterable[Criterion]) -> list[Criterion]:
    """Those whose bound is not kept."""
    return [criterion for criterion in criteria if not criterion.passed]


def criteria_table(criteria: Sequence[Criterion]) -> Table:
    """A row for each criterion."""
    cells = []
    for one in criteria:
        name, unit = NAMES[one.quantity]
        sign = "≥" if one.quantity in LOWER else "≤"
        bound = f"{sign} {_number(one.bound, unit)}"
        cells.append(
            [one.series, name, bound, _number(one.measured, unit), "passed" if one.passed else "MISSED"]
        )
    return Table("Acceptance criteria", ["series", "criterion", "bound", "measured", "result"], cells)


def _measured(score: Score) -> dict[str, float | None]:
    excess = score.excess
    return {
        "mean_excess": None if excess is None else 100.0 * excess.relative.mean,
        "without_extra_revolution": None if excess is None else 100.0 * excess.first_approach.share,
        "failed": 100.0 * score.arrived.others.share,
        "reversals": score.behaviour.reversals.high,
    }


def _number(value: float | None, unit: str) -> str:
    # Six digits: 998 of 999 flights are not 99.9 %.
    return "not known" if value is None else f"{value:.6g} {unit}".rstrip()

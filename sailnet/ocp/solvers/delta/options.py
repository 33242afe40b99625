"""What the delta method is given: where its searches begin, and how they go about it."""

from dataclasses import dataclass, field

from sailnet.ocp.solvers.delta.criteria import Weights
from sailnet.ocp.solvers.delta.heuristics import GaPso, Heuristic
from sailnet.ocp.solvers.delta.polish import Polish
from sailnet.ocp.solvers.delta.series import Basis, Fourier
from sailnet.ocp.solvers.options import check_at_least, check_positive

GOAL = 1e-3
"""Largest error at the end of an accepted flight, in the problem's units."""


@dataclass(frozen=True)
class RandomSeries:
    """Searches that begin at random series.

    Attributes:
        box: of the coefficients at first, as a share of the paper's. A polish may leave it.
        seed: of the heuristic.
        searches: of equally many evaluations each; the best counts.

    Raises:
        SailnetError: no box, or no search.
    """

    box: float = 1.0
    seed: int = 0
    searches: int = 1

    def __post_init__(self) -> None:
        check_positive(self, "box")
        check_at_least(self, 1, "searches")


@dataclass(frozen=True)
class Options:
    """How the delta method goes about it.

    Attributes:
        basis: of the series.
        heuristic: that searches.
        terms: of each series.
        nodes: intervals of a flight; the accepted one is flown over four times as many, cut at its switches.
        evaluations: flights in all.
        stages: of a search, of equally many evaluations; each weighs the ends ten times as much as the one
            before, in a smaller box around its best point.
        weights: of the criteria in the first stage.
        polish: what is done with the best point of a search, within the same evaluations; nothing by
            default, as in the paper.
        goal: largest error at the end of an accepted flight.

    Raises:
        SailnetError: a number that makes no sense.
    """

    basis: Basis = field(default_factory=Fourier)
    heuristic: Heuristic = field(default_factory=GaPso)
    terms: int = 6
    nodes: int = 60
    evaluations: int = 50_000
    stages: int = 4
    weights: Weights = field(default_factory=Weights)
    polish: Polish | None = None
    goal: float = GOAL

    def __post_init__(self) -> None:
        check_at_least(self, 1, "terms", "evaluations", "stages")
        check_at_least(self, 2, "nodes")
        check_positive(self, "goal")

"""One printed figure, checked."""

from dataclasses import dataclass
from typing import Literal

Verdict = Literal["agrees", "paper in error", "not reproducible"]


@dataclass(frozen=True)
class Row:
    """A figure that a paper prints, ours, and a second method's.

    Attributes:
        paper: its number.
        problem: name of the problem.
        quantity: what it is, with its unit.
        printed: as printed.
        ours: our value.
        check: an independent second method's value.
        check_method: that method.
        verdict: whether the paper is right.
        reason: why, in a sentence.
        seconds: what ours took.
        paper_seconds: what the paper says its own took, if it does.
    """

    paper: str
    problem: str
    quantity: str
    printed: str
    ours: float
    check: float
    check_method: str
    verdict: Verdict
    reason: str
    seconds: float
    paper_seconds: float | None

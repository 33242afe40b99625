"""One printed figure and what became of it."""

from dataclasses import dataclass, field, fields
from typing import Any, Literal

from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.solution import Solution

Verdict = Literal["agrees", "paper in error", "not reproducible"]


@dataclass(frozen=True, eq=False)
class Solved:
    """A problem and the solution that figures were read off.

    Attributes:
        problem: with the values of its parameters.
        solution: of it.
    """

    problem: Problem
    solution: Solution


@dataclass(frozen=True)
class Row:
    """A figure a paper prints, ours, and a second method's.

    Attributes:
        paper: its number, as in ``003``.
        problem: name of the problem.
        quantity: what is printed, with its unit.
        printed: as printed.
        ours: by the paper's own kind of method.
        check: by an independent second method.
        check_method: which.
        verdict: on the printed figure.
        reason: for the verdict, and what the figure depends on.
        seconds: wall time of ours.
        paper_seconds: the paper's, if it gives one.
        same: whether ours and the check are one and the same number, so that they must agree to six digits.
        solved: where ours stands in; for pictures, left out of tables and JSON.
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
    same: bool = True
    solved: Solved | None = field(default=None, repr=False, compare=False)


def record_of(entry: Any) -> dict[str, Any]:
    """The fields of a :class:`Row` or of a :class:`~sailnet.papers.trial.Trial`, solutions left out."""
    return {one.name: getattr(entry, one.name) for one in fields(entry) if one.name != "solved"}

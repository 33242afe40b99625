"""What became of one solver on the solar sail's transfer, beside the true minimum."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from sailnet.papers.row import Solved

Verdict = Literal["agrees", "differs", "no solution"]

PAPER, NAME = "001", "sail"

PRINTED = "7.01818"
"""The paper's time of flight with the bound and without smoothing [TU]."""

MINIMUM = 7.01817944
"""The same [TU] by shooting with located switches and by arcs; both agree to all these digits."""

ROUNDING = 5e-6
"""Half a unit of the last digit printed [TU]."""


@dataclass(frozen=True)
class Trial:
    """What became of one solver.

    Attributes:
        solver: which.
        settings: and its guess.
        ours: its time of flight [TU]; NaN where it has none.
        residual: largest error of its end conditions; NaN where it has none.
        seconds: wall time with compilation of what is not compiled yet, without the solution it begins at.
        verdict: on the printed figure, by this solver alone.
        reason: why there is no time, or what the time is worth.
        solved: the solution, if there is one; for pictures, left out of tables and JSON.
    """

    solver: str
    settings: str
    ours: float
    residual: float
    seconds: float
    verdict: Verdict
    reason: str
    paper: str = PAPER
    problem: str = NAME
    quantity: str = "t_f [TU]"
    printed: str = PRINTED
    check: float = MINIMUM
    check_method: str = "shooting with located switches, and arcs"
    solved: Solved | None = field(default=None, repr=False, compare=False)

    @property
    def difference(self) -> float:
        """From the true minimum [TU]."""
        return self.ours - self.check


HEADINGS = ["solver", "settings and guess", "t_f [TU]", "off by [TU]", "end residual", "verdict", "s"]


def cells(trial: Trial) -> list[str]:
    """One line of the table, as text."""
    number = math.isfinite(trial.ours)
    found = [f"{trial.ours:.8f}", f"{trial.difference:+.1e}", f"{trial.residual:.1e}"] if number else [""] * 3
    return [trial.solver, trial.settings, *found, trial.verdict, f"{trial.seconds:.3g}"]


def failure(found: Sequence[Trial]) -> str | None:
    """What is wrong with a table: two solvers must have the minimum to six digits."""
    good = [trial for trial in found if math.isclose(trial.ours, MINIMUM, rel_tol=1e-6)]
    if len(good) >= 2:
        return None
    return f"{NAME}: {len(good)} solvers have the minimum to six digits, where two must; see their reasons"

"""Following a solution while a smoothing parameter shrinks, by steps as long as the solver bears."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

from sailnet.errors import SailnetError
from sailnet.ocp.definition.solution import ConvergenceError, Step

T = TypeVar("T")


@dataclass(frozen=True)
class Schedule:
    """From where to where, and how fast.

    Attributes:
        start, end: of the parameter; equal for a single solve.
        factor: first ratio of two consecutive values; later ones adapt.
        slowest: ratio so near 1 that a failure there ends the continuation.

    Raises:
        SailnetError: it does not go down, or not towards its end.
    """

    start: float = 1.0
    end: float = 1e-5
    factor: float = 0.3
    slowest: float = 0.98

    def __post_init__(self) -> None:
        if not self.start >= self.end >= 0.0:
            raise SailnetError(
                f"a schedule goes down from its start to its end, not from {self.start} to {self.end}"
            )
        if not (0.0 < self.factor < 1.0 and 0.0 < self.slowest < 1.0):
            raise SailnetError(
                "factor and slowest of a schedule lie between 0 and 1,"
                f" not at {self.factor} and {self.slowest}"
            )

    @classmethod
    def of(cls, value: "Schedule | float") -> "Schedule":
        """The schedule itself, or that of a single value."""
        return value if isinstance(value, Schedule) else cls(value, value)


def follow(
    solve_at: Callable[[float, T], tuple[T, Step]], schedule: Schedule, guess: T, what: str
) -> tuple[T, list[Step]]:
    """Solve at every value of a schedule, each from the solution before.

    Args:
        solve_at: solves at one value from a guess.
        schedule: the values.
        guess: where to begin.
        what: name of problem and solver for the error.

    Returns:
        The last solution and all steps, failed ones included.

    Raises:
        ConvergenceError: if the steps become too short before the end.
    """
    found, step = solve_at(schedule.start, guess)
    history = [step]
    if not step.converged:
        raise ConvergenceError(
            f"{what} finds no solution at rho = {schedule.start:g}; try another guess or a larger rho",
            {"largest": step.residual},
            history,
        )
    rho, length = schedule.start, -math.log(schedule.factor)
    while rho > schedule.end:
        target = max(schedule.end, rho * math.exp(-length))
        trial, step = solve_at(target, found)
        history.append(step)
        if step.converged:
            found, rho = trial, target
            length *= 1.5
        elif length < -math.log(schedule.slowest):
            raise ConvergenceError(
                f"{what} stalls on the way to rho = {schedule.end:g}; end there, or use another method",
                {"largest": step.residual},
                history,
            )
        else:
            length /= 3.0
    return found, history

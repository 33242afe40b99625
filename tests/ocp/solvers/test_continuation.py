"""Continuation on a solver that bears steps of a given length."""

import pytest

from sailnet.ocp import ConvergenceError, Schedule, Step
from sailnet.ocp.solvers.continuation import follow


def bearing(ratio: float, floor: float = 0.0) -> tuple[list[float], object]:
    """A solver that fails where the parameter falls by more than a ratio, or below a floor."""
    solved: list[float] = []

    def solve_at(rho: float, before: float) -> tuple[float, Step]:
        good = rho >= floor and rho >= ratio * before
        solved.append(rho)
        return (rho if good else before), Step(rho, 0.0 if good else 1.0, 1, good)

    return solved, solve_at


def test_steps_are_as_long_as_the_solver_bears() -> None:
    solved, solve_at = bearing(0.2)
    found, history = follow(solve_at, Schedule(1.0, 1e-4, 0.5), 1.0, "a test")  # type: ignore[arg-type]
    assert found == 1e-4
    assert [step.rho for step in history] == solved
    good = [step.rho for step in history if step.converged]
    assert good[0] == 1.0
    assert good[1] == pytest.approx(0.5)
    assert good == sorted(good, reverse=True)
    # Longer after a success, shorter after a failure, of which this solver has some.
    assert good[2] / good[1] < 0.5
    assert 0 < len(history) - len(good) < len(good)


def test_a_single_value_is_a_single_solve() -> None:
    solved, solve_at = bearing(0.2)
    assert Schedule.of(0.3) == Schedule(0.3, 0.3)
    follow(solve_at, Schedule.of(0.3), 0.3, "a test")  # type: ignore[arg-type]
    assert solved == [0.3]


def test_a_stall_says_how_far_it_came() -> None:
    _, solve_at = bearing(0.2, floor=1e-2)
    with pytest.raises(ConvergenceError, match=r"a test stalls on the way to rho = 0\.0001") as caught:
        follow(solve_at, Schedule(1.0, 1e-4), 1.0, "a test")  # type: ignore[arg-type]
    reached = min(step.rho for step in caught.value.history if step.converged)
    assert 1e-2 <= reached < 1.05e-2
    _, solve_at = bearing(0.2, floor=2.0)
    with pytest.raises(ConvergenceError, match="finds no solution at rho = 1"):
        follow(solve_at, Schedule(1.0, 1e-4), 1.0, "a test")  # type: ignore[arg-type]

"""A problem that knows the time, and weights to begin with."""

from sailnet.ocp import (
    TIME,
    Bounded,
    FreeTime,
    Problem,
    ponn,
    symbols,
)

SMALL_WEIGHTS = ponn.RandomWeights(0.01, starts=20)


def clocked() -> Problem:
    """Dynamics and terminal cost that know the time."""
    x, u = symbols("x u")
    return Problem(
        name="clocked",
        source="",
        dynamics={x: u + 0.2 * TIME**2 * x},
        controls=[Bounded(u, -1.0, 1.0)],
        final_time=FreeTime(2.0),
        initial={x: 1.0},
        final={x: 0.3},
        running_cost=0.5 * u**2,
        terminal_cost=0.1 * TIME**2,
    )

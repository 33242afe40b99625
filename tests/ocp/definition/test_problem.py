"""What is wrong with a problem is said when it is built."""

import pytest

from sailnet.errors import SailnetError
from sailnet.ocp import (
    Bounded,
    FreeTime,
    Problem,
    symbols,
)
from sailnet.ocp.problems import (
    goddard,
)


def test_what_is_wrong_is_said() -> None:
    x, u, y = symbols("x u y")
    with pytest.raises(SailnetError, match="y is no state"):
        Problem("p", "", {x: y * u}, [Bounded(u, -1, 1)], 1.0, {x: 0.0})
    with pytest.raises(SailnetError, match="lower < upper"):
        Problem("p", "", {x: u}, [Bounded(u, 1, -1)], 1.0, {x: 0.0})
    with pytest.raises(SailnetError, match="u is no state"):
        Problem("p", "", {x: u}, [Bounded(u, -1, 1)], FreeTime(1.0), {x: 0.0}, terminal_cost=u)
    with pytest.raises(SailnetError, match="no parameter T"):
        goddard.problem().with_parameters(T=1.0)
    with pytest.raises(SailnetError, match="end value"):
        Problem("p", "", {x: u}, [Bounded(u, -1, 1)], 1.0, {y: 0.0})

"""Views of all problems: units, names, paths."""

from collections.abc import Callable

import numpy as np
import pytest

from sailnet.mission.mission import load_mission
from sailnet.ocp import Problem
from sailnet.ocp.problems import (
    asteroid_rendezvous,
    earth_dionysus,
    earth_mars,
    goddard,
    intercept,
    leo_geo,
    lunar_landing,
    mars_landing,
    reorientation,
    solar_sail,
)
from sailnet.papers.problem_views import VIEWS
from tests.papers.stills import _still

PROBLEMS: list[Callable[[], Problem]] = [
    asteroid_rendezvous.problem, earth_dionysus.problem, earth_mars.problem, goddard.problem,
    intercept.problem, leo_geo.minimum_fuel, leo_geo.minimum_time, lunar_landing.problem,
    mars_landing.problem, reorientation.problem, lambda: reorientation.problem(False),
    lambda: solar_sail.problem(load_mission("earth_mars").problem),
]  # fmt: skip


def test_every_problem_has_a_view_of_all_its_states_and_controls() -> None:
    posed = [problem() for problem in PROBLEMS]
    assert {problem.name for problem in posed} == set(VIEWS)
    for problem in posed:
        view, names = VIEWS[problem.name], problem.names
        assert sorted(x for group in view.states for x in group.labels) == sorted(names["states"])
        assert sorted(u for group in view.controls for u in group.labels) == sorted(names["controls"])
        assert {name for plane in view.planes for name in (plane.x, plane.y)} <= set(names["states"])
        assert view.throttle in ("", *(str(control.variable) for control in problem.bounded))


def test_units_and_paths_are_the_papers() -> None:
    problem = earth_mars.problem()
    velocity = VIEWS["earth-mars"].states[1]
    start = [problem.initial[x] * velocity.scale for x in problem.states if str(x) in velocity.labels]
    np.testing.assert_allclose(start, earth_mars.START[1])
    assert problem.time_guess * VIEWS["earth-mars"].time_scale == pytest.approx(earth_mars.FLIGHT_TIME)
    problem = earth_dionysus.problem()
    first, last = earth_dionysus.ends()
    motion = VIEWS["earth-dionysus"].motion
    assert motion is not None
    found = motion(_still(problem, [[*first, 1.0], [*last, 0.6]]))
    for row, end in zip(found, (earth_dionysus.START, earth_dionysus.ARRIVAL), strict=True):
        np.testing.assert_allclose(row[:3] * earth_dionysus.LENGTH, end[0], rtol=1e-9)
        np.testing.assert_allclose(row[3:] * earth_dionysus.SPEED, end[1], rtol=1e-9)
    polar = VIEWS["asteroid-rendezvous"].motion
    assert polar is not None
    # A quarter of the way round, outwards at 0.1 and along at 0.9.
    (row,) = polar(_still(asteroid_rendezvous.problem(), [[1.2, np.pi / 2, 0.1, 0.9, 1.0]]))
    np.testing.assert_allclose(row, [0.0, 1.2, 0.0, -0.9, 0.1, 0.0], atol=1e-12)

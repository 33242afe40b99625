"""Charts of one solution."""

from dataclasses import replace

import numpy as np

from sailnet.ocp import Exact, shooting
from sailnet.ocp.problems import (
    earth_mars,
    intercept,
    lunar_landing,
)
from sailnet.papers.problem_views import view_of
from sailnet.papers.row import Solved
from sailnet.papers.solution_charts import expected_hamiltonian, solution_charts
from tests.papers.stills import _still


def test_what_the_hamiltonian_has_to_be() -> None:
    for gamma in (1.0, 5.0):
        problem = intercept.problem(gamma)
        solved = Solved(problem, shooting.solve(problem, options=shooting.Options(Exact())))
        assert expected_hamiltonian(solved) == -gamma
        (deviation,) = (chart for chart in solution_charts(solved) if chart.name.startswith("deviation"))
        assert deviation.y == f"|H + {gamma:g}|"
        assert np.max(np.asarray(deviation.columns["deviation"], float)) < 1e-9
    given = earth_mars.problem()
    assert expected_hamiltonian(Solved(given, _still(given, [[0.0] * 7, [1.0] * 7]))) is None


def test_a_problem_of_ones_own_is_shown_too() -> None:
    problem = replace(lunar_landing.problem(), name="hopper")
    solved = Solved(problem, shooting.solve(problem, options=shooting.Options(Exact())))
    assert view_of(problem).title == "hopper"
    names = [chart.name for chart in solution_charts(solved)]
    assert names == [
        "states", "controls", "switching-function-s", "costates", "hamiltonian",
        "deviation-of-the-hamiltonian",
    ]  # fmt: skip

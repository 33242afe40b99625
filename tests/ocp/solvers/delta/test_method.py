"""Searches, restarted and polished, within their evaluations."""

import math

import numpy as np
import pytest

from sailnet.errors import SailnetError
from sailnet.ocp.solvers import delta
from tests.ocp.solvers.delta.cases import double_integrator


@pytest.mark.slow
def test_restarts_and_polish_within_the_evaluations() -> None:
    heuristic = delta.GaPso(population=50, flights=5)
    options = delta.Options(delta.Legendre(), heuristic, 4, 20, 600, stages=1, polish=delta.Polish(150))
    guess = delta.RandomSeries(0.25, seed=1, searches=2)
    runs = [delta.solve(double_integrator(0.25), guess, options=options) for _ in range(2)]
    np.testing.assert_array_equal(runs[0].state, runs[1].state)
    assert runs[0].solver.endswith("polished")
    assert runs[0].history[-1].iterations <= 600
    assert runs[0].residuals["boundary"] < 2e-6
    assert runs[0].final_time == pytest.approx(math.sqrt(3.0), abs=1e-5)
    spent = delta.Options(evaluations=600, polish=delta.Polish(300))
    with pytest.raises(SailnetError, match="an evaluation a stage and search"):
        delta.solve(double_integrator(), guess, options=spent)

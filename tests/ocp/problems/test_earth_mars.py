"""The transfer of least fuel against the paper's equations by hand."""

import numpy as np
import pytest

from sailnet.ocp import (
    HyperbolicTangent,
)
from sailnet.ocp.definition.functions import ExtremalFunctions
from sailnet.ocp.problems import (
    earth_mars,
)
from tests.ocp.posed import points


def test_earth_mars_is_eqs_36_to_44() -> None:
    problem = earth_mars.problem()
    t_max, c = 0.0843158, 0.6585027
    functions = ExtremalFunctions(problem, HyperbolicTangent())
    table = points(problem, 10)
    r, m, lr, lv, lm = table[:, :3], table[:, 6], table[:, 7:10], table[:, 10:13], table[:, 13]
    size, radius = np.linalg.norm(lv, axis=1), np.linalg.norm(r, axis=1)[:, None]
    s = c * size / m + lm - 1.0
    delta = 0.5 * (1.0 + np.tanh(s / 0.3))
    rate = lv / radius**3 - 3.0 * np.sum(r * lv, axis=1)[:, None] / radius**5 * r
    slopes = functions.slopes(0.0, table, 0.3)
    np.testing.assert_allclose(functions.switching(0.0, table, 0.3)[:, 0], -s, atol=1e-6)
    np.testing.assert_allclose(
        functions.control(0.0, table, 0.3), np.column_stack([-lv / size[:, None], delta]), atol=1e-6
    )
    np.testing.assert_allclose(slopes[:, 7:10], rate, rtol=1e-10)
    np.testing.assert_allclose(slopes[:, 10:13], -lr, rtol=1e-13)
    np.testing.assert_allclose(slopes[:, 13], -t_max * delta / m**2 * size, rtol=1e-5)
    assert problem.time_guess == pytest.approx(6.000006, abs=1e-6)

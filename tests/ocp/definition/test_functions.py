"""A problem's own functions and their derivatives, against finite differences."""

import numpy as np
import pytest

from sailnet.ocp.definition.functions import ProblemFunctions
from tests.ocp.posed import PROBLEMS, differences, points


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_problems_own_derivatives(name: str) -> None:
    problem = PROBLEMS[name]()
    own, n = ProblemFunctions(problem), len(problem.states)
    rng = np.random.default_rng(2)
    for y in points(problem, 2, seed=3):
        x, u = y[:n], rng.uniform(0.1, 0.9, len(problem.control_variables))
        by_x = differences(lambda at: own.dynamics(0.1, at, u)[0], x)  # noqa: B023
        by_u = differences(lambda at: own.dynamics(0.1, x, at)[0], u)  # noqa: B023
        np.testing.assert_allclose(
            own.dynamics_by_state(0.1, x, u)[0], by_x, rtol=1e-5, atol=1e-6 * np.abs(by_x).max()
        )
        np.testing.assert_allclose(own.dynamics_by_control(0.1, x, u)[0], by_u, rtol=1e-6, atol=1e-8)
        by_u = differences(lambda at: own.hamiltonian(0.1, x, y[n:], at), u)[0]  # noqa: B023
        np.testing.assert_allclose(
            own.hamiltonian_by_control(0.1, x, y[n:], u)[0], by_u, rtol=1e-6, atol=1e-8
        )

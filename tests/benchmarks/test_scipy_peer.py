"""The peer written with SciPy alone solves the problem that is timed."""

import numpy as np
import pytest

from benchmarks import scipy_peer
from sailnet.mission.mission import load_mission
from sailnet.physics.extremals import arrival_lambda_v
from tests import reference

PROBLEM = load_mission("earth_mars").problem


@pytest.mark.parametrize("numpy", [False, True])
def test_extremals_are_those_of_the_reference(numpy: bool) -> None:
    lambda_u = np.array([-0.3, 0.4])
    starts = zip([-0.5, 0.7], lambda_u, arrival_lambda_v(PROBLEM, lambda_u, 1.0), strict=True)
    jumps = 0
    tau = np.linspace(0.0, 6.0, 25)
    for costates in starts:
        found = scipy_peer.propagate(PROBLEM, costates, tau, numpy=numpy)
        expected = reference.fly(PROBLEM, [*PROBLEM.target_state, *costates], tau)
        np.testing.assert_allclose(found, expected.states, atol=1e-8)
        jumps += len(expected.jump_times)
    assert jumps > 0

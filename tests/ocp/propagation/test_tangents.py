"""Tangents in lanes against finite differences."""

import numpy as np

from sailnet.ocp import (
    L2Norm,
)
from sailnet.ocp.problems import reorientation
from sailnet.ocp.solvers.shooting_equations import Shooting
from tests.ocp.posed import differences


def test_tangents_in_lanes_are_exact() -> None:
    """Five tangents and a remainder of a second sweep, where the processor has four lanes."""
    equations = Shooting(reorientation.problem(), L2Norm(), 1e-12)
    assert equations.flow._in_lanes
    z = equations.guess([-0.7, 0.4, -0.3, 0.6, 0.2], 2.5)
    value, jacobian = equations.linearise(z, 0.1)
    np.testing.assert_array_equal(value, equations.residual(z, 0.1))
    expected = differences(lambda at: equations.residual(at, 0.1), z, 1e-6)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-5, atol=1e-6 * np.abs(expected).max())

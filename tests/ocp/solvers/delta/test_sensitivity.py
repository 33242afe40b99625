"""Sensitivities of flights against finite differences."""

import numpy as np
import pytest

from sailnet.ocp import (
    Problem,
)
from sailnet.ocp.problems import asteroid_rendezvous, leo_geo, lunar_landing
from sailnet.ocp.solvers import delta
from sailnet.ocp.solvers.delta.controls import Controls
from sailnet.ocp.solvers.delta.flight import Flyer
from sailnet.ocp.solvers.delta.sensitivity import linearised, switches
from sailnet.physics.arrays import Array
from tests.ocp.solvers.delta.cases import least_effort


@pytest.mark.slow
@pytest.mark.parametrize("softness", [0.0, 0.4])
@pytest.mark.parametrize(
    ("problem", "basis", "rtol"),
    [
        (lunar_landing.problem(), delta.Chebyshev(), 1e-7),
        (asteroid_rendezvous.problem(), delta.Fourier(), 1e-5),
        (leo_geo.minimum_fuel(), delta.Legendre(), 1e-3),
        (least_effort(), delta.Legendre(), 1e-3),
    ],
    ids=lambda value: getattr(value, "name", None),
)
def test_sensitivities_are_those_of_flights(
    problem: Problem, basis: delta.Basis, rtol: float, softness: float
) -> None:
    controls = Controls(problem, basis, 5)
    flyer = Flyer(problem, controls)
    z = 0.3 * np.random.default_rng(4).uniform(*controls.bounds)
    for switched in controls.switched:
        z[5 * switched.channel : 5 * switched.channel + 5] = 0.1, 1.0, 0.3, 0.0, 0.0
    if problem.time_is_free:
        z[-1] = 1.0

    def values(z: Array) -> Array:
        linear = linearised(flyer, z, 100, softness)
        return np.concatenate([[linear.cost], linear.errors])

    linear = linearised(flyer, z, 100, softness)
    assert bool(switches(controls, z)) == bool(controls.switched)
    expected = np.array([(values(z + h) - values(z - h)) / 2e-5 for h in 1e-5 * np.eye(len(z))]).T
    found = np.vstack([linear.cost_slope, linear.error_slopes])
    for row, wanted in zip(found, expected, strict=True):
        np.testing.assert_allclose(row, wanted, atol=rtol * np.abs(wanted).max())
    # What SLSQP makes of others is wrong, and says nothing.
    assert linear.error_slopes.flags.c_contiguous

"""Controls from series."""

import numpy as np
import pytest

from sailnet.ocp import (
    Direction,
    Problem,
    symbols,
)
from sailnet.ocp.solvers import delta
from sailnet.ocp.solvers.delta.controls import Controls
from sailnet.physics.arrays import Array
from tests.ocp.posed import differences


@pytest.mark.parametrize("size", [2, 3])
def test_angles_make_unit_vectors_and_their_tangents(size: int) -> None:
    x = symbols(" ".join(f"x{i}" for i in range(size)))
    a = symbols(" ".join(f"a{i}" for i in range(size)))
    problem = Problem(
        name="steering",
        source="none",
        dynamics=dict(zip(x, a, strict=True)),
        controls=[Direction(tuple(a))],
        final_time=1.0,
        initial=dict.fromkeys(x, 0.0),
        terminal_cost=x[0],
    )
    controls = Controls(problem, delta.Legendre(), 1)
    rng = np.random.default_rng(0)
    angles = rng.uniform(-3.0, 3.0, size - 1)
    weights = rng.standard_normal(size)

    def unit(values: Array) -> Array:
        return np.asarray(controls.controls(values.reshape(1, 1, -1), np.zeros((1, 1, 0)))[0, 0])

    assert np.linalg.norm(unit(angles)) == pytest.approx(1.0, abs=1e-15)
    turned = controls.turned(angles.reshape(1, 1, -1), weights.reshape(1, 1, -1))[0, 0]
    np.testing.assert_allclose(turned, weights @ differences(unit, angles), atol=1e-7)

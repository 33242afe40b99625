"""Training against plain least squares."""

import numpy as np

from sailnet.ocp.solvers.ponn.training import iterative_least_squares, levenberg_marquardt, mean_loss
from sailnet.physics.arrays import Array


def test_training_finds_the_least_squares_of_a_plain_fit() -> None:
    rng = np.random.default_rng(0)
    matrix, target = rng.normal(size=(20, 5)), rng.normal(size=20)
    expected = np.linalg.lstsq(matrix, target, rcond=None)[0]

    def linearise(z: Array) -> tuple[Array, Array]:
        return matrix @ z - target, matrix

    def measure(_: Array, losses: Array) -> float:
        return mean_loss(losses)

    for train in (iterative_least_squares, levenberg_marquardt):
        root = train(linearise, np.zeros(5), 10.0, 50, measure)
        np.testing.assert_allclose(root.z, expected, rtol=1e-6)
        assert root.converged
        assert not train(linearise, np.zeros(5), 1e-9, 50, measure).converged

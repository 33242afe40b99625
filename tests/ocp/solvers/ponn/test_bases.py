"""Free functions and their derivatives."""

import numpy as np
import pytest

from sailnet.errors import SailnetError
from sailnet.ocp.solvers.ponn import Basis, Chebyshev, RandomFeatures


@pytest.mark.parametrize(
    "basis", [Chebyshev(9), RandomFeatures(9), RandomFeatures(9, "logistic"), RandomFeatures(9, "sine")]
)
def test_features_are_differentiated(basis: Basis) -> None:
    z, h = np.linspace(-0.9, 0.9, 5), 1e-5
    before, value, after = (basis.features(z + step, []) for step in (-h, 0.0, h))
    for order in (0, 1):
        expected = (after[order] - before[order]) / (2 * h)
        np.testing.assert_allclose(value[order + 1], expected, atol=1e-7 * np.abs(expected).max())


def test_bases_that_are_none_are_refused() -> None:
    with pytest.raises(SailnetError, match="take tanh, logistic or sine"):
        RandomFeatures(4, "relu")  # type: ignore[arg-type]
    with pytest.raises(SailnetError, match="give at least 1"):
        Chebyshev(0)

"""The series of the delta method."""

import numpy as np
import pytest

from sailnet.ocp.solvers import delta
from sailnet.ocp.solvers.delta.series import zeros
from tests.ocp.posed import differences
from tests.ocp.solvers.delta.cases import BASES


@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_slopes_are_those_of_the_values(basis: delta.Basis) -> None:
    s = np.linspace(0.05, 0.95, 7)
    for row, when in zip(basis.slopes(s, 9), s, strict=True):
        expected = differences(lambda t: basis.values(t, 9)[0], np.array([when]))[:, 0]
        np.testing.assert_allclose(row, expected, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_series_are_orthogonal(basis: delta.Basis) -> None:
    if basis.name == "Fourier":
        s, weights = np.linspace(-1.0, 1.0, 65)[:-1], np.full(64, 1.0 / 32.0)
    else:
        rule = {"Chebyshev": np.polynomial.chebyshev.chebgauss, "Legendre": np.polynomial.legendre.leggauss}
        x, weights = rule[basis.name](40)
        s = 0.5 * (x + 1.0)
    values = basis.values(s, 9)
    gram = values.T @ (weights[:, None] * values)
    np.testing.assert_allclose(gram, np.diag(np.diag(gram)), atol=1e-13)
    assert np.all(np.diag(gram) > 0.05)


@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_zeros_are_all_found(basis: delta.Basis) -> None:
    s = np.linspace(0.0, 1.0, 200)
    wanted = np.array([0.2, 0.21, 0.7])
    f = np.prod(s[:, None] - wanted, axis=1)
    coefficients = np.linalg.lstsq(basis.values(s, 20), f, rcond=None)[0]
    found = zeros(basis, coefficients)
    np.testing.assert_allclose(found, wanted, atol=1e-4)
    np.testing.assert_allclose(basis.values(found, 20) @ coefficients, 0.0, atol=1e-14)

"""Goddard's rocket against the paper's equations by hand."""

import numpy as np

from sailnet.ocp import (
    L2Norm,
)
from sailnet.ocp.definition.functions import ExtremalFunctions
from sailnet.ocp.problems import (
    goddard,
)
from tests.ocp.posed import points


def test_goddard_is_eqs_29_and_30() -> None:
    problem = goddard.problem(4.5)
    functions = ExtremalFunctions(problem, L2Norm())
    table = points(problem, 10)
    h, v, m, lh, lv, lm = table.T
    s = 4.5 * lv / (2 * m) - 4.5 * lm / (2 * 0.5)
    u = -s / np.sqrt(s**2 + 0.3**2)
    drag = 620.0 * v**2 / (2 * m) * np.exp(500 * (1 - h))
    by_hand = lh * v - 4.5 * lm - 4.5 * lm * u - lv / h**2 + 4.5 * lv / (2 * m) * (1 + u) - lv * drag
    np.testing.assert_allclose(functions.switching(0.0, table, 0.3)[:, 0], s, rtol=1e-13)
    np.testing.assert_allclose(functions.control(0.0, table, 0.3)[:, 0], u, rtol=1e-12)
    np.testing.assert_allclose(functions.hamiltonian(0.0, table, 0.3), by_hand, rtol=1e-12, atol=1e-14)

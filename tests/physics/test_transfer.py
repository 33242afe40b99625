"""Several sails in one batch: each row is of its own sail."""

from dataclasses import replace

import numpy as np

from sailnet.physics.optics import OPTICS
from sailnet.physics.transfer import Transfer, Transfers


def test_rows_are_of_their_sails(problem: Transfer) -> None:
    weak = replace(problem, beta=0.9 * problem.beta)
    both = Transfers.of([problem, weak], [2, 1])
    assert both.beta.tolist() == [problem.beta, problem.beta, weak.beta]
    assert both.law is None
    assert both.rows(np.array([2])).beta.tolist() == [weak.beta]
    assert both.target_state == problem.target_state


def test_so_are_their_optics(problem: Transfer) -> None:
    real = replace(problem, delta=0.0, optics=OPTICS["jpl"])
    dull = replace(real, optics=replace(real.optics, reflectivity=0.5))
    both = Transfers.of([real, dull], [1, 2])
    assert both.law is not None
    np.testing.assert_array_equal(
        both.law.coefficients, [real.optics.force, dull.optics.force, dull.optics.force]
    )

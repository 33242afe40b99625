"""What every back end makes of the states and betas it is given."""

import numpy as np
import pytest

from sailnet.errors import GuidanceError
from sailnet.guidance.interface import Precision, as_betas, as_states


@pytest.mark.parametrize("precision", ["float64", "float32"])
def test_states_are_rows_of_one_precision(precision: Precision) -> None:
    given = np.array([[1.0, 0.1, 0.9], [1e300, -1e300, np.nan]])
    states = as_states(given[:, ::-1], precision)
    assert states.dtype == precision
    assert states.flags.c_contiguous
    np.testing.assert_array_equal(states[0], given[0, ::-1].astype(precision))
    assert np.isinf(states[1, 1:]).all() == (precision == "float32")
    assert as_states([(1, 0, 1)], precision).shape == (1, 3)


@pytest.mark.parametrize("states", [[1.0, 0.0, 1.0], [[1.0, 0.0]], [[[1.0, 0.0, 1.0]]], [["r", 0.0, 1.0]]])
def test_other_states_are_refused(states: object) -> None:
    with pytest.raises(GuidanceError, match=r"\(n, 3\) array"):
        as_states(states, "float64")  # type: ignore[arg-type]


def test_betas_are_one_for_each_and_nan_is_the_nominal() -> None:
    np.testing.assert_array_equal(as_betas(None, 3, 0.17, "float64"), [0.17] * 3)
    np.testing.assert_array_equal(as_betas(0.2, 2, 0.17, "float64"), [0.2] * 2)
    np.testing.assert_array_equal(as_betas([0.1, np.nan], 2, 0.17, "float64"), [0.1, 0.17])
    single = as_betas([0.1, np.nan], 2, 0.17, "float32")
    assert single.dtype == "float32"
    assert single.flags.c_contiguous
    with pytest.raises(GuidanceError, match="one for each of 3 states"):
        as_betas([0.1, 0.2], 3, 0.17, "float64")

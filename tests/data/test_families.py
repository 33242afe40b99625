"""Families: which trajectories are near-copies of each other."""

import numpy as np
import pytest

from data.families import families_of, rows_among
from sailnet.dataset import ALONE


def test_no_two_sails_share_a_family_and_daughters_of_none_have_none() -> None:
    flights = np.array([0, 3, ALONE, 3])
    first, second = families_of(0, flights), families_of(1, flights)
    assert first.tolist() == [0, 3, ALONE, 3]
    assert second[2] == ALONE
    assert not set(first[first != ALONE]) & set(second[second != ALONE])
    # As parts of an unfinished data set they may be kept in double precision.
    large = families_of(10_000, flights)
    assert np.array_equal(large.astype(float).astype(np.int64), large)


def test_rows_are_found_to_the_last_bit() -> None:
    every = np.array([[1.0, 2.0], [3.0, 4.0], [1.0, 2.0], [5.0, 6.0]])
    assert rows_among(every[[3, 2, 1]], every).tolist() == [3, 0, 1]
    assert rows_among(every[:0], every).tolist() == []
    with pytest.raises(KeyError):
        rows_among(np.nextafter(every[:1], 2.0), every)

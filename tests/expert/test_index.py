"""The index: what passes through a state is listed for it, and the geometry behind that."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from sailnet.expert.index import Index, build_index
from sailnet.expert.prisms import BIN, Grid, bins_of, meets, sums_of
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.transfer import Transfer
from tests.reference import Array

CENTRE = np.array([0.72, 0.06, 1.25])
"""A state of the Earth-Mars generalisation set in units of the target orbit."""


@pytest.fixture(scope="module")
def unit(problem: Transfer) -> Transfer:
    return Transfer(problem.beta, problem.phi_max, problem.delta, 1.0)


@pytest.fixture(scope="module")
def index(unit: Transfer) -> Index:
    bins = bins_of(CENTRE)[None] + np.argwhere(np.ones((4, 4, 4), bool)) - 2
    return build_index(unit, tuple(map(tuple, bins.tolist())))


@pytest.fixture(scope="module")
def passing(unit: Transfer) -> tuple[Array, Array, Array]:
    """Random extremals where they pass through the index: their directions, times to go and states."""
    directions = np.random.default_rng(12).normal(size=(20000, 3))
    directions = directions[arrival_gain(unit, directions) < 0.0]
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    tau = np.linspace(0.0, 8.0, 321)
    states = np.concatenate(
        [
            propagate_extremals(unit, rows, tau).states[:, :, :3]
            for rows in np.array_split(directions, len(directions) // 200)
        ]
    )
    low = BIN * (bins_of(CENTRE) - 2)
    extremal, sample = np.nonzero(((states > low) & (states < low + 4 * BIN)).all(axis=2))
    return directions[extremal], tau[sample], states[extremal, sample]


@pytest.mark.slow
def test_an_extremal_is_found_where_it_passes(index: Index, passing: tuple[Array, Array, Array]) -> None:
    directions, tau, states = passing
    assert len(tau) > 30
    guesses = index.look_up(states)
    turned = np.linalg.norm(guesses.directions - directions[guesses.state], axis=1)
    later = np.abs(guesses.tau - tau[guesses.state])
    hit = (turned < 0.02) & (later < 0.02)
    faster = np.full(len(tau), np.inf)
    np.minimum.at(faster, guesses.state, guesses.tau)
    found = np.isin(np.arange(len(tau)), guesses.state[hit])
    assert (found | (faster < tau)).all()
    assert found.mean() > 0.9
    np.testing.assert_allclose(np.linalg.norm(guesses.directions, axis=1), 1.0, rtol=1e-12)


def test_look_up_of_many_is_look_up_of_each(index: Index) -> None:
    """More states than are looked up at once, so that the rows of all parts count."""
    low = BIN * (bins_of(CENTRE) - 2)
    states = np.random.default_rng(3).uniform(low, low + 4 * BIN, (450, 3))
    together = index.look_up(states)
    for row in (0, 7, 199, 200, 399, 400, 449):
        alone = index.look_up(states[[row]])
        mine = together.state == row
        assert mine.sum() == len(alone.tau) > 0
        for name in ("directions", "tau", "outside", "width"):
            np.testing.assert_array_equal(getattr(together, name)[mine], getattr(alone, name))
    assert (together.outside >= 0.0).all()


def test_the_bins_are_half_open_cubes() -> None:
    states = np.array([[0.0, 0.0, 1.0], [0.0, -1e-12, 1.0 - 1e-12], [BIN, 0.99 * BIN, 1.0 + BIN]])
    np.testing.assert_array_equal(bins_of(states), [[0, 0, 64], [0, -1, 63], [1, 0, 65]])


cells = arrays(np.int64, (12, 3), elements=st.integers(-4, 4))
corners = arrays(float, (9, 3), elements=st.floats(-7.5, 7.5).map(lambda x: x * BIN))
sizes = arrays(float, (9, 3), elements=st.floats(-2.0, 6.0).map(lambda x: x * BIN))


@settings(max_examples=60, deadline=None)
@given(cells, corners, sizes)
def test_boxes_and_bins_that_meet_against_brute_force(
    bins: np.ndarray[tuple[int, int], np.dtype[np.int64]], lowest: Array, size: Array
) -> None:
    """Boxes may be empty, outside or of no extent at all (NaN)."""
    highest = lowest + size
    lowest[0, 1] = np.nan
    highest[1, 2] = np.nan
    wanted = np.unique(bins, axis=0)
    grid = Grid(wanted)
    assert len(grid) == len(wanted)
    np.testing.assert_array_equal(grid.places + grid.low, wanted)
    expected = set()
    for box in range(len(lowest)):
        first, last = np.floor(lowest[box] / BIN), np.floor(highest[box] / BIN)
        for number, place in enumerate(wanted):
            if (first <= place).all() and (place <= last).all():
                expected.add((box, number))
    boxes, numbers = grid.listing(lowest, highest)
    assert len(boxes) == len(expected)
    assert set(zip(boxes.tolist(), numbers.tolist(), strict=True)) == expected
    met = meets(sums_of(grid.wanted), *grid.span(lowest, highest))
    np.testing.assert_array_equal(met, np.isin(np.arange(len(lowest)), list({b for b, _ in expected})))
    np.testing.assert_array_equal(
        grid.numbers(np.asarray((wanted + 0.5) * BIN, float)), np.arange(len(wanted))
    )


def test_far_apart_bins_need_no_more_memory_than_near_ones() -> None:
    """A box of millions of bins of which two are wanted: nothing is listed for the others."""
    grid = Grid(np.array([[40, -50, 20], [240, 50, 120]]))
    box, number = grid.listing(np.full((50, 3), -9.0), np.full((50, 3), 9.0))
    np.testing.assert_array_equal(np.bincount(box), np.full(50, 2))
    np.testing.assert_array_equal(np.bincount(number), [50, 50])


@pytest.mark.slow
def test_few_prisms_and_states_together_are_listed_as_all_at_once(
    index: Index, unit: Transfer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of real sails all at once does not fit into memory."""
    numbers = np.argwhere(np.ones((4, 4, 4), bool)) - 2
    bins = tuple(map(tuple, (bins_of(CENTRE)[None] + numbers).tolist()))
    rng = np.random.default_rng(3)
    states = BIN * (bins_of(CENTRE) - 2 + rng.uniform(0.0, 4.0, (40, 3)))
    at_once = index.look_up(states)
    for name, value in (("TOGETHER", 7), ("STATES", 6), ("LOOKED_AT", 50)):
        monkeypatch.setattr(f"sailnet.expert.index.{name}", value)
    assert len(index) > 10 * 7
    in_parts = build_index.__wrapped__(unit, bins).look_up(states)
    for one, other in zip(vars(at_once).values(), vars(in_parts).values(), strict=True):
        np.testing.assert_array_equal(one, other)

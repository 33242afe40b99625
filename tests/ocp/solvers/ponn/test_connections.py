"""Constrained expressions against the papers' tables, for any free function."""

from typing import Literal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sailnet.errors import SailnetError
from sailnet.ocp.solvers.ponn import Basis, Chebyshev, RandomFeatures
from sailnet.ocp.solvers.ponn.connections import Connections, EndCondition

FIRST, LAST = EndCondition(0, 0), EndCondition(1, 0)


FIRST_SLOPE, LAST_SLOPE = EndCondition(0, 1), EndCondition(1, 1)


ACTIVATIONS: list[Literal["tanh", "logistic", "sine"]] = ["tanh", "logistic", "sine"]


ALL = [FIRST, LAST, FIRST_SLOPE, LAST_SLOPE]


@pytest.mark.parametrize("ends", [(-1.0, 1.0), (2.0, 5.0)])
def test_switching_functions_are_the_tables(ends: tuple[float, float]) -> None:
    first, last = ends
    z = np.linspace(first, last, 7)
    d, s = last - first, z - first
    tables = {
        (FIRST,): [1 + 0 * z],
        (LAST_SLOPE,): [z],
        (FIRST, LAST): [(last - z) / d, s / d],
        (FIRST, FIRST_SLOPE): [1 + 0 * z, s],
        (FIRST, LAST, FIRST_SLOPE): [
            (last - z) * (z - 2 * first + last) / d**2,
            s**2 / d**2,
            s * (last - z) / d,
        ],
        (FIRST, LAST, FIRST_SLOPE, LAST_SLOPE): [
            1 + 2 * s**3 / d**3 - 3 * s**2 / d**2,
            -2 * s**3 / d**3 + 3 * s**2 / d**2,
            s + s**3 / d**2 - 2 * s**2 / d,
            s**3 / d**2 - s**2 / d,
        ],
    }
    for conditions, columns in tables.items():
        switching = Connections(conditions, ends).switching(z)
        np.testing.assert_allclose(switching, np.column_stack(columns), atol=1e-12)


@st.composite
def bases(draw: st.DrawFn) -> Basis:
    neurons = draw(st.integers(1, 20))
    if draw(st.booleans()):
        return Chebyshev(neurons)
    seed = draw(st.integers(0, 99))
    return draw(st.sampled_from([RandomFeatures(neurons, name, seed=seed) for name in ACTIVATIONS]))


@settings(max_examples=60, deadline=None)
@given(bases(), st.sets(st.sampled_from(ALL)), st.integers(0, 2**32 - 1))
def test_expressions_hold_their_ends_whatever_the_free_function(
    basis: Basis, chosen: set[EndCondition], seed: int
) -> None:
    connections = Connections(tuple(sorted(chosen)))
    rng, ends = np.random.default_rng(seed), np.array([-1.0, 1.0])
    features = basis.features(ends, connections.degrees)
    weights = rng.normal(size=features[0].shape[1])
    values = rng.normal(size=len(chosen))
    free = connections.free(features, features, ends)
    at_ends = [free[order] @ weights + connections.switching(ends, order) @ values for order in range(2)]
    scale = 1.0 + max(float(np.abs(f).max()) for f in features[:2]) * np.abs(weights).sum()
    for condition, value in zip(connections.conditions, values, strict=True):
        assert abs(at_ends[condition.derivative][condition.end] - value) < 1e-13 * scale


def test_an_end_condition_stands_once() -> None:
    with pytest.raises(SailnetError, match="given twice"):
        Connections((FIRST, FIRST))

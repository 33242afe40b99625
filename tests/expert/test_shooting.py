"""Backward shooting: what its Newton steps cost."""

from collections import Counter

import numpy as np
import pytest

from sailnet.expert import shooting
from sailnet.expert.shooting import Shots, shoot
from sailnet.physics.propagation import TOLERANCE, Propagator
from sailnet.physics.transfer import AnyTransfer, Transfer
from tests.reference import Array

STATE = np.array([[1.101, 0.067, 1.2165]])
DIRECTION, TAU = np.array([[0.217441565317, 0.436443319412, 0.873061506776]]), np.array([26.62664169])
"""An extremal from this state, from a search of its own."""

Flight = tuple[bool, float, bytes, float]
"""Whether with derivatives; tolerance; direction and time."""


@pytest.fixture
def flights(monkeypatch: pytest.MonkeyPatch) -> "Counter[Flight]":
    """Every flight that shooting makes."""
    counted: Counter[Flight] = Counter()
    real = shooting._fly_back

    def fly_back(
        engine: Propagator, transfer: AnyTransfer, targets: Array, directions: Array, tau: Array
    ) -> tuple[Shots, Array]:
        kind = engine.variational, engine.integrator.tol
        counted.update((*kind, *row) for row in zip(map(bytes, directions), tau.tolist(), strict=True))
        return real(engine, transfer, targets, directions, tau)

    monkeypatch.setattr(shooting, "_fly_back", fly_back)
    return counted


@pytest.mark.parametrize("off", [1e-3, 0.05, 0.3])
def test_no_flight_with_derivatives_is_made_twice(
    off: float, problem: Transfer, flights: "Counter[Flight]"
) -> None:
    """Not even where step after step leads nowhere."""
    turned = DIRECTION + off * np.array([[1.0, 0.0, -1.0]])
    shots = shoot(problem, STATE, turned, TAU + off)
    assert (shots.residual[0] < 1e-11) == (off < 0.01)
    with_derivatives = {flight: times for flight, times in flights.items() if flight[0]}
    assert with_derivatives
    assert set(with_derivatives.values()) == {1}


def test_a_guess_that_leads_nowhere_is_not_flown_accurately(
    problem: Transfer, flights: "Counter[Flight]"
) -> None:
    shots = shoot(problem, np.array([[3.0, 0.0, 0.3]]), DIRECTION, np.array([1.0]), iterations=4)
    assert shots.residual[0] > shooting.PROMISING
    assert {flight[1] for flight in flights} == {shooting.ROUGH}
    assert shoot(problem, STATE, DIRECTION, TAU).residual[0] < 1e-11
    assert TOLERANCE in {flight[1] for flight in flights}

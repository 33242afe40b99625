"""The time left where a flight ended short: a lower bound, held against extremals and a bang-bang flight."""

import math
from dataclasses import replace

import numpy as np
import pytest

from sailnet.campaign.time_to_go import MISSED, least_time, time_to_go
from sailnet.flight.closed_loop import Ending, fly
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.geometry import in_space
from sailnet.physics.optics import OPTICS
from sailnet.physics.transfer import Transfer
from tests.pilots import MISSION, Constant

TRANSFER = MISSION.problem
TARGET = np.array(TRANSFER.target_state)
PULL = TRANSFER.beta / TRANSFER.target_radius**2


def extremals_before_arrival(transfer: Transfer, tau: float, components: int = 3) -> Array:
    """(n, components) states with this time to go, whatever the direction they come from."""
    drawn = np.random.default_rng(8).normal(size=(2000, components))
    directions = drawn / np.linalg.norm(drawn, axis=1, keepdims=True)
    directions = directions[arrival_gain(transfer, directions) < 0.0]
    return np.asarray(propagate_extremals(transfer, directions, [0.0, tau]).states[:, 1, :components])


@pytest.mark.parametrize(("tau", "too_much"), [(0.003, 1.002), (0.01, 1.006), (0.1, 1.05)])
@pytest.mark.parametrize(
    ("bound", "optics"), [(60.0, "ideal"), (90.0, "ideal"), (30.0, "ideal"), (60.0, "jpl"), (89.0, "nasa")]
)
def test_no_extremal_is_sooner_there(tau: float, too_much: float, bound: float, optics: str) -> None:
    """But for what gravity does in the meantime; and the bound is not idle."""
    delta = TRANSFER.delta if optics == "ideal" else 0.0
    transfer = replace(TRANSFER, phi_max=math.radians(bound), delta=delta, optics=OPTICS[optics])
    states = extremals_before_arrival(transfer, tau)
    assert len(states) > 900
    share = least_time(transfer, states, transfer.beta) / tau
    assert share.max() < too_much
    if bound == 60.0:
        assert share.min() > 0.54
        assert np.median(share) > 0.94


@pytest.mark.parametrize(("tau", "too_much"), [(0.003, 1.002), (0.01, 1.006), (0.1, 1.06)])
@pytest.mark.parametrize("bound", [60.0, 30.0])
def test_no_extremal_is_sooner_there_in_space(tau: float, too_much: float, bound: float) -> None:
    transfer = replace(TRANSFER, phi_max=math.radians(bound), delta=0.0)
    states = extremals_before_arrival(transfer, tau, 5)
    assert len(states) > 900
    share = least_time(transfer, states, transfer.beta) / tau
    assert share.max() <= too_much
    assert np.median(share) > 0.75


def test_in_the_plane_it_is_the_plane_s() -> None:
    states = np.array(TRANSFER.target_state) + 1e-3 * np.random.default_rng(2).normal(size=(50, 3))
    flat, lifted = (least_time(TRANSFER, of, TRANSFER.beta) for of in (states, in_space(states)))
    np.testing.assert_allclose(lifted, flat, rtol=1e-12)


def test_off_the_plane_it_is_a_double_integrator_of_the_thrust_across() -> None:
    """From rest at a height z: 2 sqrt(z / b), with b = a 2 / (3 sqrt(3)) of an ideal sail."""
    height = 1e-4
    state = in_space(np.array(TRANSFER.target_state))
    state[1] = height / TRANSFER.target_radius
    across = PULL * 2.0 / (3.0 * math.sqrt(3.0))
    assert least_time(TRANSFER, state, TRANSFER.beta)[0] == pytest.approx(2.0 * math.sqrt(height / across))


def test_it_scales_with_the_sail_and_is_nothing_at_the_target() -> None:
    off = TARGET + np.array([[0.0, 1e-3, -1e-3]])
    weak, strong = least_time(TRANSFER, np.repeat(off, 2, axis=0), [0.1, 0.2])
    assert weak == pytest.approx(2.0 * strong, rel=1e-12)
    assert least_time(TRANSFER, [TRANSFER.target_state], TRANSFER.beta)[0] == 0.0


def test_the_radial_part_is_a_double_integrator() -> None:
    """Full pull to a switch, and full pull back: the textbook's flight, integrated."""
    for x, u in ((1e-3, 0.0), (-2e-4, 3e-3), (1e-4, 5e-3), (-1e-4, -5e-3)):
        state = TARGET + np.array([x, u, 0.0])
        total = least_time(TRANSFER, state, TRANSFER.beta)[0]
        side = -1.0 if x + u * abs(u) / (2.0 * PULL) < 0.0 else 1.0
        first = (total + side * u / PULL) / 2.0
        distance = x + u * total - side * PULL * (first * (total - first / 2.0) - (total - first) ** 2 / 2.0)
        speed = u - side * PULL * (2.0 * first - total)
        assert (distance, speed) == pytest.approx((0.0, 0.0), abs=1e-12)


def test_it_counts_only_for_flights_that_were_stopped_near_by() -> None:
    flights = fly(MISSION, Constant(0.0), [(1.0, 0.0, 1.0)] * 4)
    tolerance = MISSION.flight.arrival_tolerance
    ends = TARGET + np.outer(
        [1e-4, 0.99 * MISSED * tolerance, 1.01 * MISSED * tolerance, 1e-4], [0.0, 0.0, 1.0]
    )
    ending = np.array([Ending.STOPPED] * 3 + [Ending.TOO_LONG], np.int32)
    bent = replace(
        flights,
        ends=ends,
        terminal_error=abs(ends - TARGET),
        ending=ending,
        beta_error=np.array([-0.1, 0, 0, 0]),
    )
    expected = least_time(TRANSFER, ends, TRANSFER.beta * np.array([0.9, 1.0, 1.0, 1.0]))
    found = time_to_go(MISSION, bent)
    np.testing.assert_array_equal(found[:2], expected[:2])
    assert np.isnan(found[2:]).all()

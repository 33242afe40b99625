"""Random starts of closed-loop flights."""

from dataclasses import fields, replace

import numpy as np
import pytest
from numpy.typing import ArrayLike

from sailnet.errors import GuidanceError
from sailnet.expert.fastest import solve_states
from sailnet.expert.optima import Optima
from sailnet.flight import starts as module
from sailnet.flight.starts import (
    BEYOND,
    DEPARTURE,
    inside_domain,
    near_departure,
    off_optima,
    random_starts,
)
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import Commands, GuidanceStatus
from sailnet.mission.mission import load_mission
from sailnet.physics.geometry import target_of
from tests.guidance.pilots import Told
from tests.pilots_in_space import ARRIVAL, FASTEST, SPACE, START

MISSION = load_mission("earth_mars")


def test_starts_fill_the_generalisation_set() -> None:
    region = MISSION.generalisation
    starts = random_starts(MISSION, 2000, seed=9)
    for column, (low, high) in enumerate((region.r, region.u, region.v)):
        values = (starts[:, column] - low) / (high - low)
        assert values.min() > 0.0
        assert values.max() < 1.0
        assert values.mean() == pytest.approx(0.5, abs=0.03)
        assert values.std() == pytest.approx(1 / np.sqrt(12), abs=0.01)
    np.testing.assert_array_equal(random_starts(MISSION, 5, seed=9, first=7), starts[7:12])


@pytest.mark.parametrize("name", ["earth_mars", "mars_earth"])
def test_they_fill_what_lies_about_the_departure_orbit(name: str) -> None:
    mission = load_mission(name)
    radius = mission.transfer.departure_radius
    starts = near_departure(mission, 2000, seed=9)
    off = (starts - [radius, 0.0, radius**-0.5]) / [radius, radius**-0.5, radius**-0.5] / DEPARTURE
    assert abs(off).max() < 1.0
    np.testing.assert_allclose(off.mean(axis=0), 0.0, atol=0.04)
    np.testing.assert_allclose(off.std(axis=0), 1 / np.sqrt(3), atol=0.03)
    np.testing.assert_array_equal(near_departure(mission, 5, seed=9, first=7), starts[7:12])


@pytest.mark.slow
def test_they_are_off_an_optimal_flight_by_a_share_of_what_is_left(monkeypatch: pytest.MonkeyPatch) -> None:
    flights = solve_states(MISSION.problem, np.array([[1.0, 0.0, 1.0], [1.1, 0.05, 0.9]]))
    monkeypatch.setattr(module, "some_optima", lambda _: flights)
    on, off, farther = (off_optima(MISSION, 40, 3, error) for error in (1e-14, 0.01, 0.03))
    radius = MISSION.problem.target_radius
    units = np.array([radius, radius**-0.5, radius**-0.5])
    left = np.linalg.norm((on - MISSION.problem.target_state) / units, axis=1)
    np.testing.assert_allclose(np.linalg.norm((off - on) / units, axis=1), 0.01 * left, rtol=1e-9)
    np.testing.assert_allclose(farther - on, 3.0 * (off - on), atol=1e-12)
    np.testing.assert_array_equal(off_optima(MISSION, 3, 3, 0.01, first=5), off[5:8])
    # What is left of an optimum is one: the extremal from there arrives as one of the two does.
    rest = solve_states(MISSION.problem, on[:6])
    apart = abs(rest.arrival_costates[:, None] - flights.arrival_costates).max(axis=2)
    assert apart.min(axis=1).max() < 1e-4
    assert set(apart.argmin(axis=1)) == {0, 1}
    assert (rest.time_of_flight < flights.time_of_flight[apart.argmin(axis=1)]).all()


def test_they_are_of_what_the_guidance_says_it_knows() -> None:
    guidance = load_guidance(MISSION)
    starts = inside_domain(MISSION, guidance, 300, seed=9)
    assert (guidance.command(starts).status != GuidanceStatus.OUTSIDE_DOMAIN).all()
    # Far beyond the generalisation set, which is a small part of it.
    low, high = MISSION.generalisation.corners
    assert ((starts >= low) & (starts <= high)).all(axis=1).mean() < 0.2
    assert starts[:, 0].max() > 3.0
    np.testing.assert_array_equal(inside_domain(MISSION, guidance, 5, seed=9, first=7), starts[7:12])


class Ignorant(Told):
    """Knows no state."""

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        count = len(np.asarray(states))
        said = super().command(states, 0.1 * np.ones(count))
        return replace(said, status=np.full(count, GuidanceStatus.OUTSIDE_DOMAIN, np.int32))


def test_a_guidance_that_knows_nothing_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "ROUNDS", 2)
    with pytest.raises(GuidanceError, match="of 1,024 states about the orbits the guidance knows none"):
        inside_domain(MISSION, Ignorant(), 3, seed=1)


def test_in_space_they_fill_the_generalisation_set_too() -> None:
    low, high = SPACE.generalisation.corners_in_space
    starts = random_starts(SPACE, 2000, seed=9)
    share = (starts - low) / (high - low)
    assert share.min() > 0.0
    assert share.max() < 1.0
    np.testing.assert_allclose(share.mean(axis=0), 0.5, atol=0.03)
    np.testing.assert_allclose(share.std(axis=0), 1 / np.sqrt(12), atol=0.01)
    np.testing.assert_array_equal(random_starts(SPACE, 5, seed=9, first=7), starts[7:12])


def test_they_fill_what_lies_about_an_inclined_orbit(monkeypatch: pytest.MonkeyPatch) -> None:
    wide = near_departure(SPACE, 1000, seed=9)
    np.testing.assert_array_equal(near_departure(SPACE, 5, seed=9, first=7), wide[7:12])
    off = wide - [1.0, 0.0, 0.0, 1.0, 0.0]
    inclination = np.radians(SPACE.transfer.inclination)
    assert (abs(off).max(axis=0) <= DEPARTURE + np.array([0.0, 1.0, 0.0, 1.0, 1.0]) * inclination).all()
    # With no neighbourhood: the orbit itself, everywhere along it.
    monkeypatch.setattr(module, "DEPARTURE", 0.0)
    orbit = near_departure(SPACE, 1000, seed=9)
    tilt = orbit[:, 3] * np.cos(orbit[:, 1])  # the angular momentum along the axis
    np.testing.assert_allclose(tilt, np.cos(inclination), rtol=1e-14)
    np.testing.assert_allclose(orbit[:, 3] ** 2 + orbit[:, 4] ** 2, 1.0, rtol=1e-14)
    argument = np.arctan2(np.sin(orbit[:, 1]), orbit[:, 4] * np.cos(orbit[:, 1]))
    assert np.histogram(argument, 8, (-np.pi, np.pi))[0].min() > 80


def test_in_space_they_are_off_an_optimal_flight_by_a_share_of_what_is_left(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Of the expert's optimum from the departure, and its mirror image."""
    mirror = np.array([np.ones(5), [1.0, -1.0, 1.0, 1.0, -1.0]])
    numbers = {item.name: np.zeros(2) for item in fields(Optima)}
    known = {"state": START * mirror, "arrival_costates": ARRIVAL * mirror}
    flights = Optima(**(numbers | known | {"time_of_flight": np.full(2, FASTEST)}))
    monkeypatch.setattr(module, "some_optima", lambda _: flights)
    on, off = (off_optima(SPACE, 40, 3, error) for error in (1e-14, 0.01))
    problem = SPACE.problem
    speed = problem.target_radius**-0.5
    units = np.array([problem.target_radius, 1.0, speed, speed, speed])
    left = np.linalg.norm((on - target_of(problem, 5)) / units, axis=1)
    np.testing.assert_allclose(np.linalg.norm((off - on) / units, axis=1), 0.01 * left, rtol=1e-9)
    assert (on[:, 1] > 0.0).any()
    assert (on[:, 1] < 0.0).any()


class Northern(Told):
    """Knows states to the north alone."""

    mission = SPACE

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        shown = np.asarray(states, float)
        known = np.where(shown[:, 1] > 0.0, GuidanceStatus.OK, GuidanceStatus.OUTSIDE_DOMAIN)
        return replace(super().command(states, 0.1 * np.ones(len(shown))), status=known.astype(np.int32))


def test_in_space_they_are_looked_for_off_the_plane_too() -> None:
    starts = inside_domain(SPACE, Northern(), 200, seed=9)
    high = BEYOND * SPACE.generalisation.corners_in_space[1]
    assert (starts[:, 1] > 0.0).all()
    assert (abs(starts[:, [1, 4]]).max(axis=0) < high[[1, 4]]).all()
    assert (abs(starts[:, [1, 4]]).max(axis=0) > 0.9 * high[[1, 4]]).all()
    np.testing.assert_array_equal(inside_domain(SPACE, Northern(), 5, seed=9, first=7), starts[7:12])

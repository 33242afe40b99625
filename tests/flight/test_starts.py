"""Random starts of closed-loop flights."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import ArrayLike

from sailnet.errors import GuidanceError
from sailnet.expert.fastest import solve_states
from sailnet.flight import starts as module
from sailnet.flight.starts import DEPARTURE, inside_domain, near_departure, off_optima, random_starts
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import Commands, GuidanceStatus
from sailnet.mission.mission import load_mission
from tests.guidance.pilots import Told

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

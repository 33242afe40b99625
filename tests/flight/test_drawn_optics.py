"""Sails whose optical coefficients are drawn around the known ones, one sail a flight."""

from dataclasses import replace

import numpy as np
import pytest

from sailnet.errors import SailnetError
from sailnet.expert.nominal import solve_nominal
from sailnet.expert.real_sails import own_optima
from sailnet.flight.closed_loop import fly
from sailnet.flight.drawn_optics import forces, optics_errors, optics_of_flights
from sailnet.mission.disturbances import Disturbance
from sailnet.physics.optics import OPTICS
from tests.campaign.small_plan import short
from tests.pilots import MISSION, Constant

AROUND = Disturbance(optics=OPTICS["nasa"], reflectivity_spread=0.02, specularity_spread=0.05, seed=4)


def test_each_flight_has_a_sail_of_its_own_within_the_widths() -> None:
    sails = optics_of_flights(MISSION, AROUND, range(300))
    assert len(set(sails)) == 300
    for name, width in (("reflectivity", 0.02), ("specularity", 0.05), ("back_emissivity", 0.0)):
        change = np.array([getattr(sail, name) for sail in sails]) - getattr(OPTICS["nasa"], name)
        assert np.abs(change).max() <= width + 1e-15
        assert not width or (change.max() > 0.9 * width and change.min() < -0.9 * width)
    assert optics_of_flights(MISSION, AROUND, [7, 5]) == [sails[7], sails[5]]
    assert optics_of_flights(MISSION, replace(AROUND, seed=5), [7]) != [sails[7]]


def test_it_flies_as_a_sail_of_just_these_coefficients() -> None:
    """Drawn, or stated: the same flight, whoever flies beside it."""
    mission, pilot, starts = short(0.5), Constant(0.6), [(1.0, 0.0, 1.0)] * 4
    drawn = fly(mission, pilot, starts, disturbance=AROUND, first=2)
    assert len(np.unique(drawn.ends[:, 2])) == 4
    for row, own in enumerate(optics_of_flights(mission, AROUND, range(2, 6))):
        stated = fly(mission, pilot, starts[:1], disturbance=Disturbance(optics=own))
        np.testing.assert_allclose(drawn.ends[row], stated.ends[0], rtol=0.0, atol=1e-15)


def test_without_widths_nothing_is_drawn() -> None:
    assert not optics_errors(MISSION, Disturbance(optics=OPTICS["jpl"]), range(3)).any()
    assert set(optics_of_flights(MISSION, Disturbance(), range(3))) == {MISSION.sail.optics}


def test_the_optimum_is_of_the_sail_that_was_drawn() -> None:
    """Of all at once, and of each alone."""
    problem, nominal = MISSION.problem, solve_nominal(MISSION).smoothed
    sails = optics_of_flights(MISSION, AROUND, range(3))
    start, costates = np.tile([1.0, 0.0, 1.0], (3, 1)), np.tile(nominal.arrival_costates, (3, 1))
    times, beta = np.full(3, nominal.time_of_flight), np.full(3, problem.beta)
    together, _ = own_optima(problem, start, costates, times, beta, sails, search=False)
    assert np.ptp(together.time_of_flight) > 1e-3
    for row, sail in enumerate(sails):
        known = (start[:1], costates[:1], times[:1], beta[:1])
        alone, _ = own_optima(problem, *known, sail, search=False)
        assert alone.time_of_flight[0] == pytest.approx(together.time_of_flight[row], abs=1e-9)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"reflectivity_spread": 0.1}, "reflectivity_spread must leave reflectivity, 1, between"),
        ({"optics": OPTICS["nasa"], "front_emissivity_spread": 0.03}, "front_emissivity, 0.025, between"),
    ],
)
def test_what_cannot_be_drawn_is_refused(given: dict[str, float], said: str) -> None:
    with pytest.raises(SailnetError, match=said):
        fly(MISSION, Constant(0.0), [(1.0, 0.0, 1.0)], disturbance=Disturbance(**given))  # type: ignore[arg-type]


def test_forces_are_those_of_each() -> None:
    sails = [OPTICS["jpl"], OPTICS["ideal"], OPTICS["jpl"]]
    np.testing.assert_array_equal(forces(sails), [sail.force for sail in sails])

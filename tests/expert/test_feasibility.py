"""Missions that cannot be flown are refused by name, before anything is made for them."""

import time
from typing import Any

import pytest

from sailnet.errors import MissionError
from sailnet.expert.feasibility import refuse_infeasible
from sailnet.mission.mission import Mission, load_mission, parse_mission


def mission_of(sail: dict[str, Any], target: float, **sections: object) -> Mission:
    content = {"name": "mine", "sail": sail, "transfer": {"target_radius": target}, **sections}
    return parse_mission(content, "the file")


@pytest.mark.parametrize(
    ("mission", "says"),
    [
        (mission_of({"beta": 0.1}, 1.0), "target_radius = 1 is transfer.departure_radius = 1"),
        (mission_of({"beta": 0.1}, 1.0005), "within the arrival tolerance: there is nothing to fly"),
        (mission_of({"beta": 1e-4}, 1.5), "sail.beta = 0.0001 is too small: no transfer takes less than"),
        (
            mission_of({"beta": 0.01}, 1.5, flight={"longest": 30.0}),
            "flight.longest = 30; 0.022 is the least",
        ),
        (
            mission_of({"beta": 0.15, "max_cone_angle": 1.0}, 1.5, flight={"longest": 60.0}),
            "sail.max_cone_angle = 1 is below what the transfer needs: .* a bound of 2 degrees would do",
        ),
        (mission_of({"beta": 0.15}, 0.7, generalisation={"r": [0.01, 0.1]}), "reaches into the Sun"),
        (
            mission_of(
                {"beta": 0.1}, 1.5, generalisation={"r": [8.0, 9.0], "u": [2.0, 3.0], "v": [3.0, 4.0]}
            ),
            "8 of the 8 corners of .generalisation. are out of reach",
        ),
    ],
)
def test_what_cannot_be_flown_is_refused_by_name_at_once(mission: Mission, says: str) -> None:
    started = time.process_time()
    with pytest.raises(MissionError, match=f"mission 'mine' cannot be flown: .*{says}"):
        refuse_infeasible(mission)
    assert time.process_time() - started < 3.0


def test_a_transfer_that_takes_longer_than_the_longest_flight_is_refused() -> None:
    """The spiral alone, 4.5 TU, would be short enough: the expert knows 7.02."""
    content = mission_of({"beta": 0.16892}, 1.524, flight={"longest": 6.0})
    with pytest.raises(MissionError, match=r"fastest transfer takes 7\.018 TU, and flight\.longest = 6"):
        refuse_infeasible(content)


@pytest.mark.slow
def test_a_shipped_mission_can_be_flown() -> None:
    refuse_infeasible(load_mission("earth_mars"))

"""A sail's strength in other quantities, and a period in hours."""

from typing import Any

import pytest

from sailnet.errors import MissionError
from sailnet.mission.mission import Mission, parse_mission
from sailnet.mission.other_units import SUN_GRAVITY, beta_of_acceleration, beta_of_loading
from sailnet.physics.optics import OPTICS


def mission_of(flight: dict[str, Any] | None = None, **sail: object) -> Mission:
    content: dict[str, Any] = {"sail": sail, "transfer": {"target_radius": 1.5}, "flight": flight or {}}
    return parse_mission(content, "the file")


def test_the_suns_gravity_at_1_au() -> None:
    assert pytest.approx(5.930e-3, rel=1e-4) == SUN_GRAVITY


def test_a_characteristic_acceleration() -> None:
    """The paper's 0.16892 is 1.0017 mm/s^2 with the Sun's gravity of ephemerides."""
    assert beta_of_acceleration(1.0) == pytest.approx(0.168632, abs=5e-7)
    assert beta_of_acceleration(1.0017) == pytest.approx(0.16892, abs=5e-6)
    assert mission_of(characteristic_acceleration_mm_s2=1).sail.beta == beta_of_acceleration(1.0)


def test_a_characteristic_acceleration_is_that_of_the_sail_whatever_its_optics() -> None:
    real = mission_of(characteristic_acceleration_mm_s2=0.6, optics="jpl")
    assert real.sail.beta == mission_of(characteristic_acceleration_mm_s2=0.6).sail.beta


def test_a_loading() -> None:
    """McInnes: 1.53 g/m^2 balance the Sun; 1 mm/s^2 needs some 9.1 g/m^2 of an ideal sail."""
    assert beta_of_loading(1.53, OPTICS["ideal"]) == pytest.approx(1.0, rel=2e-3)
    assert mission_of(loading_g_m2=9.08).sail.beta == pytest.approx(beta_of_acceleration(1.0), rel=2e-3)


def test_of_a_real_sail_a_loading_gives_less() -> None:
    """Facing the Sun, JPL's square sail has 1.816 of the 2 of an ideal one."""
    ratio = mission_of(loading_g_m2=9.0, optics="jpl").sail.beta / mission_of(loading_g_m2=9.0).sail.beta
    assert ratio == pytest.approx(1.816 / 2.0, rel=1e-3)


def test_area_and_mass_are_a_loading() -> None:
    """Of 40 m x 40 m and 16 kg: 10 g/m^2."""
    assert mission_of(area_m2=1600, mass_kg=16.0).sail.beta == mission_of(loading_g_m2=10.0).sail.beta


def test_a_period_in_hours() -> None:
    assert mission_of({"period_hours": 7.0}, beta=0.1).flight.period == pytest.approx(0.0050174, rel=1e-4)


@pytest.mark.parametrize(
    ("sail", "says"),
    [
        ({"beta": 0.1, "loading_g_m2": 9.0}, "give its strength once"),
        ({"characteristic_acceleration_mm_s2": 1.0, "area_m2": 1.0, "mass_kg": 1.0}, "its strength once"),
        ({"loading_g_m2": 9.0, "area_m2": 1.0, "mass_kg": 1.0}, "loading_g_m2 is mass_kg over area_m2"),
        ({"area_m2": 1000.0}, "give both, or neither"),
        ({"loading_g_m2": 0.0}, "loading_g_m2 = 0.0: must be a number above 0"),
        ({"characteristic_acceleration_mm_s2": -1.0}, "mm_s2 = -1.0: must be a number above 0"),
        ({"characteristic_acceleration_mm_s2": "1"}, "mm_s2 = '1': must be a number above 0"),
        ({"area_m2": True, "mass_kg": 1.0}, "area_m2 = True: must be a number above 0"),
        ({"characteristic_acceleration_mm_s2": 10.0}, "must be less than 1"),
    ],
)
def test_a_strength_that_cannot_be_is_named(sail: dict[str, Any], says: str) -> None:
    with pytest.raises(MissionError) as refusal:
        mission_of(**sail)
    assert says in str(refusal.value)


def test_a_period_in_two_units_is_refused() -> None:
    with pytest.raises(MissionError, match="period_hours, not both"):
        mission_of({"period": 0.005, "period_hours": 7.0}, beta=0.1)

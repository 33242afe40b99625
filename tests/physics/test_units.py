"""Units in SI: Kepler's laws in both."""

import math

import pytest

from sailnet.physics.units import AU, AU_PER_TU, DAY, GM_SUN, TU


def test_the_suns_gravitational_parameter_is_1() -> None:
    assert pytest.approx(AU**3 / TU**2, rel=1e-15) == GM_SUN
    assert pytest.approx(math.sqrt(GM_SUN / AU), rel=1e-15) == AU_PER_TU


def test_the_earths_year_and_speed() -> None:
    # The Gaussian year, of a massless planet at 1 AU, and the mean orbital speed of the Earth.
    assert 2.0 * math.pi * TU / DAY == pytest.approx(365.2568983, abs=1e-5)
    assert pytest.approx(29_784.7, abs=0.1) == AU_PER_TU

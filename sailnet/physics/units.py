"""Units in SI. Lengths are in AU, times in TU: the gravitational parameter of the Sun is 1 AU^3/TU^2."""

import math

AU = 149_597_870_700.0
"""Astronomical unit [m], exactly: IAU 2012, resolution B2."""

GM_SUN = 1.32712440018e20
"""Gravitational parameter of the Sun [m^3/s^2]: JPL's ephemeris DE405."""

TU = math.sqrt(AU**3 / GM_SUN)
"""Time unit [s], some 58.13 days: a circular orbit at 1 AU turns by 1 rad in it."""

AU_PER_TU = AU / TU
"""Unit of speed [m/s]: that of a circular orbit at 1 AU."""

HOUR = 3_600.0
"""[s]"""

DAY = 24.0 * HOUR
"""[s]"""


def orbital_period(radius: float) -> float:
    """Of a circular orbit about the Sun [TU], by Kepler's third law; the radius in AU."""
    return float(math.tau * radius**1.5)

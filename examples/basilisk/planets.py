"""Planets on ellipses about the Sun, offline.

Of what Basilisk has, SPICE needs kernels, and ``planetEphemeris`` knows no haste.
"""

import math
from dataclasses import dataclass

import numpy as np
from Basilisk.architecture import messaging, sysModel
from Basilisk.utilities import orbitalMotion
from guidance_module import HASTE

from sailnet.physics.units import AU, DAY, GM_SUN


@dataclass(frozen=True)
class Ellipse:
    """An orbit in the ecliptic of J2000.

    Attributes:
        a: semi-major axis [AU].
        e: eccentricity.
        i: inclination [deg].
        longitude: mean, at J2000 [deg].
        perihelion: its longitude [deg].
        node: longitude of the ascending node [deg].
    """

    a: float
    e: float
    i: float
    longitude: float
    perihelion: float
    node: float

    def state(self, time: float) -> tuple[list[float], list[float]]:
        """Position [m] and velocity [m/s], some seconds after J2000."""
        elements = orbitalMotion.ClassicElements()
        elements.a, elements.e, elements.i = self.a * AU, self.e, math.radians(self.i)
        elements.Omega = math.radians(self.node)
        elements.omega = math.radians(self.perihelion - self.node)
        mean = math.radians(self.longitude - self.perihelion) + time * math.sqrt(GM_SUN / elements.a**3)
        elements.f = orbitalMotion.E2f(orbitalMotion.M2E(math.remainder(mean, 2.0 * math.pi), self.e), self.e)
        position, velocity = orbitalMotion.elem2rv(GM_SUN, elements)
        return list(position), list(velocity)


ELLIPSES = {
    "venus": Ellipse(0.72333566, 0.00677672, 3.39467605, 181.97909950, 131.60246718, 76.67984255),
    "earth": Ellipse(1.00000261, 0.01671123, -0.00001531, 100.46457166, 102.93768193, 0.0),
    "mars": Ellipse(1.52371034, 0.09339410, 1.84969142, -4.55343205, -23.94362959, 49.55953891),
    "jupiter barycenter": Ellipse(5.20288700, 0.04838624, 1.30439695, 34.39644051, 14.72847983, 100.47390909),
}
"""By their names in Basilisk. E. M. Standish, "Keplerian Elements for Approximate Positions of the Major
Planets", JPL, at J2000; Earth's is that of Earth and Moon."""


class Planets(sysModel.SysModel):
    """Where planets are, for the gravity of each.

    Args:
        departure: days after J2000 at which the simulation begins.

    Attributes:
        outMsgs: for each planet.
    """

    def __init__(self, departure: float) -> None:
        super().__init__()
        self.outMsgs = {name: messaging.SpicePlanetStateMsg() for name in ELLIPSES}
        self._departure = departure * DAY
        self.UpdateState(0)  # the spacecraft looks before anything has run

    def UpdateState(self, CurrentSimNanos: int) -> None:  # noqa: N802 (Basilisk's name)
        """Between two of these, Basilisk moves a planet along its velocity."""
        for name, ellipse in ELLIPSES.items():
            position, velocity = ellipse.state(self._departure + CurrentSimNanos * 1e-9 * HASTE)
            made = messaging.SpicePlanetStateMsgPayload()
            made.PlanetName, made.PositionVector = name, position
            made.VelocityVector = (HASTE * np.array(velocity)).tolist()
            self.outMsgs[name].write(made, CurrentSimNanos)

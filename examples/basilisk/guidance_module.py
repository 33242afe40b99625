"""A Basilisk module of the exported C: a spacecraft's state in, the attitude of its sail out."""

import math

import numpy as np
from Basilisk.architecture import messaging, sysModel

from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.interface import GuidanceStatus, Steered
from sailnet.physics.units import AU, AU_PER_TU, TU

HASTE = 1000.0
"""So many seconds of the flight pass in one of Basilisk's.

Its clock counts nanoseconds in a double and refuses to know of more than 2^53, 104 days; a flight takes more
than a year. Lengths are as they are, speeds are HASTE times as high, and accelerations its square: the orbit
is the same.
"""

PARTS = 4
"""Of a guidance period: at the beginning of each the attitude follows the Sun line."""


class SailGuidance(sysModel.SysModel):
    """Steers one sail about the Sun, in the plane z = 0.

    Its task's period is a part of the guidance period, and the spacecraft is updated before it. It commands
    once a guidance period, and keeps the body's x axis at the cone angle from the Sun line.

    Args:
        guidance: the exported C, compiled.
        period: guidance period [TU].

    Attributes:
        stateInMsg: of the spacecraft.
        attRefOutMsg: for the spacecraft, whose attitude is prescribed.
        told: the last command.
        periods: how many there were.
    """

    def __init__(self, guidance: CGuidance, period: float) -> None:
        super().__init__()
        self.stateInMsg = messaging.SCStatesMsgReader()
        self.attRefOutMsg = messaging.AttRefMsg()
        self._guidance, self._period = guidance, period
        self._only = np.zeros(1, np.intp)
        self.Reset(0)

    @property
    def arrived(self) -> bool:
        """Whether the flight ends once the last command was held for its ``hold``."""
        return self.told is not None and int(self.told.status[0]) == GuidanceStatus.ARRIVED

    def Reset(self, CurrentSimNanos: int) -> None:  # noqa: N802 (Basilisk's name)
        """A flight begins."""
        self._steering = self._guidance.steering(1)
        self.told: Steered | None = None
        self.periods = self._updates = 0

    def UpdateState(self, CurrentSimNanos: int) -> None:  # noqa: N802 (Basilisk's name)
        """A command where one is due, and the attitude that it asks for now."""
        state = self.stateInMsg()
        r, theta, u, v = polar(state.r_BN_N, state.v_BN_N)
        if self._updates % PARTS == 0:
            self._command(r, u, v)
        self._updates += 1
        asked = float(self.told.cone_angle[0])
        self.attRefOutMsg.write(attitude(asked, r, theta, u, v, self._period / PARTS), CurrentSimNanos)

    def _command(self, r: float, u: float, v: float) -> None:
        if not self.arrived:
            self.told = self._steering.steer([(r, u, v)], self._period, self._only)
            self.periods += 1


class ConeAngles(SailGuidance):
    """The same, for a controller of the attitude: the angle alone, from the radius in the orbit's plane.

    Its task's period is the guidance period.

    Attributes:
        coneOutMsg: the angle about the orbit's normal, as Basilisk's ``eulerRotation`` takes it.
        commands: all of them [rad].
    """

    def __init__(self, guidance: CGuidance, period: float) -> None:
        self.coneOutMsg = messaging.AttStateMsg()
        self.commands: list[float] = []
        super().__init__(guidance, period)

    def UpdateState(self, CurrentSimNanos: int) -> None:  # noqa: N802 (Basilisk's name)
        """A command."""
        state = self.stateInMsg()
        r, _, u, v = polar(state.r_BN_N, state.v_BN_N)
        self._command(r, u, v)
        self.commands.append(float(self.told.cone_angle[0]))
        made = messaging.AttStateMsgPayload()
        made.state = [self.commands[-1], 0.0, 0.0]
        self.coneOutMsg.write(made, CurrentSimNanos)


def polar(position: list[float], velocity: list[float]) -> tuple[float, float, float, float]:
    """r [AU], theta [rad], u and v [AU/TU] of Basilisk's position [m] and velocity, in the plane."""
    (x, y, _), (dx, dy, _) = np.array(position) / AU, np.array(velocity) / (AU_PER_TU * HASTE)
    r = math.hypot(x, y)
    return r, math.atan2(y, x), (x * dx + y * dy) / r, (x * dy - y * dx) / r


def attitude(
    cone_angle: float, r: float, theta: float, u: float, v: float, time: float
) -> messaging.AttRefMsgPayload:
    """The body's x axis at a cone angle from the Sun line; for a time [TU] it turns as that line does.

    The line turns by v/r, which changes by -2 u v / r^2, and by what the sail itself adds to v.
    """
    made = messaging.AttRefMsgPayload()
    turned = math.remainder(theta + cone_angle, 2.0 * math.pi)
    made.sigma_RN = [0.0, 0.0, math.tan(turned / 4.0)]  # a modified Rodrigues parameter about z
    made.omega_RN_N = [0.0, 0.0, (v / r - time * u * v / r**2) * HASTE / TU]
    return made

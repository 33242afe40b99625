"""A trim mass that keeps the wheels from filling, and a watch over attitude and wheels."""

import math

import numpy as np
from Basilisk.architecture import messaging, sysModel
from Basilisk.simulation import facetSRPDynamicEffector
from guidance_module import HASTE
from sailcraft import inertia

REACH = 0.2
"""By how much the trim mass can shift the centre of mass, along y and z each [m]: ours."""

SPEED = 5e-4
"""How fast it does [m/s]: ours."""

SETTLING = 1200.0
"""Time constant of the momentum [s]."""


class Trim(sysModel.SysModel):
    """Shifts the centre of mass, and light then turns the craft: as NEA Scout's mass translator.

    What is wanted is no angular momentum of craft and wheels together: a slew changes only whose it is. The
    shift is of that momentum and its integral, each over the force of light: so the shift at which there is
    no torque is the same at any cone angle and distance. It has no hold of the roll. Basilisk's facets cannot
    be moved once it runs, so it is the torque that comes to the craft; the mass, slow and small, is in no
    equation.

    Args:
        light: whose force counts.
        beta: of the sail, from which its inertia follows.
        spin: inertia of a wheel about its axis [kg m^2].
        works: whether it does; else this only watches.

    Attributes:
        stateInMsg: of the spacecraft.
        speedInMsg: of the wheels.
        errorInMsg: of the attitude.
        torqueOutMsg: of light, by the shift.
        seen: a row an update: time [s], error of the attitude [rad], momentum of each wheel [N m s], shift
            along y and z [m].
    """

    def __init__(
        self, light: facetSRPDynamicEffector.FacetSRPDynamicEffector, beta: float, spin: float, works: bool
    ) -> None:
        super().__init__()
        self.stateInMsg = messaging.SCStatesMsgReader()
        self.speedInMsg = messaging.RWSpeedMsgReader()
        self.errorInMsg = messaging.AttGuidMsgReader()
        self.torqueOutMsg = messaging.CmdTorqueBodyMsg()
        self.seen: list[tuple[float, ...]] = []
        self._light, self._inertia, self._spin, self._works = light, np.array(inertia(beta)), spin, works
        self._shift, self._held, self._last = np.zeros(2), np.zeros(2), 0.0

    def UpdateState(self, CurrentSimNanos: int) -> None:  # noqa: N802 (Basilisk's name)
        """Look, and move the mass as far as it comes until the next time."""
        now = CurrentSimNanos * 1e-9 * HASTE
        wheels = self._spin * np.array(self.speedInMsg().wheelSpeeds[:3]) / HASTE
        force = self._light.forceExternal_B[0][0] / HASTE**2
        if self._works and force > 0.0:
            whole = wheels + self._inertia * np.array(self.stateInMsg().omega_BN_B) / HASTE
            self._move(whole, force, now - self._last)
        self._last = now
        made = messaging.CmdTorqueBodyMsgPayload()
        y, z = self._shift * force * HASTE**2
        made.torqueRequestBody = [0.0, -z, y]
        self.torqueOutMsg.write(made, CurrentSimNanos)
        error = 4.0 * math.atan(float(np.linalg.norm(self.errorInMsg().sigma_BR)))
        self.seen.append((now, error, *wheels.tolist(), *self._shift.tolist()))

    def _move(self, momentum: np.ndarray, force: float, time: float) -> None:
        over = np.array([-momentum[2], momentum[1]]) / force  # what shifts along y and z take from
        self._held = np.clip(self._held + over * time / SETTLING**2, -REACH, REACH)
        wanted = np.clip(self._held + 2.0 * over / SETTLING, -REACH, REACH)
        self._shift += np.clip(wanted - self._shift, -SPEED * time, SPEED * time)

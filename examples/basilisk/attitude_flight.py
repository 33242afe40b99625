"""A flight in Basilisk with attitude dynamics: a sailcraft on wheels follows the guidance's cone angles."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from Basilisk.architecture import messaging
from Basilisk.fswAlgorithms import attTrackingError, eulerRotation, hillPoint, rwMotorTorque
from Basilisk.simulation import extForceTorque, simpleNav, spacecraft
from Basilisk.utilities import SimulationBaseClass, simIncludeGravBody
from guidance_module import HASTE, ConeAngles, polar
from planets import ELLIPSES, Planets
from point_mass import Flown, in_nanoseconds
from sailcraft import AXES, WHEEL_MOMENTUM, controller, inertia, light, mass, sensors, wheels
from trim import Trim

from sailnet.guidance.exported_c import CGuidance
from sailnet.physics.units import AU, AU_PER_TU, DAY, GM_SUN, TU

STEPS = 2512
"""Of integrator and controller in a guidance period: 10 s each, of 7 h."""

LOOK = 16
"""Steps from one move of the trim mass to the next."""

FULL = 0.999
"""Of its largest momentum: no more of it is to be had."""

TASKS = {"dynamics": (1, 40), "guidance": (STEPS, 30), "control": (1, 20), "trim": (LOOK, 10)}
"""Steps between, and which comes first at the same instant."""

DEPARTURE = 9497.0
"""Days after J2000: 2026-01-01."""

BEHIND = math.radians(3.0)
"""How far the sail departs behind the Earth, which is then five of its Hill radii away and runs ahead."""


@dataclass(frozen=True)
class Craft:
    """What is flown.

    Attributes:
        planets: whether they pull.
        offset: of the centre of pressure [m].
        trim: whether there is a trim mass.
    """

    planets: bool = False
    offset: tuple[float, float] = (0.0, 0.0)
    trim: bool = False


@dataclass(frozen=True)
class AttitudeFlight:
    """How a flight went.

    Attributes:
        flown: its end.
        full: whether it was given up with a wheel as fast as it can be.
        across: distance from the plane z = 0 at the end [AU].
        seen: what ``Trim`` saw.
        commands: one a guidance period [rad].
    """

    flown: Flown
    full: bool
    across: float
    seen: np.ndarray
    commands: np.ndarray


class Simulation:
    """Basilisk's modules, wired.

    Args:
        guidance: the exported C, compiled.
        start: r [AU], u, v [AU/TU].
        beta: the sail's real one.
        craft: what is flown.
    """

    def __init__(
        self, guidance: CGuidance, start: tuple[float, float, float], beta: float, craft: Craft
    ) -> None:
        self.step = in_nanoseconds(guidance.mission.flight.period / STEPS)
        self.base = SimulationBaseClass.SimBaseClass()
        process = self.base.CreateNewProcess("flight")
        for name, (steps, priority) in TASKS.items():
            process.addTask(self.base.CreateNewTask(name, steps * self.step), priority)
        self._kept: list[Any] = []
        self.planets = Planets(DEPARTURE)
        self.pilot = ConeAngles(guidance, guidance.mission.flight.period)
        self.craft = self._spacecraft(start, beta)
        self._gravity(craft.planets)
        self._wheels(beta)
        self._light(beta, craft)
        self._models("guidance", self.planets, self.pilot)
        self._control(beta)
        self._models("trim", self.trim)
        self.base.InitializeSimulation()

    def run(self, time: int) -> None:
        """Until a time on Basilisk's clock [ns]."""
        self.base.ConfigureStopTime(time)
        self.base.ExecuteSimulation()

    def _models(self, task: str, *models: Any) -> None:
        """In the order in which they are to run."""
        for model in models:
            self._kept.append(model)
            self.base.AddModelToTask(task, model, 1000 - len(self._kept))

    def _spacecraft(self, start: tuple[float, float, float], beta: float) -> spacecraft.Spacecraft:
        """At rest against the Sun line, and facing the Sun."""
        made = spacecraft.Spacecraft()
        x, y, z = inertia(beta)
        made.hub.mHub = mass(beta)
        made.hub.IHubPntBc_B = [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]
        (east, north, _), _ = ELLIPSES["earth"].state(DEPARTURE * DAY)
        angle = math.remainder(math.atan2(north, east) - BEHIND, 2.0 * math.pi)
        r, u, v = start
        out = np.array([math.cos(angle), math.sin(angle)])
        along = np.array([-out[1], out[0]])
        speed = (u * out + v * along) * AU_PER_TU * HASTE
        made.hub.r_CN_NInit = [*([number] for number in r * AU * out), [0.0]]
        made.hub.v_CN_NInit = [*([number] for number in speed), [0.0]]
        made.hub.sigma_BNInit = [[0.0], [0.0], [math.tan(angle / 4.0)]]
        made.hub.omega_BN_BInit = [[0.0], [0.0], [v / r / TU * HASTE]]
        self.pilot.stateInMsg.subscribeTo(made.scStateOutMsg)
        return made

    def _gravity(self, planets: bool) -> None:
        bodies = simIncludeGravBody.gravBodyFactory()
        sun = bodies.createSun()
        sun.isCentralBody, sun.mu = True, GM_SUN * HASTE**2  # the same Sun in both simulators
        for name in ELLIPSES if planets else ():
            body = bodies.createBody(name)
            body.mu *= HASTE**2
            body.planetBodyInMsg.subscribeTo(self.planets.outMsgs[name])
        bodies.addBodiesTo(self.craft)
        self._kept.append(bodies)

    def _wheels(self, beta: float) -> None:
        self.wheels, factory, self.fitted = wheels()
        factory.addToSpacecraft("wheels", self.wheels, self.craft)
        self.spin = next(iter(factory.rwList.values())).Js
        self._kept.append(factory)

    def _light(self, beta: float, craft: Craft) -> None:
        """Light, and what the trim mass makes of it."""
        made, lever = light(craft.offset), extForceTorque.ExtForceTorque()
        where = messaging.SpicePlanetStateMsg().write(messaging.SpicePlanetStateMsgPayload())
        made.sunInMsg.subscribeTo(where)
        self.trim = Trim(made, beta, self.spin, craft.trim)
        self.trim.stateInMsg.subscribeTo(self.craft.scStateOutMsg)
        self.trim.speedInMsg.subscribeTo(self.wheels.rwSpeedOutMsg)
        lever.cmdTorqueInMsg.subscribeTo(self.trim.torqueOutMsg)
        self.craft.addDynamicEffector(made)
        self.craft.addDynamicEffector(lever)
        self._kept.append(where)
        self._models("dynamics", made, lever, self.wheels, self.craft)

    def _control(self, beta: float) -> None:
        """From the radius and a cone angle to the torque of each wheel."""
        navigation = simpleNav.SimpleNav()
        navigation.scStateInMsg.subscribeTo(self.craft.scStateOutMsg)
        radial, turned = hillPoint.hillPoint(), eulerRotation.eulerRotation()
        radial.transNavInMsg.subscribeTo(navigation.transOutMsg)
        turned.attRefInMsg.subscribeTo(radial.attRefOutMsg)
        turned.desiredAttInMsg.subscribeTo(self.pilot.coneOutMsg)
        measured = sensors()
        measured.scStateInMsg.subscribeTo(self.craft.scStateOutMsg)
        error, truth = attTrackingError.attTrackingError(), attTrackingError.attTrackingError()
        error.attNavInMsg.subscribeTo(measured.attOutMsg)
        error.attRefInMsg.subscribeTo(turned.attRefOutMsg)
        truth.attNavInMsg.subscribeTo(navigation.attOutMsg)
        truth.attRefInMsg.subscribeTo(turned.attRefOutMsg)
        self.trim.errorInMsg.subscribeTo(truth.attGuidOutMsg)
        (steering, servo), motors = controller(beta), rwMotorTorque.rwMotorTorque()
        shape = messaging.VehicleConfigMsgPayload()
        shape.ISCPntB_B = np.diag(inertia(beta)).ravel().tolist()
        known = messaging.VehicleConfigMsg().write(shape)
        steering.guidInMsg.subscribeTo(error.attGuidOutMsg)
        servo.guidInMsg.subscribeTo(error.attGuidOutMsg)
        servo.rateSteeringInMsg.subscribeTo(steering.rateCmdOutMsg)
        servo.vehConfigInMsg.subscribeTo(known)
        servo.rwParamsInMsg.subscribeTo(self.fitted)
        servo.rwSpeedsInMsg.subscribeTo(self.wheels.rwSpeedOutMsg)
        motors.controlAxes_B = [number for axis in AXES for number in axis]
        motors.vehControlInMsg.subscribeTo(servo.cmdTorqueOutMsg)
        motors.rwParamsInMsg.subscribeTo(self.fitted)
        self.wheels.rwMotorCmdInMsg.subscribeTo(motors.rwMotorTorqueOutMsg)
        self._kept.append(known)
        self._models("control", navigation, measured, radial, turned)
        self._models("control", truth, error, steering, servo, motors)


def fly(
    guidance: CGuidance,
    start: tuple[float, float, float],
    beta: float,
    craft: Craft,
    longest: float | None = None,
) -> AttitudeFlight:
    """Fly until guidance ends the flight, a wheel is full, or a time [TU] is over.

    ``beta`` is the sail's real one; the longest flight is the mission's unless it is given.
    """
    flight = Simulation(guidance, start, beta, craft)
    end = in_nanoseconds(guidance.mission.flight.longest if longest is None else longest)
    now, part, full = 0, STEPS * flight.step, False
    while now <= end:
        flight.run(now)
        lately = np.array(flight.trim.seen[-STEPS // LOOK :])
        full = bool(np.abs(lately[:, 2:5]).max() >= FULL * WHEEL_MOMENTUM)
        if full:
            end = now
        elif flight.pilot.arrived and end > now + part:
            end = now + in_nanoseconds(float(flight.pilot.told.hold[0]))
        now += part
    flight.run(end)
    flight.craft.UpdateState(end)
    last = flight.craft.scStateOutMsg.read()
    r, _, u, v = polar(last.r_BN_N, last.v_BN_N)
    ended = Flown((r, u, v), end * 1e-9 * HASTE / TU, flight.pilot.periods, flight.pilot.arrived)
    return AttitudeFlight(
        ended, full, last.r_BN_N[2] / AU, np.array(flight.trim.seen), np.array(flight.pilot.commands)
    )

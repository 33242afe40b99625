"""A flight in Basilisk: its gravity, its light pressure on one facet, its integrator, and our guidance."""

from dataclasses import dataclass

from Basilisk.architecture import messaging
from Basilisk.simulation import facetSRPDynamicEffector, spacecraft
from Basilisk.utilities import SimulationBaseClass, simIncludeGravBody
from guidance_module import HASTE, PARTS, SailGuidance, polar

from sailnet.guidance.exported_c import CGuidance
from sailnet.physics.units import AU, AU_PER_TU, GM_SUN, TU

FLUX = 1368.0
"""Of sunlight at 1 AU [W/m^2], as Basilisk's effector has it."""

LIGHT = 299_792_458.0
"""Speed of light [m/s]."""

MASS = 10.0
"""Of the craft [kg]; the area follows from it and beta."""

FIRST, THEN = 20, 10
"""Priorities of models: the spacecraft moves before guidance looks."""


@dataclass(frozen=True)
class Flown:
    """How a flight ended.

    Attributes:
        end: r [AU], u, v [AU/TU].
        time_of_flight: [TU].
        periods: guidance periods.
        stopped: by its guidance, and not at the longest flight.
    """

    end: tuple[float, float, float]
    time_of_flight: float
    periods: int
    stopped: bool


def area(beta: float) -> float:
    """Of an ideal sail [m^2]: light gives it beta times the Sun's gravity where it faces the Sun."""
    return beta * MASS * GM_SUN / AU**2 / (2.0 * FLUX / LIGHT)


def in_nanoseconds(time: float) -> int:
    """A time [TU] on Basilisk's clock."""
    return round(time * TU / HASTE * 1e9)


def fly(
    guidance: CGuidance, start: tuple[float, float, float], beta: float, longest: float | None = None
) -> Flown:
    """Fly one sail from r [AU], u, v [AU/TU] until its guidance ends the flight, or a time [TU] is over.

    ``beta`` is its real one; the longest flight is the mission's unless it is given.
    """
    mission = guidance.mission
    period = mission.flight.period
    part = in_nanoseconds(period / PARTS)
    simulation = SimulationBaseClass.SimBaseClass()
    simulation.CreateNewProcess("flight").addTask(simulation.CreateNewTask("part", part))

    craft = spacecraft.Spacecraft()
    craft.hub.mHub = MASS
    craft.hub.IHubPntBc_B = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]  # it is a point: no matter
    r, u, v = start
    craft.hub.r_CN_NInit = [[r * AU], [0.0], [0.0]]
    craft.hub.v_CN_NInit = [[u * AU_PER_TU * HASTE], [v * AU_PER_TU * HASTE], [0.0]]
    bodies = simIncludeGravBody.gravBodyFactory()
    sun = bodies.createSun()
    sun.isCentralBody, sun.mu = True, GM_SUN * HASTE**2  # the same Sun in both simulators
    bodies.addBodiesTo(craft)

    light = facetSRPDynamicEffector.FacetSRPDynamicEffector()
    light.setNumFacets(1)
    upright = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    # A mirror whose normal towards the Sun is -x: the thrust is along +x.
    light.addFacet(
        area(beta) * HASTE**2, upright, [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0], 0.0, 1.0
    )
    where = messaging.SpicePlanetStateMsg().write(messaging.SpicePlanetStateMsgPayload())
    light.sunInMsg.subscribeTo(where)
    craft.addDynamicEffector(light)

    pilot = SailGuidance(guidance, period)
    pilot.stateInMsg.subscribeTo(craft.scStateOutMsg)
    craft.attRefInMsg.subscribeTo(pilot.attRefOutMsg)
    simulation.AddModelToTask("part", light, FIRST)
    simulation.AddModelToTask("part", craft, FIRST)
    simulation.AddModelToTask("part", pilot, THEN)
    simulation.InitializeSimulation()

    now, end = 0, in_nanoseconds(mission.flight.longest if longest is None else longest)
    while now <= end:
        simulation.ConfigureStopTime(now)
        simulation.ExecuteSimulation()
        craft.UpdateState(now)  # at the same instant: it reads its attitude after it has moved
        if pilot.arrived and end > now + PARTS * part:
            end = now + in_nanoseconds(float(pilot.told.hold[0]))
        now += part
    craft.UpdateState(end)
    last = craft.scStateOutMsg.read()
    r, _, u, v = polar(last.r_BN_N, last.v_BN_N)
    return Flown((r, u, v), end * 1e-9 * HASTE / TU, pilot.periods, pilot.arrived)

"""The sailcraft with attitude dynamics: a rigid square sail, three wheels, and what steers them.

Basilisk's time is ``HASTE`` times as fast as the flight's. Masses, lengths and inertias are as they are;
rates, momenta and gains on rates are HASTE times as high; forces, torques and gains on a rate's integral, its
square. The motion is the same, angle by angle.
"""

import math

import numpy as np
from Basilisk.architecture import messaging
from Basilisk.fswAlgorithms import mrpSteering, rateServoFullNonlinear
from Basilisk.simulation import facetSRPDynamicEffector, reactionWheelStateEffector, simpleNav
from Basilisk.utilities import simIncludeRW
from guidance_module import HASTE
from point_mass import FLUX, LIGHT

from sailnet.physics.units import AU, GM_SUN

EDGE = 40.0
"""Of the square sail [m]: ours."""

OFFSET = (0.07, 0.07)
"""Of the centre of pressure from that of mass, along y and z [m]: 0.1 m, 0.25 % of the edge; ours."""

WHEEL_MOMENTUM, WHEEL_TORQUE, WHEEL_SPEED = 1.0, 0.1, 7000.0
"""Largest of each wheel [N m s], [N m], [rpm]: of 0.9 kg, table 3 of doi:10.1038/s41598-024-65807-6."""

SLEW = math.radians(120.0) / (3.0 * 3600.0)
"""Largest rate [rad/s]: from one bound of the cone angle to the other in three hours."""

POINTING, RATE, DRIFT = 400.0, 60.0, 200.0
"""Time constants [s] of the loops of angle, of rate, and of the rate loop's integral: slow, as sails bend."""

ATTITUDE_ERROR, RATE_ERROR = math.radians(20.0 / 3600.0), 5e-7
"""Within which what is measured of attitude [rad] and rate [rad/s] walks, about each axis: ours, of a small
star tracker and a gyroscope of 0.1 deg/h."""

AXES = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])


def mass(beta: float) -> float:
    """Of all of the craft [kg]: what light can push with a strength ``beta``."""
    return 2.0 * FLUX / LIGHT * EDGE**2 / (beta * GM_SUN / AU**2)


def inertia(beta: float) -> tuple[float, float, float]:
    """About x, the sail's normal, y and z [kg m^2], as if all mass lay evenly over the sail."""
    across = mass(beta) * EDGE**2 / 12.0
    return 2.0 * across, across, across


def light(offset: tuple[float, float]) -> facetSRPDynamicEffector.FacetSRPDynamicEffector:
    """On one mirror, which pushes along +x at ``offset`` from the centre of mass."""
    made = facetSRPDynamicEffector.FacetSRPDynamicEffector()
    made.setNumFacets(1)
    made.addFacet(EDGE**2 * HASTE**2, list(AXES), [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, *offset], 0.0, 1.0)
    return made


def wheels() -> tuple[
    reactionWheelStateEffector.ReactionWheelStateEffector, simIncludeRW.rwFactory, messaging.RWArrayConfigMsg
]:
    """One along each axis, at rest."""
    factory = simIncludeRW.rwFactory()
    for axis in AXES:
        factory.create(
            "custom",
            axis,
            maxMomentum=WHEEL_MOMENTUM * HASTE,
            Omega_max=WHEEL_SPEED * HASTE,
            u_max=WHEEL_TORQUE * HASTE**2,
        )
    made = reactionWheelStateEffector.ReactionWheelStateEffector()
    # Basilisk warns of what is too fast for a wheel, which knows nothing of haste.
    made.setMaxWheelAcceleration(made.getMaxWheelAcceleration() * HASTE**2)
    return made, factory, factory.getConfigMessage()


def sensors() -> simpleNav.SimpleNav:
    """Attitude and rate as measured; place and speed are known."""
    made = simpleNav.SimpleNav()
    bounds = np.zeros(18)
    bounds[6:9], bounds[9:12] = ATTITUDE_ERROR / 4.0, RATE_ERROR * HASTE
    made.walkBounds = [[bound] for bound in bounds]
    made.PMatrix = np.diag(bounds / 10.0).tolist()  # of each step
    return made


def controller(beta: float) -> tuple[mrpSteering.mrpSteering, rateServoFullNonlinear.rateServoFullNonlinear]:
    """Basilisk's steering law, which asks for a rate within ``SLEW``, and its servo for a torque."""
    steering = mrpSteering.mrpSteering()
    steering.K1 = steering.K3 = 4.0 / POINTING * HASTE  # the parameter is a quarter of the angle
    steering.omega_max = SLEW * HASTE
    servo = rateServoFullNonlinear.rateServoFullNonlinear()
    around = inertia(beta)[1]
    servo.P = around / RATE * HASTE
    servo.Ki = around / DRIFT**2 * HASTE**2
    servo.integralLimit = 1.0
    servo.knownTorquePntB_B = [0.0, 0.0, 0.0]
    return steering, servo

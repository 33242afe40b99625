"""The intercept of paper 002 in closed form, free, and bounded."""

import numpy as np
from scipy.optimize import brentq

from sailnet.ocp.problems import intercept

START, SPEED, TARGET = (
    np.array(values) for values in (intercept.POSITION, intercept.VELOCITY, intercept.TARGET_ACCELERATION)
)


def intercept_cost(time: float, gamma: float) -> float:
    """The closed form: J = Gamma T + 1.5 |Z|^2 / T^3."""
    z = START + SPEED * time + 0.5 * TARGET * time**2
    return float(gamma * time + 1.5 * z @ z / time**3)


def bounded_cost(time: float) -> float:
    """Each component by itself: a = clip(lambda (T - t)), its displacement and effort integrated exactly."""
    bound, total = intercept.BOUND, time
    for z in START + SPEED * time + 0.5 * TARGET * time**2:

        def reach(slope: float) -> float:
            free = min(time, bound / slope)
            return slope * free**3 / 3 + bound * (time**2 - free**2) / 2

        slope = brentq(lambda k: reach(k) - abs(z), 1e-9, 10.0, xtol=1e-15)  # noqa: B023
        free = min(time, bound / slope)
        total += 0.5 * (slope**2 * free**3 / 3 + bound**2 * (time - free))
    return total

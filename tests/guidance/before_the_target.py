"""From where plans lead to the target: their model flown back from there, by finer steps than theirs."""

import numpy as np

from sailnet.guidance.plans import Sails
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import target_of


def sails_of(mission: Mission, count: int) -> Sails:
    """The mission's own, ``count`` times."""
    return Sails(np.full(count, mission.sail.beta), np.zeros(count), mission.sail.optics.force)


def before_the_target(mission: Mission, tilts: Array, times: Array, steps: int) -> Array:
    """(n, 3) or (n, 5) states for (n, k) or (n, k, 2) tilts and (n, k) times, each arc in so many steps."""
    count, arcs = times.shape
    states = np.tile(target_of(mission.problem, mission.components), (count, 1))
    for k in reversed(range(arcs)):
        states = sails_of(mission, count).after(states, tilts[:, k], -times[:, k], steps)
    return states

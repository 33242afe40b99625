"""What the last period did, by what is known of the sail: one step of Eq. (1)."""

from dataclasses import dataclass

import numpy as np

from sailnet.guidance.memory import Memory
from sailnet.guidance.tilts import angles_of, normal_of, size_of
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Coefficients, runge_kutta_change, runge_kutta_change_in_space
from sailnet.physics.real_law import force_curve


@dataclass(frozen=True)
class Change:
    """What the last period did.

    Attributes:
        by: changes of the state, (n, 3) or (n, 5) [AU, rad, AU/TU].
        normal: the unit normal, (n, 2) or (n, 3): radial, transverse, northward.
        sine: of the cone angle, with its sign in the plane, (n,).
        force: of the mission's sail, (2, n), radial and across the Sun line, to the normal's side, per
            beta / r^2.
    """

    by: Array
    normal: Array
    sine: Array
    force: Array

    @property
    def cosine(self) -> Array:
        """(n,) of the cone angle."""
        return self.normal[:, 0]

    @property
    def surface(self) -> Array:
        """Direction along the sail's surface towards larger cone angles, in the components of the normal."""
        across = self.normal[:, 1:]
        if across.shape[1] == 1:
            return np.column_stack([-self.sine, self.cosine])
        size = np.where(self.sine > 0.0, self.sine, 1.0)
        return np.column_stack([-self.sine, self.cosine[:, None] * across / size[:, None]])

    @property
    def along_normal(self) -> Array:
        """(n,) the force along the normal per beta / r^2."""
        return np.asarray(self.force[0] * self.cosine + self.force[1] * np.abs(self.sine))


def predicted(memory: Memory, force: Coefficients) -> Change:
    """What the remembered command must have done to the remembered state.

    Args:
        memory: of n sails.
        force: coefficients of the mission's optics.
    """
    cone, clock = angles_of(memory.attitude)
    sails = memory.beta, memory.held, memory.tangential
    if clock is None:
        before = np.zeros((4, len(memory.state)))
        before[[0, 2, 3]] = memory.state.T
        by, sine = runge_kutta_change(before, cone, *sails, force)[[0, 2, 3]].T, np.sin(cone)
    else:
        by = runge_kutta_change_in_space(memory.state.T, np.array([cone, clock]), *sails, force).T
        sine = np.sin(size_of(memory.attitude))
    push = force_curve(size_of(memory.attitude), np.array(force))[0]
    return Change(by, normal_of(memory.attitude), sine, push)

"""The courses of sails that the expert steers: solved anew every day, followed in between."""

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.optima import put
from sailnet.guidance.by_expert.tracking import Box, Known, next_optima, nothing_known, search_optima
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.transfer import Transfer, Transfers
from sailnet.physics.units import DAY, TU

SOLVED_EVERY = DAY / TU
"""A command comes from an extremal that was solved no longer ago [TU]."""

SEARCH_EVERY = 0.2
"""Of one sail the index is asked no more often [TU]: it takes seconds."""

LAST_LEG = 1.0
"""An extremal no longer than this [TU] is flown to its end if none is found from further on: after a push to
the wrong side the next one takes the long way round, and the end of the last one is near the target still."""

LOST_AFTER = 3.0
"""Another that is so many times older than it should be says nothing of where the sail is."""


class Courses:
    """The fastest extremals of a number of sails under way.

    Within ``SOLVED_EVERY`` of arrival the last extremal is flown to its end.

    Args:
        transfer: the problem of the sail as assumed.
        count: number of sails.
        region: a box of states that many flights start from, indexed at once; see :func:`search_optima`.

    Attributes:
        searches: (count,) how often the index was asked.
    """

    def __init__(self, transfer: Transfer, count: int, region: Box | None = None) -> None:
        self._transfer, self._region = transfer, region
        self._known = Known(
            nothing_known(transfer, np.full((count, 3), np.nan)), np.full(count, transfer.beta)
        )
        self._age = np.zeros(count)
        self._tried = np.full(count, np.inf)
        self._asked = np.full(count, np.inf)
        self.searches = np.zeros(count, int)

    def pass_time(self, sails: NDArray[np.intp], duration: Array) -> None:
        """Some sails have flown on for (n,) ``duration`` [TU]."""
        for since in (self._age, self._tried, self._asked):
            since[sails] += duration

    def solve(self, states: Array, beta: Array, ahead: Array, sails: NDArray[np.intp]) -> None:
        """Solve anew for those of some sails whose extremal would be too old before ``ahead`` [TU] is over.

        Args:
            states: (n, 3) r [AU], u, v [AU/TU]; where one is not finite nothing is solved.
            beta: (n,) normalised characteristic accelerations, as they are now believed to be.
            ahead: (n,) for how long commands will be held [TU].
            sails: (n,) which of the sails these are.
        """
        left = self._known.optima.time_of_flight[sails] - self._age[sails]
        due = (self._tried[sails] + ahead > SOLVED_EVERY) & ~(left <= SOLVED_EVERY)
        due &= np.isfinite(states).all(axis=1)
        rows = np.flatnonzero(due)
        if not len(rows):
            return
        mine = sails[rows]
        now = next_optima(self._transfer, states[rows], beta[rows], self._known.rows(mine), self._age[mine])
        found = now.optima
        leg = left[rows] <= LAST_LEG
        sought = np.flatnonzero(~found.found & ~leg & (self._asked[mine] >= SEARCH_EVERY))
        put(
            found,
            sought,
            search_optima(self._transfer, states[rows[sought]], beta[rows[sought]], self._region),
        )
        self._tried[mine] = 0.0
        self._asked[mine[sought]] = 0.0
        self.searches[mine[sought]] += 1
        new = found.found
        put(self._known.optima, mine[new], found, new)
        self._known.beta[mine[new]] = now.beta[new]
        self._age[mine[new]] = 0.0

    def now(self, sails: NDArray[np.intp]) -> tuple[Array, Array, Array]:
        """What the extremals of some sails say of this moment.

        Returns:
            (n,) the cone angle [rad]; (n,) the time of flight that is left [TU]; (n, 3) costates, scaled to
            H = 0. NaN where no extremal is known.
        """
        known, age = self._known.rows(sails), self._age[sails]
        costates = known.optima.costates.copy()
        left = np.maximum(known.optima.time_of_flight - age, 0.0)
        older = np.flatnonzero(known.optima.found & (age > 0.0) & (left > 0.0))
        if len(older):
            costates[older] = self._propagated(known.rows(older), left[older])
        at_end = known.optima.found & (left <= 0.0)
        costates[at_end] = known.optima.arrival_costates[at_end]
        angle = np.full(len(sails), np.nan)
        there = known.optima.found
        angle[there] = guidance_law(self._transfer, costates[there, 1], costates[there, 2])
        return angle, left, costates

    def lost(self, sails: NDArray[np.intp], ahead: Array) -> NDArray[np.bool_]:
        """(n,) of which sails no extremal is known, or none that is not long out of date."""
        leg = self._known.optima.time_of_flight[sails] <= LAST_LEG + SOLVED_EVERY
        old = self._age[sails] > LOST_AFTER * np.maximum(SOLVED_EVERY, ahead)
        return np.asarray(old & ~leg | ~self._known.optima.found[sails])

    def _propagated(self, known: Known, left: Array) -> Array:
        sails = Transfers(self._transfer, known.beta, self._transfer.law)
        grid = np.column_stack([np.zeros(len(left)), left])
        return propagate_extremals(sails, known.optima.arrival_costates, grid).states[:, 1, 3:]

"""Fastest extremals kept up along flights: each is found from the one of a while before.

The index finds the fastest extremal from a state without being told anything, which takes seconds. A sail
that flies along one is a while later near a point of it, and Newton's method finds the new one from there in
milliseconds. It stays in a family of extremals, so that the index is asked again where that ended.
"""

from dataclasses import dataclass, replace

import numpy as np

from sailnet.errors import SolveError
from sailnet.expert.continuation import follow
from sailnet.expert.directions import Rows
from sailnet.expert.fastest import solve_states
from sailnet.expert.optima import RESIDUAL_GOAL, Optima, optima_of, put
from sailnet.expert.real_sails import own_optima
from sailnet.expert.shooting import Shots, shoot
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer, Transfers

ITERATIONS = 12
"""Newton steps from one extremal to the next."""

LATER, LATER_BY = 0.02, 0.01
"""An extremal may take this share and so much [TU] longer than the last one promised; else it is another."""

PER_BETA = 3.0
"""And by this share for every share by which beta changed."""

STRETCH = 0.03
"""Where an extremal exists for beta as it was but not as it is, the family ended in between. Up to this
share of a change the old beta's is flown on, and no other way is looked for."""

SHORTEST = 1e-3
"""Time of flight that is guessed at least [TU]."""


Box = tuple[Array, Array]
"""Lowest and highest state (3,) of a box."""


@dataclass(frozen=True)
class Known:
    """What is known of n sails.

    Attributes:
        optima: extremals from where they were; NaN where none is known.
        beta: (n,) normalised characteristic accelerations those are of.
    """

    optima: Optima
    beta: Array

    def rows(self, chosen: Rows) -> "Known":
        """Of some of the sails."""
        return Known(self.optima.rows(chosen), self.beta[chosen])


def nothing_known(transfer: Transfer, states: Array) -> Optima:
    """No extremal from any of (n, 3) states: what shots that were not flown reach."""
    nowhere = np.full(states.shape, np.nan)
    return optima_of(transfer, states, Shots.not_flown(nowhere, nowhere[:, 0]))


def next_optima(transfer: Transfer, states: Array, beta: Array, last: Known, elapsed: Array) -> Known:
    """The extremals of sails a while later, of the families of those before.

    Newton's method goes from the old extremal to the new state and beta at once. Where that fails it goes to
    the state alone, and on to a beta that is far off by continuation; see also ``STRETCH``.

    Args:
        transfer: the problem; its beta is not used.
        states: (n, 3) r [AU], u, v [AU/TU] now.
        beta: (n,) normalised characteristic accelerations, as they are now believed to be.
        last: of the n sails.
        elapsed: (n,) time since then [TU].

    Returns:
        The extremals, ``searched`` NaN, and of what beta they are; nothing where none was known or none of
        the family was found.
    """
    optima = nothing_known(transfer, states)
    _put_next(transfer, optima, np.flatnonzero(last.optima.found), beta, last, elapsed)
    there = nothing_known(transfer, states)
    failed = np.flatnonzero(last.optima.found & ~optima.found & (beta != last.beta))
    _put_next(transfer, there, failed, last.beta, last, elapsed)
    close = np.abs(beta / last.beta - 1.0) <= STRETCH
    kept = there.found & close
    put(optima, np.flatnonzero(kept), there, kept)
    rows = np.flatnonzero(there.found & ~close)
    if len(rows):
        before, now = last.beta[rows], beta[rows]
        followed = follow(
            lambda shares: Transfers(transfer, before + shares * (now - before), transfer.law),
            states[rows],
            there.arrival_costates[rows],
            there.time_of_flight[rows],
        )
        put(optima, rows, optima_of(Transfers(transfer, now, transfer.law), states[rows], followed.shots))
    return Known(optima, np.where(kept, last.beta, beta))


def search_optima(transfer: Transfer, states: Array, beta: Array, region: Box | None = None) -> Optima:
    """The fastest extremals of sails that nothing is known of, each as if it were the only one.

    The index is asked for the transfer's own sail, whose extremal is followed to the sail's beta; where that
    fails, for that very sail.

    Args:
        transfer: the problem, with a beta that many searches share.
        states: (n, 3) r [AU], u, v [AU/TU].
        beta: (n,) normalised characteristic accelerations.
        region: a box to index at once, for all states in it; every other state is indexed alone.

    Returns:
        The extremals; nothing where none was found, as from what is no state of a sail.
    """
    optima = nothing_known(transfer, states)
    for row in range(len(states)):
        try:
            found = _fastest(transfer, states[[row]], beta[[row]], region)
        except SolveError:  # no state of a sail, or one on the target orbit already
            continue
        put(optima, np.array([row]), found)
    return optima


def _fastest(transfer: Transfer, state: Array, beta: Array, region: Box | None) -> Optima:
    """Of one sail."""
    inside = region is not None and bool(((state >= region[0]) & (state <= region[1])).all())
    shared = solve_states(transfer, state, region if inside else None)
    if beta[0] == transfer.beta:
        return shared
    known = shared.arrival_costates, shared.time_of_flight
    own, _ = own_optima(transfer, state, *known, beta, transfer.optics, search=False)
    return own if own.found[0] else solve_states(replace(transfer, beta=float(beta[0])), state)


def _put_next(
    transfer: Transfer, optima: Optima, rows: Rows, beta: Array, last: Known, elapsed: Array
) -> None:
    """Newton's method from the last extremals of some sails; what is likely of the same family is kept."""
    if not len(rows):
        return
    sails, states, known = Transfers(transfer, beta[rows], transfer.law), optima.state[rows], last.rows(rows)
    promised = np.maximum(known.optima.time_of_flight - elapsed[rows], SHORTEST)
    shots = shoot(
        sails, states, known.optima.arrival_costates, promised, 0.1 * RESIDUAL_GOAL, iterations=ITERATIONS
    )
    found = optima_of(sails, states, shots)
    changed = np.abs(beta[rows] / known.beta - 1.0)
    near = found.time_of_flight <= promised * (1.0 + LATER + PER_BETA * changed) + LATER_BY
    put(optima, rows[near], found, near)

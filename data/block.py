"""From propagated extremals to a block of the data set."""

import numpy as np
from numpy.typing import NDArray

from sailnet.dataset import JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG, Block
from sailnet.dynamics import Array
from sailnet.extremals import Extremals
from sailnet.jumps import preprocess
from sailnet.mission import Transfer
from sailnet.pontryagin import guidance_law

STATES = ("r", "u", "v", "lambda_r", "lambda_u", "lambda_v")
COLUMNS = (*STATES, "tau", "alpha", "alpha_pre")

AT_ONCE = 64
"""Trajectories worked on at once: few enough to stay in the processor's cache."""


def block_of(
    transfer: Transfer,
    costates: Array,
    extremals: Extremals,
    kept: NDArray[np.bool_],
    lengths: NDArray[np.int64],
) -> Block:
    """The first ``lengths`` samples of the extremals that are ``kept``.

    Args:
        transfer: the problem.
        costates: (n, 3) arrival costates.
        extremals: n extremals on one grid of time to go.
        kept: (n,) which of them.
        lengths: (n,) how many samples of each.
    """
    rows = np.flatnonzero(kept)
    costates, lengths = costates[rows], lengths[rows]
    first = np.append(0, np.cumsum(lengths))
    # A jump that lies beyond the last sample is none of this trajectory's.
    jump_time = extremals.jump_times[rows]
    jump_time = np.where(jump_time <= extremals.tau[lengths - 1], jump_time, np.nan)
    columns = np.empty((len(COLUMNS), first[-1]))
    for start in range(0, len(rows), AT_ONCE):
        some = slice(start, start + AT_ONCE)
        samples = slice(first[start], first[min(start + AT_ONCE, len(rows))])
        within = np.arange(len(extremals.tau)) < lengths[some, None]
        columns[:6, samples] = extremals.states[rows[some]][within].T
        tau = np.broadcast_to(extremals.tau, within.shape)[within]
        alpha = guidance_law(transfer, *columns[4:6, samples])
        columns[6, samples], columns[7, samples] = tau, alpha
        columns[8, samples] = preprocess(alpha, tau, np.repeat(jump_time[some], lengths[some]))
    return Block(
        dict(zip(COLUMNS, columns, strict=True)),
        {
            "lambda_r0": costates[:, 0],
            "lambda_u0": costates[:, 1],
            "lambda_v0": costates[:, 2],
            "jump_time": jump_time,
            "flags": JUMP_FLAG * np.isfinite(jump_time) + NEGATIVE_ARRIVAL_FLAG * (costates[:, 2] > 0.0),
        },
        lengths,
    )

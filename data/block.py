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
    costates, lengths = costates[kept], lengths[kept]
    within = np.arange(len(extremals.tau)) < lengths[:, None]
    states = extremals.states[kept][within]
    tau = np.broadcast_to(extremals.tau, within.shape)[within]
    alpha = guidance_law(transfer, states[:, 4], states[:, 5])
    jump_time = extremals.jump_times[kept]
    # A jump that lies beyond the last sample is none of this trajectory's.
    end = extremals.tau[lengths - 1]
    jump_time = np.where(jump_time <= end, jump_time, np.nan)
    return Block(
        {
            **{name: states[:, i] for i, name in enumerate(STATES)},
            "tau": tau,
            "alpha": alpha,
            "alpha_pre": preprocess(alpha, tau, np.repeat(jump_time, lengths)),
        },
        {
            "lambda_r0": costates[:, 0],
            "lambda_u0": costates[:, 1],
            "lambda_v0": costates[:, 2],
            "jump_time": jump_time,
            "flags": JUMP_FLAG * np.isfinite(jump_time) + NEGATIVE_ARRIVAL_FLAG * (costates[:, 2] > 0.0),
        },
        lengths,
    )

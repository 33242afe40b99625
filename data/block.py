"""From propagated extremals to a block of the data set."""

import numpy as np
from numpy.typing import NDArray

from sailnet.dataset import JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG, Block
from sailnet.physics.arrays import Array
from sailnet.physics.jumps import preprocess
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.transfer import Transfer

COLUMNS = ("r", "u", "v", "lambda_r", "lambda_u", "lambda_v", "tau", "alpha", "alpha_pre", "beta")

AT_ONCE = 20_000
"""Samples worked on at once: few enough to stay in the processor's cache."""


def block_of(
    transfer: Transfer,
    costates: Array,
    tau: Array,
    states: Array,
    jump_time: Array,
    lengths: NDArray[np.int64],
) -> Block:
    """Assemble the columns of n trajectories with m samples in all.

    Args:
        transfer: the problem.
        costates: (n, 3) arrival costates.
        tau: (m,) time to go, one trajectory after the other.
        states: (m, 6) states and costates there.
        jump_time: (n,) time to go at the jump, NaN without one.
        lengths: (n,) samples of each trajectory.
    """
    columns = np.empty((len(COLUMNS), len(tau)))
    jump = np.repeat(jump_time, lengths)
    for start in range(0, len(tau), AT_ONCE):
        rows = slice(start, start + AT_ONCE)
        columns[:6, rows] = states[rows].T
        alpha = guidance_law(transfer, *columns[4:6, rows])
        columns[6, rows], columns[7, rows] = tau[rows], alpha
        columns[8, rows] = preprocess(alpha, tau[rows], jump[rows])
    columns[9] = transfer.beta
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

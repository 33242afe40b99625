"""From propagated extremals to a block of the data set."""

import numpy as np
from numpy.typing import NDArray

from sailnet.dataset import JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG, SAMPLES, Block
from sailnet.physics.arrays import Array
from sailnet.physics.jumps import preprocess
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.transfer import Transfer

PROPAGATED = ("r", "u", "v", "lambda_r", "lambda_u", "lambda_v")
"""Of a state and its costates, in the order in which they are propagated."""

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
    columns = {name: np.empty(len(tau)) for name in SAMPLES if name != "trajectory"}
    columns["tau"][:], columns["beta"][:] = tau, transfer.beta
    jump = np.repeat(jump_time, lengths)
    for start in range(0, len(tau), AT_ONCE):
        rows = slice(start, start + AT_ONCE)
        for name, values in zip(PROPAGATED, states[rows].T, strict=True):
            columns[name][rows] = values
        alpha = guidance_law(transfer, columns["lambda_u"][rows], columns["lambda_v"][rows])
        columns["alpha"][rows] = alpha
        columns["alpha_pre"][rows] = preprocess(alpha, tau[rows], jump[rows])
    return Block(
        columns,
        {
            "lambda_r0": costates[:, 0],
            "lambda_u0": costates[:, 1],
            "lambda_v0": costates[:, 2],
            "jump_time": jump_time,
            "flags": JUMP_FLAG * np.isfinite(jump_time) + NEGATIVE_ARRIVAL_FLAG * (costates[:, 2] > 0.0),
        },
        lengths,
    )

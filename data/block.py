"""From propagated extremals to a block of the data set."""

import numpy as np
from numpy.typing import NDArray

from sailnet.dataset import ALONE, JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG, Block
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import attitude, force_costates, geometry_of
from sailnet.physics.jumps import preprocess
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.transfer import Transfer

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
    """Assemble the columns of n trajectories with m samples in all, each a family of its own.

    Args:
        transfer: the problem.
        costates: (n, 3) arrival costates; in space (n, 5).
        tau: (m,) time to go, one trajectory after the other.
        states: (m, 6) states and costates there; in space (m, 10).
        jump_time: (n,) time to go at the jump, NaN without one.
        lengths: (n,) samples of each trajectory.
    """
    size = costates.shape[1]
    state_names = geometry_of(size).state_names
    costate_names = [f"lambda_{name}" for name in state_names]
    propagated = (*state_names, *costate_names)
    commands = ("alpha", "alpha_pre" if size == 3 else "clock_angle")
    columns = {name: np.empty(len(tau)) for name in (*propagated, *commands)}
    jump = np.repeat(jump_time, lengths)
    for start in range(0, len(tau), AT_ONCE):
        rows = slice(start, start + AT_ONCE)
        for name, values in zip(propagated, states[rows].T, strict=True):
            columns[name][rows] = values
        own = np.ascontiguousarray(states[rows, size:])
        alpha = guidance_law(transfer, *force_costates(own))
        if size == 3:
            columns["alpha"][rows] = alpha
            columns["alpha_pre"][rows] = preprocess(alpha, tau[rows], jump[rows])
        else:
            columns["alpha"][rows], columns["clock_angle"][rows] = attitude(own, alpha)
    arrivals = {f"{name}0": values for name, values in zip(costate_names, costates.T, strict=True)}
    back = costates[:, costate_names.index("lambda_v")] > 0.0
    flags = JUMP_FLAG * np.isfinite(jump_time) + NEGATIVE_ARRIVAL_FLAG * back
    return Block(
        columns | {"tau": tau, "beta": np.full(len(tau), transfer.beta)},
        arrivals | {"jump_time": jump_time, "family": np.full(len(costates), ALONE), "flags": flags},
        lengths,
    )

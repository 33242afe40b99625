"""Approaches to the target from all sides: extremals with other arrival costates than optimal flights have.

Along flights alone a network would learn the approach only from where optimal flights come; a disturbance of
the last few hours leads elsewhere. Each is sampled as far back as nothing is known to be faster.
"""

import math

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from data.block import block_of
from sailnet.dataset import ALONE, Block
from sailnet.networks.approach import approach_direction
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.geometry import geometry_of
from sailnet.physics.transfer import Transfer

SAMPLES = 60
"""Samples of an approach besides its arrival, evenly in log(tau)."""

SHORTEST = 0.002
"""The first of them [TU]."""

SPREAD = (0.003, 0.5)
"""By how much, relative to (lambda_u, lambda_v), arrival costates of flights are varied."""

FROM_ALL_SIDES = 0.25
"""Share of approaches with arrival costates of any direction."""

LEAST_GAIN = 1e-3
"""Smallest -lambda . dx/dt relative to |(lambda_u, lambda_v)|: beyond, costates grow without bound."""

NEIGHBOURS, RADIUS, SLOWER = 8, 0.03, 1.08
"""A sample is not the fastest if one of so many neighbours this near, in approach coordinates (log s
weighted by 0.3), has tau / s lower by this factor."""


def approach_costates(
    problem: Transfer, arrivals: Array, count: int, rng: np.random.Generator
) -> tuple[Array, NDArray[np.intp]]:
    """Arrival costates beside those of flights, and some of any direction.

    Args:
        problem: the transfer, with the sail's beta.
        arrivals: (n, 3) arrival costates of flights, of r, u and v; in space (n, 5).
        count: how many are drawn; those with which no sail arrives are left out.
        rng: draws.

    Returns:
        (k, 3) costates with -lambda . dx/dt = 1, and (k,) the flights that they are near, ``ALONE`` for
        any direction.
    """
    parents = rng.integers(len(arrivals), size=count)
    near = arrivals[parents]
    positions = near.shape[1] // 2
    size = np.linalg.norm(near[:, positions:], axis=1)[:, None]
    near += (
        size
        * np.exp(rng.uniform(math.log(SPREAD[0]), math.log(SPREAD[1]), (count, 1)))
        * rng.normal(size=near.shape)
    )
    anywhere = rng.normal(size=near.shape)
    # lambda_r acts through lambda_r tau: what matters at 0.3 TU is nothing at 0.003.
    anywhere[:, :positions] /= np.exp(rng.uniform(np.log(0.05), np.log(3.0), count))[:, None]
    aside = rng.uniform(size=count) < FROM_ALL_SIDES
    costates = np.where(aside[:, None], anywhere, near)
    gain = arrival_gain(problem, costates)
    kept = gain < -LEAST_GAIN * np.linalg.norm(costates[:, positions:], axis=1)
    return costates[kept] / -gain[kept, None], np.where(aside, ALONE, parents)[kept]


def approaches(
    problem: Transfer, costates: Array, longest: float, flights: Block, rng: np.random.Generator
) -> tuple[Block, NDArray[np.bool_]]:
    """Sample approaches, each as far back as it is the fastest known.

    Args:
        problem: the transfer, with the sail's beta.
        costates: (n, 3) at arrival; in space (n, 5).
        longest: how far back at most [TU].
        flights: of the same sail, which no approach may be slower than.
        rng: draws the times of samples.

    Returns:
        The approaches that could be propagated, and (n,) which those are.
    """
    tau = np.zeros((len(costates), SAMPLES + 1))
    even = np.linspace(np.log(SHORTEST), np.log(longest), SAMPLES)
    jitter = rng.uniform(-0.5, 0.5, (len(costates), SAMPLES)) * (even[1] - even[0])
    tau[:, 1:] = np.exp(even + np.minimum(jitter, 0.0) + np.where(even < even[-1], np.maximum(jitter, 0), 0))
    extremals = propagate_extremals(problem, costates, tau)
    whole = np.isfinite(extremals.states).all(axis=(1, 2))
    costates, tau = costates[whole], tau[whole]
    states, jump_times = extremals.states[whole], extremals.jump_times[whole]

    components = costates.shape[1]
    names = geometry_of(components).state_names
    known = np.column_stack([flights.samples[name] for name in (*names, "tau")])
    known = known[(known[:, -1] > 0.0) & (known[:, -1] <= longest)]
    points = np.concatenate([states[:, 1:, :components].reshape(-1, components), known[:, :-1]])
    direction, s = approach_direction(problem, points, problem.beta)
    relative = np.append(np.concatenate([tau[:, 1:].ravel(), known[:, -1]]) / s, np.inf)
    place = np.column_stack([direction, 0.3 * np.log(s)])
    mine = tau[:, 1:].size
    _, beside = cKDTree(place).query(place[:mine], k=NEIGHBOURS, distance_upper_bound=RADIUS)
    slower = relative[:mine] > SLOWER * relative[beside].min(axis=1)
    # What comes before a point that is not the fastest is not the fastest either (Bellman).
    fastest = ~np.logical_or.accumulate(slower.reshape(-1, SAMPLES), axis=1)
    used = np.column_stack([np.ones(len(tau), bool), fastest])
    lengths = used.sum(axis=1)
    ends = tau[np.arange(len(tau)), lengths - 1]
    jump = np.where(jump_times <= ends, jump_times, np.nan)
    return block_of(problem, costates, tau[used], states[used], jump, lengths), np.asarray(whole)

"""The expert in three dimensions: the fastest of the extremals found from states off the target's plane.

Backward shooting has five unknowns for five components. What it starts from are the plane's optima: a state
is laid into the plane, its speed along the plane kept, and the extremals found there are those of the state
at latitude and northward speed 0. Nearby Newton's method needs no more than that; farther off the extremals
are followed as the state is lifted. A plane's index is complete, and no families of extremals were met that
are in space alone: from random directions and far neighbours' extremals one gets to the same. Where many
states are asked for, those that nothing was found for start from their neighbours', found by a k-d tree.
"""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.errors import SolveError
from sailnet.expert.continuation import follow
from sailnet.expert.fastest import Region, keep_faster, solve_families
from sailnet.expert.neighbours import spread
from sailnet.expert.optima import RESIDUAL_GOAL, Extremal, Optima, nothing_found, optima_of
from sailnet.expert.shooting import shoot
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import in_space, target_of
from sailnet.physics.transfer import Transfer

AXIS = 1e-6
"""Cosine of the latitude below which a state counts as on the axis of the target orbit, where no direction is
the transverse one [1]."""

NOTHING_THERE = 1e-3
"""A state over the target orbit, as near as this to it once laid into the plane, is laid beside it: from the
orbit itself there is no extremal to follow."""

SLOWER = 1.05
"""How many times the fastest's time the plane's second fastest may take for it to be followed as well."""


def solve(transfer: Transfer, state: ArrayLike) -> Extremal:
    """The fastest extremal found from ``state`` = (r, latitude, u, v, w).

    Args:
        transfer: the problem.
        state: r [AU], latitude [rad], u, v, w [AU/TU]: radial, transverse, northward.

    Raises:
        SolveError: the state cannot be, or no extremal was found that passes through it.
    """
    target = np.asarray(state, float)
    _refuse(transfer, target[None] if target.ndim == 1 else target)
    optima = solve_states(transfer, target[None], rivals=True)
    if not optima.found[0]:
        r, latitude, u, v, w = target
        raise SolveError(
            f"no extremal found from r = {r:g} AU, latitude {math.degrees(latitude):g} degrees, u = {u:g}, "
            f"v = {v:g}, w = {w:g} AU/TU to a circular orbit of {transfer.target_radius:g} AU"
        )
    return optima.extremal(0)


def solve_states(
    transfer: Transfer, states: ArrayLike, region: Region | None = None, rivals: bool = False
) -> Optima:
    """The fastest extremals found from many states in three dimensions.

    Args:
        transfer: the problem.
        states: (n, 5) rows r [AU], latitude [rad], u, v, w [AU/TU].
        region: lowest and highest state of a box whose extremals in the plane are indexed at once, for this
            and later calls. By default what surrounds the states is.
        rivals: also look for the second fastest extremal, however slow it is in the plane.

    Returns:
        The optima; ``searched`` is NaN, since nothing says that none was missed.

    Raises:
        SolveError: a state is not finite, has r <= 0, is on the axis, on the target orbit or outside the
            region.
    """
    given = np.asarray(states, float)
    given = given.reshape(-1, 5) if given.size else np.empty((0, 5))
    _refuse(transfer, given)
    best, second = nothing_found(given), nothing_found(given)
    flat, box = _laid(transfer, given), None if region is None else _laid_box(*region)
    for family in solve_families(transfer, flat, box, math.inf if rivals else SLOWER):
        rows = np.flatnonzero(family.found)
        _lift(transfer, best, second, rows, family.rows(rows))
    if len(given) > 1 and not best.found.all():
        spread(transfer, best)
    best.rival_time[:] = second.time_of_flight
    return best


def _refuse(transfer: Transfer, states: Array) -> None:
    """Refuse states that no sail can be in, or that there is nothing to solve for."""
    told = "(r, latitude, u, v, w) must be five finite numbers with r > 0"
    if states.ndim != 2 or states.shape[1] != 5:
        raise SolveError(f"the state {told}, not {states.squeeze().tolist()}")
    bad = ~np.isfinite(states).all(axis=1) | ~(states[:, 0] > 0.0)
    if bad.any():
        raise SolveError(f"the state {told}, not {states[np.argmax(bad)].tolist()}")
    beyond = np.abs(states[:, 1]) > math.pi / 2
    if beyond.any():
        degrees = math.degrees(states[np.argmax(beyond), 1])
        raise SolveError(f"a latitude is from -90 to 90 degrees, not {degrees:g}")
    if (np.cos(states[:, 1]) < AXIS).any():
        raise SolveError(
            "the state is on the axis of the target orbit, where no direction is the transverse one: "
            "start beside it"
        )
    if (np.abs(states - target_of(transfer, 5)).max(axis=1, initial=0.0) < RESIDUAL_GOAL).any():
        raise SolveError("the state is on the target orbit already: there is nothing to solve")


def _laid(transfer: Transfer, states: Array) -> Array:
    """(n, 3) states in the plane with the same distance and speeds."""
    planar = np.column_stack([states[:, 0], states[:, 2], np.hypot(states[:, 3], states[:, 4])])
    there = np.abs(planar - transfer.target_state).max(axis=1) < NOTHING_THERE
    planar[there, 0] -= 2.0 * NOTHING_THERE * transfer.target_radius
    return planar


def _laid_box(low: ArrayLike, high: ArrayLike) -> Region:
    """The box that states of a box are laid into."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    northward = max(abs(low[4]), abs(high[4]))
    return low[[0, 2, 3]], np.array([high[0], high[2], np.hypot(high[3], northward)])


def _lift(transfer: Transfer, best: Optima, second: Optima, rows: NDArray[np.intp], planar: Optima) -> None:
    """Put what extremals in the plane lead to from some rows' states into those that are faster."""
    if not len(rows):
        return
    states = best.state[rows]
    costates, tau = in_space(planar.arrival_costates), planar.time_of_flight
    found = optima_of(transfer, states, shoot(transfer, states, costates, tau))
    keep_faster(best, second, rows, found)
    lost = np.flatnonzero(~found.found)
    if not len(lost):
        return
    start = in_space(planar.state)[lost]

    def lifted(shares: Array) -> Array:
        return start + shares[:, None] * (states[lost] - start)

    followed = follow(lambda _: transfer, lifted, costates[lost], tau[lost])
    found = optima_of(transfer, states[lost], followed.shots)
    keep_faster(best, second, rows[lost], found)

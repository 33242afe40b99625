"""The expert: the minimum-time extremal from any state, found by backward shooting.

Guesses come from an index of coarse extremals, refined around the states that are asked for;
Newton's method finishes them, and of the extremals that reach a state the fastest wins.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.errors import SolveError
from sailnet.expert.directions import Rows
from sailnet.expert.index import Guesses, Index, build_index
from sailnet.expert.prisms import bins_of
from sailnet.expert.shooting import Shots, shoot
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.pontryagin import evaluate_hamiltonian, guidance_law, hamiltonian_bound
from sailnet.physics.transfer import AnyTransfer, Transfer

Region = tuple[ArrayLike, ArrayLike]
"""Lowest and highest state of a box."""

RESIDUAL_GOAL = 1e-9
"""An extremal counts as found when it passes this close to the state (any component)."""

EFFORT = 2
"""How many times the budget of directions a second search may take, of the few states that need one."""

SAME = 0.02
"""Guesses of one extremal from neighbouring prisms differ by less than this in time to go."""


@dataclass(frozen=True)
class Extremal:
    """A minimum-time extremal from a state to the target orbit.

    Attributes:
        state: (3,) r [AU], u, v [AU/TU] at the start.
        time_of_flight: time to the target orbit [TU].
        costates: (3,) lambda_r, lambda_u, lambda_v at the start, scaled to H = 0.
        arrival_costates: (3,) the same at the target.
        cone_angle: optimal cone angle at the start [rad].
        jumps: jumps of the cone angle on the way.
        jump_time: time to go at the jump [TU], NaN without one.
        residual: largest component of the error in the state.
        rival_time: time of flight [TU] of the next extremal found to reach the same state, NaN where
            none was. Extremals that take much longer are not looked for.
        searched: time [TU] up to which every extremal was looked for, NaN if none but this one was.
    """

    state: Array
    time_of_flight: float
    costates: Array
    arrival_costates: Array
    cone_angle: float
    jumps: int
    jump_time: float
    residual: float
    rival_time: float
    searched: float

    @property
    def complete(self) -> bool:
        """Whether all that could be faster was looked for: else the search ran out of directions before."""
        return self.time_of_flight <= self.searched


@dataclass(frozen=True)
class Optima:
    """Minimum-time extremals from many states; the attributes of :class:`Extremal`, one row a state.

    NaN (and 0 jumps) where none was found, see ``found``.
    """

    state: Array
    time_of_flight: Array
    costates: Array
    arrival_costates: Array
    cone_angle: Array
    jumps: NDArray[np.int64]
    jump_time: Array
    residual: Array
    rival_time: Array
    searched: Array

    @property
    def complete(self) -> NDArray[np.bool_]:
        """(n,) which of them are known to be the fastest, see :attr:`Extremal.complete`."""
        return np.asarray(self.time_of_flight <= self.searched)

    @property
    def found(self) -> NDArray[np.bool_]:
        """(n,) which states an extremal was found for."""
        return np.isfinite(self.time_of_flight)

    def extremal(self, row: int) -> Extremal:
        """One of them."""
        arrays = {"state", "costates", "arrival_costates"}
        values = {name: column[row] for name, column in vars(self).items()}
        return Extremal(**{name: value if name in arrays else value.item() for name, value in values.items()})


def solve(transfer: Transfer, state: ArrayLike) -> Extremal:
    """The minimum-time extremal from ``state`` = (r, u, v).

    Args:
        transfer: the problem.
        state: r [AU], u [AU/TU], v [AU/TU].

    Raises:
        SolveError: the state is not finite, or no extremal was found that passes through it.
    """
    target = np.asarray(state, float)
    if target.shape != (3,):
        raise SolveError(
            f"the state (r, u, v) must be three finite numbers with r > 0, not {target.tolist()}"
        )
    optima = solve_states(transfer, target[None], rivals=True)
    if not optima.found[0]:
        raise SolveError(
            f"no extremal found from r = {target[0]:g} AU, u = {target[1]:g}, v = {target[2]:g} AU/TU "
            f"to a circular orbit of {transfer.target_radius:g} AU"
        )
    return optima.extremal(0)


def solve_states(
    transfer: Transfer,
    states: ArrayLike,
    region: Region | None = None,
    rivals: bool = False,
) -> Optima:
    """The minimum-time extremals from many states.

    Args:
        transfer: the problem.
        states: (n, 3) rows r [AU], u, v [AU/TU].
        region: lowest and highest state of a box to index at once, for this and later calls. By
            default what surrounds the states is indexed, and what was not found once more alone.
            Where a faster one than found may have been missed, the search goes on until none is left, with
            ``EFFORT`` times its budget.
        rivals: also look for the second fastest extremal.

    Raises:
        SolveError: a state is not finite, has r <= 0, lies outside the region or on the target orbit.
    """
    given = np.asarray(states, float).reshape(-1, 3)
    bad = ~np.isfinite(given).all(axis=1) | ~(given[:, 0] > 0.0)
    if bad.any():
        worst = given[np.argmax(bad)].tolist()
        raise SolveError(f"the state (r, u, v) must be three finite numbers with r > 0, not {worst}")
    if (np.abs(given - transfer.target_state).max(axis=1) < RESIDUAL_GOAL).any():
        raise SolveError("the state is on the target orbit already: there is nothing to solve")
    optima = _nothing(given)
    _search(transfer, optima, np.arange(len(given)), region, rivals)
    if region is None:
        _search(transfer, optima, np.flatnonzero(~optima.found), None, rivals)
    _search(transfer, optima, np.flatnonzero(optima.found & ~optima.complete), None, rivals, longer=True)
    return optima


def sample(transfer: Transfer, extremal: Extremal, count: int = 501) -> tuple[Array, Array]:
    """An extremal from departure to arrival.

    Returns:
        (count,) time since departure [TU], and (count, 7) columns r, u, v, lambda_r, lambda_u,
        lambda_v and the optimal cone angle [rad].
    """
    costates = np.reshape(extremal.arrival_costates, (1, 3))
    times, columns = sample_many(transfer, costates, np.array([extremal.time_of_flight]), count)
    return times[0], columns[0]


def sample_many(
    transfer: Transfer, arrival_costates: Array, times_of_flight: Array, count: int = 501
) -> tuple[Array, Array]:
    """The same from the facts that determine extremals: (n, m) times and (n, m, 7) columns.

    Args:
        transfer: the problem.
        arrival_costates: (n, 3) at arrival.
        times_of_flight: (n,) [TU].
        count: samples of each, m.
    """
    tau = np.linspace(0.0, times_of_flight, count, axis=1)
    states = propagate_extremals(transfer, arrival_costates, tau).states[:, ::-1]
    alpha = guidance_law(transfer, states[..., 4], states[..., 5])
    return tau, np.concatenate([states, alpha[..., None]], axis=2)


def extremal_of(transfer: Transfer, state: Array, shots: Shots, row: int) -> Extremal | None:
    """One shot as an extremal, or None if it does not reach the state."""
    optima = optima_of(transfer, state[None], shots.rows([row]))
    return optima.extremal(0) if optima.found[0] else None


def _scaled(transfer: Transfer, states: ArrayLike) -> Array:
    """States in units of the target orbit."""
    size = transfer.target_radius
    return np.asarray(np.asarray(states, float) * [1.0 / size, np.sqrt(size), np.sqrt(size)])


def _search(
    transfer: Transfer, optima: Optima, rows: Rows, region: Region | None, rivals: bool, longer: bool = False
) -> None:
    """Put what is found faster into some rows of ``optima``, and how far it was looked for."""
    if not len(rows):
        return
    states = optima.state[rows]
    scaled, size = _scaled(transfer, states), transfer.target_radius
    index = _index(transfer, scaled, region, optima.time_of_flight[rows] / size**1.5 if longer else None)
    _keep_faster(optima, rows, _fastest(transfer, states, _distinct(index.look_up(scaled)), rivals))
    optima.searched[rows] = np.fmax(optima.searched[rows], index.searched(scaled) * size**1.5)


def _index(transfer: Transfer, scaled: Array, region: Region | None, until: Array | None = None) -> Index:
    """The index of the states' bins, or of a region; searched until all that is faster is known, if asked."""
    bins = bins_of(scaled)
    if region is not None:
        low, high = bins_of(_scaled(transfer, np.array(region, float)))
        if (bins < low).any() or (bins > high).any():
            raise SolveError("a state lies outside the region that was to be indexed")
        bins = np.stack(np.meshgrid(*map(np.arange, low, high + 1), indexing="ij"), axis=-1).reshape(-1, 3)
    wanted, which = np.unique(bins, axis=0, return_inverse=True)
    unit = replace(transfer, target_radius=1.0)
    named = tuple(map(tuple, wanted.tolist()))
    if until is None:
        return build_index(unit, named)
    last = np.zeros(len(wanted))
    np.maximum.at(last, which.ravel(), until)
    return build_index(unit, named, EFFORT, tuple(last.tolist()))


def _distinct(guesses: Guesses) -> Guesses:
    """One guess an extremal: neighbouring prisms that nearly hold a state all point to it."""
    order = np.lexsort((guesses.outside, guesses.state))
    kept = [order[:0]]
    while len(order):
        begins = np.flatnonzero(np.diff(guesses.state[order], prepend=-1))
        best = order[begins]
        kept.append(best)
        beside = np.repeat(best, np.diff(begins, append=len(order)))
        turned = np.linalg.norm(guesses.directions[order] - guesses.directions[beside], axis=1)
        # The farther a state lies from a prism, the less its guess says.
        apart = turned > (1.0 + 10.0 * guesses.outside[order]) * (
            guesses.width[order] + guesses.width[beside]
        )
        later = np.abs(guesses.tau[order] - guesses.tau[beside]) > SAME + guesses.outside[order]
        order = order[apart | later]
    rows = np.concatenate(kept)
    return Guesses(*(column[rows] for column in vars(guesses).values()))


def _fastest(transfer: Transfer, states: Array, guesses: Guesses, rivals: bool) -> Optima:
    """Refine guesses, fastest first, until none that is left could be faster."""
    size = transfer.target_radius
    directions = guesses.directions * [np.sqrt(size), size**2, size**2]
    tau, margin = guesses.tau * size**1.5, SAME * size**1.5
    best = _nothing(states)
    waiting = np.lexsort((tau, guesses.state))
    while True:
        limit = (best.rival_time if rivals else best.time_of_flight)[guesses.state[waiting]]
        waiting = waiting[~(tau[waiting] > limit + margin)]
        if not len(waiting):
            return best
        first = np.diff(guesses.state[waiting], prepend=-1) != 0
        rows, waiting = waiting[first], waiting[~first]
        at = guesses.state[rows]
        _keep_faster(
            best,
            at,
            optima_of(transfer, states[at], shoot(transfer, states[at], directions[rows], tau[rows])),
        )


def _keep_faster(best: Optima, at: NDArray[np.intp], found: Optima) -> None:
    """Replace rows ``at`` of ``best`` by what is faster; the slower of two different ones is a rival."""
    old, new = best.time_of_flight[at], found.time_of_flight
    faster = found.found & ~(new >= old)
    rival = np.where(np.abs(new - old) < 1e-6, np.nan, np.where(faster, old, new))
    rival = np.fmin(np.fmin(best.rival_time[at], found.rival_time), rival)
    put(best, at[faster], found, faster)
    best.rival_time[at] = rival


def put(best: Optima, at: NDArray[np.intp], found: Optima, chosen: object = ...) -> None:
    """Replace rows ``at`` of ``best`` by the chosen ones of ``found``."""
    for mine, theirs in zip(vars(best).values(), vars(found).values(), strict=True):
        mine[at] = theirs[chosen]


def _nothing(states: Array) -> Optima:
    def empty(*width: int) -> Array:
        return np.full((len(states), *width), np.nan)

    jumps = np.zeros(len(states), int)
    columns = (empty(), empty(3), empty(3), empty(), jumps, empty(), empty(), empty(), empty())
    return Optima(states.copy(), *columns)


def optima_of(transfer: AnyTransfer, states: Array, shots: Shots) -> Optima:
    """Shots as extremals, their costates scaled to H = 0 (Eq. 19); NaN for what is none."""
    with np.errstate(divide="ignore"):
        scale = -1.0 / arrival_gain(transfer, shots.directions)[:, None]
    costates = scale * shots.states[:, 3:]
    alpha = guidance_law(transfer, costates[:, 1], costates[:, 2])
    optima = Optima(
        state=states.copy(),
        time_of_flight=shots.tau.copy(),
        costates=costates,
        arrival_costates=scale * shots.directions,
        cone_angle=alpha,
        jumps=shots.jumps.astype(int),
        jump_time=shots.jump_times.copy(),
        residual=shots.residual.copy(),
        rival_time=np.full(len(states), np.nan),
        searched=np.full(len(states), np.nan),
    )
    drift = np.abs(evaluate_hamiltonian(transfer, states, costates, alpha))
    # Both ends stand for the whole: an order of magnitude is left to what lies between.
    ends = np.stack([np.broadcast_to(transfer.target_state, states.shape), states], axis=1)
    bound = 10.0 * hamiltonian_bound(transfer, ends, np.stack([optima.arrival_costates, costates], axis=1))
    reached = (shots.residual <= RESIDUAL_GOAL) & (drift <= bound) & (scale[:, 0] > 0.0)
    put(optima, np.flatnonzero(~reached), _nothing(states[~reached]))
    return optima

"""Minimum-time extremals: what is known of one, of many, and their samples on the way."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.shooting import Shots
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.geometry import force_costates, target_of
from sailnet.physics.pontryagin import evaluate_hamiltonian, guidance_law, hamiltonian_bound
from sailnet.physics.transfer import AnyTransfer, Transfer

RESIDUAL_GOAL = 1e-9
"""An extremal counts as found when it passes this close to the state (any component)."""


@dataclass(frozen=True)
class Extremal:
    """A minimum-time extremal from a state to the target orbit.

    Attributes:
        state: (3,) r [AU], u, v [AU/TU] at the start; in space (5,) r, latitude [rad], u, v, w.
        time_of_flight: time to the target orbit [TU].
        costates: (3,) lambda_r, lambda_u, lambda_v at the start, scaled to H = 0; in space (5,).
        arrival_costates: (3,) the same at the target.
        cone_angle: optimal cone angle at the start [rad]; in space see
            :func:`sailnet.physics.geometry.attitude`.
        jumps: jumps of the cone angle on the way, in space fast turns of the clock angle
            (:class:`sailnet.physics.extremals.Extremals`).
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

    def rows(self, chosen: object) -> "Optima":
        """Some of them, in any order and any number of times."""
        return Optima(*(column[chosen] for column in vars(self).values()))

    @classmethod
    def join(cls, parts: "Sequence[Optima]") -> "Optima":
        """Some, one after the other."""
        columns = zip(*(vars(part).values() for part in parts), strict=True)
        return cls(*(np.concatenate(column) for column in columns))

    def extremal(self, row: int) -> Extremal:
        """One of them."""
        arrays = {"state", "costates", "arrival_costates"}
        values = {name: column[row] for name, column in vars(self).items()}
        return Extremal(**{name: value if name in arrays else value.item() for name, value in values.items()})


def nothing_found(states: Array) -> Optima:
    """No extremal from any of (n, 3) or (n, 5) states."""
    size = states.shape[1]

    def empty(*width: int) -> Array:
        return np.full((len(states), *width), np.nan)

    jumps = np.zeros(len(states), int)
    columns = (empty(), empty(size), empty(size), empty(), jumps, empty(), empty(), empty(), empty())
    return Optima(states.copy(), *columns)


def put(best: Optima, at: object, found: Optima, chosen: object = ...) -> None:
    """Replace rows ``at`` of ``best`` by the chosen ones of ``found``."""
    for mine, theirs in zip(vars(best).values(), vars(found).values(), strict=True):
        mine[at] = theirs[chosen]


def optima_of(transfer: AnyTransfer, states: Array, shots: Shots) -> Optima:
    """Shots as extremals, their costates scaled to H = 0 (Eq. 19); NaN for what is none."""
    with np.errstate(divide="ignore"):
        scale = -1.0 / arrival_gain(transfer, shots.directions)[:, None]
    costates = scale * shots.states[:, states.shape[1] :]
    alpha = guidance_law(transfer, *force_costates(costates))
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
    ends = np.stack([np.broadcast_to(target_of(transfer, states.shape[1]), states.shape), states], axis=1)
    bound = 10.0 * hamiltonian_bound(transfer, ends, np.stack([optima.arrival_costates, costates], axis=1))
    reached = (shots.residual <= RESIDUAL_GOAL) & (drift <= bound) & (scale[:, 0] > 0.0)
    put(optima, np.flatnonzero(~reached), nothing_found(states[~reached]))
    return optima


def extremal_of(transfer: Transfer, state: Array, shots: Shots, row: int) -> Extremal | None:
    """One shot as an extremal, or None if it does not reach the state."""
    optima = optima_of(transfer, state[None], shots.rows([row]))
    return optima.extremal(0) if optima.found[0] else None


def sample(transfer: Transfer, extremal: Extremal, count: int = 501) -> tuple[Array, Array]:
    """An extremal from departure to arrival.

    Returns:
        (count,) time since departure [TU], and (count, 7) columns r, u, v, lambda_r, lambda_u,
        lambda_v and the optimal cone angle [rad]; in space (count, 11).
    """
    costates = extremal.arrival_costates[None]
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
    alpha = guidance_law(transfer, *force_costates(states[..., states.shape[-1] // 2 :]))
    return tau, np.concatenate([states, alpha[..., None]], axis=2)

"""Where closed-loop flights start: random states of the generalisation set, and of what lies around it.

States are r [AU], u, v [AU/TU] in the plane; of a mission with an inclination r, latitude [rad], u, v, w.
"""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from sailnet.errors import GuidanceError
from sailnet.expert.any_dimension import solve_states
from sailnet.expert.optima import Optima
from sailnet.guidance.interface import Guidance, GuidanceStatus
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.geometry import orbit_units, target_of

OPTIMA = 256
"""Optimal flights beside which others start."""

DEPARTURE = 0.05
"""Half-widths of the departure orbit's neighbourhood, in units of its radius and its speed; in radians."""

BEYOND = 3.0
"""How far off the plane to look for states that are known, in widths of the generalisation set."""

CANDIDATES = 512
"""States drawn at once for each start until one is known to the networks."""

ROUNDS = 64
"""Of candidates, after which there is none: one state in 30 of the box is known to those of earth_mars."""


def random_starts(mission: Mission, count: int, seed: int, first: int = 0) -> Array:
    """(count, 3) or (count, 5) uniform states of the generalisation set (Section 5.3).

    Args:
        mission: with the generalisation set.
        count: how many.
        seed: of the random numbers; start i depends on (seed, i) alone.
        first: number of the first one.
    """
    low, high = mission.region
    return _drawn(seed, first, count, lambda rng: rng.uniform(low, high))


def near_departure(mission: Mission, count: int, seed: int, first: int = 0) -> Array:
    """(count, 3) or (count, 5) uniform states about the departure orbit, ``DEPARTURE`` to each side.

    About an inclined orbit they are anywhere along it.
    """
    radius = mission.transfer.departure_radius
    if not mission.inclined:
        orbit, widths = np.array([radius, 0.0, radius**-0.5]), DEPARTURE * orbit_units(radius, 3)
        return orbit + _drawn(seed, first, count, lambda rng: rng.uniform(-widths, widths))
    beside = DEPARTURE * orbit_units(radius, 5)

    def drawn(rng: np.random.Generator) -> Array:
        along = {"node_distance": rng.uniform(-180.0, 180.0)}
        there = mission.model_copy(update={"transfer": mission.transfer.model_copy(update=along)})
        return np.array(there.departure_state_in_space) + rng.uniform(-beside, beside)

    return _drawn(seed, first, count, drawn)


@lru_cache(maxsize=2)
def some_optima(mission: Mission) -> Optima:
    """Fastest extremals from ``OPTIMA`` random starts of the generalisation set, those that are found.

    They are the same whatever is flown beside them, and take the expert half a minute.
    """
    starts = random_starts(mission, OPTIMA, seed=0)
    optima = solve_states(mission.problem, starts, region=mission.region)
    return optima.rows(optima.found)


def off_optima(mission: Mission, count: int, seed: int, error: float, first: int = 0) -> Array:
    """(count, 3) or (count, 5) points of :func:`some_optima`, each some way off its flight.

    The point is one of evenly distributed time to go. It is off in a random direction, by ``error`` times
    what is left: the length of the deviation from the target, with r in units of the target's, u, v, w in
    those of its speed, and the latitude in radians.

    Args:
        mission: poses the problem.
        count: how many.
        seed: as of ``random_starts``.
        error: relative.
        first: number of the first one.
    """
    flights = some_optima(mission)
    components = flights.state.shape[1]

    def draw(rng: np.random.Generator) -> Array:
        return np.append(rng.uniform(size=2), rng.normal(size=components))

    drawn = _drawn(seed, first, count, draw, 2)
    flight = (drawn[:, 0] * len(flights.state)).astype(int)
    tau = np.column_stack([np.zeros(count), drawn[:, 1] * flights.time_of_flight[flight]])
    extremals = propagate_extremals(mission.problem, flights.arrival_costates[flight], tau)
    points, direction = extremals.states[:, 1, :components], drawn[:, 2:]
    units = orbit_units(mission.problem.target_radius, components)
    left = np.linalg.norm((points - target_of(mission.problem, components)) / units, axis=1)
    size = error * left / np.linalg.norm(direction, axis=1)
    return np.asarray(points + size[:, None] * direction * units)


def inside_domain(mission: Mission, guidance: Guidance, count: int, seed: int, first: int = 0) -> Array:
    """(count, 3) or (count, 5) states that the guidance says it knows, evenly distributed over all of those.

    Args:
        mission: says how far to look: r from a quarter of the inner orbit to four times the outer, u and v
            up to 1.5 times the speed of the inner; latitude and w ``BEYOND`` times as far as the
            generalisation set.
        guidance: whose domain it is.
        count: how many.
        seed: as of ``random_starts``.
        first: number of the first one.

    Raises:
        GuidanceError: it knows hardly any state.
    """
    orbits = sorted((mission.transfer.departure_radius, mission.transfer.target_radius))
    speed = orbits[0] ** -0.5
    low, high = [0.25 * orbits[0], -1.5 * speed, 0.0], [4.0 * orbits[1], 1.5 * speed, 1.5 * speed]
    if mission.inclined:
        for place, corners in zip((low, high), mission.generalisation.corners_in_space, strict=True):
            for component in (1, 4):
                place.insert(component, BEYOND * float(corners[component]))
    rngs = [np.random.default_rng([seed, number, 3]) for number in range(first, first + count)]
    starts = np.full((count, len(low)), np.nan)
    for _ in range(ROUNDS):
        left = np.flatnonzero(np.isnan(starts[:, 0]))
        candidates = np.array([rngs[row].uniform(low, high, (CANDIDATES, len(low))) for row in left])
        known = _known(guidance, candidates.reshape(-1, len(low))).reshape(len(left), CANDIDATES)
        some = known.any(axis=1)
        starts[left[some]] = candidates[some, known[some].argmax(axis=1)]
        if some.all():
            return starts
    raise GuidanceError(f"of {ROUNDS * CANDIDATES:,} states about the orbits the guidance knows none")


def _known(guidance: Guidance, states: Array) -> NDArray[np.bool_]:
    status = guidance.command(states).status
    return np.asarray(status != GuidanceStatus.OUTSIDE_DOMAIN)


def _drawn(
    seed: int, first: int, count: int, draw: Callable[[np.random.Generator], Array], stream: int = 1
) -> Array:
    """(count, k) what each start draws from random numbers of its own."""
    drawn = [draw(np.random.default_rng([seed, number, stream])) for number in range(first, first + count)]
    return np.array(drawn)

"""The fastest extremals of neighbouring sails: one is searched, the others are led to.

From the middle sail outward each begins at what the one before has found. What is left out are mostly the
slowest flights of sails that hardly get away; those the weakest is searched for, and from it they lead back.
"""

from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.any_dimension import solve_once, solve_some
from sailnet.expert.neighbours import next_optima, solve_among, spread
from sailnet.expert.optima import Optima, put
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

SEEDS = 256
"""States of the middle one that are searched for by an index; the others begin at neighbours. 64 saved some
seconds and left 26 of 7,168 flights to Venus slower or out."""

WORTH_A_SEARCH = 12, 0.02
"""States of the weakest without an extremal, and their share of all, from which on an index is made for them:
ten to thirty seconds."""

STEPS = 4
"""From one sail to the next when slow flights lead on: of 1.7 % of beta at once Newton's method takes few."""


def sails_of(mission: Mission, levels: range) -> list[Transfer]:
    """The problem with some of the wide recipe's values of beta, by their numbers."""
    recipe = mission.dataset.wide
    beta = mission.sail.beta * np.linspace(*recipe.beta, recipe.levels)[levels]
    return [replace(mission.problem, beta=float(own)) for own in beta]


def short_enough(mission: Mission, optima: Optima) -> Optima:
    """Those found of a flight that is not lost for its length."""
    return optima.rows(optima.found & ~(optima.time_of_flight > mission.flight.longest))


def solve_neighbouring_sails(sails: list[Transfer], states: list[Array], seeds: int = SEEDS) -> list[Optima]:
    """The fastest extremals of neighbouring sails.

    Args:
        sails: from the weakest to the strongest, some per cent apart at most.
        states: (n, 3) r [AU], u, v [AU/TU] for each, that fill the same region; or (n, 5) in space.
        seeds: states of the middle one that are searched for.

    Returns:
        For each the optima, as of :func:`sailnet.expert.neighbours.solve_among`.
    """
    optima = _outward(sails, states, seeds)
    least, share = WORTH_A_SEARCH
    if np.count_nonzero(~optima[0].found) >= max(least, share * len(states[0])):
        _search_what_is_left(sails, optima)
    return optima


def _outward(sails: list[Transfer], states: list[Array], count: int) -> list[Optima]:
    """From the middle one outward, each from those of the one before."""
    middle = len(sails) // 2
    seeds = solve_some(sails[middle], states[middle][:count])
    optima = {middle: solve_among(sails[middle], states[middle], seeds)}
    for level in [*range(middle + 1, len(sails)), *range(middle - 1, -1, -1)]:
        inner = level - 1 if level > middle else level + 1
        optima[level] = solve_among(sails[level], states[level], optima[inner])
    return [optima[level] for level in range(len(sails))]


def _search_what_is_left(sails: list[Transfer], optima: list[Optima]) -> None:
    """Put in what a search finds for the weakest, and what then leads from each to the next one."""
    left = [np.flatnonzero(~known.found) for known in optima]
    # Not their region's: to 1.35 AU with JPL's optics that index took 17 GB and more, for 41 states 0.8.
    _put_in(sails[0], optima[0], left[0], solve_once(sails[0], optima[0].state[left[0]]))
    # What one search of the weakest misses, the second leads back to.
    back = [(1, 0)] if len(sails) > 1 else []
    for one, other in [*pairwise(range(len(sails))), *back]:
        led = _led(sails[one], sails[other], optima[one].rows(left[one]))
        still = np.flatnonzero(~optima[other].found)
        found = solve_among(sails[other], optima[other].state[still], led)
        _put_in(sails[other], optima[other], still, found)


def _put_in(sail: Transfer, optima: Optima, rows: NDArray[np.intp], found: Optima) -> None:
    put(optima, rows[found.found], found, found.found)
    spread(sail, optima, rows[found.found])


def _led(one: Transfer, other: Transfer, optima: Optima) -> Optima:
    """Of another sail from the same states, by some steps of beta: slow flights change much with it."""
    for beta in np.linspace(one.beta, other.beta, STEPS + 1)[1:-1]:
        optima = next_optima(replace(one, beta=float(beta)), optima.rows(optima.found))
    return optima

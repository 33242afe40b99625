"""The fastest extremals of neighbouring sails: one is searched, the others are led to.

From the middle sail outward each begins at what the one before has found. What is left out are mostly the
slowest flights of sails that hardly get away; those the weakest is searched for, and from it they lead back.
"""

from dataclasses import replace
from itertools import pairwise

import numpy as np

from sailnet.expert.any_dimension import solve_some
from sailnet.expert.neighbours import solve_among
from sailnet.expert.optima import Optima
from sailnet.expert.real_sails import own_optima
from sailnet.expert.what_is_left import put_in, search_what_is_left, worth_a_search
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

SEEDS = 256
"""States of the middle one that are searched for by an index; the others begin at neighbours. 64 saved some
seconds and left 26 of 7,168 flights to Venus slower or out."""


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
    if worth_a_search(optima[0]):
        _search_and_lead(sails, optima)
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


def _search_and_lead(sails: list[Transfer], optima: list[Optima]) -> None:
    """Put in what a search finds for the weakest, and what then leads from each to the next one and back."""
    left = [np.flatnonzero(~known.found) for known in optima]
    search_what_is_left(sails[0], optima[0])
    levels = range(len(sails))
    for one, other in [*pairwise(levels), *pairwise(levels[::-1])]:
        # Back there is little to find, but where the weaker ones' search has failed: to 4 AU an eighth.
        if other > one or worth_a_search(optima[other]):
            _lead(sails[one], sails[other], optima[one].rows(left[one]), optima[other])


def _lead(one: Transfer, other: Transfer, known: Optima, optima: Optima) -> None:
    """Put in what extremals of one sail lead to by continuation: slow flights change much with beta."""
    known = known.rows(known.found)
    beta, ways = np.full(len(known.state), other.beta), (known.arrival_costates, known.time_of_flight)
    led, _ = own_optima(one, known.state, *ways, beta, one.optics, search=False)
    still = np.flatnonzero(~optima.found)
    put_in(other, optima, still, solve_among(other, optima.state[still], led))

"""The fastest extremals of neighbouring sails: one is searched, the others are led to.

From the middle sail outward each begins at what the one before has found. What is left out are mostly the
slowest flights of sails that hardly get away; those the weakest is searched for, and from it they lead back.
"""

from dataclasses import replace

import numpy as np

from sailnet.expert.any_dimension import solve_some, solve_states
from sailnet.expert.neighbours import next_optima, solve_among, spread
from sailnet.expert.optima import Optima, put
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

SEEDS = 256
"""States of the middle one that are searched for by an index; the others begin at neighbours."""

WORTH_A_SEARCH = 12
"""States of the weakest without an extremal from which on an index is made for them, one to two minutes."""

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


def solve_neighbouring_sails(sails: list[Transfer], states: list[Array]) -> list[Optima]:
    """The fastest extremals of neighbouring sails.

    Args:
        sails: from the weakest to the strongest, some per cent apart at most.
        states: (n, 3) r [AU], u, v [AU/TU] for each, that fill the same region; or (n, 5) in space.

    Returns:
        For each the optima, as of :func:`sailnet.expert.neighbours.solve_among`.
    """
    optima = _outward(sails, states)
    if np.count_nonzero(~optima[0].found) >= WORTH_A_SEARCH:
        _search_what_is_left(sails, optima)
    return optima


def _outward(sails: list[Transfer], states: list[Array]) -> list[Optima]:
    """From the middle one outward, each from those of the one before."""
    middle = len(sails) // 2
    seeds = solve_some(sails[middle], states[middle][:SEEDS])
    optima = {middle: solve_among(sails[middle], states[middle], seeds)}
    for level in [*range(middle + 1, len(sails)), *range(middle - 1, -1, -1)]:
        inner = level - 1 if level > middle else level + 1
        optima[level] = solve_among(sails[level], states[level], optima[inner])
    return [optima[level] for level in range(len(sails))]


def _search_what_is_left(sails: list[Transfer], optima: list[Optima]) -> None:
    """Put in what a search finds for the weakest, and for each other one what then leads on from there."""
    left = np.flatnonzero(~optima[0].found)
    states = optima[0].state[left]
    # Not their region's: to 1.35 AU with JPL's optics that index took 17 GB and more, for 41 states 0.8.
    found = solve_states(sails[0], states)
    for level, (sail, known) in enumerate(zip(sails, optima, strict=True)):
        if level:
            left = np.flatnonzero(~known.found)
            found = solve_among(sail, known.state[left], _led(sails[level - 1], sail, found))
        put(known, left[found.found], found, found.found)
        spread(sail, known)
        found = known.rows(left)


def _led(one: Transfer, other: Transfer, optima: Optima) -> Optima:
    """Of another sail from the same states, by some steps of beta: slow flights change much with it."""
    for beta in np.linspace(one.beta, other.beta, STEPS + 1)[1:-1]:
        optima = next_optima(replace(one, beta=float(beta)), optima.rows(optima.found))
    return optima

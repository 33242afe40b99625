"""Optima of the sails that flew: from one sail's optima to those of many others, by continuation.

A flight is judged by the shortest time of its very sail. To index the extremals of every single sail takes
a second or more each; an optimum of the nominal sail is followed to the sail that flew in milliseconds.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.any_dimension import solve_states
from sailnet.expert.continuation import follow
from sailnet.expert.neighbours import spread
from sailnet.expert.optima import Optima, optima_of, put
from sailnet.physics.arrays import Array
from sailnet.physics.optics import OPTICS, Optics
from sailnet.physics.real_law import RealLaw
from sailnet.physics.transfer import Transfer, Transfers


def own_optima(
    transfer: Transfer,
    states: Array,
    arrival_costates: Array,
    times_of_flight: Array,
    beta: Array,
    optics: Optics | Sequence[Optics] = OPTICS["ideal"],
    *,
    search: bool = True,
    among: bool = False,
) -> tuple[Optima, NDArray[np.bool_]]:
    """Minimum-time extremals of many sails, one a state.

    Where an optimum cannot be followed to the end, at a fold for instance, that very sail is solved anew.
    Continuation keeps to a family of extremals, while the fastest of another sail may be of another: over the
    generalisation set, beta within 15 %, that was one state in some hundreds, at the slow end, by under 1 %.

    Args:
        transfer: the problem of the nominal sail.
        states: (n, 3) r [AU], u, v [AU/TU] at the start, or (n, 5) in space.
        arrival_costates: (n, 3), or (n, 5), of the nominal sail's optima from there; NaN if not known.
        times_of_flight: (n,) of those [TU].
        beta: (n,) normalised characteristic accelerations of the sails.
        optics: of all the sails, or n, of each. If these or the nominal's are not ideal, the exact law is
            solved for, delta = 0.
        search: solve anew what cannot be followed, which takes many seconds a sail; else it is not found.
        among: try neighbours' extremals too, of states that fill their region.

    Returns:
        The optima of the sails, ``searched`` NaN unless solved anew; and (n,) which of them were or would be.
    """
    beta = np.asarray(beta, float)
    kinds = [optics] * len(beta) if isinstance(optics, Optics) else list(optics)
    end = np.array([one.force for one in kinds]).reshape(-1, 3)
    ideal = transfer.law is None and (end == transfer.optics.force).all()
    common = replace(transfer, delta=transfer.delta if ideal else 0.0)

    def sails(shares: Array) -> Transfers:
        between = transfer.optics.force + shares[:, None] * (end - transfer.optics.force)
        law = None if ideal else RealLaw.of(between, transfer.phi_max)
        return Transfers(common, transfer.beta + shares * (beta - transfer.beta), law)

    followed = follow(sails, states, arrival_costates, times_of_flight)
    own = sails(np.ones(len(beta)))
    optima = optima_of(own, states, followed.shots)
    if among:
        spread(own, optima)
    anew = ~optima.found
    for row in np.flatnonzero(anew) if search else ():
        very = replace(common, beta=float(beta[row]), optics=kinds[row])
        put(optima, np.array([row]), solve_states(very, states[[row]]))
    return optima, anew

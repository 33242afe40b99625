"""The expert beside scipy's fsolve, on random states of the generalisation set, on one core."""

import time

import numpy as np

from benchmarks import scipy_peer
from sailnet.expert.fastest import RESIDUAL_GOAL, solve, solve_states
from sailnet.flight.starts import random_starts
from sailnet.mission.mission import Mission


def measure(mission: Mission, states: int, peers: int, seed: int) -> dict[str, float]:
    """Solve ``states`` random states with the expert, and the first ``peers`` of them with fsolve too.

    fsolve is given a start near the solution, (1e-3 in the arrival direction, 0.01 TU in time to go),
    which the expert has to find for itself.
    """
    problem, box = mission.problem, mission.generalisation.corners
    starts = random_starts(mission, states, seed)
    started = time.perf_counter()
    solve_states(problem, starts[:1], region=box)
    cold = time.perf_counter() - started
    started = time.perf_counter()
    optima = solve_states(problem, starts, region=box)
    warm = time.perf_counter() - started
    started = time.perf_counter()
    solve(problem, starts[0])
    alone = time.perf_counter() - started
    rng = np.random.default_rng([seed, 1])
    residuals, agree, started = [], [], time.perf_counter()
    for row in range(peers):
        direction = optima.arrival_costates[row] / np.linalg.norm(optima.arrival_costates[row])
        direction = direction + 1e-3 * rng.normal(size=3)
        direction /= np.linalg.norm(direction)
        tau = optima.time_of_flight[row] + 0.01 * rng.normal()
        found, residual = scipy_peer.solve(problem, starts[row], direction, float(tau))
        residuals.append(residual)
        agree.append(abs(found[2] - optima.time_of_flight[row]) < 1e-6)
    peer = (time.perf_counter() - started) / peers
    return {
        "states": states,
        "seed": seed,
        "found": int(optima.found.sum()),
        "largest_residual": float(np.nanmax(optima.residual)),
        "longest_time_of_flight": float(np.nanmax(optima.time_of_flight)),
        "with_a_jump": int((optima.jumps[optima.found] > 0).sum()),
        "index_seconds": cold,
        "milliseconds_a_state": 1e3 * warm / states,
        "one_state_alone_seconds": alone,
        "fsolve_states": peers,
        "fsolve_solved": int((np.array(residuals) <= RESIDUAL_GOAL).sum()),
        "fsolve_same_time": int(sum(agree)),
        "fsolve_milliseconds_a_state": 1e3 * peer,
        "times_faster": peer * states / warm,
    }

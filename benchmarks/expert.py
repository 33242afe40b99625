"""The expert on random states of the generalisation set, on one core: an ideal sail and JPL's, and fsolve."""

import time

import numpy as np

from benchmarks import scipy_peer
from sailnet.expert.fastest import solve, solve_states
from sailnet.expert.optima import RESIDUAL_GOAL, Optima
from sailnet.flight.starts import random_starts
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.optics import OPTICS

REPEATS = 3
"""Of what takes seconds: the median counts."""


def _search(mission: Mission, starts: Array) -> tuple[Optima, float, float]:
    """Optima of the starts, seconds of the processor for the index, and for a start once that is there."""
    box, seconds = mission.generalisation.corners, []
    for rows in (1, *[len(starts)] * REPEATS):
        started = time.process_time()
        optima = solve_states(mission.problem, starts[:rows], region=box)
        seconds.append(time.process_time() - started)
    return optima, seconds[0], float(np.median(seconds[1:])) / len(starts)


def measure(mission: Mission, states: int, peers: int, seed: int) -> dict[str, float]:
    """Solve ``states`` random states with the expert, and the first ``peers`` of them with fsolve too.

    The same states are solved for JPL's sail, its seconds beside the ideal one's: of the processor, since the
    machine is shared. fsolve is given a start near the solution, (1e-3 in the arrival direction, 0.01 TU in
    time to go), which the expert has to find for itself.
    """
    problem = mission.problem
    starts = random_starts(mission, states, seed)
    optima, cold, warm = _search(mission, starts)
    started = time.process_time()
    solve(problem, starts[0])
    alone = time.process_time() - started
    real, real_cold, real_warm = _search(mission.with_optics(OPTICS["jpl"]), starts)
    rng = np.random.default_rng([seed, 1])
    residuals, agree, started = [], [], time.process_time()
    for row in range(peers):
        direction = optima.arrival_costates[row] / np.linalg.norm(optima.arrival_costates[row])
        direction = direction + 1e-3 * rng.normal(size=3)
        direction /= np.linalg.norm(direction)
        tau = optima.time_of_flight[row] + 0.01 * rng.normal()
        found, residual = scipy_peer.solve(problem, starts[row], direction, float(tau))
        residuals.append(residual)
        agree.append(abs(found[2] - optima.time_of_flight[row]) < 1e-6)
    peer = (time.process_time() - started) / peers
    return {
        "states": states,
        "seed": seed,
        "found": int(optima.found.sum()),
        "largest_residual": float(np.nanmax(optima.residual)),
        "longest_time_of_flight": float(np.nanmax(optima.time_of_flight)),
        "with_a_jump": int((optima.jumps[optima.found] > 0).sum()),
        "index_seconds": cold,
        "milliseconds_a_state": 1e3 * warm,
        "one_state_alone_seconds": alone,
        "jpl_found": int(real.found.sum()),
        "jpl_largest_residual": float(np.nanmax(real.residual)),
        "jpl_index_seconds": real_cold,
        "jpl_milliseconds_a_state": 1e3 * real_warm,
        "jpl_over_ideal": real_warm / warm,
        "fsolve_states": peers,
        "fsolve_solved": int((np.array(residuals) <= RESIDUAL_GOAL).sum()),
        "fsolve_same_time": int(sum(agree)),
        "fsolve_milliseconds_a_state": 1e3 * peer,
        "times_faster": peer / warm,
    }

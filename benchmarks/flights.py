"""``python -m benchmarks.flights``: closed-loop flights, whole campaigns and what a guidance period costs.

The peer is the loop as it would be written in Python: the same exported C for all sails at once, and the
plant compiled from the expressions of Eq. (1) by heyoka, a fourth-order Runge-Kutta step a period.
"""

import argparse
import ctypes
import json
import os
import resource
import sys
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.artefacts.provenance import software
from sailnet.campaign.random_flights import BATCH, fly_random_starts
from sailnet.flight.closed_loop import fly
from sailnet.flight.plant import SideBySide, rules
from sailnet.flight.plant_library import STEER, plant
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import Guidance, Precision, Steered
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import runge_kutta_step
from sailnet.physics.optics import OPTICS
from sailnet.workers.executors import workers

NOTE = (
    "Random starts of the generalisation set, the exported C in double precision, a period of 0.005 TU. The "
    "loop in Python calls the same C for all sails at once and heyoka's compiled Runge-Kutta step of Eq. (1)."
)

CAMPAIGNS = {
    "nominal": Disturbance(),
    "beta": Disturbance(beta_spread=0.15, beta_noise=0.15),
    "everything": Disturbance(
        beta_spread=0.05,
        beta_noise=0.05,
        beta_wander=0.02,
        degradation_loss=0.05,
        r_noise=1e-6,
        u_noise=1e-6,
        v_noise=1e-6,
        r_wander=1e-6,
        u_wander=1e-6,
        v_wander=1e-6,
        rate_limit=20.0,
        delay=0.002,
        resolution=1e-4,
        misalignment_spread=0.005,
        outage_probability=0.001,
        optics=OPTICS["jpl"],
    ),
}
"""Disturbances with which a whole campaign is timed; the last draws ten random numbers a period."""


def python_loop(mission: Mission, guidance: Guidance, starts: Array) -> tuple[Array, Array, int]:
    """(n, 3) ends, (n,) times of flight and the number of periods, without disturbances."""
    count, period = len(starts), mission.flight.period
    states = np.zeros((4, count))
    states[[0, 2, 3]] = starts.T
    duration, steering, flying, periods = np.zeros(count), guidance.steering(count), np.arange(count), 0
    while len(flying) and duration.max() < mission.flight.longest:
        steered = steering.steer(states[[0, 2, 3]][:, flying].T, period, flying)
        states[:, flying] = runge_kutta_step(
            states[:, flying], steered.cone_angle, mission.sail.beta, steered.hold
        )
        duration[flying] += steered.hold
        periods += len(flying)
        flying = flying[~steered.arrived]
    return states[[0, 2, 3]].T, duration, periods


def _seconds(run: Callable[[], object], repeats: int = 3) -> float:
    """Processor time of the fastest of some runs: other work on the machine only adds."""
    times = []
    for _ in range(repeats):
        started = time.process_time()
        run()
        times.append(time.process_time() - started)
    return min(times)


class Idle:
    """A steering function in Python that is called once for 500 sails: what is left is the plant.

    Args:
        command: what every sail is told, always.
    """

    def __init__(self, **command: float) -> None:
        kind = plant().structures["plant_command_f64"]
        self._command = plant().filled("plant_command_f64", command)

        def steer(*given: int) -> None:
            count, commands, statuses = given[0], given[6], given[7]
            room = (ctypes.c_char * (count * kind.itemsize)).from_address(commands)
            np.frombuffer(room, kind)[:] = self._command
            ctypes.memset(statuses, 0, 4 * count)

        self._function = STEER(steer)

    def native(self) -> tuple[int, int, Precision]:
        """See :class:`sailnet.guidance.NativeSteering`."""
        return ctypes.cast(self._function, ctypes.c_void_p).value or 0, 0, "float64"

    def steer(
        self,
        states: ArrayLike,
        period: float,
        sails: NDArray[np.intp],
        attitudes: ArrayLike | None = None,
    ) -> Steered:
        """See :class:`sailnet.guidance.Steering`; the plant calls the native function instead."""
        raise NotImplementedError


def period_costs(mission: Mission, guidance: Guidance, seed: int) -> dict[str, object]:
    """Nanoseconds a guidance period of one sail, a batch of flights side by side on one core."""
    starts = random_starts(mission, BATCH, seed)
    ends, durations, periods = python_loop(mission, guidance, starts)
    flights = fly(mission, guidance, starts)
    in_c = _seconds(lambda: fly(mission, guidance, starts)) / int(flights.periods.sum())
    in_python = _seconds(lambda: python_loop(mission, guidance, starts)) / periods
    single = starts[:1]
    one = [_seconds(lambda: fly(mission, guidance, single))]
    one.append(_seconds(lambda: python_loop(mission, guidance, single)))
    steering, rows = guidance.steering(BATCH), np.arange(BATCH)
    alone = _seconds(lambda: [steering.steer(starts, mission.flight.period, rows) for _ in range(200)])
    idle = Idle(cone_angle=0.5, time_of_flight=1.0, beta=0.17, hold=mission.flight.period)

    def plant_alone(disturbance: Disturbance) -> float:
        given = rules(mission, disturbance, mission.flight.period, guidance.beta_range)
        run = _seconds(lambda: SideBySide(given, starts, 0, idle, np.zeros((len(starts), 3))).fly(500))
        return 1e9 * run / BATCH / 500

    return {
        "flight_in_C": 1e9 * in_c,
        "flight_in_Python": 1e9 * in_python,
        "times_faster": in_python / in_c,
        "one_flight_alone_times_faster": one[1] / one[0],
        "of_it_guidance": 1e9 * alone / BATCH / 200,
        "plant_alone": plant_alone(Disturbance()),
        "plant_with_everything": plant_alone(CAMPAIGNS["everything"]),
        "largest_difference_of_ends": float(abs(ends - flights.ends).max()),
        "largest_difference_of_times": float(abs(durations - flights.time_of_flight).max()),
    }


def campaign(
    mission: Mission, guidance: Guidance, flights: int, disturbance: Disturbance
) -> dict[str, object]:
    """A whole campaign on all cores, the start of the processes included."""

    def used() -> float:
        usages = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
        return sum(usage.ru_utime + usage.ru_stime for usage in usages)

    before, started = used(), time.perf_counter()
    with workers(os.cpu_count() or 1) as pool:
        flown = fly_random_starts(mission, guidance, flights, disturbance, workers=pool)
    wall = time.perf_counter() - started
    return {
        "flights": flights,
        "arrived": int(flown.arrived.sum()),
        "wall_seconds": wall,
        "cpu_seconds": used() - before,
        "million_periods": int(flown.periods.sum()) / 1e6,
    }


def measure(mission: Mission, flights: int, seed: int) -> dict[str, object]:
    """Both, for the shipped networks in double precision and the mission's own period."""
    guidance = load_guidance(mission, "c", "float64")
    whole = {
        f"campaign_{name}": campaign(mission, guidance, flights, disturbance)
        for name, disturbance in CAMPAIGNS.items()
    }
    return {**whole, **period_costs(mission, guidance, seed)}


def main() -> int:
    """Measure and print JSON."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.flights", description=__doc__)
    parser.add_argument("--flights", type=int, default=10_000, help="of a campaign (%(default)s)")
    parser.add_argument("--seed", type=int, default=2, help="of the starts (%(default)s)")
    options = parser.parse_args()
    result = measure(load_mission("earth_mars"), options.flights, options.seed)
    print(json.dumps({**result, "cores": os.cpu_count(), "software": software()}, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())

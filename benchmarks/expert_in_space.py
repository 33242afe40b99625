"""``python -m benchmarks.expert_in_space``: random states in three dimensions, solved on one core.

What was measured is written into ``benchmarks/IN_SPACE.md``.
"""

import argparse
import os
import sys
import time
from pathlib import Path

import numpy as np

from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.expert.fastest_in_space import solve, solve_states
from sailnet.expert.neighbours import solve_among
from sailnet.expert.optima import RESIDUAL_GOAL
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.arrays import Array

RESULTS = Path(__file__).parent / "IN_SPACE.md"

IMPROVED = 1e-6
"""A line's time of flight [TU] that a refined search lowers by so much was not the fastest."""


def measure(mission: Mission, states: int, lines: int, points: int, seed: int) -> dict[str, float]:
    """Solve ``states`` random states of the generalisation set, and states along lines through it.

    What is found along a line is looked for again from the extremals of each state's neighbours alone, and
    theirs, until none is faster. What that lowers had been missed.
    """
    problem, region = mission.problem, mission.generalisation.corners_in_space
    rng = np.random.default_rng(seed)
    starts = rng.uniform(*region, (states, 5))
    seconds = []
    for rows in (1, states):
        began = time.process_time()
        optima = solve_states(problem, starts[:rows], region)
        seconds.append(time.process_time() - began)
    began = time.process_time()
    solve(problem, mission.departure_state_in_space)
    alone = time.process_time() - began
    lowered, unsolved, largest = 0, 0, 0.0
    for _ in range(lines):
        on_line = _line(region, points, rng)
        found = solve_states(problem, on_line, region)
        refined = solve_among(problem, on_line, found)
        gain = np.nan_to_num(found.time_of_flight - refined.time_of_flight, nan=0.0)
        unsolved += int((~found.found).sum())
        lowered, largest = lowered + int((gain > IMPROVED).sum()), max(largest, float(gain.max()))
    return {
        "states": states,
        "seed": seed,
        "found": int((optima.residual <= RESIDUAL_GOAL).sum()),
        "largest_residual": float(np.nanmax(optima.residual)),
        "longest_time_of_flight": float(np.nanmax(optima.time_of_flight)),
        "with_a_fast_turn": int((optima.jumps[optima.found] > 0).sum()),
        "index_of_the_plane_and_compilation_seconds": seconds[0],
        "milliseconds_a_state": 1e3 * seconds[1] / states,
        "one_state_alone_seconds": alone,
        "lines": lines,
        "states_on_lines": lines * points,
        "of_them_unsolved": unsolved,
        "lowered_by_a_refined_search": lowered,
        "by_at_most": largest,
    }


def _line(region: tuple[Array, Array], points: int, rng: np.random.Generator) -> Array:
    one, other = rng.uniform(*region, (2, 5))
    return np.asarray(one + np.linspace(0.0, 1.0, points)[:, None] * (other - one))


def main() -> int:
    """Measure and write."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.expert_in_space", description=__doc__)
    parser.add_argument("--mission", default="earth_mars_3d", help="(%(default)s)")
    parser.add_argument("--states", type=int, default=10_000, help="(%(default)s)")
    parser.add_argument("--lines", type=int, default=20, help="through the generalisation set (%(default)s)")
    parser.add_argument("--points", type=int, default=101, help="states on a line (%(default)s)")
    parser.add_argument("--seed", type=int, default=2, help="of every random number (%(default)s)")
    parser.add_argument("--output", type=Path, default=RESULTS, help="(%(default)s)")
    options = parser.parse_args()
    mission = load_mission(options.mission)
    measured = measure(mission, options.states, options.lines, options.points, options.seed)
    origin = software()
    rows = [
        f"| {key.replace('_', ' ')} | {value:.4g} |"
        if isinstance(value, float)
        else f"| {key.replace('_', ' ')} | {value} |"
        for key, value in measured.items()
    ]
    text = [
        f"Written by `python -m benchmarks.expert_in_space` on {origin['machine']}, {os.cpu_count()} cores, "
        f"{origin['date']}, revision {origin['revision']}: random states of the generalisation set of "
        f"`{mission.name}`, on one core, in processor time. Other work on the machine makes it longer.",
        "",
        "| quantity | value |",
        "|---|---|",
        *rows,
    ]
    fill_block(options.output, "expert", "\n".join(text))
    print("\n".join(text))
    return 0


if __name__ == "__main__":
    sys.exit(main())

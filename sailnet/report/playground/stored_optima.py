"""What the page compares with: the expert's answers from every start that can be dragged to, computed once.

``python -m sailnet.report.playground.stored_optima`` writes them; it takes a quarter of an hour of one core.
Starts are a grid as fine as what a page can show, and from each the minimum time is the expert's own at
a few values of beta; between these a page interpolates the logarithm of the time over that of beta. Of the
sail as assumed the costates at the start are there too, from which the optimal trajectory follows.
"""

import argparse
import base64
import json
import sys
import zlib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.files import write_text
from sailnet.artefacts.provenance import software
from sailnet.expert.fastest import solve_states
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.arrays import Array
from sailnet.report.playground.module import FOLDER
from sailnet.workers.progress import progress

OPTIMA = FOLDER / "earth_mars.optima.json"
"""Those of ``earth_mars``."""

MISSING = 65535
"""Level of a time that the expert did not find."""


@dataclass(frozen=True)
class Axis:
    """Of a grid: hundredths from the first to the last, both of them on it."""

    first: int
    last: int

    @property
    def values(self) -> Array:
        """In AU or AU/TU."""
        return np.arange(self.first, self.last + 1) / 100.0


AXES = {"r": Axis(100, 115), "u": Axis(0, 20), "v": Axis(80, 120)}
"""The generalisation set of Section 5.3, and u up to where both of the paper's cases are within."""

SHARES = (0.8, 0.9, 1.0, 1.1, 1.2)
"""Values of beta over the mission's: what its networks have learnt."""


def starts(axes: dict[str, Axis] = AXES) -> Array:
    """(n, 3) r [AU], u, v [AU/TU] of the grid, v fastest."""
    grid = np.meshgrid(*(axis.values for axis in axes.values()), indexing="ij")
    return np.stack(grid, axis=-1).reshape(-1, 3)


def solve_grid(mission: Mission, axes: dict[str, Axis] = AXES, *, quiet: bool = False) -> dict[str, Any]:
    """Solve them all; returns what is stored."""
    states = starts(axes)
    region = (states.min(axis=0), states.max(axis=0))
    times = []
    costates = np.full((len(states), 3), np.nan)
    with progress(len(SHARES), "beta", "optima", quiet=quiet) as bar:
        for share in SHARES:
            sail = replace(mission.problem, beta=share * mission.problem.beta)
            optima = solve_states(sail, states, region)
            times.append(optima.time_of_flight)
            if share == 1.0:
                costates = optima.costates
            bar.update()
    shortest, step, levels = coded(np.array(times))
    size = np.linalg.norm(costates, axis=1, keepdims=True)
    return {
        "mission": mission.digest("sail", "transfer"),
        "made": software(),
        "axes": {name: [axis.first, axis.last] for name, axis in axes.items()},
        "shares": list(SHARES),
        "shortest": shortest,
        "step": step,
        "times": packed(levels),
        "costates": packed(np.nan_to_num(costates / size).astype("<f4")),
    }


def coded(times: Array) -> tuple[float, float, NDArray[np.uint16]]:
    """The shortest time [TU], the step of its logarithm and the levels above it; ``MISSING`` for NaN."""
    known = np.isfinite(times)
    shortest = float(f"{times[known].min():.9g}")
    step = float(f"{np.log(times[known].max() / shortest) / (MISSING - 1):.9g}")
    levels = np.full(times.shape, MISSING, np.uint16)
    levels[known] = np.clip(np.round(np.log(times[known] / shortest) / step), 0, MISSING - 1)
    return shortest, step, levels


def packed(numbers: NDArray[Any]) -> str:
    """Base64 of the deflated bytes, all first ones before all second ones and so on: they are alike."""
    planes = numbers.ravel().view(np.uint8).reshape(-1, numbers.itemsize).T
    return base64.b64encode(zlib.compress(planes.tobytes(), 9)).decode("ascii")


def main() -> int:
    """Solve, and write the file."""
    parser = argparse.ArgumentParser(
        prog="python -m sailnet.report.playground.stored_optima", description=__doc__
    )
    parser.add_argument("--output", type=Path, default=OPTIMA, metavar="FILE", help="(%(default)s)")
    options = parser.parse_args()
    text = json.dumps(solve_grid(load_mission("earth_mars")), separators=(",", ":"))
    write_text(options.output, text)
    print(f"{options.output}: {len(text)} bytes, {len(starts())} starts, {len(SHARES)} values of beta")
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""What a data set holds, and whether it holds what it promises."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

from sailnet.dataset import (
    CROSSING_FLAG,
    JUMP_FLAG,
    NEGATIVE_ARRIVAL_FLAG,
    Dataset,
    open_dataset,
)
from sailnet.errors import DatasetError
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import attitude, force_costates, target_of
from sailnet.physics.pontryagin import evaluate_hamiltonian, guidance_law, hamiltonian_bound

ORIGIN = ("recipe", "tolerance", "sailnet", "revision", "heyoka", "numpy", "date")
"""What a data set must say about its origin."""

CHOSEN = 500
"""Trajectories, at random, whose Hamiltonian and commands are computed again."""

ROUNDING = 1e-9
"""By how much a value may miss what the same formula gives on another processor."""


def inspect_dataset(path: Path, bar: "tqdm[Any] | None" = None) -> dict[str, object]:
    """Verify everything that can be verified of a data set, and summarise it.

    Checked are the schema, all checksums, the origin, that every value is finite and in its range,
    that each trajectory begins on the target orbit at tau = 0 with tau rising from there, and for a
    random subset that the commands are the law's and that H stays at zero.

    Args:
        path: the file.
        bar: advanced by the number of values read, if given.

    Raises:
        DatasetError: the file is damaged, or its content is not what the schema promises.
    """
    with open_dataset(path) as data:
        absent = [name for name in ORIGIN if name not in data.provenance]
        if absent:
            raise DatasetError(f"{path} does not say where it comes from: {', '.join(absent)} is missing")
        for name in ORIGIN:
            if not isinstance(said := data.provenance[name], str | float):
                raise DatasetError(f"{path} does not say where it comes from: {name} is {said!r:.40}")
        if not data.trajectories:
            raise DatasetError(f"{path} holds no trajectory; generate it again")
        if bar is not None:
            groups = data.layout.groups
            values = len(groups["samples"]) * data.samples + len(groups["trajectories"]) * data.trajectories
            bar.reset(values)
        check = _Check(path, data, bar)
        data.verify(check.see)
        flags = check.flags()
        hamiltonian = _hamiltonian(path, data)
        return {
            "mission": f"{data.mission.name}: {data.mission.title}",
            "recipe": data.provenance["recipe"],
            "trajectories": data.trajectories,
            "samples": data.samples,
            "jump_share": float(np.mean((flags & JUMP_FLAG) > 0)),
            "negative_arrival_share": float(np.mean((flags & NEGATIVE_ARRIVAL_FLAG) > 0)),
            "crossing_share": float(np.mean((flags & CROSSING_FLAG) > 0)),
            "largest_hamiltonian": hamiltonian,
            "ranges": check.ranges,
            "software": {name: data.provenance[name] for name in ORIGIN[2:-1]},
            "date": data.provenance["date"],
            "digest": data.digest,
        }


class _Check:
    """Looks at every value once, while the checksums are computed."""

    def __init__(self, path: Path, data: Dataset, bar: "tqdm[Any] | None") -> None:
        self.ranges: dict[str, list[float]] = {}
        self._path, self._data, self._bar = path, data, bar
        self._target = dict(zip(data.states, target_of(data.mission.problem, len(data.states)), strict=True))
        self._last_tau = np.nan

    def see(self, key: str, start: int, values: NDArray[Any]) -> None:
        """Check some consecutive values of a column."""
        group, name = key.split("/")
        finite = np.isfinite(values)
        if name != "jump_time":
            self._require(key, start, finite, values, "is not finite")
        if finite.any():
            low, high = float(values[finite].min()), float(values[finite].max())
            known = self.ranges.get(key, [low, high])
            self.ranges[key] = [min(low, known[0]), max(high, known[1])]
        if group == "samples":
            self._sample(name, key, start, values)
        elif name == "first_sample":
            rising = np.diff(self._data.first_sample[start : start + len(values) + 1]) > 0
            self._require(key, start, rising, values, "leaves its trajectory without samples")
        if self._bar is not None:
            self._bar.update(len(values))

    def _sample(self, name: str, key: str, start: int, values: NDArray[Any]) -> None:
        first, problem = self._data.first_sample, self._data.mission.problem
        at = slice(*np.searchsorted(first[:-1], [start, start + len(values)]))
        begins = np.zeros(len(values), bool)
        begins[first[at] - start] = True
        if name == "r":
            self._require(key, start, values > 0.0, values, "is not positive")
        if name in ("alpha", "alpha_pre"):
            inside = np.abs(values) <= problem.phi_max
            self._require(key, start, inside, values, f"is beyond the bound {problem.phi_max:.6f}")
        if name == "alpha" and self._data.mission.inclined:
            self._require(
                key, start, values >= 0.0, values, "is negative, which the clock angle makes needless"
            )
        if name == "clock_angle":
            self._require(key, start, np.abs(values) <= np.pi, values, "is not between -pi and pi")
        if name in self._target:
            target = self._target[name]
            arrives = ~begins | (np.abs(values - target) <= ROUNDING)
            self._require(
                key, start, arrives, values, f"is not on the target orbit, where it is {target:.6f}"
            )
        if name == "beta":
            self._require(key, start, values > 0.0, values, "is not positive")
        if name == "tau":
            rises = np.diff(values, prepend=self._last_tau) > 0.0
            self._require(key, start, np.where(begins, values == 0.0, rises), values, "does not rise from 0")
            self._last_tau = values[-1]
        if name == "trajectory":
            rows = np.arange(start, start + len(values))
            belongs = values == np.searchsorted(first, rows, side="right") - 1
            self._require(key, start, belongs, values, "is not the trajectory that owns the row")

    def flags(self) -> NDArray[np.int64]:
        """Flags of each trajectory, which must agree with its other columns."""
        rows = self._data.read_trajectories(["flags", "jump_time", "lambda_v0"])
        flags = rows["flags"].astype(int)
        expected = JUMP_FLAG * np.isfinite(rows["jump_time"]) + NEGATIVE_ARRIVAL_FLAG * (
            rows["lambda_v0"] > 0
        )
        agree = (flags & ~CROSSING_FLAG) == expected
        self._require("trajectories/flags", 0, agree, flags, "contradicts jump_time or lambda_v0")
        return flags

    def _require(
        self, key: str, start: int, good: NDArray[np.bool_], values: NDArray[Any], said: str
    ) -> None:
        if not good.all():
            row = int(np.argmin(good))
            raise DatasetError(
                f"{self._path} is no data set of optimal trajectories: {key} of row {start + row}, "
                f"{values[row]}, {said}; generate it again"
            )


def _hamiltonian(path: Path, data: Dataset) -> float:
    """Largest |H| along some trajectories, after making sure that it is small enough."""
    rows = np.random.default_rng(0).permutation(data.trajectories)[:CHOSEN]
    largest = 0.0
    for row in np.sort(rows):
        first, after = data.first_sample[row : row + 2]
        columns = data.read(
            [n for n in data.layout.groups["samples"] if n != "trajectory"], int(first), int(after)
        )
        states, costates = (
            np.column_stack([columns[prefix + x] for x in data.states]) for prefix in ("", "lambda_")
        )
        alpha, beta = columns["alpha"], columns["beta"]
        if np.ptp(beta) > 0.0:
            raise DatasetError(f"{path}: beta changes along trajectory {row}; generate it again")
        problem = replace(data.mission.problem, beta=float(beta[0]))
        law = guidance_law(problem, *force_costates(costates))
        if np.abs(_told(columns) - _optimal(costates, law)).max() > ROUNDING or (
            "alpha_pre" in columns and np.any(np.abs(columns["alpha_pre"]) != np.abs(alpha))
        ):
            raise DatasetError(
                f"{path}: the commands of trajectory {row} are not the law's; generate it again"
            )
        size = np.abs(evaluate_hamiltonian(problem, states, costates, alpha)).max()
        if size > (bound := hamiltonian_bound(problem, states, costates)):
            raise DatasetError(
                f"{path}: along trajectory {row} |H| reaches {size:.3g}, optimal ones stay below "
                f"{bound:.3g}; generate it again"
            )
        largest = max(largest, float(size))
    return largest


def _told(columns: Mapping[str, Array]) -> Array:
    """(m, 2) cone and, in space, clock angle that are stored."""
    alpha = columns["alpha"]
    return np.column_stack([alpha, columns.get("clock_angle", np.zeros_like(alpha))])


def _optimal(costates: Array, law: Array) -> Array:
    """(m, 2) those of the law."""
    angles = (law, np.zeros_like(law)) if costates.shape[1] == 3 else attitude(costates, law)
    return np.column_stack(angles)

"""Known plans: optimal extremals from states at which the networks' plan leads nowhere.

Near an edge along which two families of extremals are as fast, the direction of the arrival costates jumps,
which smooth networks blur. A few samples of the data set do not: where no plan is flown and that of the
networks does not converge, the tracker tries those from states near by (docs/tracking.md).
"""

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from sailnet.artefacts.untrusted import table_of
from sailnet.errors import MissionError, NetworkError
from sailnet.mission.mission import Mission
from sailnet.mission.stored import stored_mission
from sailnet.networks.stored_tensors import Kind, read_tensors, write_tensors
from sailnet.physics.arrays import Array

FILE = "known_plans.safetensors"
"""Its name in a folder of networks."""

MOST_PLANS = 4096
"""Of a table: the flight file has it as constants."""


@dataclass(frozen=True)
class KnownPlans:
    """Optimal extremals of a mission, each of a vehicle of the mission's optics.

    Attributes:
        states: (n, 3) rows r [AU], u, v [AU/TU], or (n, 5) r, latitude [rad], u, v, w.
        shares: (n,) normalised characteristic accelerations, relative to the mission's.
        directions: (n, 3) or (n, 5) unit vectors along the arrival costates.
        tau: (n,) times to go [TU].
        mission: that they are of.
        provenance: data set, seed and whatever else is recorded.
    """

    states: Array
    shares: Array
    directions: Array
    tau: Array
    mission: Mission
    provenance: Mapping[str, object]

    def __post_init__(self) -> None:
        # In double precision no number is other than in single, in which they fly.
        for name in ("states", "shares", "directions", "tau"):
            object.__setattr__(self, name, np.asarray(getattr(self, name), np.float32).astype(float))
        count, components = len(self.tau), self.mission.components
        shapes = self.states.shape, self.directions.shape, self.shares.shape
        if not 0 < count <= MOST_PLANS or shapes != ((count, components),) * 2 + ((count,),):
            raise NetworkError(f"these are no known plans of mission {self.mission.name}: shapes {shapes}")
        sizes = np.linalg.norm(self.directions, axis=1)
        good = np.isfinite(self.rows).all() and (self.rows[:, [components, -1]] > 0.0).all()
        if not good or (abs(sizes - 1.0) > 1e-5).any():
            raise NetworkError("known plans are not finite, or their directions no unit vectors")

    def __len__(self) -> int:
        return len(self.tau)

    @property
    def rows(self) -> Array:
        """(n, 2 k + 2) of each the state, the share, the direction and the time to go."""
        return np.column_stack([self.states, self.shares, self.directions, self.tau])


def _faults(stored: Any) -> Iterator[str]:
    names = sorted(stored.keys())
    if names != ["plans"]:
        yield f"its tensors are {', '.join(names):.200}"
        return
    entry = stored.get_slice("plans")
    shape = tuple(entry.get_shape())
    if (
        entry.get_dtype() != "F32"
        or len(shape) != 2
        or shape[1] not in (8, 12)
        or not 0 < shape[0] <= MOST_PLANS
    ):
        yield f"its plans are {entry.get_dtype()} of the shape {shape}"


KIND = Kind(
    "table of known plans",
    "sailnet-known-plans/1",
    ("mission", "provenance"),
    _faults,
    "choose them again (python -m training.known_plans) or copy the file again",
)


def save_known_plans(plans: KnownPlans, folder: Path) -> None:
    """Write ``known_plans.safetensors``; it appears whole or not at all.

    Raises:
        NetworkError: it cannot be written (full disk, no permission).
    """
    provenance = json.dumps(dict(plans.provenance), sort_keys=True)
    texts = {"mission": plans.mission.to_json(), "provenance": provenance}
    write_tensors(KIND, folder / FILE, {"plans": plans.rows.astype("<f4")}, texts)


def load_known_plans(folder: Path, mission: Mission) -> KnownPlans | None:
    """Read the known plans in a folder of networks, if there are any.

    Args:
        folder: of a mission's networks.
        mission: that they must belong to.

    Raises:
        NetworkError: the file is damaged, or of another mission.
    """
    path = folder / FILE
    if not path.exists():
        return None
    tensors, metadata = read_tensors(KIND, path)
    try:
        of = stored_mission(metadata["mission"], str(path))
        provenance = table_of(metadata["provenance"])
    except (ValueError, MissionError) as error:
        raise NetworkError(f"{path} is not a complete {KIND.name}: {error}") from error
    if of.digest() != mission.digest():
        raise NetworkError(
            f"the known plans in {folder} are of mission {of.name!r} with other parameters than mission "
            f"{mission.name!r}"
        )
    rows, components = tensors["plans"].astype(float), mission.components
    if rows.shape[1] != 2 * components + 2:
        raise NetworkError(f"{path} is not a complete {KIND.name}: its rows have {rows.shape[1]} numbers")
    states, shares, directions, tau = np.split(rows, [components, components + 1, 2 * components + 1], axis=1)
    return KnownPlans(states, shares[:, 0], directions, tau[:, 0], of, provenance)

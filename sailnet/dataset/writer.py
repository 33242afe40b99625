"""Writing a data set: blocks of trajectories stream into a file that appears whole or not at all."""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.column_writing import write_columns
from sailnet.dataset.block import Block
from sailnet.dataset.schema import ALONE, layout_of
from sailnet.mission.mission import Mission


def write_dataset(
    path: Path,
    mission: Mission,
    blocks: Iterator[Block],
    provenance: Mapping[str, object],
    scratch: Path | None = None,
) -> None:
    """Stream blocks of trajectories into a new file.

    Args:
        path: where to; an existing file is replaced once the new one is complete.
        mission: the mission the samples belong to, stored whole.
        blocks: trajectories in order; memory holds one block at a time.
        provenance: seed, tolerances, versions: whatever tells where the samples come from.
        scratch: folder of the same file system for the unfinished file; beside ``path`` by default.

    Raises:
        DatasetError: the file cannot be written (full disk, no permission).
    """
    write_columns(
        path, layout_of(mission), _flattened(blocks), {"mission": mission.to_json()}, provenance, scratch
    )


def _flattened(blocks: Iterator[Block]) -> Iterator[dict[str, NDArray[Any]]]:
    """Columns of whole trajectories, by group and name, with the links between the two groups."""
    trajectories = samples = 0
    for block in blocks:
        rows = np.arange(trajectories, trajectories + len(block.lengths))
        values: dict[str, NDArray[Any]] = {f"samples/{k}": v for k, v in block.samples.items()}
        values.setdefault("trajectories/family", np.full(len(block.lengths), ALONE))
        values["samples/trajectory"] = np.repeat(rows, block.lengths)
        values |= {f"trajectories/{k}": v for k, v in block.trajectories.items()}
        values["trajectories/first_sample"] = samples + np.cumsum(block.lengths) - block.lengths
        yield values
        trajectories, samples = trajectories + len(block.lengths), samples + int(block.lengths.sum())

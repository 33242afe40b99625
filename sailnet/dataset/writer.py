"""Writing a data set: blocks of trajectories stream into a file that appears whole or not at all."""

import hashlib
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.files import write_whole
from sailnet.dataset.block import Block
from sailnet.dataset.schema import (
    GROUPS,
    SCHEMA,
    append,
    column_type,
    content_digest,
    create_columns,
    put_text,
    text_digest,
)
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission

CHUNK = {"samples": 16_384, "trajectories": 4_096}
"""Rows of a chunk."""


def write_dataset(
    path: Path,
    mission: Mission,
    blocks: Iterator[Block],
    provenance: Mapping[str, object],
    scratch: Path | None = None,
) -> None:
    """Stream blocks of trajectories into a new file, which appears whole or not at all.

    Args:
        path: where to; an existing file is replaced once the new one is complete.
        mission: the mission the samples belong to, stored whole.
        blocks: trajectories in order; memory holds one block at a time.
        provenance: seed, tolerances, versions: whatever tells where the samples come from.
        scratch: folder of the same file system for the unfinished file; beside ``path`` by default.

    Raises:
        DatasetError: the file cannot be written (full disk, no permission).
    """

    def write(beside: Path) -> None:
        # v110: only since this version of the format does every piece of metadata carry a checksum;
        # without one HDF5 can crash or hang on a single flipped bit. No chunk cache: rows go straight
        # to the file, without another copy.
        with h5py.File(beside, "w", libver="v110", rdcc_nbytes=0) as file:
            columns = create_columns(file, GROUPS, column_type, CHUNK)
            digests = {key: hashlib.sha256() for key in columns}
            trajectories = samples = 0
            for block in blocks:
                for key, values in _flatten(block, trajectories, samples).items():
                    append(columns[key], values)
                    digests[key].update(values.data)
                trajectories, samples = trajectories + len(block.lengths), samples + int(block.lengths.sum())
            for key, column in columns.items():
                put_text(column, sha256=digests[key].hexdigest())
            origin = json.dumps(dict(provenance), sort_keys=True)
            put_text(file, schema=SCHEMA, mission=mission.to_json(), provenance=origin)
            file.attrs["trajectories"], file.attrs["samples"] = trajectories, samples
            put_text(file, sha256=content_digest(file), provenance_sha256=text_digest(origin))

    try:
        write_whole(path, write, scratch)
    except (OSError, RuntimeError) as error:  # h5py raises either when HDF5 cannot write
        raise DatasetError(f"cannot write data set {path}: {error}") from error


def _flatten(block: Block, first_trajectory: int, first_sample: int) -> dict[str, NDArray[Any]]:
    rows = np.arange(first_trajectory, first_trajectory + len(block.lengths), dtype=column_type("trajectory"))
    values: dict[str, NDArray[Any]] = {f"samples/{k}": v for k, v in block.samples.items()}
    values["samples/trajectory"] = np.repeat(rows, block.lengths)
    values |= {f"trajectories/{k}": v for k, v in block.trajectories.items()}
    values["trajectories/first_sample"] = first_sample + np.cumsum(block.lengths) - block.lengths
    return {
        key: np.ascontiguousarray(value, dtype=column_type(key.split("/")[1]))
        for key, value in values.items()
    }

"""The data set: the only place that knows how optimal samples are stored.

Layout (see ``data/README.md``): one chunked, checksummed one-dimensional array per quantity in
``/samples`` and ``/trajectories`` of an HDF5 file, readable from any language; what it is and where
it came from in the root attributes.
"""

from sailnet.dataset.block import Block
from sailnet.dataset.reader import Dataset, open_dataset
from sailnet.dataset.schema import (
    ALONE,
    CROSSING_FLAG,
    INTEGER,
    JUMP_FLAG,
    NEGATIVE_ARRIVAL_FLAG,
    SAMPLES,
    SCHEMA,
    TRAJECTORIES,
    layout_of,
)
from sailnet.dataset.writer import write_dataset

__all__ = [
    "ALONE",
    "CROSSING_FLAG",
    "INTEGER",
    "JUMP_FLAG",
    "NEGATIVE_ARRIVAL_FLAG",
    "SAMPLES",
    "SCHEMA",
    "TRAJECTORIES",
    "Block",
    "Dataset",
    "layout_of",
    "open_dataset",
    "write_dataset",
]

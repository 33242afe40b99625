"""What is looked at of a file of columns before any of its values is read: a stranger may have made it."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np

if TYPE_CHECKING:
    from sailnet.artefacts.column_files import Layout

MOST_OF_A_CHUNK = 1 << 22
"""Bytes of a chunk, which is unpacked as a whole."""

MOST_UNPACKED = (1 << 26, 100)
"""Bytes that compressed columns may hold together, and for each byte of the file so many more."""

_FILTERS = {h5py.h5z.FILTER_DEFLATE, h5py.h5z.FILTER_SHUFFLE}


def faults(file: Any, layout: "Layout", size: int) -> Iterator[str]:
    """Where an open HDF5 file differs from its layout, in words; nothing where it holds just that.

    Columns lie in the file itself, under the types of the layout, in one dimension, as long as those beside
    them, and take no more memory than a file of this size can need.

    Args:
        file: as h5py opened it.
        layout: what it should hold.
        size: of the file, in bytes.
    """
    stored = unpacked = 0
    for group, names in layout.groups.items():
        rows: int | None = None
        if not _is(file, group, h5py.Group):
            yield f"{group} is no group of its own"
            return
        for name in names:
            if not _is(file[group], name, h5py.Dataset):
                yield f"{group}/{name} is no column of its own"
                return
            column = file[group][name]
            if fault := _fault(column, layout.type_of(name), compressed=layout.small):
                yield f"{group}/{name} {fault}"
                return
            rows = len(column) if rows is None else rows
            if len(column) != rows:
                yield f"{group}/{name} has {len(column)} rows, the columns beside it {rows}"
            stored += column.id.get_storage_size()
            unpacked += column.nbytes
    most, times = MOST_UNPACKED
    if stored > size or unpacked > (most + times * size if layout.small else size):
        yield f"its columns say that they hold {unpacked} bytes, in a file of {size}"


def lacks(file: Any, key: str) -> bool:
    """Whether nothing lies at ``group/name`` of an open HDF5 file, not even a link to elsewhere."""
    group, _, name = key.partition("/")
    return _is(file, group, h5py.Group) and file[group].get(name, getlink=True) is None


def _is(place: Any, name: str, kind: type) -> bool:
    """Whether this lies here, and is no link to elsewhere, which is not even followed."""
    link = place.get(name, getlink=True)
    return isinstance(link, h5py.HardLink) and place.get(name, getclass=True) is kind


def _fault(column: Any, wanted: np.dtype[Any], *, compressed: bool) -> str:
    plan = column.id.get_create_plist()
    filters = {plan.get_filter(i)[0] for i in range(plan.get_nfilters())}
    if not column.id.get_type().equal(h5py.h5t.py_create(wanted)):
        return f"is of another type than {wanted}"
    if column.ndim != 1:
        return f"has the shape {column.shape}, not one dimension"
    if column.is_virtual or column.external:
        return "is stored outside the file"
    if column.chunks is None:
        return "is not stored in chunks"
    if column.chunks[0] * wanted.itemsize > MOST_OF_A_CHUNK:
        return f"is stored in chunks of {column.chunks[0]} rows"
    if filters - (_FILTERS if compressed else set()):
        return "is stored packed in a way that sailnet does not use"
    if column.id.get_num_chunks() * column.chunks[0] < len(column):
        return f"says it has {len(column)} rows, and does not hold them"
    return ""

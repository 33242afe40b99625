"""Flights inside a page: thousands of them, rounded and compressed; the page unpacks those it opens.

Every column is rounded to levels between its smallest and largest value, and the levels' differences are
deflated, some flights together. A page draws a few hundred points on a few hundred pixels: what is rounded
away is not seen, and the results file has every digit.
"""

import base64
import json
import struct
import zlib
from collections.abc import Iterable, Iterator, Mapping
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.physics.arrays import Array
from sailnet.report.charts import page_columns

TOGETHER = 20
"""Flights that are deflated together: names and repeated numbers cost little then."""

FINEST = 65534
"""Levels of a column at most; one more stands for no number."""

Flight = tuple[Mapping[str, Any], Mapping[str, Array]]
"""What a page says of a flight, as JSON, and the columns that it draws."""


def compress_flights(flights: Iterable[Flight], levels: int) -> Iterator[str]:
    """Texts of up to ``TOGETHER`` flights each.

    A text is base64 of a deflated block: the length of the header as a little-endian 32-bit number, the
    header, and the levels. The header is a JSON list of flights, each with what is said of it and its
    ``columns``: [name, length, smallest value, step, whether these are of the decimal logarithm], or
    [name, values] where there are few. The levels of a column are ``length`` differences modulo 2^16, all
    low bytes before all high ones; level 65535 is no number.

    Args:
        flights: in order.
        levels: of a column; times, among which the last are near to each other, have ``FINEST``.
    """
    source = iter(flights)
    while block := list(islice(source, TOGETHER)):
        header, body = [], []
        for about, columns in block:
            described: list[list[Any]] = []
            for name, values in columns.items():
                if len(values) <= 2:
                    described.append([name, page_columns({name: values})[name]])
                    continue
                logarithmic = name.startswith("off_")
                scaled = np.log10(values) if logarithmic else values
                steps = FINEST if name.endswith("time") else levels
                low, step, coded = _levels(scaled, steps)
                described.append([name, len(values), low, step, int(logarithmic)])
                body.append(coded)
            header.append({**about, "columns": described})
        text = json.dumps(header, ensure_ascii=False, separators=(",", ":"), allow_nan=False).encode()
        content = struct.pack("<I", len(text)) + text + b"".join(body)
        yield base64.b64encode(zlib.compress(content, 9)).decode("ascii")


def _levels(values: Array, levels: int) -> tuple[float, float, bytes]:
    known = np.isfinite(values)
    low, high = (values[known].min(), values[known].max()) if known.any() else (0.0, 0.0)
    step = float(f"{(high - low) / levels:.9g}") or 1.0
    level = np.full(len(values), FINEST + 1, np.int64)
    level[known] = np.clip(np.round((values[known] - low) / step), 0, levels)
    change: NDArray[np.uint16] = np.diff(level, prepend=0).astype(np.uint16)
    planes = change.astype("<u2").view(np.uint8).reshape(-1, 2).T
    return float(f"{low:.9g}"), step, planes.tobytes()

"""The bound on the cone angle in a chart: dashed, on both sides of zero where the angle has a sign."""

import numpy as np

from sailnet.physics.arrays import Array
from sailnet.report.charts import GREY, Curve

BOUNDS = tuple(
    Curve("span", f"bound_{side}", "", colour=GREY, dash=True, width=1.0) for side in ("high", "low")
)
"""Its curves; of angles without a sign there is no lower one."""


def bound_columns(bound: float, begin: float, end: float, *, signed: bool) -> dict[str, Array]:
    """What :data:`BOUNDS` show.

    Args:
        bound: size of the cone angle at most [deg].
        begin: time from which it is drawn [TU].
        end: until when.
        signed: whether the cone angle has a sign, as in the plane.
    """
    columns = {"span": np.array([begin, end]), "bound_high": np.full(2, bound)}
    return columns | ({"bound_low": np.full(2, -bound)} if signed else {})

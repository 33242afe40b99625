"""What a view of an optimal-control problem is: units, names of axes, a path through space."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from sailnet.ocp.definition.solution import Solution
from sailnet.physics.arrays import Array

Columns = dict[str, Array]

Rows = NDArray[np.intp]
"""Points of a solution that are drawn."""

NONE = "–"
"""Batch of what has no dimension."""


@dataclass(frozen=True)
class Group:
    """States or controls of one kind, which share a chart.

    Attributes:
        title: of the chart.
        unit: in which they are shown.
        labels: name in the problem -> name in the legend.
        scale: one unit of the problem, in the unit shown.
    """

    title: str
    unit: str
    labels: Mapping[str, str]
    scale: float = 1.0


@dataclass(frozen=True)
class Plane:
    """A path in a plane.

    Attributes:
        title: of the chart.
        x, y: names of states.
        x_label, y_label: of the axes, without units.
    """

    title: str
    x: str
    y: str
    x_label: str
    y_label: str


Motion = Callable[[Solution], Array]
"""(m, 6) positions and velocities, where gravity pulls to the origin with a parameter of 1."""


@dataclass(frozen=True)
class View:
    """How a problem is shown.

    Attributes:
        title: of the problem.
        states, controls: all of them, in charts.
        cost: what the cost is, its unit, and one unit of the problem's cost in that; what is maximised
            has a negative one.
        time_unit, time_scale: of the time.
        planes: paths of states.
        motion: around a body, which is then drawn with the orbits of departure and arrival.
        body: its name.
        length_unit, length_scale: of the motion.
        flat: whether it stays in a plane.
        throttle: the control that is at least half up where the path is drawn as burning.
        coasting: what the path is called elsewhere.
    """

    title: str
    states: Sequence[Group]
    controls: Sequence[Group]
    cost: tuple[str, str, float] = ("J", NONE, 1.0)
    time_unit: str = NONE
    time_scale: float = 1.0
    planes: Sequence[Plane] = field(default_factory=tuple)
    motion: Motion | None = None
    body: str = ""
    length_unit: str = "AU"
    length_scale: float = 1.0
    flat: bool = False
    throttle: str = ""
    coasting: str = "coast"


def labelled(quantity: str, unit: str) -> str:
    """The label of an axis."""
    return f"{quantity} [{unit}]"


def slug(text: str) -> str:
    """A name for files and for links."""
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")

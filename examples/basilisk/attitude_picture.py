"""A picture of a flight with attitude dynamics."""

from pathlib import Path

import matplotlib as mpl
import numpy as np
from attitude_flight import LOOK, STEPS, AttitudeFlight
from matplotlib.axes import Axes
from sailcraft import WHEEL_MOMENTUM

from sailnet.physics.units import DAY, HOUR, TU

mpl.use("Agg")
from matplotlib import pyplot as plt

LOOKS = STEPS // LOOK
"""In a guidance period, of which the whole flight's half shows the extremes."""

DEPARTURE = 6.0
"""Hours of the left half."""


def draw(flight: AttitudeFlight, period: float, path: Path) -> None:
    """Cone angle, attitude error, momenta and trim mass; ``period`` is the guidance's [TU]."""
    figure, rows = plt.subplots(
        4, 2, figsize=(10.0, 9.0), sharex="col", sharey="row", width_ratios=[1.0, 2.5]
    )
    hours = np.arange(flight.commands.size + 1) * period * TU / HOUR
    commands = np.degrees(np.append(flight.commands, flight.commands[-1]))
    for axes, scale in zip(rows[0], (1.0, DAY / HOUR), strict=True):
        axes.step(hours / scale, commands, where="post", color="C0", lw=1.0)
    seen = flight.seen
    _both(rows[1], seen[:, 0], np.degrees(seen[:, 1]), "C3", None)
    for column, axis in enumerate("xyz"):
        _both(rows[2], seen[:, 0], seen[:, 2 + column], f"C{column}", f"about {axis}")
    for column, axis in enumerate("yz"):
        _both(rows[3], seen[:, 0], seen[:, 5 + column], f"C{1 + column}", f"along {axis}")
    names = (
        "cone angle\ncommanded [deg]",
        "attitude error\n[deg]",
        "wheels [N m s]",
        "centre of mass\nshifted [m]",
    )
    for (left, right), name in zip(rows, names, strict=True):
        left.set_ylabel(name)
        left.set_xlim(-0.1, DEPARTURE)
        left.grid(alpha=0.3)
        right.grid(alpha=0.3)
    rows[1][0].set_yscale("log")
    rows[1][0].set_ylim(bottom=1e-4)
    for axes in rows[2]:
        for bound in (-WHEEL_MOMENTUM, WHEEL_MOMENTUM):
            axes.axhline(bound, color="0.5", ls="--", lw=0.8)
    rows[2][1].legend(loc="upper right", ncols=3)
    rows[3][1].legend(loc="center right", ncols=2)
    rows[3][0].set_xlabel("hours since departure")
    rows[3][1].set_xlabel("days since departure; extremes in 7 h")
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    plt.close(figure)


def _both(
    halves: tuple[Axes, Axes], seconds: np.ndarray, values: np.ndarray, color: str, label: str | None
) -> None:
    """All of the beginning, and least and largest in each guidance period of the whole."""
    left, right = halves
    early = seconds <= DEPARTURE * HOUR
    left.plot(seconds[early] / HOUR, values[early], color=color, lw=1.0)
    whole = values.size // LOOKS * LOOKS
    parts = values[:whole].reshape(-1, LOOKS)
    days = seconds[:whole:LOOKS] / DAY
    # A slew is far narrower than a dot of the picture: its line has a width.
    right.fill_between(days, parts.min(axis=1), parts.max(axis=1), color=color, alpha=0.4, lw=1.2)
    right.plot(days, parts[:, -1], color=color, lw=0.8, label=label)

"""The report's pictures, drawn with matplotlib."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from scipy.integrate import cumulative_simpson

from sailnet.flight.closed_loop import Flights, History
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array

NETWORK, OPTIMUM, BASELINE, GREY, BAD = "#0b6e99", "#e07a1f", "#8a6bbf", "#8c8c8c", "#c0392b"

STYLE: Any = {
    "font.size": 10,
    "font.family": "sans-serif",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e6e6e6",
    "axes.axisbelow": True,
    "svg.fonttype": "path",
    "svg.hashsalt": "sailnet",
}


@dataclass(frozen=True)
class Optimum:
    """An extremal from departure to arrival: time [TU] and the columns of ``expert.sample``."""

    time: Array
    columns: Array

    @property
    def angle(self) -> Array:
        """Heliocentric angle from departure [rad]."""
        rate = self.columns[:, 2] / self.columns[:, 0]
        return np.asarray(cumulative_simpson(rate, x=self.time, initial=0.0))


def to_svg(figure: Figure) -> str:
    """The figure as an <svg> element."""
    stream = StringIO()
    with mpl.rc_context(STYLE):
        for legend in (*figure.legends, *(ax.get_legend() for ax in figure.axes)):
            if legend is not None:
                legend.set_frame_on(False)
        figure.savefig(stream, format="svg", bbox_inches="tight", metadata={"Date": None})
    text = stream.getvalue()
    return text[text.index("<svg") :]


def _figure(columns: int, width: float = 9.0, height: float = 3.8) -> tuple[Figure, list[Axes]]:
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(width, height), layout="constrained")
        axes = figure.subplots(1, columns, squeeze=False)[0]
        return figure, list(axes)


def trajectories(mission: Mission, flights: Mapping[str, tuple[History, Optimum | None]]) -> Figure:
    """Heliocentric paths: flown and optimal, between departure and target orbit (Figs 9 and 11)."""
    figure, axes = _figure(len(flights), 4.5 * len(flights), 4.6)
    circle = np.linspace(0.0, 2.0 * np.pi, 361)
    for ax, (title, (flown, optimum)) in zip(axes, flights.items(), strict=True):
        for radius, label in (
            (mission.transfer.departure_radius, "departure orbit"),
            (mission.transfer.target_radius, "target orbit"),
        ):
            style = "-" if label == "target orbit" else ":"
            ax.plot(radius * np.cos(circle), radius * np.sin(circle), style, color=GREY, lw=1, label=label)
        if optimum is not None:
            r, angle = optimum.columns[:, 0], optimum.angle
            ax.plot(r * np.cos(angle), r * np.sin(angle), color=OPTIMUM, lw=3.5, alpha=0.6, label="optimum")
        r, angle = flown.states[:, 0], flown.states[:, 1]
        ax.plot(r * np.cos(angle), r * np.sin(angle), color=NETWORK, lw=1.4, label="networks in C")
        ax.plot(r[0] * np.cos(angle[0]), r[0] * np.sin(angle[0]), "o", color=NETWORK, ms=5)
        ax.plot(r[-1] * np.cos(angle[-1]), r[-1] * np.sin(angle[-1]), "s", color=NETWORK, ms=5)
        ax.plot(0.0, 0.0, "o", color="#f2b705", ms=9)
        ax.set(title=title, aspect="equal", xlabel="X [AU]", ylabel="Y [AU]")
    axes[0].legend(loc="upper left", fontsize=8, bbox_to_anchor=(0.0, -0.16), ncols=2)
    return figure


def commands(
    mission: Mission, flights: Mapping[str, tuple[History, History | None, Optimum | None]]
) -> Figure:
    """Commanded cone angle against the optimum (Figs 8c, 8d and 10); None leaves a curve out."""
    figure, axes = _figure(len(flights))
    bound = mission.sail.max_cone_angle
    for ax, (title, (flown, baseline, optimum)) in zip(axes, flights.items(), strict=True):
        for side in (-bound, bound):
            ax.axhline(side, color=GREY, lw=0.8, ls="--")
        if optimum is not None:
            ax.plot(
                optimum.time,
                np.degrees(optimum.columns[:, 6]),
                color=OPTIMUM,
                lw=3.5,
                alpha=0.6,
                label="indirect optimum",
            )
        if baseline is not None:
            ax.plot(
                baseline.time, np.degrees(baseline.cone_angle), color=BASELINE, lw=0.9, label="two networks"
            )
        ax.plot(flown.time, np.degrees(flown.cone_angle), color=NETWORK, lw=1.3, label="three networks, in C")
        ax.set(title=title, xlabel="time [TU]", ylabel="cone angle [deg]", ylim=(-1.15 * bound, 1.15 * bound))
        ax.set_xlim(-0.1, 1.15 * flown.time[-1])  # a flight that never arrives would squeeze the others
    figure.legend(*axes[0].get_legend_handles_labels(), fontsize=8, loc="outside lower left", ncols=3)
    return figure


def predictions(flown: History, predicted_lambda_v: Array, optimum: Optimum) -> Figure:
    """Predicted time of flight and lambda_v along a flight (Figs 8a and 8b)."""
    figure, (left, right) = _figure(2)
    total = optimum.time[-1]
    left.plot(optimum.time, total - optimum.time, color=OPTIMUM, lw=3.5, alpha=0.6, label="indirect optimum")
    left.plot(flown.time, flown.predicted_time_of_flight, color=NETWORK, lw=1.3, label="network")
    left.set(xlabel="time [TU]", ylabel="time of flight left [TU]")
    left.legend(fontsize=8)
    right.plot(optimum.time, optimum.columns[:, 5], color=OPTIMUM, lw=3.5, alpha=0.6)
    right.plot(flown.time, predicted_lambda_v, color=NETWORK, lw=1.3)
    right.set(xlabel="time [TU]", ylabel="costate $\\lambda_v$")
    return figure


def jump(tau: Array, columns: Mapping[str, Array], jump_time: float) -> Figure:
    """A jump of the cone angle and its preprocessing (Figs 4 and 5), against time to go."""
    figure, (left, right) = _figure(2)
    left.plot(tau, columns["lambda_u"], color=NETWORK, label="$\\lambda_u$")
    left.plot(tau, columns["lambda_v"], color=OPTIMUM, label="$\\lambda_v$")
    left.axhline(0.0, color=GREY, lw=0.8)
    right.plot(tau, np.degrees(columns["alpha"]), color=OPTIMUM, lw=3.0, alpha=0.6, label="$\\alpha$")
    right.plot(
        tau, np.degrees(columns["alpha_pre"]), color=NETWORK, lw=1.3, label="$\\alpha_{pre}$, Eq. (23)"
    )
    right.plot(tau, np.degrees(np.abs(columns["alpha"])), color=BAD, lw=1.0, ls=":", label="$|\\alpha|$")
    for ax in (left, right):
        ax.axvline(jump_time, color=GREY, lw=0.8, ls="--")
        ax.set_xlabel("time to go $\\tau$ [TU]")
        ax.invert_xaxis()
        ax.legend(fontsize=8)
    left.set_ylabel("costate [TU$^2$/AU]")
    right.set_ylabel("cone angle [deg]")
    return figure


def training(histories: Mapping[str, Sequence[Mapping[str, float]]]) -> Figure:
    """Mean squared error over epochs (Fig. 7): one panel a network."""
    figure, axes = _figure(len(histories), 2.6 * len(histories), 3.0)
    parts = (("train", NETWORK, "-"), ("validation", OPTIMUM, "--"), ("test", BASELINE, ":"))
    for ax, (name, epochs) in zip(axes, histories.items(), strict=True):
        number = [epoch["epoch"] for epoch in epochs]
        for part, colour, style in parts:
            ax.semilogy(number, [epoch[part] for epoch in epochs], style, color=colour, lw=1.3, label=part)
        ax.set(title=name, xlabel="epoch")
    axes[0].set_ylabel("MSE (output scaled to [0, 1])")
    axes[0].legend(fontsize=8)
    return figure


def campaign(mission: Mission, flights: Flights) -> Figure:
    """Where flights succeed and fail, and how far from the target they end (Fig. 14)."""
    figure, (left, middle, right) = _figure(3, 12.0, 3.8)
    good = flights.arrived
    for ax, column, name in ((left, 0, "r [AU]"), (middle, 1, "u [AU/TU]")):
        for mask, colour, label in ((good, NETWORK, "arrived"), (~good, BAD, "missed")):
            ax.plot(
                flights.starts[mask, column],
                flights.starts[mask, 2],
                ".",
                color=colour,
                ms=5,
                label=f"{label} ({mask.sum()})",
            )
        ax.set(xlabel=f"start {name}", ylabel="start v [AU/TU]")
    left.legend(fontsize=8, loc="upper left", bbox_to_anchor=(0.0, 1.12), ncols=2)
    bins = np.logspace(-8, 1, 55).tolist()
    for column, (name, colour) in enumerate((("r", NETWORK), ("u", OPTIMUM), ("v", BASELINE))):
        error = np.clip(flights.terminal_error[:, column], 1e-8, 10.0)
        right.hist(error, bins=bins, histtype="step", color=colour, lw=1.4, label=f"$\\Delta {name}$")
    right.axvline(mission.flight.arrival_tolerance, color=GREY, lw=0.8, ls="--")
    right.set(xscale="log", xlabel="terminal error [AU, AU/TU]", ylabel="flights")
    right.legend(fontsize=8)
    return figure

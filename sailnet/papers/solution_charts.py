"""One solution of an optimal-control problem as people look at it: path, state, control, Hamiltonian."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sailnet.ocp.definition.functions import ProblemFunctions
from sailnet.ocp.definition.solution import Solution
from sailnet.papers.problem_views import view_of
from sailnet.papers.row import Solved
from sailnet.papers.solution_paths import paths
from sailnet.papers.views import Columns, Group, Rows, labelled, slug
from sailnet.physics.arrays import Array
from sailnet.report.charts import GREY, NETWORK, PALETTE, Chart, Curve

SHOWN = 500
"""Points of a curve in a page."""

ROUNDING = 1e-12
"""A switching function that is nowhere greater is none: its control is never on a bound."""

FLOOR = 1e-16
"""Smaller deviations of the Hamiltonian, which are rounding, are drawn there."""


def solution_charts(solved: Solved, most: int | None = SHOWN) -> list[Chart]:
    """The charts of a solution.

    Args:
        solved: the solution and its problem.
        most: points of a curve; all of them for None.
    """
    rows = np.arange(len(solved.solution.time))
    if most is not None and len(rows) > most:
        rows = np.unique(np.linspace(0, len(rows) - 1, most).astype(int))
    drawing = _OverTime(solved, rows)
    return [
        *paths(solved, drawing.view, rows),
        *map(drawing.states, drawing.view.states),
        *map(drawing.controls, drawing.view.controls),
        *drawing.switching(),
        drawing.costates(),
        drawing.hamiltonian(),
        drawing.deviation(),
    ]


def solution_columns(solution: Solution) -> Columns:
    """Everything along a solution, in the units of its problem."""
    names = solution.names
    return {
        "time": solution.time,
        **dict(zip(names["states"], solution.state.T, strict=True)),
        **dict(zip((f"lambda_{x}" for x in names["states"]), solution.costate.T, strict=True)),
        **dict(zip(names["controls"], solution.control.T, strict=True)),
        **dict(zip(names["switching"], solution.switching.T, strict=True)),
        "hamiltonian": solution.hamiltonian,
    }


def is_smoothed(solved: Solved) -> bool:
    """Whether there is a bound to smooth, and the solution does so."""
    bounds = [bound for one in solved.problem.bounded for bound in (one.lower, one.upper)]
    return solved.solution.rho > 0.0 and bool(np.isfinite(bounds).any())


def expected_hamiltonian(solved: Solved) -> float | None:
    """What the Hamiltonian has to be all along, if the final time is free and nothing depends on time."""
    problem, solution = solved.problem, solved.solution
    if problem.final_equations or not (problem.time_is_free and problem.autonomous):
        return None
    slope = ProblemFunctions(problem).terminal_cost_by_time(solution.final_time, solution.state[-1:])
    return 0.0 - float(slope[0])


class _OverTime:
    """Charts over time.

    Args:
        solved: the solution and its problem.
        rows: the points that are drawn.
    """

    def __init__(self, solved: Solved, rows: Rows) -> None:
        self.solved, self.rows, self.view = solved, rows, view_of(solved.problem)
        self.clock = solved.solution.time[rows] * self.view.time_scale
        self.expected = expected_hamiltonian(solved)
        first = float(solved.solution.hamiltonian[0])
        self.wanted = first if self.expected is None else self.expected

    def states(self, group: Group) -> Chart:
        """States of one kind."""
        return self._chart(
            group.title, labelled(", ".join(group.labels.values()), group.unit), self._of(group)
        )

    def controls(self, group: Group) -> Chart:
        """Controls of one kind, with their bounds, and with the switches unless they are directions."""
        chart = self.states(group)
        bounded = [one for one in self.solved.problem.bounded if str(one.variable) in group.labels]
        if not bounded:
            return chart
        bounds = {bound * group.scale for one in bounded for bound in (one.lower, one.upper)}
        finite = sorted(filter(np.isfinite, bounds))
        return self._marked(chart, finite, "Dashed across: the bounds. " if finite else "")

    def switching(self) -> list[Chart]:
        """The switching functions, each with its own switches."""
        solution = self.solved.solution
        what = "∂H/∂u; where it is negative, a control that enters H linearly is at its upper bound. "
        charts = []
        for name in solution.names["switching"]:
            title, values = f"Switching function {name}", solution[name][self.rows]
            most = float(np.nanmax(np.abs(values)))
            if most > ROUNDING:
                charts.append(self._marked(self._chart(title, name, {name: values}), [0.0], what, name))
            else:
                flat = f"∂H/∂u, zero but for rounding: at most {most:.1e}."
                charts.append(self._chart(title, name, {name: values}, caption=flat, y_range=(-1.0, 1.0)))
        return charts

    def costates(self) -> Chart:
        """All costates."""
        solution = self.solved.solution
        table = zip(solution.names["states"], solution.costate[self.rows].T, strict=True)
        return self._chart("Costates", "λ", {f"λ_{_greek(name)}": values for name, values in table})

    def hamiltonian(self) -> Chart:
        """The Hamiltonian, on a scale on which rounding is not seen."""
        values = self.solved.solution.hamiltonian[self.rows]
        columns = {"H": values, "span": self.clock[[0, -1]], "must": np.full(2, self.wanted)}
        least = 0.5 * abs(self.wanted) if abs(self.wanted) > 1e-6 else 0.1
        half = max(2.0 * float(np.nanmax(np.abs(values - self.wanted))), least)
        caption = f"Dashed: {self.wanted:.6g}, which it has to be all along."
        if self.expected is None:
            caption = f"It has to be constant; dashed: the {self.wanted:.6g} at the start."
        curves = [
            Curve("time", "H", "H", colour=NETWORK),
            Curve("span", "must", "", colour=GREY, dash=True, width=1.0),
        ]
        limits = self.wanted - half, self.wanted + half
        return self._chart("Hamiltonian", "H", columns, curves, caption, y_range=limits)

    def deviation(self) -> Chart:
        """How far the Hamiltonian is from what it has to be."""
        off = np.abs(self.solved.solution.hamiltonian - self.wanted)
        caption, rho = f"At most {np.nanmax(off):.1e}.", self.solved.solution.rho
        if is_smoothed(self.solved):
            caption += (
                f" The control is smoothed, with ρ = {rho:.3g}, and so does not quite minimise H, which"
                " changes by that."
            )
        columns = {"deviation": np.maximum(off[self.rows], FLOOR)}
        curves = [Curve("time", "deviation", "deviation", colour=NETWORK)]
        sign = "+" if self.wanted < 0.0 else "−"
        y = f"|H {sign} {abs(self.wanted):g}|" if self.wanted else "|H|"
        if self.expected is None:
            y = "|H − H(0)|"
        return self._chart("Deviation of the Hamiltonian", y, columns, curves, caption, logarithmic="y")

    def _of(self, group: Group) -> Columns:
        return {
            label: self.solved.solution[name][self.rows] * group.scale for name, label in group.labels.items()
        }

    def _chart(
        self,
        title: str,
        y: str,
        columns: Columns,
        curves: Sequence[Curve] = (),
        caption: str = "",
        logarithmic: str = "",
        y_range: tuple[float, float] | None = None,
    ) -> Chart:
        own = [
            Curve("time", name, name, colour=colour)
            for name, colour in zip(columns, [*PALETTE, *PALETTE], strict=False)
        ]
        return Chart(
            slug(title),
            title,
            caption,
            labelled("time", self.view.time_unit),
            y,
            curves or own,
            {"time": self.clock, **columns},
            logarithmic,
            y_range=y_range,
        )

    def _marked(self, chart: Chart, levels: Sequence[float], caption: str, own: str = "") -> Chart:
        """With lines across at some levels, and upright at the switches, or at those of that name alone."""
        columns: dict[str, Array] = {name: np.asarray(values) for name, values in chart.columns.items()}
        plotted = np.concatenate([values for name, values in columns.items() if name != "time"])
        values = np.array([*plotted[np.isfinite(plotted)], *levels])
        marks: list[Curve] = []
        columns["span"] = self.clock[[0, -1]]
        for i, level in enumerate(levels):
            columns[f"level_{i}"] = np.full(2, level)
            marks.append(Curve("span", f"level_{i}", "", colour=GREY, dash=True, width=1.0))
        switches = [one for one in self.solved.solution.switches if own in ("", one.name)]
        times = [one.time * self.view.time_scale for one in switches]
        if times:
            # One broken line for all of them: up, then a gap.
            columns["switch"] = np.repeat(times, 3)
            columns["upright"] = np.tile([values.min(), values.max(), np.nan], len(times))
            marks.append(Curve("switch", "upright", "switch", colour="#b9a5d8", width=1.2))
        curves = [*marks, *chart.curves]
        return replace(chart, columns=columns, curves=curves, caption=caption + self._counted(len(times)))

    def _counted(self, switches: int) -> str:
        # Where a smoothed control meets its bounds is a matter of taste.
        none = "" if is_smoothed(self.solved) else "No switch."
        return {0: none, 1: "Upright: the switch."}.get(switches, f"Upright: {switches} switches.")


def _greek(name: str) -> str:
    return name.replace("omega", "ω").replace("theta", "θ")

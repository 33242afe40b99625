"""The page of ``sailnet papers``: the tables, and the very solutions whose figures stand in them."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from sailnet.artefacts.files import write_text
from sailnet.papers.problem_views import view_of
from sailnet.papers.row import Row, Solved
from sailnet.papers.solution_charts import is_smoothed, solution_charts, solution_columns
from sailnet.papers.trial import Trial
from sailnet.papers.views import slug
from sailnet.report.charts import Chart, for_page, write_csv, write_picture
from sailnet.report.flight_page import chart_page

Entry = Row | Trial

DIGITS = 7
"""Significant digits of a number in a chart: Goddard's rocket climbs by a hundredth of its altitude."""

MOST_NAMED = 20
"""Switches whose times are told one by one."""


@dataclass(frozen=True)
class Shown:
    """One solution on the page.

    Attributes:
        name: of its place in the page and of its files.
        title: how it was found.
        brief: its cost and switches, in a line.
        solved: the solution and its problem.
        facts: about it.
        charts: of it; their names begin with its own.
    """

    name: str
    title: str
    brief: str
    solved: Solved
    facts: Mapping[str, str]
    charts: Sequence[Chart]


@dataclass
class Section:
    """The solutions of one problem, or of one instance of it.

    Attributes:
        name: of its place in the page.
        paper: its number.
        title: of the problem.
        instance: as the table names it.
        source: paper and equations.
        solutions: every one once, however many figures were read off it.
    """

    name: str
    paper: str
    title: str
    instance: str
    source: str
    solutions: list[Shown] = field(default_factory=list)


def write_report(
    entries: Sequence[Entry], failures: Sequence[str], made: Mapping[str, str], folder: Path, command: str
) -> None:
    """Write ``index.html``, and beside it every solution as ``solutions/NAME.png`` and ``.csv``.

    Args:
        entries: rows and trials, with the solutions that they come from.
        failures: what could not be solved, or does not agree.
        made: machine, date and revision.
        folder: where to.
        command: that writes it again.
    """
    sections, places = _sections(entries)
    shown = [one for section in sections for one in section.solutions]
    rows = [entry for entry in entries if isinstance(entry, Row)]
    text = chart_page(
        "papers.html.jinja",
        {
            "charts": [for_page(chart, DIGITS) for one in shown for chart in one.charts],
            "flights": {"rows": []},
        },
        Path(__file__).parent,
        rows=rows,
        trials=[entry for entry in entries if isinstance(entry, Trial)],
        links={number: places[id(entry)] for number, entry in enumerate(rows) if id(entry) in places},
        tried=[places.get(id(entry)) for entry in entries if isinstance(entry, Trial)],
        verdicts=Counter(row.verdict for row in rows),
        sections=sections,
        failures=failures,
        made=made,
        command=command,
    )
    write_text(folder / "index.html", text)
    for one in shown:
        write_csv(folder / "solutions" / f"{one.name}.csv", solution_columns(one.solved.solution))
        whole = solution_charts(one.solved, most=None)
        write_picture(folder / "solutions" / f"{one.name}.png", whole, columns=2)


def _sections(entries: Sequence[Entry]) -> tuple[list[Section], dict[int, str]]:
    """The sections, and the place in the page of every entry that has a solution."""
    sections: dict[tuple[str, str], Section] = {}
    names: dict[int, str] = {}
    places: dict[int, str] = {}
    for entry in entries:
        if entry.solved is None:
            continue
        solved = entry.solved
        key = entry.paper, entry.problem
        if key not in sections:
            title, source = view_of(solved.problem).title, solved.problem.source
            name = slug(f"{entry.paper}-{entry.problem}")
            sections[key] = Section(name, entry.paper, title, entry.problem, source)
        section = sections[key]
        if id(solved.solution) not in names:
            solver = entry.solver if isinstance(entry, Trial) else solved.solution.solver
            names[id(solved.solution)] = name = f"{section.name}-{len(section.solutions) + 1}"
            section.solutions.append(_shown(name, solver, solved, entry))
        places[id(entry)] = names[id(solved.solution)]
    return list(sections.values()), places


def _shown(name: str, solver: str, solved: Solved, entry: Entry) -> Shown:
    solution, view = solved.solution, view_of(solved.problem)
    label, unit, scale = view.cost
    clock = f"{solution.final_time * view.time_scale:.9g}{_of(view.time_unit)}"
    cost = f"{solution.cost * scale:.9g}{_of(unit)}"
    times = ", ".join(f"{switch.time * view.time_scale:.6g}" for switch in solution.switches)
    count = len(solution.switches)
    smoothed = f", ρ = {solution.rho:.3g}" if is_smoothed(solved) else ""
    facts = {
        "found by": solver + smoothed,
        "settings and guess": entry.settings if isinstance(entry, Trial) else "",
        "final time": clock + ("" if solved.problem.time_is_free else ", given"),
        f"cost: {label}": cost,
        "largest residuals": ", ".join(f"{kind} {value:.1e}" for kind, value in solution.residuals.items()),
        "switches": f"{count}: {times}{_of(view.time_unit)}" if 0 < count <= MOST_NAMED else str(count),
        "structure": solution.message if solution.message.startswith("arcs") else "",
        "steps of the continuation": str(len(solution.history)),
        "points": str(len(solution.time)),
        "wall time": f"{entry.seconds:.3g} s",
    }
    charts = [replace(chart, name=f"{name}-{chart.name}") for chart in solution_charts(solved)]
    switches = {0: "no switch", 1: "one switch"}.get(count, f"{count} switches")
    brief = f"{label} = {cost}, {switches}"
    return Shown(name, solver + smoothed, brief, solved, {k: v for k, v in facts.items() if v}, charts)


def _of(unit: str) -> str:
    return f" {unit}" if unit.isascii() else ""

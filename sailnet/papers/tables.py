"""The tables of ``sailnet papers``: for people to read, and as Markdown."""

from collections.abc import Iterable, Sequence

from sailnet.artefacts.provenance import software
from sailnet.papers import trial
from sailnet.papers.row import Row
from sailnet.papers.trial import Trial

Table = Sequence[Sequence[str]]


def _by_paper(rows: Iterable[Row]) -> dict[str, list[Row]]:
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(row.paper, []).append(row)
    return found


def _seconds(value: float | None) -> str:
    return "" if value is None else f"{value:.3g}"


def _cells(row: Row) -> list[str]:
    check = f"{row.check:.9g} ({row.check_method})"
    times = [_seconds(row.seconds), _seconds(row.paper_seconds)]
    return [row.problem, row.quantity, row.printed, f"{row.ours:.9g}", check, row.verdict, *times]


HEADINGS = ["problem", "quantity", "printed", "ours", "check (method)", "verdict", "s", "paper's s"]


def tables(rows: Iterable[Row]) -> str:
    """A table a paper, for people to read."""
    return "\n\n".join(
        f"Paper {paper}\n{_aligned([HEADINGS, *map(_cells, those)])}"
        for paper, those in _by_paper(rows).items()
    )


def _aligned(table: Table) -> str:
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    lines = ("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) for row in table)
    return "\n".join(line.rstrip() for line in lines)


def markdown(rows: Iterable[Row]) -> str:
    """The same for a README, with the reasons, and with machine, date and revision."""
    parts = [origin()]
    for paper, those in _by_paper(rows).items():
        table = _piped([*HEADINGS, "why"], [[*_cells(row), row.reason] for row in those])
        parts.append(f"**Paper {paper}**\n\n{table}")
    return "\n\n".join(parts)


def trial_table(trials: Sequence[Trial]) -> str:
    """What became of every solver on the sail, for people to read; reasons beneath."""
    if not trials:
        return ""
    table = _aligned([trial.HEADINGS, *map(trial.cells, trials)])
    reasons = [f"{one.solver}: {one.reason}" for one in trials if one.reason]
    return "\n".join([f"Paper {trial.PAPER}, {trial.NAME}", table, *reasons])


def trials_markdown(trials: Sequence[Trial]) -> list[str]:
    """The same as Markdown, with the reasons in it; nothing without trials."""
    rows = [[*trial.cells(one), one.reason] for one in trials]
    return [_piped([*trial.HEADINGS, "why"], rows)] if trials else []


def origin() -> str:
    """Who has written a table, where and when."""
    made = software()
    return f"Written by `sailnet papers` on {made['machine']}, {made['date']}, revision {made['revision']}."


def _piped(headings: Sequence[str], rows: Table) -> str:
    lines = [headings, ["---"] * len(headings), *rows]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)

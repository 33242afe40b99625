"""``sailnet papers``: every printed figure beside ours and a second method's, as a table or as JSON."""

import json
import math
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from tqdm import tqdm

from sailnet.artefacts.files import fill_block, split_at_block, write_whole
from sailnet.artefacts.provenance import software
from sailnet.errors import SailnetError
from sailnet.ocp.papers import bbsr, delta, ponn, sail, trial
from sailnet.ocp.papers.row import Row, record_of
from sailnet.ocp.papers.trial import Trial
from sailnet.report import report

AGREEMENT = 1e-6
"""Ours and the check may differ by this, relatively: six digits."""

BLOCK = "papers"
"""Name of the block of a README that the table is written to; the sail's has the sail's name."""

Entry = Row | Trial


@dataclass(frozen=True)
class Part:
    """Figures that are computed together.

    Attributes:
        paper: its number.
        problems: names of the problems, as rows have them before the first comma.
        rows: computes the figures.
    """

    paper: str
    problems: tuple[str, ...]
    rows: Callable[[], Sequence[Entry]]


PARTS = (
    Part("000", ("earth-mars",), ponn.earth_mars_rows),
    Part("000", ("mars-landing",), ponn.landing_rows),
    Part("002", ("intercept",), ponn.intercept_rows),
    Part("002", ("intercept",), ponn.bounded_rows),
    Part("003", ("goddard",), bbsr.goddard_table),
    Part("003", ("reorientation-1",), bbsr.first_reorientation),
    Part("003", ("reorientation-2",), bbsr.second_reorientation),
    Part("003", ("earth-dionysus",), bbsr.dionysus_rows),
    Part("004", ("lunar-landing", "asteroid-rendezvous", "leo-geo-time", "leo-geo-fuel"), delta.rows),
    Part(trial.PAPER, (trial.NAME,), sail.trials),
)
"""In the order of the table; a paper that is added is a line here."""

Table = Sequence[Sequence[str]]


def run(name: str | None, as_json: bool, folder: Path | None = None, readme: Path | None = None) -> int:
    """Compute the figures and print them on stdout; progress and remarks go to stderr.

    Args:
        name: number of a paper or name of a problem; all of them by default.
        as_json: print a list of objects instead of tables.
        folder: gets ``papers.json``, ``papers.md``, and the page ``index.html`` with every solution drawn,
            which are beside it as PNG and CSV too.
        readme: a file whose block ``papers`` gets the Markdown table too, and whose block ``sail`` the
            sail's, if all is well.

    Returns:
        Exit status: 0, or 1 where ours and the check differ beyond six digits or nothing converged.

    Raises:
        SailnetError: there is no such paper or problem, the README has no such block, the folder cannot
            be written, or there is nothing to draw with.
    """
    pictures = report("papers_page") if folder is not None else None
    parts = _chosen(name)
    if readme is not None:
        if name is not None:
            raise SailnetError("a README gets the whole table: leave out NAME, or --readme")
        for block in [BLOCK, *(trial.NAME for part in parts if trial.NAME in part.problems)]:
            split_at_block(readme, block)
    entries, failures = _computed(parts, name)
    rows = [entry for entry in entries if isinstance(entry, Row)]
    trials = [entry for entry in entries if isinstance(entry, Trial)]
    found = json.dumps([_object(entry) for entry in entries], indent=1, allow_nan=False)
    print(found if as_json else "\n\n".join(filter(None, [tables(rows), trial_table(trials)])))
    failures += [
        f"{row.problem}, {row.quantity}: ours {row.ours:.9g} and {row.check:.9g} by {row.check_method}"
        " are not the same to six digits; neither is to be trusted before it is known why"
        for row in rows
        if not agree(row)
    ]
    wrong = trial.failure(trials) if trials else None
    failures += [wrong] if wrong else []
    if folder is not None and pictures is not None:
        try:
            _write(folder / "papers.json", found + "\n")
            _write(folder / "papers.md", "\n\n".join([markdown(rows), *_trials_markdown(trials)]) + "\n")
            pictures.write_report(entries, failures, software(), folder)
        except OSError as error:
            raise SailnetError(f"cannot write {folder}: {error}") from error
    if readme is not None and not failures:
        fill_block(readme, BLOCK, markdown(rows))
        for table in _trials_markdown(trials):
            fill_block(readme, trial.NAME, f"{_made()}\n\n{table}")
    for failure in failures:
        print(f"error: {failure}", file=sys.stderr)
    return 1 if failures else 0


def agree(row: Row) -> bool:
    """Whether ours and the check are the same to six digits, where they are the same quantity."""
    if not row.same:
        return math.isfinite(row.ours) and math.isfinite(row.check)
    return math.isfinite(row.ours) and math.isclose(row.ours, row.check, rel_tol=AGREEMENT)


def _chosen(name: str | None) -> list[Part]:
    chosen = [part for part in PARTS if name is None or name == part.paper or name in part.problems]
    if not chosen:
        papers = dict.fromkeys(part.paper for part in PARTS)
        problems = dict.fromkeys(problem for part in PARTS for problem in part.problems)
        raise SailnetError(
            f"no paper or problem is called {name}; the papers are {', '.join(papers)},"
            f" the problems {', '.join(problems)}"
        )
    return chosen


def _computed(parts: Sequence[Part], name: str | None) -> tuple[list[Entry], list[str]]:
    """The rows asked for, and what could not be solved: one failure must not cost the other rows."""
    rows: list[Entry] = []
    failures: list[str] = []
    with tqdm(parts, desc="papers", unit="part", file=sys.stderr, disable=None) as bar:
        for part in bar:
            bar.set_postfix_str(f"{part.paper} {part.problems[0]}")
            try:
                computed = part.rows()
            except SailnetError as error:
                failures.append(f"paper {part.paper}, {', '.join(part.problems)}: {error}")
                continue
            rows += [row for row in computed if name in (None, part.paper, _problem(row))]
    return rows, failures


def _problem(row: Entry) -> str:
    """The problem's name: behind a comma stands which instance of it."""
    return row.problem.partition(",")[0]


def _object(row: Entry) -> dict[str, object]:
    """As JSON has it, which knows no NaN: null."""
    values = record_of(row) | ({"difference": row.difference} if isinstance(row, Trial) else {})
    return {
        key: None if isinstance(value, float) and not math.isfinite(value) else value
        for key, value in values.items()
    }


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
    parts = [_made()]
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


def _trials_markdown(trials: Sequence[Trial]) -> list[str]:
    rows = [[*trial.cells(one), one.reason] for one in trials]
    return [_piped([*trial.HEADINGS, "why"], rows)] if trials else []


def _made() -> str:
    made = software()
    return f"Written by `sailnet papers` on {made['machine']}, {made['date']}, revision {made['revision']}."


def _piped(headings: Sequence[str], rows: Table) -> str:
    lines = [headings, ["---"] * len(headings), *rows]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)


def _write(path: Path, text: str) -> None:
    write_whole(path, lambda beside: beside.write_text(text, encoding="utf-8"))

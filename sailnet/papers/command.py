"""``sailnet papers``: every printed figure beside ours and a second method's, as a table or as JSON."""

import json
import math
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from sailnet.artefacts.files import fill_block, split_at_block, write_text, writing
from sailnet.artefacts.provenance import software
from sailnet.errors import SailnetError
from sailnet.papers import trial
from sailnet.papers.parts import PARTS, Entry, Part, chosen, problem_of
from sailnet.papers.row import Row, record_of
from sailnet.papers.tables import markdown, origin, tables, trial_table, trials_markdown
from sailnet.papers.trial import Trial
from sailnet.report import report
from sailnet.workers.executors import processes
from sailnet.workers.progress import progress

AGREEMENT = 1e-6
"""Ours and the check may differ by this, relatively: six digits."""

BLOCK = "papers"
"""Name of the block of a text that the table is written to; the sail's has the sail's name."""


def run(
    name: str | None,
    as_json: bool,
    folder: Path | None = None,
    readme: Path | None = None,
    workers: int = 1,
    *,
    command_line: str = "sailnet papers",
) -> int:
    """Compute the figures and print them on stdout; progress and remarks go to stderr.

    Args:
        name: number of a paper or name of a problem; all of them by default.
        as_json: print a list of objects instead of tables.
        folder: gets ``papers.json``, ``papers.md``, and the page ``index.html`` with every solution drawn,
            which are beside it as PNG and CSV too.
        readme: a text whose block ``papers`` gets the Markdown table too, and whose block ``sail`` the
            sail's, if all is well.
        workers: processes that solve problems side by side; seconds are then those of a busy machine.
        command_line: that was given, for the page.

    Returns:
        Exit status: 0, or 1 where ours and the check differ beyond six digits or nothing converged.

    Raises:
        SailnetError: there is no such paper or problem, what it needs is not installed, the text has no
            such block, the folder cannot be written, or there is nothing to draw with.
    """
    if workers < 1:
        raise SailnetError(f"{workers} workers solve nothing: give at least 1")
    parts = chosen(PARTS, name)
    if folder is not None:
        report("flight_page")  # says what to install before minutes are spent
    if readme is not None:
        if name is not None:
            raise SailnetError("a README gets the whole table: leave out NAME, or --readme")
        for block in [BLOCK, *(trial.NAME for part in parts if trial.NAME in part.problems)]:
            split_at_block(readme, block)
    entries, failures = _computed(parts, name, workers)
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
    if folder is not None:
        from sailnet.papers import page

        with writing(folder):
            write_text(folder / "papers.json", found + "\n")
            write_text(folder / "papers.md", "\n\n".join([markdown(rows), *trials_markdown(trials)]) + "\n")
            page.write_report(entries, failures, software(), folder, command_line)
    if readme is not None and not failures:
        fill_block(readme, BLOCK, markdown(rows))
        for table in trials_markdown(trials):
            fill_block(readme, trial.NAME, f"{origin()}\n\n{table}")
    for failure in failures:
        print(f"error: {failure}", file=sys.stderr)
    return 1 if failures else 0


def agree(row: Row) -> bool:
    """Whether ours and the check are the same to six digits, where they are the same quantity."""
    if not row.same:
        return math.isfinite(row.ours) and math.isfinite(row.check)
    return math.isfinite(row.ours) and math.isclose(row.ours, row.check, rel_tol=AGREEMENT)


def _computed(parts: Sequence[Part], name: str | None, workers: int) -> tuple[list[Entry], list[str]]:
    """The rows asked for, and what could not be solved: one failure must not cost the other rows."""
    rows: list[Entry] = []
    failures: list[str] = []
    with (
        _solved(parts, workers) as solved,
        progress(len(parts), "part", "papers") as bar,
    ):
        bar.set_postfix_str(parts[0].name)
        for number, (part, found) in enumerate(zip(parts, solved, strict=True), start=1):
            if isinstance(found, SailnetError):
                failures.append(f"{part.name}: {found}")
            else:
                rows += [row for row in found if name in (None, part.paper, problem_of(row))]
            bar.update()
            bar.set_postfix_str(parts[number].name if number < len(parts) else "")
            if bar.disable:
                # Where no bar is drawn, in a log say, minutes without a word look like a halt.
                print(f"papers: {number} of {len(parts)}, {part.name}", file=sys.stderr, flush=True)
    return rows, failures


Outcome = Sequence[Entry] | SailnetError


@contextmanager
def _solved(parts: Sequence[Part], workers: int) -> Iterator[Iterator[Outcome]]:
    """What becomes of parts, in their order."""
    solve, numbers = partial(_outcome, parts), range(len(parts))
    if workers == 1 or len(parts) == 1:
        yield map(solve, numbers)
        return
    with processes(min(workers, len(parts))) as pool:
        yield pool.map(solve, numbers)


def _outcome(parts: Sequence[Part], number: int) -> Outcome:
    try:
        return list(parts[number].rows())
    except SailnetError as error:
        return error


def _object(row: Entry) -> dict[str, object]:
    """As JSON has it, which knows no NaN: null."""
    values = record_of(row) | ({"difference": row.difference} if isinstance(row, Trial) else {})
    return {
        key: None if isinstance(value, float) and not math.isfinite(value) else value
        for key, value in values.items()
    }

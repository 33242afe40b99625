"""What bad days came to, as Markdown: a table for each kind of day, and each row with its date and revision.

Rows are of their own runs: what is measured anew takes the place of its row, and the others stay.
"""

from collections.abc import Callable, Iterable
from pathlib import Path

from sailnet.artefacts.files import split_at_block
from sailnet.artefacts.provenance import software

Day = dict[str, object]
Days = list[Day]
Records = dict[str, dict[str, Days]]
"""By kind of day and name of the work; of clusters by loss and work."""

Row = list[object]


def _kills(name: str, days: Days) -> Iterable[Row]:
    moments = ", ".join(str(day["moment"]) for day in counted(days))
    same = f"{_count(days, 'same')} of {len(days)}"
    yield [name, len(counted(days)), moments, same, _total(days, "orphans"), _total(days, "leftovers")]


def _writers(name: str, days: Days) -> Iterable[Row]:
    for day in days:
        yield [name, day["status"], day["seconds"], day["cpu"], day["said"], day["same"]]


def _clusters(name: str, days: Days) -> Iterable[Row]:
    for day in days:
        yield [day["loss"], name, *(day[key] for key in ("status", "first", "seconds", "said", "same"))]


def _disks(name: str, days: Days) -> Iterable[Row]:
    full = [day for day in days if day["status"]]
    sizes = ", ".join(str(int(str(day["size"])) // 1000) for day in days)
    yield [
        name,
        sizes,
        f"{len(full)} of {len(days)}",
        f"{_count(full, 'told')} of {len(full)}",
        f"{_count(full, 'reckoned')} of {len(full)}",
        _count(full, "whole"),
        f"{_count(days, 'same')} of {len(days)}",
        full[-1]["said"] if full else "",
    ]


def _faults(name: str, days: Days) -> Iterable[Row]:
    for day in days:
        yield [day["fault"], name, *(day[key] for key in ("status", "seconds", "said"))]


TABLES: dict[str, tuple[str, int, Callable[[str, Days], Iterable[Row]]]] = {
    "kills": (
        "kill -9 at random moments, then the same command again | kills | moments [s] | same content "
        "| orphans after 5 s | left-overs",
        1,
        _kills,
    ),
    "writers": (
        "two writers at once | status | seconds | of the processor | what the second says | first as ever",
        1,
        _writers,
    ),
    "clusters": (
        "Dask loses | work | status | seconds to the first word | to the end | what it says "
        "| same content in the end",
        2,
        _clusters,
    ),
    "disks": (
        "a disk that fills | sizes [kB] | full at | said so with the path | said how much was needed and is "
        "free | half looks whole | same content with room | what it says",
        1,
        _disks,
    ),
    "faults": ("fault | given | status | seconds | what it says", 2, _faults),
}
"""By kind of day: the table's head, how many of a row's cells say what it is of, and its rows."""


def counted(days: Days) -> Days:
    """A command that ended before it was killed shows nothing."""
    return [day for day in days if not day.get("finished")]


def table(records: Records) -> list[str]:
    """The records as Markdown."""
    lines = [
        f"`make bad-days` on {software()['machine']}, commands at toy size. Content is compared by digests "
        "that hold no date."
    ]
    for kind, (head, _, rows_of) in TABLES.items():
        if kind not in records:
            continue
        lines += ["", *_head(head)]
        for name, days in records[kind].items():
            rows = list(rows_of(name, days))
            of = days if len(rows) == len(days) else days[-1:]
            lines += [
                _row([*cells, f"{day['date']}, {day['revision']}"])
                for cells, day in zip(rows, of, strict=True)
            ]
    return lines


def merged(lines: list[str], path: Path, mark: str) -> list[str]:
    """The lines of a table, and those rows of the text's block that they say nothing anew of."""
    before = split_at_block(path, mark)[1].splitlines()
    result = [lines[0]]
    for head, keys, _ in TABLES.values():
        rows = _rows(before, head, keys) | _rows(lines, head, keys)
        if rows:
            result += ["", *_head(head), *rows.values()]
    return result


def _head(head: str) -> list[str]:
    return [f"| {head} | of |", "|" + "---|" * (head.count("|") + 2)]


def _rows(lines: list[str], head: str, keys: int) -> dict[tuple[str, ...], str]:
    """Below this head, by the cells that say what a row is of."""
    first = _head(head)[0]
    if first not in lines:
        return {}
    found = {}
    for line in lines[lines.index(first) + 2 :]:
        if not line.startswith("|"):
            break
        found[tuple(line.split(" | ")[:keys])] = line
    return found


def _row(cells: Row) -> str:
    named = {True: "yes", False: "no"}
    texts = [named[cell] if isinstance(cell, bool) else str(cell) for cell in cells]
    return "| " + " | ".join(text.replace("|", "/").replace("\n", " ") for text in texts) + " |"


def _count(days: Days, key: str) -> int:
    return sum(bool(day[key]) for day in days)


def _total(days: Days, key: str) -> int:
    return sum(int(str(day[key])) for day in days)

"""Which figures there are, in parts that are computed together; a paper that is added is a line here."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.util import find_spec

from sailnet.errors import SailnetError, did_you_mean
from sailnet.papers import bbsr, delta, ponn, sail, trial
from sailnet.papers.row import Row
from sailnet.papers.trial import Trial

Entry = Row | Trial


@dataclass(frozen=True)
class Part:
    """Figures that are computed together.

    Attributes:
        paper: its number.
        problems: names of the problems, as rows have them before the first comma.
        rows: computes the figures.
        extras: module -> the extra of this package that installs it, for what is not always there.
    """

    paper: str
    problems: tuple[str, ...]
    rows: Callable[[], Sequence[Entry]]
    extras: tuple[tuple[str, str], ...] = ()

    @property
    def name(self) -> str:
        """For people."""
        return f"paper {self.paper}, {', '.join(self.problems)}"

    def check(self) -> None:
        """Make sure that all it needs is installed.

        Raises:
            SailnetError: it is not.
        """
        for module, extra in self.extras:
            if find_spec(module) is None:
                raise SailnetError(
                    f"{self.name} needs {module}, which is not installed: pip install 'sailnet[{extra}]',"
                    " or name another paper or problem"
                )


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
    Part(trial.PAPER, (trial.NAME,), sail.trials, (("pygmo", "ocp"),)),
)
"""In the order of the table."""


def chosen(parts: Sequence[Part], name: str | None) -> list[Part]:
    """The parts of a paper or with a problem, or all.

    Raises:
        SailnetError: there is no such paper or problem, or what a part needs is not installed.
    """
    found = [part for part in parts if name is None or name == part.paper or name in part.problems]
    if not found:
        papers = dict.fromkeys(part.paper for part in parts)
        problems = dict.fromkeys(problem for part in parts for problem in part.problems)
        raise SailnetError(
            f"no paper or problem is called {name}; the papers are {', '.join(papers)},"
            f" the problems {', '.join(problems)}{did_you_mean(name or '', problems)}"
        )
    for part in found:
        part.check()
    return found


def problem_of(entry: Entry) -> str:
    """The problem's name: behind a comma stands which instance of it."""
    return entry.problem.partition(",")[0]

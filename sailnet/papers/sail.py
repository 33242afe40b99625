"""Every solver on the solar sail's transfer from the Earth to Mars, the one that paper 001 prints.

What finds its own way begins at a guess that does not hold the answer: random costates, straight lines,
random weights. What only refines begins at shooting's solution, and its settings say so.
"""

import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from sailnet.errors import SailnetError
from sailnet.mission.mission import load_mission
from sailnet.ocp import (
    Exact,
    Problem,
    Saturation,
    Schedule,
    Solution,
    arcs,
    collocation,
    delta,
    multiple,
    ponn,
    shooting,
)
from sailnet.ocp.problems import solar_sail
from sailnet.papers.row import Solved
from sailnet.papers.trial import MINIMUM, ROUNDING, Trial, Verdict

GUESS = 6.0
"""Time of flight to begin with [TU]."""

FIRST = 1e-3
"""First smoothing parameter, the paper's delta; at 0.1 neither shooting nor collocation found an extremal."""

PATH = Schedule(FIRST, 1e-8)

_ENDS = ("boundary", "transversality", "largest")
"""Kinds of residuals that are errors of end conditions."""


class Solver(Protocol):
    """The one form of every ``solve`` in :mod:`sailnet.ocp.solvers`."""

    def __call__(self, problem: Problem, guess: Any, *, options: Any) -> Solution:
        """Solve a problem."""
        ...


@dataclass(frozen=True)
class Way:
    """A solver and how it is set.

    Attributes:
        solve: the solver.
        options: its own.
        settings: the same in words, with the guess.
        guess: what it begins at; None for what is the solver's own.
        after: the solver, by its name in :data:`WAYS`, whose solution it begins at instead.
    """

    solve: Solver
    options: Any
    settings: str
    guess: Any = None
    after: str | None = None


WAYS: Mapping[str, Way] = {
    "shooting": Way(
        shooting.solve,
        shooting.Options(Saturation(), PATH, iterations=30),
        "saturation 1e-3 to 1e-8; random costates in [-10, 10], 6 TU",
        shooting.RandomCostates(10.0, starts=300),
    ),
    "shooting, exact": Way(
        shooting.solve, shooting.Options(Exact()), "no smoothing, switches located", after="shooting"
    ),
    "multiple": Way(
        multiple.solve,
        multiple.Options(Saturation(), PATH, pieces=10),
        "saturation 1e-3 to 1e-8, 10 pieces",
        after="shooting",
    ),
    "collocation": Way(
        collocation.solve,
        collocation.Options(Saturation(), PATH, final_tolerance=1e-8),
        "saturation 1e-3 to 1e-8; straight lines, all costates -10, 6 TU",
        collocation.StraightLines(costate=-10.0),
    ),
    "arcs": Way(arcs.solve, arcs.Options(), "no smoothing, structure read off its guess", after="shooting"),
    "ponn": Way(
        ponn.solve,
        ponn.Options(Saturation(), FIRST, ponn.Chebyshev(100), points=200, goal=1e-5, iterations=60),
        "100 Chebyshev polynomials, saturation 1e-3, mean loss 1e-5; 5 random starts, 6 TU",
        ponn.RandomWeights(-10.0, starts=5),
    ),
    "ponn, from shooting": Way(
        ponn.solve,
        ponn.Options(Saturation(), FIRST, ponn.Chebyshev(100), points=200, goal=1e-3),
        "100 Chebyshev polynomials, saturation 1e-3, mean loss 1e-3",
        after="shooting",
    ),
    "ponn.split": Way(
        ponn.split.solve,
        ponn.split.Options(basis=ponn.Chebyshev(80), points=160, goal=1e-6),
        "80 Chebyshev polynomials an arc, no smoothing, mean loss 1e-6",
        after="shooting",
    ),
    "delta": Way(
        delta.solve,
        delta.Options(delta.Chebyshev(), terms=10, evaluations=40_000, weights=delta.Weights(minimum=10.0)),
        "10 Chebyshev polynomials, GA-PSO, 40000 flights, delta_s^H tenfold; 3 TU to 9 TU",
    ),
    "shooting, from delta": Way(
        shooting.solve, shooting.Options(Saturation(), PATH), "saturation 1e-3 to 1e-8", after="delta"
    ),
    "delta, polished": Way(
        delta.solve,
        delta.Options(
            delta.Chebyshev(),
            terms=12,
            evaluations=20_000,
            weights=delta.Weights(minimum=10.0),
            polish=delta.Polish(evaluations=500),
        ),
        "12 Chebyshev polynomials, GA-PSO in a quarter of the box, 8 searches, polished, "
        "20000 flights; 3 TU to 9 TU",
        delta.RandomSeries(box=0.25, searches=8),
    ),
}
"""Every solver on the sail, in the order of the table."""


def trials(names: Sequence[str] = tuple(WAYS)) -> list[Trial]:
    """Let solvers try, in the order of :data:`WAYS`.

    Args:
        names: of those that shall; the ones they begin at are run as well, unlisted.
    """
    bench = Bench()
    return [bench.trial(name) for name in WAYS if name in names]


@dataclass
class Bench:
    """The sail's transfer, and what has been tried on it; every solver is run once.

    Attributes:
        problem: from the Earth to Mars.
        found: by the solver's name.
    """

    problem: Problem = field(
        default_factory=lambda: solar_sail.problem(load_mission("earth_mars").problem, GUESS)
    )
    found: dict[str, Trial] = field(default_factory=dict)

    def trial(self, name: str) -> Trial:
        """What became of one solver."""
        if name not in self.found:
            self.found[name] = self._tried(name, WAYS[name])
        return self.found[name]

    def _tried(self, name: str, way: Way) -> Trial:
        guess, settings = way.guess, way.settings
        if way.after:
            settings += f"; from the solution of {way.after}"
            near = self.trial(way.after).solved
            guess = near.solution if near else None
        began = time.perf_counter()
        try:
            if way.after and guess is None:
                raise SailnetError("has nothing to begin at: the solver before it found no solution")
            found = way.solve(self.problem, guess, options=way.options)
        except SailnetError as error:
            seconds = time.perf_counter() - began
            return Trial(name, settings, math.nan, math.nan, seconds, "no solution", str(error))
        seconds = time.perf_counter() - began
        ends = [value for kind, value in found.residuals.items() if kind in _ENDS]
        near_by = abs(found.final_time - MINIMUM) <= ROUNDING
        verdict: Verdict = "agrees" if near_by else "differs"
        worth, solved = _worth(found, near_by), Solved(self.problem, found)
        return Trial(name, settings, found.final_time, max(ends), seconds, verdict, worth, solved=solved)


def _worth(found: Solution, near: bool) -> str:
    """What a solution says of itself where its end conditions do not tell all."""
    if "mean loss" in found.residuals:
        return (
            f"mean loss {found.residuals['mean loss']:.1e}: the cone angle turns steeply before its"
            " bound, which polynomials follow slowly; the end states are met by construction"
        )
    if "delta_s_h" in found.residuals and not near:
        return (
            "a flight that arrives and no minimum: its cone angle does not minimise the Hamiltonian,"
            f" delta_s^H = {found.residuals['delta_s_h']:.2g}"
        )
    return ""

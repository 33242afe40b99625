"""Every solver on the solar sail's transfer from the Earth to Mars, the one that paper 001 prints.

What finds its own way begins at a guess that does not hold the answer: random costates, straight lines,
random weights. What only refines begins at shooting's solution, and its settings say so.
"""

import math
import time
from collections.abc import Callable, Sequence

from sailnet.errors import SailnetError
from sailnet.mission.mission import load_mission
from sailnet.ocp import arcs, collocation, delta, multiple, ponn, shooting, switch_times
from sailnet.ocp.continuation import Schedule
from sailnet.ocp.papers.row import Solved
from sailnet.ocp.papers.trial import MINIMUM, ROUNDING, Trial, Verdict
from sailnet.ocp.ponn import Chebyshev, split
from sailnet.ocp.problem import Problem
from sailnet.ocp.problems import solar_sail
from sailnet.ocp.smoothing import Exact, Saturation
from sailnet.ocp.solution import Solution

GUESS = 6.0
"""Time of flight to begin with [TU]."""

FIRST = 1e-3
"""First smoothing parameter, the paper's delta; at 0.1 neither shooting nor collocation found an extremal."""

_ENDS = ("boundary", "transversality", "largest")
"""Kinds of residuals that are errors of end conditions."""

SOLVERS = (
    "shooting",
    "shooting, exact",
    "multiple",
    "collocation",
    "arcs",
    "ponn",
    "ponn, from shooting",
    "ponn.split",
    "delta",
    "shooting, from delta",
    "delta, polished",
    "switch_times",
)


def trials(names: Sequence[str] = SOLVERS) -> list[Trial]:
    """Let solvers try, in the order of :data:`SOLVERS`.

    Args:
        names: of those that shall; the ones they begin at are run as well, unlisted.
    """
    bench = _Bench()
    return [bench.trial(name) for name in SOLVERS if name in names]


class _Bench:
    """Solvers by name, each run once."""

    def __init__(self) -> None:
        self.problem = solar_sail.problem(load_mission("earth_mars").problem, GUESS)
        self.found: dict[str, tuple[Trial, Solution | None]] = {}
        self.ways: dict[str, tuple[str, str | None, Callable[[Solution | None], Solution]]] = {
            "shooting": (
                "saturation 1e-3 to 1e-8; random costates in [-10, 10], 6 TU",
                None,
                lambda _: shooting.solve(
                    self.problem,
                    Saturation(),
                    Schedule(FIRST, 1e-8),
                    guess=shooting.RandomCostates(10.0),
                    starts=300,
                    iterations=30,
                ),
            ),
            "shooting, exact": (
                "no smoothing, switches located",
                "shooting",
                lambda near: shooting.solve(self.problem, Exact(), guess=near),
            ),
            "multiple": (
                "saturation 1e-3 to 1e-8, 10 pieces",
                "shooting",
                lambda near: multiple.solve(
                    self.problem, _given(near), Saturation(), Schedule(FIRST, 1e-8), pieces=10
                ),
            ),
            "collocation": (
                "saturation 1e-3 to 1e-8; straight lines, all costates -10, 6 TU",
                None,
                lambda _: collocation.solve(
                    self.problem, Saturation(), Schedule(FIRST, 1e-8), costate=-10.0, final_tolerance=1e-8
                ),
            ),
            "arcs": (
                "no smoothing, structure read off its guess",
                "shooting",
                lambda near: arcs.solve(self.problem, _given(near)),
            ),
            "ponn": (
                "100 Chebyshev polynomials, saturation 1e-3, mean loss 1e-5; 5 random starts, 6 TU",
                None,
                lambda _: ponn.solve(
                    self.problem,
                    Saturation(),
                    FIRST,
                    basis=Chebyshev(100),
                    points=200,
                    starts=5,
                    spread=-10.0,
                    goal=1e-5,
                    iterations=60,
                ),
            ),
            "ponn, from shooting": (
                "100 Chebyshev polynomials, saturation 1e-3, mean loss 1e-3",
                "shooting",
                lambda near: ponn.solve(
                    self.problem,
                    Saturation(),
                    FIRST,
                    guess=_given(near),
                    basis=Chebyshev(100),
                    points=200,
                    goal=1e-3,
                ),
            ),
            "ponn.split": (
                "80 Chebyshev polynomials an arc, no smoothing, mean loss 1e-6",
                "shooting",
                lambda near: split.solve(
                    self.problem, _given(near), basis=Chebyshev(80), points=160, goal=1e-6
                ),
            ),
            "delta": (
                "10 Chebyshev polynomials, GA-PSO, 40000 flights, delta_s^H tenfold; 3 TU to 9 TU",
                None,
                lambda _: delta.solve(
                    self.problem,
                    basis=delta.Chebyshev(),
                    terms=10,
                    evaluations=40_000,
                    weights=delta.Weights(minimum=10.0),
                ),
            ),
            "shooting, from delta": (
                "saturation 1e-3 to 1e-8",
                "delta",
                lambda near: shooting.solve(self.problem, Saturation(), Schedule(FIRST, 1e-8), guess=near),
            ),
            "delta, polished": (
                "12 Chebyshev polynomials, GA-PSO in a quarter of the box, 8 searches, polished, "
                "20000 flights; 3 TU to 9 TU",
                None,
                lambda _: delta.solve(
                    self.problem,
                    basis=delta.Chebyshev(),
                    terms=12,
                    evaluations=20_000,
                    weights=delta.Weights(minimum=10.0),
                    polish=delta.Polish(evaluations=500),
                    restarts=8,
                    box=0.25,
                ),
            ),
            "switch_times": ("the structure of its guess", "shooting", self._directly),
        }

    def trial(self, name: str) -> Trial:
        return self._run(name)[0]

    def _run(self, name: str) -> tuple[Trial, Solution | None]:
        if name not in self.found:
            settings, before, solve = self.ways[name]
            near = self._run(before)[1] if before else None
            if before:
                settings += f"; from the solution of {before}"
            self.found[name] = _tried(self.problem, name, settings, lambda: solve(near))
        return self.found[name]

    def _directly(self, near: Solution | None) -> Solution:
        try:
            switch_times.solve(self.problem, _given(near))
        except SailnetError as error:
            raise SailnetError(
                "takes controls that are always on a bound, for a final time as terminal cost; the cone angle"
                f" lies between its bounds for most of the way ({error})"
            ) from error
        raise SailnetError("gives lengths of arcs and no flight to judge")


def _given(near: Solution | None) -> Solution:
    if near is None:
        raise SailnetError("has nothing to begin at: the solver before it found no solution")
    return near


def _tried(
    problem: Problem, name: str, settings: str, solve: Callable[[], Solution]
) -> tuple[Trial, Solution | None]:
    began = time.perf_counter()
    try:
        found = solve()
    except SailnetError as error:
        seconds = time.perf_counter() - began
        return Trial(name, settings, math.nan, math.nan, seconds, "no solution", str(error)), None
    seconds = time.perf_counter() - began
    ends = [value for kind, value in found.residuals.items() if kind in _ENDS]
    near = abs(found.final_time - MINIMUM) <= ROUNDING
    verdict: Verdict = "agrees" if near else "differs"
    worth, solved = _worth(found, near), Solved(problem, found)
    trial = Trial(name, settings, found.final_time, max(ends), seconds, verdict, worth, solved=solved)
    return trial, found


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

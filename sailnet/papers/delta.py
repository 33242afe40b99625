"""The figures of paper 004 (the delta method), each by two other methods.

What the delta method itself reaches on these problems is in :mod:`sailnet.papers.delta_table`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

from sailnet.ocp import arcs, collocation, shooting
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import Exact, L2Norm
from sailnet.ocp.definition.solution import Solution
from sailnet.ocp.problems import asteroid_rendezvous, leo_geo, lunar_landing
from sailnet.ocp.solvers.continuation import Schedule
from sailnet.papers.row import Row, Solved
from sailnet.physics.units import DAY

PAPER = "004"

NEAR_OURS = "begun at collocation near ours smoothed"


@dataclass(frozen=True)
class Reference:
    """The two indirect solutions of a problem.

    Attributes:
        problem: poses it.
        solve: by shooting.
        check: by another method.
        method: which that is, and where it begins.
    """

    problem: Callable[[], Problem]
    solve: Callable[[], Solution]
    check: Callable[[], Solution]
    method: str


@cache
def _landing() -> Solution:
    return shooting.solve(lunar_landing.problem(), options=shooting.Options(Exact()))


@cache
def _rendezvous() -> Solution:
    problem = asteroid_rendezvous.problem()
    smoothed = shooting.solve(problem, options=shooting.Options(L2Norm(), Schedule(1.0, 1e-2)))
    return shooting.solve(problem, smoothed, options=shooting.Options(Exact()))


def _rendezvous_by_arcs() -> Solution:
    problem = asteroid_rendezvous.problem()
    lines, path = collocation.StraightLines(costate=0.1), Schedule(1.0, 1e-3)
    return arcs.solve(problem, collocation.solve(problem, lines, options=collocation.Options(L2Norm(), path)))


@cache
def _fastest() -> Solution:
    # Nothing is bounded, so no smoothing is in it.
    return shooting.solve(leo_geo.minimum_time(), options=shooting.Options(L2Norm(), 1.0))


@cache
def _thriftiest() -> Solution:
    return shooting.solve(leo_geo.minimum_fuel(), options=shooting.Options(Exact()))


def _by_arcs(problem: Problem, smoothed: Solution) -> Solution:
    """The limit on the arcs of a solution by collocation near a smoothed one."""
    near = collocation.solve(problem, smoothed, options=collocation.Options(L2Norm(), smoothed.rho))
    first = "-" if near.switches[0].rising else "+"
    switched = [(switch.time, "+" if switch.rising else "-") for switch in near.switches]
    return arcs.solve(problem, near, options=arcs.Options([(0.0, first), *switched]))


def _landing_by_arcs() -> Solution:
    problem = lunar_landing.problem()
    smoothed = shooting.solve(problem, _landing(), options=shooting.Options(L2Norm(), 1e-2))
    return _by_arcs(problem, smoothed)


def _fastest_by_collocation() -> Solution:
    options = collocation.Options(L2Norm(), 1.0, tolerance=1e-8)
    return collocation.solve(leo_geo.minimum_time(), _fastest(), options=options)


def _thriftiest_by_arcs() -> Solution:
    problem = leo_geo.minimum_fuel()
    return _by_arcs(problem, shooting.solve(problem, options=shooting.Options(L2Norm(), 1e-3)))


REFERENCES: Mapping[str, Reference] = {
    "lunar-landing": Reference(
        lunar_landing.problem,
        _landing,
        _landing_by_arcs,
        f"arcs, {NEAR_OURS}",
    ),
    "asteroid-rendezvous": Reference(
        asteroid_rendezvous.problem,
        _rendezvous,
        _rendezvous_by_arcs,
        "arcs, begun at collocation from straight lines",
    ),
    "leo-geo-time": Reference(
        leo_geo.minimum_time,
        _fastest,
        _fastest_by_collocation,
        "collocation, begun at ours",
    ),
    "leo-geo-fuel": Reference(
        leo_geo.minimum_fuel,
        _thriftiest,
        _thriftiest_by_arcs,
        f"arcs, {NEAR_OURS}",
    ),
}
"""By the problem's name."""


def rows() -> list[Row]:
    """A row a figure; takes about half a minute."""
    return [*_lunar(), *_asteroid(), *_transfer()]


def _lunar() -> list[Row]:
    landing, exact = _landing(), lunar_landing.analytic()
    solved = Solved(lunar_landing.problem(), landing)
    setting = (
        f"with g = {lunar_landing.GRAVITY} m/s^2, kappa = {lunar_landing.EXHAUST_VELOCITY:.0f} m/s and"
        f" u <= {lunar_landing.MOST_FLOW} kg/s, none of which is printed"
    )
    gravity = lunar_landing.gravity_of(8.3, 14.6)
    return [
        Row(
            PAPER,
            landing.problem,
            "final time [s]",
            "14.6",
            landing.final_time * lunar_landing.TIME,
            exact.touchdown,
            "closed form",
            "paper in error",
            f"free fall alone takes {lunar_landing.free_fall():.1f} s and thrust lengthens it;"
            f" ours {setting}",
            landing.wall_time,
            91.73,
            solved=solved,
        ),
        Row(
            PAPER,
            landing.problem,
            "time of the switch [s]",
            "8.3",
            landing.switches[0].time * lunar_landing.TIME,
            exact.ignition,
            "closed form",
            "paper in error",
            f"without loss of mass, 8.3 s and 14.6 s need g = {gravity:.2f} m/s^2, twice the Moon's;"
            f" ours {setting}",
            landing.wall_time,
            91.73,
            solved=solved,
        ),
    ]


def _asteroid() -> list[Row]:
    solution, check = _rendezvous(), REFERENCES["asteroid-rendezvous"].check()
    return [
        Row(
            PAPER,
            solution.problem,
            "switches",
            "2",
            len(solution.switches),
            len(check.switches),
            REFERENCES[solution.problem].method,
            "paper in error",
            "the printed switching function, Eq. (40), itself has three zeros, at"
            f" {', '.join(f'{t:.3f}' for t in asteroid_rendezvous.printed_switches())};"
            f" ours are at {', '.join(f'{s.time:.3f}' for s in solution.switches)};"
            f" propellant {solution.cost * 1500.0:.4f} kg, of which the paper prints nothing",
            solution.wall_time,
            None,
            solved=Solved(asteroid_rendezvous.problem(), solution),
        )
    ]


def _transfer() -> list[Row]:
    fastest, fastest_check = _fastest(), REFERENCES["leo-geo-time"].check()
    thriftiest, thrifty_check = _thriftiest(), REFERENCES["leo-geo-fuel"].check()
    choice = (
        f"thrust and Isp are not printed; ours {leo_geo.THRUST:.0f} N and {leo_geo.SPECIFIC_IMPULSE:.0f} s"
    )
    fraction = "as a share of the initial mass, since 0.7 kg of 1000 kg buy no transfer"
    day = leo_geo.TIME / DAY
    figures = [
        (fastest, fastest_check, "final time [d]", "5.4926", _days, choice),
        (fastest, fastest_check, "propellant", "0.6952 (kg)", _propellant, f"{choice}; {fraction}"),
        (
            thriftiest,
            thrifty_check,
            "final time [d]",
            "7.5538",
            _days,
            f"{choice}; given, not found: the same multiple of the minimum time,"
            f" {fastest.final_time * day:.4f} d",
        ),
        (thriftiest, thrifty_check, "propellant", "0.6771 (Kg)", _propellant, f"{choice}; {fraction}"),
    ]
    return [
        Row(
            PAPER,
            solution.problem,
            quantity,
            printed,
            value(solution),
            value(check),
            REFERENCES[solution.problem].method,
            "not reproducible",
            reason,
            solution.wall_time,
            None,
            solved=Solved(REFERENCES[solution.problem].problem(), solution),
        )
        for solution, check, quantity, printed, value, reason in figures
    ]


def _days(solution: Solution) -> float:
    return solution.final_time * leo_geo.TIME / DAY


def _propellant(solution: Solution) -> float:
    return float(1.0 - solution["m"][-1])

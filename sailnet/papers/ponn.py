"""What papers 000 and 002 print of their Pontryagin networks, beside ours and beside a second method's."""

import contextlib
import math
from collections.abc import Callable, Sequence

import numpy as np
from scipy.optimize import minimize_scalar

from sailnet.ocp import (
    ConvergenceError,
    Exact,
    HyperbolicTangent,
    Problem,
    Saturation,
    Schedule,
    Solution,
    arcs,
    ponn,
    shooting,
)
from sailnet.ocp.problems import earth_mars, intercept, mars_landing
from sailnet.ocp.solvers.ponn import Chebyshev, RandomFeatures
from sailnet.papers import logistic
from sailnet.papers.row import Row, Solved, Verdict

TABLE_2 = [
    (0.0, "61.63", "12.53", "1.0e-8", 0.01),
    (1.0, "45.54", "65.30", "1.3e-9", 0.01),
    (5.0, "23.8", "191.75", "1.5e-9", 0.01),
    (10.0, "18.62", "295.11", "3.7e-9", 0.009),
]
"""Of paper 002: Gamma, t_f [s], J, mean loss, training time [s]."""

GPOPS = [(1.0, "45.54", "65.27", 1.48), (10.0, "18.63", "294.97", 15.41)]
"""Of paper 002, by direct collocation: Gamma, t_f [s], J, time [s]."""

CLOSED_FORM, POLYNOMIALS = "closed form, minimised over the final time", "the same with Chebyshev polynomials"

BY_ARCS = "arcs, begun at shooting from random costates"

PLAIN_RHO = 0.03
"""Below it switches are sharper than the papers' training points can tell."""


def verdict(printed: str, ours: float) -> Verdict:
    """Whether a printed figure is ours to within one unit of its last digit: rounded, or cut off."""
    digit = 10.0 ** -len(printed.partition(".")[2])
    return "agrees" if abs(ours - float(printed)) < digit else "paper in error"


def closed_form(gamma: float) -> tuple[float, float]:
    """Final time [s] and cost of the unbounded intercept: J = Gamma T + 1.5 |Z|^2 / T^3, minimised."""
    r, v, a = (np.array(x) for x in (intercept.POSITION, intercept.VELOCITY, intercept.TARGET_ACCELERATION))

    def cost(time: float) -> float:
        z = r + v * time + 0.5 * a * time**2
        return float(gamma * time + 1.5 * z @ z / time**3)

    found = minimize_scalar(cost, bounds=(5.0, 100.0), options={"xatol": 1e-12})
    return float(found.x), float(found.fun)


def converged(problem: Problem, basis: RandomFeatures | Chebyshev, starts: int) -> list[Solution]:
    """The unbounded intercept by networks of the paper's size, from as many random starts as converge."""
    found = []
    options = ponn.Options(basis=basis, points=20, training="iterative least squares")
    for seed in range(starts):
        with contextlib.suppress(ConvergenceError):
            found.append(ponn.solve(problem, ponn.RandomWeights(seed=seed), options=options))
    return found


def intercept_rows(starts: int = 100) -> list[Row]:
    """Table 2 of paper 002, and what it has from direct collocation."""
    found = []
    for gamma, *printed, seconds in TABLE_2:
        found += _table_2(gamma, printed, seconds, starts)
    for gamma, t_f, j, seconds in GPOPS:
        problem = intercept.problem(gamma)
        solution = shooting.solve(problem, options=shooting.Options(Exact()))
        solved = Solved(problem, solution)
        name, (time, cost) = f"intercept, Gamma = {gamma:g}, GPOPS-II", closed_form(gamma)
        for quantity, text, ours, check in (
            ("t_f [s]", t_f, solution.final_time, time),
            ("J", j, solution.cost, cost),
        ):
            rounded = f"{ours:.{len(text.partition('.')[2])}f}"
            found.append(
                Row(
                    "002",
                    name,
                    quantity,
                    text,
                    ours,
                    check,
                    CLOSED_FORM,
                    verdict(text, ours),
                    "ours by shooting" + (f", to these digits {rounded}" if rounded != text else ""),
                    solution.wall_time,
                    seconds,
                    solved=solved,
                )
            )
    return found


def _table_2(gamma: float, printed: Sequence[str], seconds: float, starts: int) -> list[Row]:
    problem, (time, cost), (t_f, j, loss) = intercept.problem(gamma), closed_form(gamma), printed
    random = converged(problem, RandomFeatures(16), starts)
    polynomial = converged(problem, Chebyshev(16), starts)
    ours, spent = random[-1], float(np.median([solution.wall_time for solution in random]))
    worst, worst_polynomial = (
        max(solution.residuals["mean loss"] for solution in solutions) for solutions in (random, polynomial)
    )
    coarse = np.linspace(0.0, ours.final_time, 20)
    effort = sum(np.interp(coarse, ours.time, a) ** 2 for a in ours.control.T)
    trapezoid = gamma * ours.final_time + 0.5 * float(np.trapezoid(effort, coarse))
    why = f"the trapezoidal rule on the 20 training points makes it {trapezoid:.2f}"
    cut = "cut off, not rounded" if float(f"{ours.final_time:.2f}") > float(t_f) else ""
    all_of_them: Verdict = "agrees" if len(random) == starts else "not reproducible"
    as_small: Verdict = "agrees" if worst <= float(loss) else "not reproducible"
    most = "the greatest of ours from all starts is at most the paper's"
    tried = f"random starts that converge, of {starts}"
    figures: list[tuple[str, str, float, float, str, Verdict, str]] = [
        ("t_f [s]", t_f, ours.final_time, time, CLOSED_FORM, verdict(t_f, ours.final_time), cut),
        ("J", j, ours.cost, cost, CLOSED_FORM, verdict(j, ours.cost), why),
        ("mean loss", loss, worst, worst_polynomial, POLYNOMIALS, as_small, most),
        (tried, "all", len(random), len(polynomial), POLYNOMIALS, all_of_them, ""),
    ]
    name, solved = f"intercept, Gamma = {gamma:g}", Solved(problem, ours)
    return [
        Row("002", name, *figure, spent, seconds, same=figure[4] == CLOSED_FORM, solved=solved)
        for figure in figures
    ]


def bounded_rows() -> list[Row]:
    """Section 3.2 of paper 002."""
    problem = intercept.problem(1.0, intercept.BOUND)
    smooth = ponn.solve(
        problem,
        ponn.RandomWeights(0.01, starts=20),
        options=ponn.Options(
            Saturation(), Schedule(1.0, 1e-3, 0.3), Chebyshev(40), points=120, goal=5e-3, iterations=300
        ),
    )
    split = ponn.split.solve(problem, smooth, options=ponn.split.Options(basis=Chebyshev(10), points=20))
    saturated = shooting.Options(Saturation(), Schedule(1.0, 1e-4, 0.1))
    near = shooting.solve(problem, options=saturated)
    by_shooting = shooting.solve(problem, near, options=shooting.Options(Exact()))
    printed = {"t_f [s]": "51.946", "J": "67.807"}
    reason = f"not converged in eps: {logistic.reason(*printed.values())}"
    return [
        Row(
            "002",
            "intercept, +-0.7 m/s^2",
            quantity,
            printed[quantity],
            ours,
            check,
            "shooting with located switches",
            verdict(printed[quantity], ours),
            reason,
            smooth.wall_time + split.wall_time,
            None,
            solved=Solved(problem, split),
        )
        for quantity, ours, check in (
            ("t_f [s]", split.final_time, by_shooting.final_time),
            ("J", split.cost, by_shooting.cost),
        )
    ]


def _shot(problem: Problem) -> Solution:
    """A problem of least fuel by shooting from random costates."""
    options = shooting.Options(HyperbolicTangent(), Schedule(1.0, 1e-4, 0.1))
    return shooting.solve(problem, shooting.RandomCostates(starts=50), options=options)


def fuel_rows(
    problem: Problem,
    mass: float,
    neurons: int,
    points: int,
    printed: tuple[str, str, str],
    note: Callable[[], str],
) -> list[Row]:
    """Fuel by a second method and by the network, and the number of switches, as paper 000 prints them."""
    plain = ponn.solve(
        problem,
        ponn.RandomWeights(0.01, starts=20),
        options=ponn.Options(
            HyperbolicTangent(), Schedule(1.0, PLAIN_RHO, 0.3), Chebyshev(neurons), points, goal=5e-3
        ),
    )
    split = ponn.split.solve(problem, plain)
    # Begun without the network: what both find is found twice.
    smooth = _shot(problem)
    check = arcs.solve(problem, smooth)
    kilograms, seconds = split.cost * mass, plain.wall_time + split.wall_time
    reason = (
        f"not the optimum: the unsplit network does not resolve the switches; ours at rho = {plain.rho:g}"
        f" has {plain.cost * mass:.2f} kg burnt, {(1.0 - plain['m'][-1]) * mass:.2f} kg missing"
    )
    best, network_s, switches = printed

    def row(quantity: str, text: str, ours: float, other: float, why: str) -> Row:
        return Row(
            "000",
            problem.name,
            quantity,
            text,
            ours,
            other,
            BY_ARCS,
            verdict(text, ours),
            why,
            seconds,
            None,
            solved=Solved(problem, split),
        )

    return [
        row("fuel, the paper's other method [kg]", best, kilograms, check.cost * mass, note()),
        row("fuel, PoNN [kg]", network_s, kilograms, check.cost * mass, reason),
        row("switches", switches, len(split.switches), len(check.switches), ""),
    ]


def earth_mars_rows() -> list[Row]:
    """Section 4.1 of paper 000."""
    return fuel_rows(
        earth_mars.problem(), earth_mars.MASS, 70, 140, ("396.06", "396.85", "4"), lambda: "its shooting"
    )


def landing_rows() -> list[Row]:
    """Section 4.2 of paper 000."""

    def note() -> str:
        straight = _shot(mars_landing.problem(0.0))
        angle = math.degrees(mars_landing.CANT)
        return (
            f"its GPOPS-II; only with engines canted by {angle:.0f} degrees, which is not printed: without,"
            f" {straight.cost * mars_landing.MASS:.2f} kg"
        )

    return fuel_rows(mars_landing.problem(), mars_landing.MASS, 30, 120, ("267.93", "268.30", "2"), note)

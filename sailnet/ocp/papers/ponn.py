"""What papers 000 and 002 print of their Pontryagin networks, beside ours and beside a second method's."""

import math
from collections.abc import Callable

import numpy as np
from scipy.optimize import minimize_scalar

from sailnet.ocp import (
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
from sailnet.ocp.papers.row import Row, Verdict
from sailnet.ocp.ponn import Chebyshev, RandomFeatures
from sailnet.ocp.problems import earth_mars, intercept, mars_landing

TABLE_2 = [
    (0.0, "61.63", "12.53", "1.0e-8", 0.01),
    (1.0, "45.54", "65.30", "1.3e-9", 0.01),
    (5.0, "23.8", "191.75", "1.5e-9", 0.01),
    (10.0, "18.62", "295.11", "3.7e-9", 0.009),
]
"""Of paper 002: Gamma, t_f [s], J, mean loss, training time [s]."""

GPOPS = [(1.0, "45.54", "65.27", 1.48), (10.0, "18.63", "294.97", 15.41)]
"""Of paper 002, by direct collocation: Gamma, t_f [s], J, time [s]."""

PLAIN_RHO = 0.03
"""Below it switches are sharper than the papers' training points can tell."""


def rows() -> list[Row]:
    """Every figure of both papers; a few minutes."""
    return [*intercept_rows(), *bounded_rows(), *earth_mars_rows(), *landing_rows()]


def verdict(printed: str, ours: float) -> Verdict:
    """Whether a printed figure is ours to its last digit, rounded or cut off."""
    digit = 10.0 ** -len(printed.partition(".")[2])
    value = float(printed)
    return "agrees" if -0.5 * digit <= ours - value < digit else "paper in error"


def closed_form(gamma: float) -> tuple[float, float]:
    """Final time [s] and cost of the unbounded intercept: J = Gamma T + 1.5 |Z|^2 / T^3, minimised."""
    r, v, a = (np.array(x) for x in (intercept.POSITION, intercept.VELOCITY, intercept.TARGET_ACCELERATION))

    def cost(time: float) -> float:
        z = r + v * time + 0.5 * a * time**2
        return float(gamma * time + 1.5 * z @ z / time**3)

    found = minimize_scalar(cost, bounds=(5.0, 100.0), options={"xatol": 1e-12})
    return float(found.x), float(found.fun)


def network(gamma: float, basis: RandomFeatures | Chebyshev, seed: int = 0) -> Solution:
    """The unbounded intercept by a network of the paper's size, from a random start."""
    return ponn.solve(
        intercept.problem(gamma), basis=basis, points=20, training="iterative least squares", seed=seed
    )


def intercept_rows() -> list[Row]:
    """Table 2 of paper 002, and what it has from direct collocation."""
    found = []
    network(1.0, RandomFeatures(16))  # compiles
    for gamma, t_f, j, loss, seconds in TABLE_2:
        ours, exact = network(gamma, RandomFeatures(16)), network(gamma, Chebyshev(16))
        name, (time, cost) = f"intercept, Gamma = {gamma:g}", closed_form(gamma)
        coarse = np.linspace(0.0, ours.final_time, 20)
        a = np.array([np.interp(coarse, ours.time, u) for u in ours.control.T])
        trapezoid = gamma * ours.final_time + 0.5 * float(np.trapezoid((a**2).sum(axis=0), coarse))
        cut = "cut off, not rounded" if round(ours.final_time, 2) > float(t_f) + 1e-9 and gamma == 10 else ""
        by = "closed form, minimised over the final time"
        spent = (ours.wall_time, seconds)
        found += [
            Row(
                "002",
                name,
                "t_f [s]",
                t_f,
                ours.final_time,
                time,
                by,
                verdict(t_f, ours.final_time),
                cut,
                *spent,
            ),
            Row(
                "002",
                name,
                "J",
                j,
                ours.cost,
                cost,
                by,
                verdict(j, ours.cost),
                f"the trapezoidal rule on the 20 training points makes it {trapezoid:.2f}",
                *spent,
            ),
            Row(
                "002",
                name,
                "mean loss",
                loss,
                ours.residuals["mean loss"],
                exact.residuals["mean loss"],
                "the same with Chebyshev polynomials",
                "agrees" if ours.residuals["mean loss"] <= float(loss) else "not reproducible",
                "ours is at most the paper's",
                *spent,
            ),
        ]
    for gamma, t_f, j, seconds in GPOPS:
        solution = shooting.solve(intercept.problem(gamma), Exact())
        name, (time, cost) = f"intercept, Gamma = {gamma:g}, GPOPS-II", closed_form(gamma)
        for quantity, printed, value, check in (
            ("t_f [s]", t_f, solution.final_time, time),
            ("J", j, solution.cost, cost),
        ):
            found.append(
                Row(
                    "002",
                    name,
                    quantity,
                    printed,
                    value,
                    check,
                    "closed form, minimised over the final time",
                    verdict_rounded(printed, value),
                    "ours by shooting",
                    solution.wall_time,
                    seconds,
                )
            )
    return found


def verdict_rounded(printed: str, ours: float) -> Verdict:
    """The same within one unit of the last digit, for figures of a tolerance of their own."""
    digit = 10.0 ** -len(printed.partition(".")[2])
    return "agrees" if abs(ours - float(printed)) <= 1.0 * digit else "paper in error"


def bounded_rows() -> list[Row]:
    """Section 3.2 of paper 002."""
    problem = intercept.problem(1.0, intercept.BOUND)
    smooth = ponn.solve(
        problem,
        Saturation(),
        Schedule(1.0, 1e-3, 0.3),
        basis=Chebyshev(40),
        points=120,
        spread=0.01,
        starts=20,
        goal=5e-3,
        iterations=300,
    )
    split = ponn.split.solve(problem, smooth, basis=Chebyshev(10), points=20)
    by_shooting = shooting.solve(
        problem, Exact(), guess=shooting.solve(problem, Saturation(), Schedule(1.0, 1e-4, 0.1))
    )
    reason = (
        "not converged in epsilon: without it, on domains split where the bounds are reached, the network"
        " meets every condition to rounding"
    )
    return [
        Row(
            "002",
            "intercept, +-0.7 m/s^2",
            quantity,
            printed,
            ours,
            check,
            "shooting with located switches",
            verdict(printed, ours),
            reason,
            smooth.wall_time + split.wall_time,
            None,
        )
        for quantity, printed, ours, check in (
            ("t_f [s]", "51.946", split.final_time, by_shooting.final_time),
            ("J", "67.807", split.cost, by_shooting.cost),
        )
    ]


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
        HyperbolicTangent(),
        Schedule(1.0, PLAIN_RHO, 0.3),
        basis=Chebyshev(neurons),
        points=points,
        spread=0.01,
        starts=20,
        goal=5e-3,
    )
    split = ponn.split.solve(problem, plain)
    check = arcs.solve(problem, split)
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
            "arcs (shooting, no smoothing)",
            verdict(text, ours),
            why,
            seconds,
            None,
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
        straight = shooting.solve(
            mars_landing.problem(0.0), HyperbolicTangent(), Schedule(1.0, 1e-4, 0.1), starts=50
        )
        angle = math.degrees(mars_landing.CANT)
        return (
            f"its GPOPS-II; only with engines canted by {angle:.0f} degrees, which is not printed: without,"
            f" {straight.cost * mars_landing.MASS:.2f} kg"
        )

    return fuel_rows(mars_landing.problem(), mars_landing.MASS, 30, 120, ("267.93", "268.30", "2"), note)

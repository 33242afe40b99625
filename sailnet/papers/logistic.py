"""The bounded intercept of paper 002 by its own smoothing, until the parameter no longer matters.

python -m sailnet.papers.logistic sailnet/papers/RESULTS.md
"""

import argparse
import math
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.ocp import Logistic, Saturation, Schedule, Solution, shooting
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.problems import intercept

SERIES = tuple(float(f"5e-{k}") for k in range(7, 17))
"""eps; the paper's own go from 0.5 to 5e-11. Above these w costs so much that the target is hardly caught."""

LAST = 5e-11
"""The paper's last eps."""


@dataclass(frozen=True)
class Smoothed:
    """The extremal of one eps.

    Attributes:
        eps: of Eq. (61).
        final_time: t_f [s].
        cost: J without the penalty.
        penalty: eps times the integral of w^2.
        largest_w: largest |w|.
    """

    eps: float
    final_time: float
    cost: float
    penalty: float
    largest_w: float


def _problem() -> Problem:
    return intercept.problem(1.0, intercept.BOUND)


@cache
def _solutions() -> dict[float, Solution]:
    saturated = shooting.Options(Saturation(), Schedule(1.0, 1e-4, 0.1))
    guess = shooting.solve(_problem(), options=saturated)
    found: dict[float, Solution] = {}
    for eps in SERIES:
        guess = found[eps] = shooting.solve(_problem(), guess, options=shooting.Options(Logistic(), eps))
    return found


def _smoothed(eps: float, solution: Solution) -> Smoothed:
    slope = Logistic().slope / (2.0 * intercept.BOUND)
    # Rounding may take a control to its bound, where w is infinite.
    share = np.clip(solution.control / intercept.BOUND, -1.0 + 1e-16, 1.0 - 1e-16)
    w = 2.0 / slope * np.arctanh(share)
    penalty = eps * float(np.trapezoid((w**2).sum(axis=1), solution.time))
    return Smoothed(eps, solution.final_time, solution.cost, penalty, float(np.abs(w).max()))


def series() -> list[Smoothed]:
    """One extremal for each eps of SERIES."""
    return [_smoothed(eps, solution) for eps, solution in _solutions().items()]


def of_final_time(time: float) -> Smoothed:
    """The extremal that arrives at a time [s] among those of SERIES."""
    solutions = _solutions()

    def solved(log_eps: float) -> Solution:
        nearest = min(solutions, key=lambda eps: abs(math.log10(eps) - log_eps))
        options = shooting.Options(Logistic(), 10.0**log_eps)
        return shooting.solve(_problem(), solutions[nearest], options=options)

    ends = math.log10(SERIES[-1]), math.log10(SERIES[0])
    log_eps = float(brentq(lambda x: solved(x).final_time - time, *ends, xtol=1e-6))
    return _smoothed(10.0**log_eps, solved(log_eps))


def reason(time: str, cost: str) -> str:
    """Why a printed pair is not this problem's.

    Args:
        time, cost: t_f [s] and J as printed.
    """
    found = series()
    (last,) = (one for one in found if one.eps == LAST)
    limit, there = found[-1], of_final_time(float(time))
    settled = next(one for one in found if abs(one.final_time / limit.final_time - 1.0) < 1e-7)
    return (
        f"by the paper's own smoothing {last.final_time:.4f} s and {last.cost:.4f} at its last eps, {LAST:g},"
        f" where |w| reaches {last.largest_w:.0f}; {settled.final_time:.5f} s and {settled.cost:.5f} from"
        f" eps = {settled.eps:g} on; {time} s belongs to eps = {there.eps:.1e} and J = {there.cost:.3f}"
        f" ({there.cost + there.penalty:.3f} with eps w^2), not {cost}"
    )


def markdown() -> str:
    """A line for each eps of SERIES."""
    lines = ["| eps | t_f [s] | J | eps integral of w^2 | largest w |", "| --- " * 5 + "|"]
    for one in series():
        eps = f"{one.eps:.0e}".replace("e-0", "e-") + (", the paper's last" if one.eps == LAST else "")
        penalty = f"{one.penalty:.3g}" if one.penalty > 0.01 else f"{one.penalty:.1e}".replace("e-0", "e-")
        lines.append(f"| {eps} | {one.final_time:.5f} | {one.cost:.5f} | {penalty} | {one.largest_w:.0f} |")
    return "\n".join(lines)


def main() -> None:
    """Write the table into a text."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("text", type=Path, help="its block <!-- logistic --> becomes the table")
    made = software()
    origin = (
        f"Written by `python -m sailnet.papers.logistic` on {made['machine']}, {made['date']}, "
        f"revision {made['revision']}."
    )
    fill_block(parser.parse_args().text, "logistic", f"{origin}\n\n{markdown()}")


if __name__ == "__main__":
    main()

"""End conditions of a problem as residuals: end values, transversality, and H where the time is free."""

from collections.abc import Mapping
from dataclasses import dataclass

import heyoka as hy

from sailnet.ocp.definition.canonical import Canonical
from sailnet.ocp.definition.problem import TIME, Problem, costate, dot
from sailnet.physics.dynamics import Expression


@dataclass(frozen=True, eq=False)
class Ends:
    """Residuals at both ends, as expressions of time, states, costates and multipliers there.

    With n states, p end equations and k unknowns beside the trajectory (multipliers, and the final
    time if free), the initial and final residuals are 2n + k together, those ``initial`` that only say
    that a state has its given value included.

    Attributes:
        initial, final: residuals.
        initial_kinds, final_kinds: "boundary" or "transversality", for each of them.
        initial_multipliers, final_multipliers: variables, one an end equation.
    """

    initial: list[Expression]
    final: list[Expression]
    initial_kinds: list[str]
    final_kinds: list[str]
    initial_multipliers: list[Expression]
    final_multipliers: list[Expression]


def ends(problem: Problem, equations: Canonical) -> Ends:
    """Derive the end conditions of a problem under one form of its control law."""
    nu_0 = [hy.expression(f"nu_initial_{i}") for i in range(len(problem.initial_equations))]
    nu_f = [hy.expression(f"nu_final_{i}") for i in range(len(problem.final_equations))]
    start = dot(nu_0, [hy.expression(e) for e in problem.initial_equations])
    finish = hy.expression(problem.terminal_cost) + dot(
        nu_f, [hy.expression(e) for e in problem.final_equations]
    )
    initial, initial_kinds = _rows(problem, problem.initial, -start)
    final, final_kinds = _rows(problem, problem.final, finish)
    initial += problem.initial_equations
    initial_kinds += ["boundary"] * len(nu_0)
    final += problem.final_equations
    final_kinds += ["boundary"] * len(nu_f)
    if problem.time_is_free:
        final.append(equations.hamiltonian + hy.diff(finish, TIME))
        final_kinds.append("transversality")
    return Ends(initial, final, initial_kinds, final_kinds, nu_0, nu_f)


def _rows(
    problem: Problem, values: Mapping[Expression, float], cost: Expression
) -> tuple[list[Expression], list[str]]:
    rows, kinds = [], []
    for x in problem.states:
        fixed = x in values
        rows.append(x - values[x] if fixed else costate(x) - hy.diff(cost, x))
        kinds.append("boundary" if fixed else "transversality")
    return rows, kinds

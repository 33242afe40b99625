"""Pontryagin's conditions of a problem, derived: Hamiltonian, control law, canonical equations, ends.

The sign convention is the minimum principle's with a cost multiplier of one: H = L + lambda . f,
lambda' = -dH/dx, and a control affine in H sits at its upper bound where its switching function is negative.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import heyoka as hy

from sailnet.errors import SailnetError
from sailnet.ocp.definition.problem import TIME, ZERO, Bounded, Direction, Problem, costate, dot, total
from sailnet.ocp.definition.smoothing import Exact, Smoothing
from sailnet.physics.dynamics import Expression

RHO: Expression = hy.expression("rho")
"""The smoothing parameter."""


@dataclass(frozen=True)
class Singular:
    """A bounded control on its singular arc, in place of a smoothing.

    Attributes:
        control: position among the bounded controls.
        order: q; the control appears in the 2q-th time derivative of its switching function.
    """

    control: int = 0
    order: int = 1


Form = Smoothing | Singular


@dataclass(frozen=True, eq=False)
class Canonical:
    """The canonical equations of a problem under one form of its control law, as expressions.

    Attributes:
        states, costates, controls: variables.
        parameters: the problem's parameters, as variables.
        extras: the smoothing parameter, or one mode a bounded control where the law is exact or singular.
        free_hamiltonian: H of states, costates and controls.
        costate_slopes: -dH/dx, of the same.
        hamiltonian: H with the law in it.
        law: control -> expression of states and costates.
        switching: names and expressions of the switching functions, dH/du / scale.
        corners: for each of these, an expression whose zeros change the control's mode; a constant
            where nothing does.
        slopes: time derivatives of states, then costates, with the law in them.
        running_cost: with the law in it.
        surface: for a singular arc, the expressions that vanish on it.
    """

    states: list[Expression]
    costates: list[Expression]
    controls: list[Expression]
    parameters: list[Expression]
    extras: list[Expression]
    free_hamiltonian: Expression
    costate_slopes: list[Expression]
    hamiltonian: Expression
    law: dict[Expression, Expression]
    switching: list[tuple[str, Expression]]
    corners: list[Expression]
    slopes: list[Expression]
    running_cost: Expression
    surface: list[Expression]

    @property
    def variables(self) -> list[Expression]:
        """States, then costates."""
        return [*self.states, *self.costates]

    @property
    def arguments(self) -> list[Expression]:
        """Everything a compiled function of this form takes: time, variables, extras, parameters."""
        return [TIME, *self.variables, *self.extras, *self.parameters]


def canonical(problem: Problem, form: Form) -> Canonical:
    """Derive a problem's necessary conditions under a smoothing, exactly, or on a singular arc.

    Raises:
        SailnetError: if a control's minimiser has no closed form that can be derived.
    """
    return _derive(
        tuple(problem.dynamics.items()),
        tuple(problem.controls),
        hy.expression(problem.running_cost),
        tuple(problem.parameters),
        form,
    )


@cache
def _derive(
    dynamics: tuple[tuple[Expression, Expression], ...],
    controls: tuple[Bounded | Direction, ...],
    running_cost: Expression,
    parameters: tuple[str, ...],
    form: Form,
) -> Canonical:
    states = [x for x, _ in dynamics]
    costates = [costate(x) for x in states]
    slopes = [hy.expression(dx) for _, dx in dynamics]
    free = running_cost + dot(costates, slopes)
    # Reverse mode shares subexpressions: a third fewer terms to propagate than from one derivative each.
    gradient = hy.diff_tensors([free], states).gradient
    costate_slopes = [-hy.expression(slope) for slope in gradient]
    bounded = [control for control in controls if isinstance(control, Bounded)]
    law = _directions(controls, free)
    steered = hy.subs(free, law)
    one_rho = not isinstance(form, Exact | Singular)
    extras = [RHO] if one_rho else [hy.expression(f"mode_{i}") for i in range(len(bounded))]
    smoothing: Smoothing = Exact() if isinstance(form, Singular) else form
    switching, corners = [], []
    for i, control in enumerate(bounded):
        slope = hy.diff(steered, control.variable) / control.scale
        extra = RHO if one_rho else extras[i]
        bound, corner, switch = _minimiser(control, slope, smoothing, extra)
        law[control.variable] = bound
        switching.append((control.switching, switch))
        corners.append(corner)
    motion = [*slopes, *costate_slopes]
    variables = [*states, *costates]
    surface: list[Expression] = []
    if isinstance(form, Singular):
        chosen = bounded[form.control].variable
        others = {u: value for u, value in law.items() if u != chosen}
        surface, law[chosen] = _singular(
            switching[form.control][1], variables, [hy.subs(dy, others) for dy in motion], chosen, form.order
        )
    # Directions are expressions of the costates alone; throttles enter after them.
    return Canonical(
        states=states,
        costates=costates,
        controls=[u for c in controls for u in (c.variables if isinstance(c, Direction) else [c.variable])],
        parameters=[hy.expression(name) for name in parameters],
        extras=extras,
        free_hamiltonian=free,
        costate_slopes=costate_slopes,
        hamiltonian=hy.subs(free, law),
        law=law,
        switching=switching,
        corners=corners,
        slopes=[hy.subs(dy, law) for dy in motion],
        running_cost=hy.subs(running_cost, law),
        surface=surface,
    )


def _directions(controls: Sequence[Bounded | Direction], free: Expression) -> dict[Expression, Expression]:
    law: dict[Expression, Expression] = {}
    for control in controls:
        if not isinstance(control, Direction):
            continue
        primer = [hy.diff(free, a) for a in control.variables]
        if control.throttle is not None:
            primer = [hy.diff(p, control.throttle) for p in primer]
        banned = {str(a) for a in control.variables} | {str(control.throttle)}
        if any(banned & set(hy.get_variables(p)) for p in primer):
            raise SailnetError(
                f"the Hamiltonian is not linear in {', '.join(map(str, control.variables))} (times its"
                " throttle); use other controls"
            )
        size = hy.sqrt(total([p**2 for p in primer]))
        law |= {a: -p / size for a, p in zip(control.variables, primer, strict=True)}
    return law


def _minimiser(
    control: Bounded, slope: Expression, smoothing: Smoothing, extra: Expression
) -> tuple[Expression, Expression, Expression]:
    """The law of a scalar control, where its mode changes, and its switching function."""
    u = control.variable
    if str(u) not in hy.get_variables(slope):
        return smoothing.switch(slope, control.lower, control.upper, extra), slope, slope
    bar = control.minimiser
    if bar is None:
        curvature = hy.diff(slope, u)
        if str(u) in hy.get_variables(curvature):
            raise SailnetError(f"the Hamiltonian is neither affine nor quadratic in {u}; give its minimiser")
        bar = -hy.subs(slope, {u: ZERO}) / curvature
    law = smoothing.clip(bar, control.lower, control.upper, extra)
    corner = hy.expression(1.0)
    for bound in (control.lower, control.upper):
        if math.isfinite(bound):
            corner = corner * (bar - bound)
    return law, corner, hy.subs(slope, {u: law})


def _singular(
    switching: Expression,
    variables: list[Expression],
    motion: list[Expression],
    control: Expression,
    order: int,
) -> tuple[list[Expression], Expression]:
    """Differentiate the switching function until the control appears; the surface and the control."""
    surface = [switching]
    for k in range(2 * order):
        gradient = hy.diff_tensors([surface[-1]], variables).gradient
        rate = dot(gradient, motion)
        if k < 2 * order - 1:
            # The control's terms cancel here, which no simplifier need find out.
            surface.append(hy.subs(rate, {control: ZERO}))
    constant = hy.subs(rate, {control: ZERO})
    return surface, -constant / (hy.subs(rate, {control: hy.expression(1.0)}) - constant)

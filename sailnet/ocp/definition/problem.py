"""What an optimal-control problem is: symbols for the dynamics, the cost, the bounds and both ends.

Expressions are heyoka's, not CasADi's: heyoka compiles Taylor integrators with variational equations
and located events, and vectorised functions with exact derivatives, and the sail's own dynamics are
written in it, so one symbolic language serves both houses. CasADi stays outside, in the tests alone,
where it is a second opinion.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import heyoka as hy

from sailnet.errors import SailnetError
from sailnet.physics.dynamics import Expression

TIME: Expression = hy.make_vars("t")
"""The independent variable, in dynamics, costs and end conditions (there it is the final time)."""

ZERO: Expression = hy.expression(0.0)


def symbols(names: str) -> list[Expression]:
    """Variables for states, controls or parameters from their names, separated by spaces."""
    return [hy.expression(name) for name in names.split()]


def total(terms: Sequence[Expression]) -> Expression:
    """The sum of expressions; zero without any."""
    return hy.sum([ZERO, *terms])


def dot(left: Sequence[Expression], right: Sequence[Expression]) -> Expression:
    """The inner product of two vectors of expressions."""
    return total([a * b for a, b in zip(left, right, strict=True)])


@dataclass(frozen=True)
class Bounded:
    """A scalar control, bounded below and above; infinite bounds are none.

    Where the Hamiltonian is affine in it the control is bang-bang by the sign of its switching
    function S = (dH/du) / scale: the upper bound for S < 0. Where it is quadratic, the control is the
    minimiser, clipped.

    Attributes:
        variable: the control.
        lower, upper: its bounds.
        switching: name of its switching function.
        scale: what the paper divides dH/du by; a smoothing parameter is measured in its units.
        minimiser: where H is neither: its minimiser without bounds, of states and costates
            (see :func:`costate`); it is clipped.
    """

    variable: Expression
    lower: float = -math.inf
    upper: float = math.inf
    switching: str = "S"
    scale: float = 1.0
    minimiser: Expression | None = None


@dataclass(frozen=True)
class Direction:
    """A unit vector, optimally against the primer vector dH/d(direction).

    Attributes:
        variables: its components, in which the Hamiltonian must be linear.
        throttle: the non-negative control that multiplies it everywhere, if there is one; divided out
            so that the direction is defined while coasting too.
    """

    variables: tuple[Expression, ...]
    throttle: Expression | None = None


@dataclass(frozen=True)
class FreeTime:
    """A final time to be optimised.

    Attributes:
        guess: where solvers begin.
    """

    guess: float


@dataclass(frozen=True, eq=False)
class Problem:
    """Minimise terminal_cost(x(t_f), t_f) + integral of running_cost, from t = 0.

    Attributes:
        name: short, as in ``sailnet papers NAME``.
        source: paper and equations.
        dynamics: state -> its time derivative; the order is the order of all state vectors.
        controls: in the order of all control vectors (a direction contributes its components).
        final_time: a number, or free.
        initial, final: state -> its value; a state that is missing is free there.
        initial_equations, final_equations: expressions of the states (and of TIME) that vanish there.
        running_cost, terminal_cost: expressions of states, controls (running only) and TIME.
        parameters: name -> value of every other symbol; see :meth:`with_parameters`.
        costate_guess: initial costates to begin at, if good ones are known.
        units: what one unit of each dimension is, for reports.
    """

    name: str
    source: str
    dynamics: Mapping[Expression, Expression]
    controls: Sequence[Bounded | Direction]
    final_time: float | FreeTime
    initial: Mapping[Expression, float]
    final: Mapping[Expression, float] = field(default_factory=dict)
    initial_equations: Sequence[Expression] = ()
    final_equations: Sequence[Expression] = ()
    running_cost: Expression = ZERO
    terminal_cost: Expression = ZERO
    parameters: Mapping[str, float] = field(default_factory=dict)
    costate_guess: Sequence[float] | None = None
    units: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        known = {str(x) for x in [*self.states, *self.control_variables, TIME]} | set(self.parameters)
        for expression in [*self.dynamics.values(), self.running_cost]:
            self._check(expression, known)
        ends = known - {str(u) for u in self.control_variables}
        for expression in [*self.initial_equations, *self.final_equations, self.terminal_cost]:
            self._check(expression, ends)
        for x in [*self.initial, *self.final]:
            if x not in self.dynamics:
                raise SailnetError(f"{self.name}: {x} has an end value and no dynamics; add its derivative")
        for control in self.controls:
            if isinstance(control, Bounded) and not control.lower < control.upper:
                raise SailnetError(f"{self.name}: bounds of {control.variable} must satisfy lower < upper")

    def _check(self, expression: Expression, known: set[str]) -> None:
        unknown = sorted(set(hy.get_variables(hy.expression(expression))) - known)
        if unknown:
            raise SailnetError(
                f"{self.name}: {', '.join(unknown)} is no state, control or parameter that may stand here;"
                " declare it"
            )

    @property
    def states(self) -> list[Expression]:
        """State variables, in order."""
        return list(self.dynamics)

    @property
    def costates(self) -> list[Expression]:
        """Costate variables, in the order of the states."""
        return [costate(x) for x in self.dynamics]

    @property
    def control_variables(self) -> list[Expression]:
        """Control variables, in order."""
        found: list[Expression] = []
        for control in self.controls:
            found += control.variables if isinstance(control, Direction) else [control.variable]
        return found

    @property
    def bounded(self) -> list[Bounded]:
        """The scalar controls with (possibly infinite) bounds."""
        return [control for control in self.controls if isinstance(control, Bounded)]

    @property
    def names(self) -> dict[str, list[str]]:
        """Names of states, controls and switching functions, as a solution carries them."""
        return {
            "states": [str(x) for x in self.states],
            "controls": [str(u) for u in self.control_variables],
            "switching": [control.switching for control in self.bounded],
        }

    @property
    def autonomous(self) -> bool:
        """Whether time stands neither in the dynamics nor in the running cost."""
        expressions = [*self.dynamics.values(), self.running_cost]
        return not any(str(TIME) in hy.get_variables(hy.expression(e)) for e in expressions)

    @property
    def time_is_free(self) -> bool:
        """Whether the final time is optimised."""
        return isinstance(self.final_time, FreeTime)

    @property
    def time_guess(self) -> float:
        """The final time, or where to begin looking for it."""
        return self.final_time.guess if isinstance(self.final_time, FreeTime) else self.final_time

    def with_parameters(self, **values: float) -> "Problem":
        """The same problem with other values of some parameters; nothing is compiled again."""
        unknown = sorted(set(values) - set(self.parameters))
        if unknown:
            raise SailnetError(
                f"{self.name} has no parameter {', '.join(unknown)}; it has {', '.join(self.parameters)}"
            )
        return replace(self, parameters={**self.parameters, **values})


def costate(state: Expression) -> Expression:
    """The costate variable of a state variable."""
    return hy.expression(f"lambda_{state}")

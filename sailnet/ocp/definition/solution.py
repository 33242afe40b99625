"""What every solver returns, and what it raises when it has nothing to return."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypedDict

import numpy as np

from sailnet.errors import SailnetError
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class Switch:
    """A zero of a switching function, or an end of a clipped or singular arc.

    Attributes:
        time: when.
        name: of the switching function.
        rising: whether the control's value goes up.
    """

    time: float
    name: str
    rising: bool


@dataclass(frozen=True)
class Step:
    """One solve of a continuation.

    Attributes:
        rho: the continuation parameter.
        residual: largest residual reached there.
        iterations: of the solver.
        converged: whether the solver accepted it.
    """

    rho: float
    residual: float
    iterations: int
    converged: bool


class ConvergenceError(SailnetError):
    """No solver's answer met the conditions; there is none to look at.

    Attributes:
        residuals: the best that was reached, by kind.
        history: the continuation up to where it stalled.
    """

    def __init__(
        self, message: str, residuals: Mapping[str, float] | None = None, history: Sequence[Step] = ()
    ) -> None:
        self.residuals = dict(residuals or {})
        self.history = list(history)
        reached = [step for step in self.history if step.converged]
        parts = [message, *(f"{kind} residual {value:.2e}" for kind, value in self.residuals.items())]
        if self.history:
            parts.append(
                f"last step that converged: rho = {reached[-1].rho:.3e}" if reached else "none converged"
            )
        super().__init__("; ".join(parts))


class Table(TypedDict):
    """Columns of a :class:`Solution`, as ``Solution(**table, ...)`` takes them."""

    time: Array
    state: Array
    costate: Array
    control: Array
    switching: Array
    hamiltonian: Array


@dataclass
class Solution:
    """An extremal that meets the conditions of its problem.

    Attributes:
        problem: its name.
        solver: which solver found it.
        time: (m,) from 0 to the final time.
        state, costate: (m, n) along it.
        control: (m, k) along it.
        switching: (m, s) switching functions, one a bounded control (dH/du / scale).
        hamiltonian: (m,) along it.
        cost: the value of the cost functional.
        residuals: largest residual by kind: ``boundary`` (end values), ``transversality`` (costates and
            Hamiltonian at the ends), ``dynamics`` (the differential equations, relative).
        switches: in the order of time.
        history: continuation steps.
        wall_time: of the whole solve [s], compilation included.
        rho: the smoothing parameter it belongs to; 0 for none.
        names: of states, controls and switching functions.
        multipliers: of the end equations, initial ones first.
        converged: False only where a caller asked for the best point instead of an error.
        message: what the solver says of it.
    """

    problem: str
    solver: str
    time: Array
    state: Array
    costate: Array
    control: Array
    switching: Array
    hamiltonian: Array
    cost: float
    residuals: dict[str, float]
    switches: list[Switch] = field(default_factory=list)
    history: list[Step] = field(default_factory=list)
    wall_time: float = 0.0
    rho: float = 0.0
    names: dict[str, list[str]] = field(default_factory=dict)
    multipliers: Array = field(default_factory=lambda: np.zeros(0))
    converged: bool = True
    message: str = ""

    @property
    def final_time(self) -> float:
        """When it ends."""
        return float(self.time[-1])

    def __getitem__(self, name: str) -> Array:
        """(m,) history of a state, costate (``lambda_x``), control or switching function by name."""
        for kind, table in (
            ("states", self.state),
            ("controls", self.control),
            ("switching", self.switching),
        ):
            if name in self.names[kind]:
                return np.asarray(table[:, self.names[kind].index(name)])
        if name.removeprefix("lambda_") in self.names["states"]:
            return np.asarray(self.costate[:, self.names["states"].index(name.removeprefix("lambda_"))])
        raise SailnetError(f"{self.problem} has no {name!r}; it has {self.names}")

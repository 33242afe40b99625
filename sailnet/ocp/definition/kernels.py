"""Compiled, vectorised evaluation of expressions and of their exact derivatives."""

from collections.abc import Hashable, Sequence
from functools import cache
from typing import Any

import heyoka as hy
import numpy as np

from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Expression


@cache
def compiled(expressions: tuple[Expression, ...], variables: tuple[Expression, ...]) -> Any:
    """One compiled function of many expressions; compiled once."""
    return hy.cfunc(list(expressions), vars=list(variables), compact_mode=len(expressions) > 40)


@cache
def derivatives(expressions: tuple[Expression, ...], by: tuple[Expression, ...]) -> tuple[Expression, ...]:
    """The Jacobian of expressions, row by row."""
    tensors = hy.diff_tensors(list(expressions), list(by))
    return tuple(np.asarray(tensors.jacobian).ravel())


class Kernel:
    """Expressions, or their derivatives, as one compiled function of (m, v) points.

    It keeps hold of what is compiled: finding that by its expressions takes longer than evaluating it.

    Args:
        expressions: e of them.
        variables: v variables, in the order of the columns.
        by: variables to differentiate by, if it is the derivatives that are wanted.
    """

    def __init__(
        self,
        expressions: Sequence[Expression],
        variables: Sequence[Expression],
        by: Sequence[Expression] | None = None,
    ) -> None:
        rows = tuple(hy.expression(e) for e in expressions)
        self._shape: tuple[int, ...] = (len(rows),) if by is None else (len(rows), len(by))
        if by is not None and rows and by:
            rows = derivatives(rows, tuple(by))
        self._function = compiled(rows, tuple(variables)) if 0 not in self._shape else None

    def __call__(self, inputs: Array) -> Array:
        """(m, e) values, or (m, e, b) derivatives."""
        if self._function is None:
            return np.zeros((len(inputs), *self._shape))
        values = np.asarray(self._function(np.ascontiguousarray(inputs.T)))
        return values.T.reshape(len(inputs), *self._shape)


class Kernels:
    """Kernels of the same variables by name, each made at first use."""

    def __init__(self, variables: Sequence[Expression]) -> None:
        self._variables = list(variables)
        self._made: dict[Hashable, Kernel] = {}

    def __call__(
        self,
        key: Hashable,
        inputs: Array,
        expressions: Sequence[Expression],
        by: Sequence[Expression] | None = None,
    ) -> Array:
        """Evaluate the kernel of that name; the expressions must be the same for the same name."""
        if key not in self._made:
            self._made[key] = Kernel(expressions, self._variables, by)
        return self._made[key](inputs)

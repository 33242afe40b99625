"""Linear algebra on one thread.

The systems of these solvers have tens to hundreds of rows. What a second thread of BLAS computes of them it
loses by waiting, and on a machine that is shared it waits for whole time slices, many times a step: a network
of thirty polynomials took over thirty times the processor time.
"""

from collections.abc import Callable
from functools import cache, wraps
from typing import ParamSpec, TypeVar

from threadpoolctl import ThreadpoolController

P = ParamSpec("P")
Result = TypeVar("Result")


@cache
def _libraries() -> ThreadpoolController:
    # To look for them takes milliseconds; at the first solve all of them are loaded.
    return ThreadpoolController()


def on_one_thread(function: Callable[P, Result]) -> Callable[P, Result]:
    """A function in which BLAS uses one thread; outside it everything is as before."""

    @wraps(function)
    def limited(*args: P.args, **kwargs: P.kwargs) -> Result:
        with _libraries().limit(limits=1, user_api="blas"):
            return function(*args, **kwargs)

    return limited

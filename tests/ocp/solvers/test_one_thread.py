"""Linear algebra on one thread, and only where it is asked for."""

import pytest
import scipy.linalg  # noqa: F401  (the library whose threads are counted)
from threadpoolctl import threadpool_info, threadpool_limits

from sailnet.ocp.solvers.one_thread import on_one_thread


def threads() -> set[int]:
    return {library["num_threads"] for library in threadpool_info() if library["user_api"] == "blas"}


def test_one_thread_within_and_as_many_as_before_outside() -> None:
    @on_one_thread
    def within(error: bool) -> set[int]:
        """What it does."""
        if error:
            raise ValueError
        return threads()

    assert within.__doc__ == "What it does."
    with threadpool_limits(2, user_api="blas"):
        assert threads() == {2}
        assert within(error=False) == {1}
        assert threads() == {2}
        with pytest.raises(ValueError):  # noqa: PT011
            within(error=True)
        assert threads() == {2}

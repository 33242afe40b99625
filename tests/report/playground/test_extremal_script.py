"""Expressions of heyoka as JavaScript; that they are the equations of the expert test_page.py shows."""

import heyoka as hy
import pytest

from sailnet.report.playground.extremal_script import javascript


def test_expressions_are_written_as_they_are_read() -> None:
    x, y = hy.make_vars("x", "y")
    assert javascript(x + 2.0 * y) == "(x + (2.0 * y))"
    assert javascript(-(x**3.0)) == "(-Math.pow(x, 3.0))"
    assert javascript(hy.atan2(y, x)) == "Math.atan2(y, x)"
    assert javascript(hy.select(hy.gt(x, y), x, hy.cos(y))) == "((x > y) ? x : Math.cos(y))"


def test_what_is_not_known_is_refused() -> None:
    x, _ = hy.make_vars("x", "y")
    with pytest.raises(ValueError, match="no JavaScript is known here"):
        javascript(hy.erf(x))
    long = x
    for _ in range(12):
        long = hy.sin(long) * hy.cos(long)
    with pytest.raises(ValueError, match="does not write"):
        javascript(long)

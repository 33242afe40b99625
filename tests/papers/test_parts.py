"""The list of figures is whole, and says what a part needs."""

import inspect
import subprocess
import sys

import pytest

from sailnet.errors import SailnetError
from sailnet.papers import bbsr, delta, parts, ponn
from sailnet.papers.row import Row


def test_every_function_that_gives_rows_is_in_the_table() -> None:
    listed = {part.rows for part in parts.PARTS}
    inner = {bbsr.goddard_rows, ponn.fuel_rows}
    giving = {
        function
        for module in (bbsr, delta, ponn)
        for name, function in inspect.getmembers(module, inspect.isfunction)
        if function.__annotations__.get("return") == list[Row] and not name.startswith("_")
    }
    assert inner < giving
    assert giving - inner <= listed


def test_what_is_not_installed_is_named_before_any_work() -> None:
    part = parts.Part("900", ("kite",), lambda: pytest.fail("computed"), (("no_such_module", "ocp"),))
    with pytest.raises(SailnetError, match=r"kite needs no_such_module, .* pip install 'sailnet\[ocp\]'"):
        parts.chosen([part], "kite")
    # What is not asked for need not be there, and a wrong name is told first.
    other = parts.Part("901", ("cart",), list)
    assert parts.chosen([part, other], "cart") == [other]
    with pytest.raises(SailnetError, match="the problems kite, cart"):
        parts.chosen([part, other], "nosuch")


@pytest.mark.slow
def test_only_the_sail_needs_pygmo() -> None:
    """In a process that cannot import it, all else is there, and what needs it says what to install."""
    script = """
import sys
sys.modules["pygmo"] = None
from sailnet import cli
from sailnet.papers import parts
for part in parts.PARTS[:-1]:
    part.check()
assert [cli.main(["papers", name]) for name in ("nosuch", "sail")] == [1, 1]
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout == ""
    wrong, missing = done.stderr.splitlines()
    assert "no paper or problem is called nosuch; the papers are 000, 002" in wrong
    assert "pip install 'sailnet[ocp]'" in missing

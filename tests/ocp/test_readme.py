"""The example of the library's README."""

import re
from pathlib import Path
from typing import Any

import pytest

README = Path(__file__).parents[2] / "sailnet/ocp/README.md"


def test_the_example_of_the_readme() -> None:
    found = re.search(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    assert found
    names: dict[str, Any] = {}
    exec(found[1], names)
    # By hand: full thrust one way for 1, the other way for 1.
    for solution in (names["limit"], names["check"]):
        assert solution.final_time == pytest.approx(2.0, abs=1e-9)
        assert [switch.time for switch in solution.switches] == pytest.approx([1.0], abs=1e-9)

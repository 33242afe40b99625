"""One form for every solver, and options that are checked when they are built."""

import inspect
import math
from dataclasses import FrozenInstanceError, fields
from types import ModuleType
from typing import Any

import pytest

from sailnet.errors import SailnetError
from sailnet.ocp import (
    Exact,
    Schedule,
    arcs,
    collocation,
    delta,
    multiple,
    ponn,
    reach,
    shooting,
    survey,
    switch_times,
)

SOLVERS: dict[str, ModuleType] = {
    "shooting": shooting,
    "multiple": multiple,
    "collocation": collocation,
    "arcs": arcs,
    "ponn": ponn,
    "ponn.split": ponn.split,
    "delta": delta,
    "switch_times": switch_times,
    "reach": reach,
    "survey": survey,
}


@pytest.mark.parametrize("name", SOLVERS)
def test_a_problem_a_guess_and_options(name: str) -> None:
    module = SOLVERS[name]
    solve = module.extremals if name == "survey" else module.solve
    parameters = inspect.signature(solve).parameters
    assert list(parameters) == ["problem", "guess", "options"]
    assert parameters["options"].kind is inspect.Parameter.KEYWORD_ONLY
    assert parameters["options"].default is None
    # Every option has its line.
    for field in fields(module.Options):
        assert f"{field.name}:" in (inspect.getdoc(module.Options) or "").replace(", ", ":"), field.name
    options = module.Options()
    with pytest.raises(FrozenInstanceError):
        options.goal = 1.0
    number = "goal" if hasattr(options, "goal") else "tolerance"
    for value in (0.0, -1.0, math.nan):
        with pytest.raises(SailnetError, match=f"Options: {number} must be greater than zero"):
            module.Options(**{number: value})


@pytest.mark.parametrize(
    ("build", "wrong", "said"),
    [
        (shooting.Options, {"iterations": 0}, "shooting.Options: iterations is 0; give at least 1"),
        (shooting.Options, {"rough": 0.0}, "shooting.Options: rough must be greater"),
        (multiple.Options, {"pieces": 0}, "pieces is 0"),
        (arcs.Options, {"order": 0}, "order is 0"),
        (reach.Options, {"retreats": -1}, "retreats is -1; give at least 0"),
        (delta.Options, {"nodes": 1}, "delta.Options: nodes is 1; give at least 2"),
        (delta.Options, {"terms": 0}, "terms is 0"),
        (delta.RandomSeries, {"searches": 0}, "RandomSeries: searches is 0"),
        (delta.RandomSeries, {"box": 0.0}, "box must be greater"),
        (shooting.RandomCostates, {"starts": 0}, "RandomCostates: starts is 0"),
        (ponn.RandomWeights, {"starts": 0}, "RandomWeights: starts is 0"),
        (collocation.StraightLines, {"nodes": 2}, "nodes is 2"),
        (multiple.Options, {"smoothing": Exact()}, "cannot locate switches"),
        (collocation.Options, {"smoothing": Exact()}, "cannot locate switches"),
        (ponn.Options, {"smoothing": Exact()}, "cannot locate switches"),
        (Schedule, {"start": 1e-3, "end": 1.0}, "goes down"),
        (Schedule, {"factor": 1.0}, "between 0 and 1"),
    ],
)
def test_what_makes_no_sense_is_refused(build: Any, wrong: dict[str, Any], said: str) -> None:
    with pytest.raises(SailnetError, match=said):
        build(**wrong)

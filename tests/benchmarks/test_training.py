"""The race of optimisers: who is judged how. How fast they are is not for tests."""

import sys
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import pytest
import torch
from torch import Tensor

from benchmarks.training import (
    ABSENT,
    CONTESTANTS,
    Outcome,
    as_module,
    as_parameters,
    contest,
    race,
    table,
)
from tests.tools import needs_peer
from training.layers import Layers, forward
from training.least_squares import LeastSquares
from training.train import Problems

torch.set_num_threads(1)

LAYERS = Layers((2, 3, 3, 1))
PEERS = {"torch-levenberg-marquardt": needs_peer("torch_levenberg_marquardt")}


def _problem(samples: int, seed: int) -> LeastSquares:
    inputs = torch.rand(2, samples, generator=torch.Generator().manual_seed(seed), dtype=torch.float64)
    return LeastSquares.of(LAYERS, inputs, inputs[0] * inputs[1])


@pytest.fixture(scope="module")
def run() -> Problems:
    return Problems(_problem(600, 1), _problem(100, 2), _problem(100, 3))


def test_module_computes_the_same_network_and_gives_its_parameters_back(run: Problems) -> None:
    parameters = LAYERS.initial(1)
    module = as_module(LAYERS, parameters)
    assert torch.equal(as_parameters(module), parameters)
    expected = forward(LAYERS.matrices(parameters), run.test.inputs)[1][0]
    torch.testing.assert_close(module(run.test.inputs[:-1].T)[:, 0], expected, rtol=1e-13, atol=1e-13)


@pytest.mark.slow
@pytest.mark.parametrize("who", [pytest.param(who, marks=PEERS.get(who, ())) for who in CONTESTANTS])
def test_contestants_lower_the_error_from_the_same_start(who: str, run: Problems) -> None:
    *_, last = islice(CONTESTANTS[who](run.train, 5, 1e9), 200)
    assert run.train.loss(last) < 0.2 * run.train.loss(LAYERS.initial(5))


def _walk(*vectors: Tensor) -> Iterator[Tensor]:
    yield from vectors


def test_the_best_by_validation_is_judged_and_the_goal_is_the_test_error(run: Problems) -> None:
    steps = CONTESTANTS["sailnet"](run.train, 5, 1.0)
    path = [next(steps) for _ in range(12)]
    good, bad = path[-1], path[0]
    reached = run.test.loss(good)
    outcome = race(run, lambda *_: _walk(bad, good, bad), 5, 1e9, 0.0, to_goal=False)
    assert (outcome.steps, outcome.test_mse, outcome.goal_seconds) == (3, reached, None)
    goal = max(reached, run.validation.loss(good))
    stopped = race(run, lambda *_: _walk(bad, good, bad), 5, 1e9, goal, to_goal=True)
    assert (stopped.steps, stopped.test_mse, stopped.goal_seconds) == (2, reached, stopped.seconds)
    none = race(run, lambda *_: _walk(bad), 5, 0.0, goal, to_goal=True)
    assert (none.steps, none.goal_seconds) == (0, None)


@pytest.mark.slow
def test_all_are_compared_and_an_absent_package_is_named(
    stored: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "torch_levenberg_marquardt", None)
    outcomes = contest(stored, "alpha_pre", 1, 0.3)
    assert list(outcomes) == ["sailnet", "Adam"]
    assert capsys.readouterr().err.splitlines() == [ABSENT]
    assert all(outcome.steps > 0 and outcome.test_mse > 0.0 for outcome in outcomes.values())


def test_table_has_a_row_for_each() -> None:
    rows = table(
        {"tau": {"sailnet": Outcome(12.3, 45, 9.87e-9, 12.3), "Adam": Outcome(12.4, 6, 1e-5, None)}}
    ).splitlines()
    assert rows[2] == "| tau | 1.00e-08 | sailnet | 12 | 45 | 9.87e-09 | 12 s |"
    assert rows[3] == "| tau | 1.00e-08 | Adam | 12 | 6 | 1.00e-05 | never |"

"""Trainings compared in flight: what networks lack is from the first; the table says how far means differ."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.flown_tables import cells_of
from benchmarks.trainings import completed, lines_of
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import scores_of
from sailnet.errors import NetworkError
from sailnet.networks.guidance_networks import NAMES
from sailnet.networks.network import load_network, save_network
from tests.campaign.small_plan import GUIDANCE, MISSION, plan_of
from tests.random_networks import random_guidance, random_plan_networks, save_guidance
from training.targets import TARGETS


def test_networks_of_plans_that_are_lacking_are_the_first_trainings(tmp_path: Path) -> None:
    """Scaled by the ranges of the networks given, as the export asks of them, and otherwise the same."""
    given, first, whole = (tmp_path / name for name in ("given", "first", "whole"))
    for folder in (given, first):
        folder.mkdir()
    given_law, first_law = (random_guidance(seed=seed, approach=True) for seed in (1, 2))
    wider = replace(first_law.tau, input_max=1.25 * first_law.tau.input_max)
    save_guidance(given_law, given)
    for network in (wider, *first_law.all[1:], *random_plan_networks().all):
        save_network(
            replace(network, input_min=wider.input_min, input_max=wider.input_max),
            first / f"{network.name}.safetensors",
        )
    completed(given, first, whole)
    for name in NAMES:
        assert (whole / f"{name}.safetensors").read_bytes() == (given / f"{name}.safetensors").read_bytes()
    low, high = given_law.tau.input_min, given_law.tau.input_max
    inputs = np.random.default_rng(5).uniform(low, high, (100, len(low)))
    for name in set(TARGETS["wide"]) - set(NAMES):
        before, after = (load_network(folder / f"{name}.safetensors") for folder in (first, whole))
        np.testing.assert_array_equal([after.input_min, after.input_max], [low, high])
        np.testing.assert_allclose(after(inputs), before(inputs), rtol=1e-12, atol=1e-12)
    (given / f"{NAMES[0]}.safetensors").unlink()
    with pytest.raises(NetworkError):
        completed(given, first, tmp_path / "again")


@pytest.mark.slow
def test_the_table_has_a_row_for_each_training(tmp_path: Path) -> None:
    series = [
        {"name": "nominal", "flights": 3, "optima": 3},
        {"name": "noise", "flights": 3, "optima": 3, "disturbance": {"beta_noise": 0.1}},
    ]
    scores = scores_of(fly_plan(MISSION, GUIDANCE, plan_of(series=series), tmp_path / "x.h5"))
    lines = lines_of(MISSION, [("seed 1", "1e-6", scores), ("seed 2", "2e-6", scores)])
    heads, _, first, second = lines[2:6]
    assert heads.endswith("| nominal | noise |")
    assert first == f"| seed 1 | 1e-6 | {cells_of(scores[0])} | {cells_of(scores[1])} |"
    assert second.startswith("| seed 2 | 2e-6 | ")
    mean = f"{100.0 * scores[0].excess.relative.mean:.4f}" if scores[0].excess else ""
    assert f"from {mean} to {mean} %" in lines[-1]

"""The networks that come with the package: what the README promises of them."""

from pathlib import Path

import numpy as np
import pytest

from export.agreement import compare, sails_of_box
from sailnet.backends import Backend, load_guidance
from sailnet.flight import Disturbance, fly
from sailnet.mission import Mission, shipped_missions
from sailnet.montecarlo import evaluate, summarise
from sailnet.networks import load_guidance_networks
from sailnet.report.paper import CASES, NOISE, NOISE_START

SHIPPED = Path(__file__).parent.parent / "sailnet" / "shipped"


def test_every_shipped_set_belongs_to_a_shipped_mission() -> None:
    names = {folder.name for folder in SHIPPED.iterdir()}
    assert names
    assert names <= set(shipped_missions())


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("backend", ["c", "onnx"])
def test_the_papers_cases_end_on_the_target(mission: Mission, case: str, backend: Backend) -> None:
    flight = fly(mission, load_guidance(mission, backend), [CASES[case]])
    assert flight.arrived.all()
    assert flight.terminal_error.max() < 2e-4


def test_c_and_onnx_fly_to_the_same_place(mission: Mission) -> None:
    starts = np.array([*CASES.values(), NOISE_START])
    noise = Disturbance(beta_noise=NOISE, seed=8)
    ends = [
        fly(mission, load_guidance(mission, backend), starts, disturbance=noise).ends
        for backend in ("c", "onnx")
    ]
    np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-9)


def test_most_random_starts_arrive_and_no_command_leaves_the_bound(mission: Mission) -> None:
    guidance = load_guidance(mission, "c")
    campaign = summarise(list(evaluate(mission, guidance, 100, Disturbance(seed=77), period=0.01)))
    assert campaign.success_share > 0.5
    assert campaign.attitude_violations(mission.problem.phi_max) == 0


def test_c_onnxruntime_and_pytorch_agree() -> None:
    folder = SHIPPED / "earth_mars"
    networks = load_guidance_networks(folder)
    for record in compare(networks, folder, sails_of_box(networks, 100_000, seed=3)):
        largest, median = record["largest"], record["median"]
        assert isinstance(largest, float)
        assert isinstance(median, float)
        if record["precision"] == "float64":
            assert largest < 1e-12
        else:
            # Steep networks round in single precision, in PyTorch and onnxruntime too: the report says
            # how many states are within 1e-6 and how far the worst is.
            assert median < 1e-6
            assert largest < 5e-4


def test_the_model_card_tells_the_data_set() -> None:
    networks = load_guidance_networks(SHIPPED / "earth_mars")
    card = (SHIPPED / "earth_mars" / "MODEL_CARD.md").read_text()
    assert str(networks.tau.provenance["dataset"]) in card
    for network in (networks.tau, networks.alpha_pre, networks.lambda_v):
        assert f"{network.provenance['test_mse']:.2e}" in card

"""The networks that come with the package: what the README promises of them."""

from typing import get_args

import numpy as np
import pytest

from export.agreement import compare, compare_directions, sails_of_box
from sailnet.campaign.printed import CASE_ERROR, CASE_OPTIMUM, CASES, NOISE, NOISE_START
from sailnet.campaign.random_flights import fly_random_starts
from sailnet.campaign.scores import attitude_violations
from sailnet.expert.fastest import solve
from sailnet.flight.closed_loop import fly
from sailnet.guidance.backends import Backend, load_guidance, missions_with_networks
from sailnet.guidance.interface import Layout, Precision
from sailnet.guidance.rules import RULES
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission, load_mission, shipped_missions
from sailnet.networks.guidance_networks import load_guidance_networks
from sailnet.networks.plan_networks import load_plan_networks
from tests.paths import ROOT

SHIPPED = ROOT / "sailnet" / "shipped"


def test_every_shipped_set_belongs_to_a_shipped_mission() -> None:
    names = {folder.name for folder in SHIPPED.iterdir() if folder.is_dir()}
    assert names
    assert names <= set(shipped_missions())
    # What is told of and flown by the processors is what setup.py finds to compile.
    compiled = {source.parent.name for source in SHIPPED.glob("*/sailnet_guidance.c")}
    assert missions_with_networks() == sorted(names) == sorted(compiled)


@pytest.mark.parametrize(("name", "optimum"), [("earth_mars_jpl", 7.4397331), ("earth_mars_nasa", 7.4562960)])
@pytest.mark.parametrize("precision", ["float64", "float32"])
def test_real_sails_fly_near_their_own_optimum(name: str, optimum: float, precision: Precision) -> None:
    """From the Earth's orbit; the optima are by DOP853 in Cartesian coordinates, the control minimised."""
    own = load_mission(name)
    flight = fly(own, load_guidance(own, precision=precision), [[1.0, 0.0, 1.0]])
    assert flight.arrived.all()
    assert flight.reversals[0] <= 1
    # Flights end within 0.005 TU of the target.
    assert optimum - 0.005 < flight.time_of_flight[0] < 1.002 * optimum


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("period", [0.001, 0.005, 0.02])
def test_the_papers_cases_end_nearer_to_the_target_than_the_papers(
    mission: Mission, case: str, period: float
) -> None:
    flight = fly(mission, load_guidance(mission, "c"), [CASES[case]], period=period)
    assert flight.arrived.all()
    assert np.all(flight.terminal_error[0] <= CASE_ERROR[case])
    assert flight.time_of_flight[0] < 1.004 * CASE_OPTIMUM[case]


@pytest.mark.slow
@pytest.mark.parametrize("backend", ["c", "onnx"])
@pytest.mark.parametrize("precision", ["float64", "float32"])
def test_every_back_end_and_precision_ends_on_the_target(
    mission: Mission, backend: Backend, precision: Precision
) -> None:
    flight = fly(mission, load_guidance(mission, backend, precision), [*CASES.values()])
    assert flight.arrived.all()
    # In float the distance from the target is known to 1e-7 AU, as much as what is left of it at the end.
    assert flight.terminal_error.max() < (5e-6 if precision == "float64" else 3e-4)


@pytest.mark.slow
def test_both_layouts_and_onnx_fly_to_the_same_place(mission: Mission) -> None:
    starts = np.array([*CASES.values(), NOISE_START])
    noise = Disturbance(beta_noise=NOISE, seed=8)
    guidances = [load_guidance(mission, layout=layout) for layout in get_args(Layout)]
    guidances.append(load_guidance(mission, "onnx"))
    flight, *others = (fly(mission, guidance, starts, disturbance=noise).ends for guidance in guidances)
    # A correction ends where the residual is below the goal: rounding may decide of one more step.
    for ends in others:
        np.testing.assert_allclose(ends, flight, rtol=0, atol=1e-5)
        assert not np.array_equal(ends, flight)


@pytest.mark.parametrize(
    ("disturbance", "least"),
    [
        (Disturbance(seed=77), 120),
        (Disturbance(beta_spread=0.15, seed=77), 119),
        (Disturbance(beta_spread=0.15, beta_noise=0.15, seed=77), 117),
        (Disturbance(beta_spread=0.05, beta_drift=-0.003, seed=77), 119),
    ],
)
def test_random_starts_arrive_with_a_sail_nobody_knows(
    mission: Mission, disturbance: Disturbance, least: int
) -> None:
    guidance = load_guidance(mission, "c")
    flights = fly_random_starts(mission, guidance, 120, disturbance, period=0.01)
    assert flights.arrived.sum() >= least
    assert attitude_violations(flights, mission.problem.phi_max) == 0
    if not disturbance.beta_noise:
        # The estimate has found the sail, whatever it is; behind a drift it lags by its memory at most.
        real = 1.0 + flights.beta_error
        real *= 1.0 + disturbance.beta_drift * flights.time_of_flight
        estimate = flights.beta_estimate / mission.sail.beta
        lag = 1.2 * abs(disturbance.beta_drift) * RULES.memory
        np.testing.assert_allclose(estimate, real, rtol=max(lag, 1e-3))


@pytest.mark.slow
def test_flights_are_nearly_as_fast_as_the_optimum(mission: Mission) -> None:
    guidance = load_guidance(mission, "c")
    starts = np.array([[1.0, 0.0, 1.0], [1.03, 0.05, 0.9], [1.1, 0.02, 0.95], [1.12, 0.08, 0.85]])
    flights = fly(mission, guidance, starts)
    gaps = flights.time_of_flight / [solve(mission.problem, s).time_of_flight for s in starts] - 1.0
    assert np.all(np.abs(gaps) < 0.01)
    assert gaps.mean() < 0.003


@pytest.mark.slow
def test_c_onnxruntime_and_pytorch_agree() -> None:
    folder = SHIPPED / "earth_mars"
    networks = load_guidance_networks(folder)
    plan = load_plan_networks(folder, networks.mission)
    assert plan is not None
    sails = sails_of_box(networks, 100_000, seed=3)
    records = [*compare(networks, folder, sails), *compare_directions(plan, folder, sails)]
    assert {record["precision"] for record in records} == {"float32", "float64"}
    for record in records:
        largest, median = record["largest"], record["median"]
        assert isinstance(largest, float)
        assert isinstance(median, float)
        if record["precision"] == "float64":
            assert largest < 1e-12
        else:
            # Steep networks round in single precision, in PyTorch and onnxruntime too: the model card
            # says how far the worst is.
            assert median < 1e-6
            assert largest < 5e-4


def test_the_model_card_tells_the_data_set() -> None:
    networks = load_guidance_networks(SHIPPED / "earth_mars")
    card = (SHIPPED / "earth_mars" / "MODEL_CARD.md").read_text()
    assert str(networks.tau.provenance["dataset"]) in card
    plan = load_plan_networks(SHIPPED / "earth_mars", networks.mission)
    assert plan is not None
    for network in (*networks.all, *plan.all):
        assert f"{network.provenance['test_mse']:.2e}" in card

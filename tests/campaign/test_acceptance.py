"""The acceptance campaign as tables: what its flights give, whoever computes it."""

import numpy as np
import pytest

from sailnet.campaign.acceptance import CAMPAIGN, acceptance_table, headline_table
from sailnet.campaign.plan import load_plan
from sailnet.campaign.printed import CASES
from sailnet.campaign.results import Results
from sailnet.campaign.run import fly_plan
from sailnet.expert.fastest import solve_states
from sailnet.flight.closed_loop import fly
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import load_guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import load_mission

MISSION = load_mission("earth_mars")
GUIDANCE = load_guidance(MISSION)
FLIGHTS = 4


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Results:
    plan = load_plan(CAMPAIGN).changed(FLIGHTS, None)
    return fly_plan(MISSION, GUIDANCE, plan, tmp_path_factory.mktemp("acceptance") / "x.h5")


def cells(lines: list[str]) -> list[list[str]]:
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("|")]


def triple(values: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> str:
    return "(" + ", ".join(f"{value:.1e}" for value in values) + ")"


def test_the_table_is_that_of_the_flights(flown: Results) -> None:
    rows = cells(acceptance_table(flown))
    starts = random_starts(MISSION, FLIGHTS, 2)
    optima = solve_states(MISSION.problem, starts).time_of_flight
    for name, disturbance in {
        "nominal": Disturbance(seed=2),
        "unknown bias": Disturbance(beta_spread=0.15, seed=2),
        "unknown bias and white noise": Disturbance(beta_spread=0.15, beta_noise=0.15, seed=2),
        "unknown bias and slow drift": Disturbance(beta_spread=0.05, beta_drift=-0.003, seed=2),
    }.items():
        flights = fly(MISSION, GUIDANCE, starts, disturbance=disturbance)
        (row,) = (row for row in rows if row[0] == f"{FLIGHTS}, {name}")
        assert row[1].startswith(f"{flights.arrived.sum()} (")
        near = flights.arrived & (flights.terminal_error <= 1e-4).all(axis=1)
        assert row[2] == f"{100 * near.mean():.2f} %"
        median, late = np.quantile(flights.terminal_error, [0.5, 0.99], axis=0)
        assert row[3:5] == [triple(median), f"{late.max():.1e}"]
        gap = (flights.time_of_flight / optima - 1)[flights.arrived]
        assert row[5] == ", ".join(f"{100 * value:.3f} %" for value in np.quantile(gap, [0.5, 0.99, 1.0]))


def test_the_cases_are_those_of_the_paper_at_every_period(flown: Results) -> None:
    rows = [row for row in cells(acceptance_table(flown)) if row[0] in CASES]
    expected = []
    for name, start in CASES.items():
        for period in (0.001, 0.002, 0.005, 0.01, 0.02):
            flight = fly(MISSION, GUIDANCE, [start], period=period)
            error, time = triple(flight.terminal_error[0]), f"{flight.time_of_flight[0]:.5f}"
            expected.append([name, f"{period:g}", error, time])
    assert rows == expected


def test_the_headline_has_a_row_a_series(flown: Results) -> None:
    whole, few = cells(acceptance_table(flown)), cells(headline_table(flown))
    assert [row[0] for row in few[2:]] == [
        "nominal", "unknown bias", "unknown bias and white noise", "unknown bias and slow drift", *CASES,
    ]  # fmt: skip
    assert few[2][1] == f"{FLIGHTS} of {FLIGHTS}"
    assert [row[2] for row in few[2:6]] == [row[3] for row in whole[2:6]]
    assert few[-1][1:3] == ["1 of 1", next(row[2] for row in whole if row[:2] == ["Case 2", "0.005"])]

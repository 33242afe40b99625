"""The acceptance campaign as tables: what its flights give, whoever computes it."""

import numpy as np
import pytest

from sailnet.campaign.acceptance import CAMPAIGN, acceptance_table, headline, summary_table
from sailnet.campaign.excess import counted_times
from sailnet.campaign.plan import load_plan
from sailnet.campaign.printed import CASES
from sailnet.campaign.results import Results
from sailnet.campaign.run import fly_plan
from sailnet.campaign.tables import percent, plain
from sailnet.expert.fastest import solve
from sailnet.flight.closed_loop import fly
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import load_guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import load_mission

MISSION = load_mission("earth_mars")
GUIDANCE = load_guidance(MISSION)
FLIGHTS = 3

SERIES = {
    "nominal": Disturbance(seed=2),
    "unknown bias": Disturbance(beta_spread=0.15, seed=2),
    "unknown bias and white noise": Disturbance(beta_spread=0.15, beta_noise=0.15, seed=2),
    "unknown bias and slow drift": Disturbance(beta_spread=0.05, beta_drift=-0.003, seed=2),
}


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Results:
    plan = load_plan(CAMPAIGN).changed(FLIGHTS, None)
    return fly_plan(MISSION, GUIDANCE, plan, tmp_path_factory.mktemp("acceptance") / "x.h5")


def cells(lines: list[str]) -> list[list[str]]:
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("|")]


def triple(values: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> str:
    return "(" + ", ".join(f"{value:.1e}" for value in values) + ")"


def by_head(lines: list[str], head: str) -> dict[str, str]:
    """A column of random starts, by the name of the series."""
    for table in "\n".join(lines).split("\n\n"):
        heads, _, *rows = cells(table.splitlines())
        if head in heads and heads[0] == "flown":
            return {row[0]: row[heads.index(head)] for row in rows}
    raise AssertionError(head)


def test_the_table_is_that_of_the_flights(flown: Results) -> None:
    lines = acceptance_table(flown)
    starts = random_starts(MISSION, FLIGHTS, 2)
    for number, (name, disturbance) in enumerate(SERIES.items()):
        flights = fly(MISSION, GUIDANCE, starts, disturbance=disturbance)
        rows = flown.rows(number, MISSION.flight.period)
        optima = flown.flights["own_optimal_time"][rows]
        above = counted_times(MISSION, flights, optima) / optima - 1.0
        assert by_head(lines, "mean excess over the optimum")[name].startswith(f"{percent(above.mean())} (")
        late = ", ".join(percent(value) for value in np.quantile(above, [0.5, 0.99, 1.0]))
        assert by_head(lines, "excess over the optimum: median, 99 %, worst")[name] == late
        home = int((flights.arrived & (above <= 0.5)).sum())
        assert (
            by_head(lines, "arrived without an extra revolution: within 1.5 optima")[name]
            == f"{home} of {FLIGHTS}"
        )
        reversals = ", ".join(f"{value:.0f}" for value in np.quantile(flights.reversals, [0.5, 0.99, 1.0]))
        assert by_head(lines, "attitude reversals: median, 99 %, worst")[name] == reversals
        failed = int((~flights.arrived).sum())
        assert by_head(lines, "failed")[name] == f"{failed} of {FLIGHTS}"
        near = int((flights.arrived & (flights.terminal_error <= 1e-4).all(axis=1)).sum())
        assert by_head(lines, "within 0.0001: 15,000 km, 2.98 m/s")[name] == f"{near} of {FLIGHTS}"
        median = np.median(flights.terminal_error, axis=0)
        assert by_head(lines, "median error (r, u, v) [AU, AU/TU]")[name] == triple(median)
        kilometres = f"{plain(median[0] * 149_597_870.7)} km; "
        assert by_head(lines, "median error (r, u, v)")[name].startswith(kilometres)


def test_optima_of_the_sail_as_assumed_are_the_experts(flown: Results) -> None:
    """Every series has them for all its flights."""
    starts = random_starts(MISSION, FLIGHTS, 2)
    ends = [0, FLIGHTS - 1]
    expected = [solve(MISSION.problem, start).time_of_flight for start in starts[ends]]
    for number, series in enumerate(flown.plan.whole):
        for period in flown.plan.periods_of(series, MISSION):
            rows = flown.rows(number, period)
            found = flown.flights["optimal_time"][rows]
            assert np.isfinite(flown.flights["own_optimal_time"][rows]).all()
            if len(rows) > 1:
                np.testing.assert_allclose(found[ends], expected, rtol=1e-9)


def test_the_cases_are_those_of_the_paper_at_every_period(flown: Results) -> None:
    rows = [row for row in cells(acceptance_table(flown)) if row[0] in CASES]
    expected = []
    for name, start in CASES.items():
        for period in (0.001, 0.002, 0.005, 0.01, 0.02):
            flight = fly(MISSION, GUIDANCE, [start], period=period)
            hours = f"{period:g} ({period * 5_022_642.9 / 3600.0:.1f} h)"
            slew = np.degrees(flight.command_slew[0])
            error, time = triple(flight.terminal_error[0]), f"{flight.time_of_flight[0]:.5f}"
            expected.append([name, hours, f"{slew:,.0f}", time, error])
    assert [[row[place] for place in (0, 1, 4, 5, -1)] for row in rows] == expected


def test_the_headline_has_a_row_a_series_and_leads_with_what_counts(flown: Results) -> None:
    few = cells(headline(flown).markdown())
    assert few[0][1:4] == [
        "mean excess over the optimum", "arrived without an extra revolution: within 1.5 optima",
        "attitude reversals: median, 99 %, worst",
    ]  # fmt: skip
    assert [row[0] for row in few[2:]] == [*SERIES, *CASES]
    whole = by_head(acceptance_table(flown), "mean excess over the optimum")
    assert [row[1] for row in few[2:6]] == list(whole.values())
    assert few[2][4:6] == [f"{FLIGHTS} of {FLIGHTS}", f"0 of {FLIGHTS}"]


def test_the_summary_is_short_and_agrees_with_the_tables(flown: Results) -> None:
    lines = summary_table(flown)
    assert max(map(len, lines)) <= 120
    rows = cells(lines)[2:]
    assert [row[0] for row in rows] == list(SERIES)
    means = by_head(acceptance_table(flown), "mean excess over the optimum")
    for row in rows:
        assert means[row[0]].startswith(f"{row[2].split(',')[0]} (")
        assert row[1] == f"{FLIGHTS}"

"""Scores as tables: what counts first, and words for numbers that are easily misread."""

import numpy as np
import pytest
from scipy.stats import binomtest

from sailnet.campaign.behaviour import DEGREE_PER_HOUR, behaviour_of, behaviour_record
from sailnet.campaign.own_optima import Turns
from sailnet.campaign.score_tables import beside_others
from sailnet.campaign.scores import Score, score_of
from sailnet.campaign.shares import Share, Spread
from sailnet.campaign.tables import Table, failures_text, percent, plain, score_tables, side_by_side
from sailnet.flight.closed_loop import Flights, fly
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.rules import RULES
from sailnet.mission.disturbances import Disturbance
from tests.pilots import MISSION, Constant

GUIDANCE = load_guidance(MISSION)
STARTS = [(1.0, 0.0, 1.0), (1.05, 0.15, 1.03), (1.1, 0.18, 0.93)]


TURNS = Turns(np.array([2.0, 3.4, np.nan]), np.array([1.0, 2.0, np.nan]))
NO_TURNS = Turns(*np.full((2, 30), np.nan))


def score_flights() -> Flights:
    return fly(MISSION, GUIDANCE, STARTS, disturbance=Disturbance(misalignment=0.02, rate_limit=20.0))


@pytest.fixture(scope="module")
def score() -> Score:
    return score_of(MISSION, score_flights(), np.array([7.0, 6.1, np.nan]), TURNS, [1e-4], 0, "slow", 0.005)


def test_no_failure_in_many_says_how_many_there_may_be() -> None:
    """The upper end of Wilson's interval of none."""
    high = binomtest(0, 10_000).proportion_ci(method="wilson").high
    assert failures_text(Share(10_000, 10_000)) == f"0 (at most {100 * high:.2f} %)" == "0 (at most 0.04 %)"
    assert failures_text(Share(9_978, 10_000)) == "22 (0.15 to 0.33 %)"
    assert failures_text(Share(1, 1)) == "0 of 1"


def test_time_counts_first(score: Score) -> None:
    time, attitude, known, ends = score_tables([score])
    assert time.heads[3:6] == [
        "mean excess over the optimum", "arrived without an extra revolution: within 1.5 optima",
        "attitude reversals: median, 99 %, worst",
    ]  # fmt: skip
    row = dict(zip(time.heads, time.cells[0], strict=True))
    assert score.excess is not None
    above, days = score.excess.relative, score.excess.days
    assert row["mean excess over the optimum"] == f"{percent(above.mean)} ({plain(days.mean)} days)"
    assert row["optimum unknown"] == "1"
    assert row["of the optimum as assumed"] == "2, 2, 2"
    assert row["period [TU]"] == "0.005 (7.0 h)"
    assert dict(zip(attitude.heads, attitude.cells[0], strict=True))["attitude beyond the bound"].endswith(
        "by up to 1.15°"
    )
    assert "km; " in ends.cells[0][ends.heads.index("median error (r, u, v)")]
    told = np.sort(score_flights().command_slew[:2] / TURNS.slew[:2])
    row = dict(zip(attitude.heads, attitude.cells[0], strict=True))
    assert row["slew of the command, in optima: median, 99 %"].startswith(f"{told.mean():.2f}, ")
    assert known.cells[0][3:] == ["none"] * 4
    for table in (time, attitude, known, ends):
        assert [len(row) for row in table.cells] == [len(table.heads)]
        assert len(table.lines()) == 2
        assert table.markdown()[1].count("---") == len(table.heads)


def test_a_rate_limit_is_what_the_sail_turns_by_and_not_what_it_is_told(score: Score) -> None:
    """20 rad/TU are 0.82 degrees an hour."""
    assert round(20.0 / DEGREE_PER_HOUR, 3) == 0.821
    told, done = score.behaviour.command_slew, score.behaviour.attitude_slew
    assert done.worst < told.worst


def test_behaviour_counts_flights_and_periods() -> None:
    skewed = Disturbance(misalignment=0.02, beta_bias=-0.3)
    flights = fly(MISSION, GUIDANCE, STARTS, disturbance=skewed)
    found = behaviour_of(MISSION, flights)
    assert (found.beyond.count, found.kept.count) == ((flights.beyond_bound > 0).sum(), 0)
    assert found.largest_excess == pytest.approx(np.degrees(0.02), abs=1e-9)
    assert found.at_limit_periods == flights.beta_at_limit.sum() > 0
    assert found.outside_periods == flights.outside.sum()
    straight = behaviour_of(MISSION, fly(MISSION, Constant(0.3), STARTS))
    assert (straight.reversals.worst, straight.command_slew.worst, straight.largest_excess) == (0.0, 0.0, 0.0)


def test_outages_and_what_is_reckoned_are_counted_apart() -> None:
    """Beyond the longest reckoning nothing is known, and that is no reckoning."""
    period = MISSION.flight.period
    away = Disturbance(outage_probability=0.001, outage_duration=2.0 * RULES.longest_reckoning, seed=3)
    flights = fly(MISSION, GUIDANCE, STARTS * 10, disturbance=away)
    found = behaviour_of(MISSION, flights)
    assert found.unseen.count == (flights.outages > 0).sum() > 0
    assert found.unseen_periods == flights.outages.sum()
    assert found.reckoned_periods == flights.reckoned.sum()
    assert 0 < found.reckoned_periods < found.unseen_periods - RULES.longest_reckoning / period
    assert found.reckoned.count <= found.unseen.count
    cells = score_of(MISSION, flights, np.full(30, np.nan), NO_TURNS, [], 0, "away", period)
    table = score_tables([cells])[2]
    row = dict(zip(table.heads, table.cells[0], strict=True))
    share = 100.0 * found.reckoned_periods / found.periods
    assert row["steered by dead reckoning"] == f"{found.reckoned.count} ({share:.2f} % of all periods)"
    assert row["without navigation"].startswith(f"{found.unseen.count} (")
    assert behaviour_record(found)["reckoned_periods"] == found.reckoned_periods


def test_guidances_side_by_side_keep_the_rows_of_a_series_together() -> None:
    one, other = (
        [Table("Times", ["series", "mean"], [["a", f"1{name}"], ["b", f"2{name}"]])] for name in "xy"
    )
    (both,) = side_by_side({"float64": one, "float32": other})
    assert (both.title, both.heads) == ("Times", ["series", "flown by", "mean"])
    assert both.cells == [
        ["a", "float64", "1x"], ["a", "float32", "1y"], ["b", "float64", "2x"], ["b", "float32", "2y"],
    ]  # fmt: skip


def test_a_spread_is_mean_and_quantiles() -> None:
    values = np.arange(101.0)
    assert Spread.of(values, 2.0) == Spread(25.0, 25.0, 49.5, 50.0)


def test_percents_have_the_digits_that_count() -> None:
    assert [percent(x) for x in (0.00123, 0.0456, 0.41234, 4.567, -0.0003, 5.7e-6, 0.0)] == [
        "0.123 %", "4.56 %", "41.2 %", "457 %", "-0.030 %", "0.00057 %", "0.000 %",
    ]  # fmt: skip


def test_numbers_for_people_have_no_exponent_but_where_they_are_tiny() -> None:
    assert [plain(x) for x in (4.0912e6, 663.45, 0.0161803, 1.2345e-7, 0.0)] == [
        "4,090,000", "663", "0.0162", "1.23e-07", "0",
    ]  # fmt: skip


def test_tables_of_campaigns_come_beside_those_that_stand_there() -> None:
    """In the order of names, and also where nothing stood before."""
    law, reach = (
        f"**{name}** (`{name}`, networks `1`)\n\n| {n} |" for n, name in enumerate(("law", "reach"))
    )
    assert beside_others("", reach) == beside_others("\n", reach) == reach
    assert beside_others(reach, law) == f"{law}\n\n{reach}"
    assert beside_others(f"{law}\n\n{reach}", law.replace("0", "7")) == f"{law.replace('0', '7')}\n\n{reach}"

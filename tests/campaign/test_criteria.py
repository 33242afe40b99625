"""Acceptance criteria: what is measured, on which side of its bound, and what no optimum leaves open."""

from dataclasses import replace

import numpy as np
import pytest

from sailnet.campaign.criteria import Criterion, criteria_of, criteria_table, missed
from sailnet.campaign.own_optima import Turns
from sailnet.campaign.scores import Score, score_of
from sailnet.flight.closed_loop import Ending
from sailnet.mission.acceptance import SERIES, Acceptance, Bounds
from sailnet.mission.sizes import sized
from tests.campaign.test_excess import flights_with
from tests.pilots import MISSION

NAN = float("nan")
LOOSE = Bounds(mean_excess=1e6, without_extra_revolution=0.0, failed=100.0, reversals=1e6)


def scored(name: str, optima: list[float]) -> Score:
    """Four flights: two on time, one with an extra revolution, one failed at the longest flight."""
    flights = flights_with(
        [7.0, 7.0, 14.0, MISSION.flight.longest], [0.0] * 4, [Ending.STOPPED] * 3 + [Ending.TOO_LONG]
    )
    flights = replace(flights, reversals=np.array([0, 1, 2, 9], np.uint32))
    turns = Turns(*np.full((2, 4), NAN))
    return score_of(MISSION, flights, np.array(optima), turns, [], 0, name, 0.005)


def of_nominal(**bounds: float) -> Acceptance:
    nominal = LOOSE.model_copy(update=bounds)
    return Acceptance(nominal=nominal, unknown_bias=LOOSE, white_noise=LOOSE, slow_drift=LOOSE)


def test_every_quantity_is_measured_over_all_flights() -> None:
    found = criteria_of(of_nominal(), [scored("nominal", [7.0] * 4)])
    longest = MISSION.flight.longest / 7.0 - 1.0
    assert {one.quantity: one.measured for one in found} == pytest.approx(
        {
            "mean_excess": 100.0 * (0.0 + 0.0 + 1.0 + longest) / 4,
            "without_extra_revolution": 50.0,
            "failed": 25.0,
            "reversals": 2.0 + 0.97 * 7.0,
        }
    )
    assert not missed(found)


@pytest.mark.parametrize(
    ("quantity", "met", "not_met"),
    [
        ("without_extra_revolution", 50.0, 50.01),
        ("failed", 25.0, 24.9),
        ("reversals", 8.79, 8.78),
        ("mean_excess", 1e4, 100.0),
    ],
)
def test_a_bound_that_is_just_met_passes_and_one_beyond_names_its_series(
    quantity: str, met: float, not_met: float
) -> None:
    score = scored("nominal", [7.0] * 4)
    assert not missed(criteria_of(of_nominal(**{quantity: met}), [score]))
    (only,) = missed(criteria_of(of_nominal(**{quantity: not_met}), [score]))
    assert (only.series, only.quantity, only.bound) == ("nominal", quantity, not_met)
    assert not only.passed
    assert not only.record()["passed"]
    assert sum(row[-1] == "MISSED" for row in criteria_table([only]).cells) == 1


def test_without_any_optimum_what_needs_one_is_missed() -> None:
    found = criteria_of(of_nominal(), [scored("nominal", [NAN] * 4)])
    assert [one.quantity for one in missed(found)] == ["mean_excess", "without_extra_revolution"]
    assert [one.measured for one in missed(found)] == [None, None]


def test_series_without_bounds_have_no_criteria() -> None:
    assert criteria_of(of_nominal(), [scored("Case 1", [7.0] * 4)]) == []
    found = criteria_of(of_nominal(), [scored(name, [7.0] * 4) for name in SERIES])
    assert [one.series for one in found[::4]] == list(SERIES)


def test_a_quick_run_has_wider_criteria_and_fewer_trainings() -> None:
    quick = sized(MISSION, "quick")
    for name in SERIES.values():
        full, wide = getattr(MISSION.acceptance, name), getattr(quick.acceptance, name)
        assert wide.mean_excess > full.mean_excess
        assert wide.without_extra_revolution < full.without_extra_revolution
        assert wide.failed > full.failed
    assert quick.selection.trainings < MISSION.selection.trainings


def test_a_criterion_says_what_was_measured_and_what_is_asked() -> None:
    text = str(Criterion("nominal", "mean_excess", 0.12, 3.36))
    assert "3.36 %" in text
    assert "0.12 %" in text

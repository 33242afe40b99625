"""The campaigns that come with the package: what they fly, and that their words say it."""

import re

import numpy as np
import pytest

from sailnet.campaign.behaviour import DEGREE, DEGREE_PER_HOUR
from sailnet.campaign.plan import Plan, load_plan, ready_campaigns
from sailnet.campaign.printed import CASES
from sailnet.flight.closed_loop import fly_recorded
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import GuidanceStatus
from sailnet.guidance.rules import RULES
from sailnet.mission.mission import load_mission
from sailnet.physics.units import AU, AU_PER_TU, DAY, HOUR, TU

MISSION = load_mission("earth_mars")
GUIDANCE = load_guidance(MISSION)
FLOWN_AS_LISTED = {"starts outside the trained domain": 12}


@pytest.mark.parametrize("name", ready_campaigns())
def test_ready_campaigns_can_be_flown(name: str) -> None:
    plan = load_plan(name)
    assert plan.name == name
    for series in plan.whole:
        series.disturbances(MISSION, plan.seed)
        if isinstance(series.starts, tuple):
            assert series.count == FLOWN_AS_LISTED.get(series.name, 1)
    few = {series.count for series in plan.changed(7, None).whole if not isinstance(series.starts, tuple)}
    assert few == {7}
    large = {series.count for series in plan.whole if not isinstance(series.starts, tuple)}
    assert large == {1000 if name == "paper" else 10_000}


def test_ready_campaigns_are_those_that_were_promised() -> None:
    promised = {"paper", "generalisation", "beta-bias", "beta-noise", "navigation", "actuation", "everything"}
    assert set(ready_campaigns()) == promised | {
        "acceptance",
        "ageing",
        "bad-days",
        "drawn-optics",
        "law",
        "optics",
        "reach",
    }


@pytest.mark.parametrize("name", ["acceptance", "paper"])
def test_ready_campaigns_fly_the_paper_s_cases(name: str) -> None:
    """Table 2, at several periods, so that no lucky stop counts."""
    series = {series.name: series for series in load_plan(name).series}
    for case, state in CASES.items():
        assert series[case].starts == (state,)
        assert series[case].periods == (0.001, 0.002, 0.005, 0.01, 0.02)


def disturbed(plan: Plan, series: str) -> dict[str, object]:
    (found,) = (each.disturbance for each in plan.series if each.name == series)
    return found


def test_half_and_twice_are_half_and_twice_of_each() -> None:
    """But for the rate, of which twice is half, the correlation time and the optics."""
    plan = load_plan("everything")
    expected = disturbed(plan, "as expected")
    for name, factor in (("half", 0.5), ("twice", 2.0)):
        found = disturbed(plan, name)
        assert found.keys() == expected.keys()
        for key, value in expected.items():
            same = key in ("optics", "navigation_wander_time")
            power = -1 if key == "rate_limit" else 1
            assert found[key] == (value if same else pytest.approx(float(str(value)) * factor**power)), key


def test_the_words_of_everything_are_its_numbers() -> None:
    """In units of a mission; navigation is correlated, and not white."""
    plan = load_plan("everything")
    found = disturbed(plan, "as expected")
    numbers = {key: float(str(value)) for key, value in found.items() if key != "optics"}
    assert not any(key.endswith("_noise") and key[0] in "ruv" for key in numbers)
    days, hours = TU / DAY, TU / HOUR
    rates = [float(str(disturbed(plan, name)["rate_limit"])) / DEGREE_PER_HOUR for name in ("half", "twice")]
    for words in (
        f"errors of navigation of {numbers['r_wander'] * AU / 1e3:.0f} km and "
        f"{100.0 * numbers['v_wander'] * AU_PER_TU:.1f} cm/s, correlated over 0.1 TU, "
        f"{numbers['navigation_wander_time'] * days:.1f} days",
        f"turns by {numbers['rate_limit'] / DEGREE_PER_HOUR:.1f}° an hour, "
        f"{numbers['rate_limit']:.0f} rad/TU",
        f"come {numbers['delay'] * hours:.1f} hours late",
        f"rounded to {numbers['resolution'] / DEGREE:.3f}°",
        f"askew within {numbers['misalignment_spread'] / DEGREE:.2f}°",
        f"an outage that lasts {MISSION.disturbance.outage_duration * hours:.0f} hours",
        f"turn by {rates[0]:.1f} and {rates[1]:.1f}° an hour",
    ):
        assert words in plan.text
    assert numbers["rate_limit"] / DEGREE_PER_HOUR == pytest.approx(70.0 / 3.0, rel=1e-3)
    assert numbers["rate_limit"] == pytest.approx(MISSION.flight.turn_rate, rel=1e-3)


def test_the_law_is_flown_in_eight_series_with_a_seed_of_its_own() -> None:
    plan = load_plan("law")
    assert [series.name for series in plan.series] == [
        "nominal", "bias ±15 %", "noise ±15 %, as in the paper", "wander 5 % for 1 TU", "drift −2 % a year",
        "JPL optics, networks of the ideal sail", "everything, as expected", "everything, twice",
    ]  # fmt: skip
    assert plan.seed not in {load_plan(name).seed for name in ready_campaigns() if name != "law"}
    everything = load_plan("everything")
    for name in ("as expected", "twice"):
        assert disturbed(plan, f"everything, {name}") == disturbed(everything, name)
    drift = disturbed(load_plan("acceptance"), "unknown bias and slow drift")
    assert disturbed(plan, "drift −2 % a year") == drift


def test_bad_days_are_as_bad_as_they_say() -> None:
    plan = load_plan("bad-days")
    longest = RULES.longest_reckoning
    assert f"for at most {longest:g} TU, {longest * TU / DAY:.0f} days" in plan.text
    for words, days in (("a day", 1), ("a week", 7), ("60 days, beyond the longest reckoning", 60)):
        found = disturbed(plan, f"outages of {words}")
        duration = float(str(found["outage_duration"]))
        assert duration * TU / DAY == pytest.approx(days, rel=1e-2)
        assert ("beyond" in words) == (duration > longest)
        assert found["outage_probability"] == 1e-3
    for series in plan.series:
        if told := re.search(r"([\d.]+)°/h", series.name):
            rate = float(str(series.disturbance["rate_limit"]))
            assert rate / DEGREE_PER_HOUR == pytest.approx(float(told[1]), abs=5e-3)
        elif told := re.search(r"off by ([+−])(\d)°", series.name):
            sign = {"+": 1.0, "−": -1.0}[told[1]]
            assert float(str(series.disturbance["misalignment"])) / DEGREE == pytest.approx(
                sign * int(told[2])
            )
    low, _ = GUIDANCE.beta_range
    weak = MISSION.sail.beta * (1.0 + float(str(disturbed(plan, plan.series[-2].name)["beta_bias"])))
    assert weak < low
    (outside,) = (series.starts for series in plan.whole if series.name in FLOWN_AS_LISTED)
    status = GUIDANCE.command(np.array(outside)).status
    assert (status == GuidanceStatus.OUTSIDE_DOMAIN).all()


@pytest.mark.slow
def test_bad_days_are_flown_by_the_flight_file_s_own_rules() -> None:
    """In an outage it reckons for as long as it may, then the sail faces the Sun."""
    plan = load_plan("bad-days")
    (series,) = (each for each in plan.whole if "60 days" in each.name)
    disturbance = series.disturbances(MISSION, plan.seed)
    flights, histories = fly_recorded(
        MISSION, GUIDANCE, series.states(MISSION, GUIDANCE, plan.seed, 0, 10), disturbance=disturbance
    )
    outs = 0
    for number, history in enumerate(histories):
        unseen = np.isnan(history.seen[:, 0])
        reckoned = history.status == GuidanceStatus.RECKONED
        lost = history.status == GuidanceStatus.INVALID_INPUT
        assert flights.outages[number] == unseen.sum()
        assert flights.reckoned[number] == reckoned.sum()
        assert not (reckoned & ~unseen).any()
        np.testing.assert_array_equal(history.cone_angle[lost], 0.0)
        assert np.isfinite(history.predicted_time_of_flight).all()
        starts = np.flatnonzero(unseen & ~np.roll(unseen, 1))
        for start in starts:
            upto = start + int(np.argmin(np.append(unseen[start:], False)))
            time = MISSION.flight.period * np.arange(1, upto - start + 1)
            known = time <= RULES.longest_reckoning
            # The times are added up on board, and rounded: by one period it may be the other.
            told = np.abs(time - RULES.longest_reckoning) > 0.5 * MISSION.flight.period
            ended = history.status[start:upto] == GuidanceStatus.ARRIVED
            np.testing.assert_array_equal((reckoned[start:upto] | ended)[told], known[told])
            outs += int((~known).any())
    assert outs > 0

"""Results read back are what was flown; nothing damaged or outdated goes unnoticed."""

import hashlib
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest

from sailnet.artefacts.column_files import content_digest
from sailnet.campaign import results
from sailnet.campaign.columns import LAYOUT
from sailnet.campaign.results import Results, open_results
from sailnet.campaign.run import fly_plan
from sailnet.errors import CampaignError
from sailnet.flight.closed_loop import Flights
from tests.campaign.small_plan import CASE, GUIDANCE, MISSION, assert_same, plan_of, short


def test_flights_read_back_are_what_was_stored(small: Results) -> None:
    rows = np.arange(len(small.flights["series"]))
    flights = small.as_flights(rows)
    assert isinstance(flights, Flights)
    np.testing.assert_array_equal(flights.ends[:, 2], small.flights["end_v"])
    np.testing.assert_array_equal(flights.terminal_error[:, 1], small.flights["error_u"])
    assert flights.arrived.dtype == bool


@pytest.mark.slow
def test_damage_is_noticed(tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    plan = plan_of(series=[{"name": "one", "starts": [CASE], "periods": [0.05]}])
    fly_plan(MISSION, GUIDANCE, plan, path)
    raw = path.read_bytes()
    expected = open_results(path).digest
    noticed = 0
    for position in np.random.default_rng(3).integers(0, len(raw), 60).tolist():
        path.write_bytes(raw[:position] + bytes([raw[position] ^ 16]) + raw[position + 1 :])
        try:
            found = open_results(path).digest
        except CampaignError:
            noticed += 1
        else:
            assert found == expected  # unused bytes
    assert noticed > 10
    for length in (0, 100, len(raw) // 2, len(raw) - 1):
        path.write_bytes(raw[:length])
        with pytest.raises(CampaignError, match=r"x\.h5"):
            open_results(path)
    with pytest.raises(CampaignError, match="cannot open results"):
        open_results(tmp_path / "none.h5")


def test_rows_are_found_wherever_they_are(small: Results, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a file that somebody else made they need not lie together, as ours do."""
    monkeypatch.setattr(results, "BLOCK", 7)
    series = np.array([0, 0, 1, 1, 0, 0, 0, 0, 0, 2, 1, 0])
    period = np.array([1, 1, 1, 2, 2, 1, 1, 1, 1, 1, 1, 1]) / 20
    found = replace(small, flights={"series": series, "period": period})
    for number in range(4):
        for length in (0.05, 0.1):
            expected = np.flatnonzero((series == number) & (period == length))
            np.testing.assert_array_equal(found.rows(number, length), expected, strict=True)
    none = replace(small, flights={"series": series[:0], "period": period[:0]})
    assert none.rows(0, 0.05).tolist() == []


def test_results_are_what_was_opened_whatever_replaces_them(tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    plan = plan_of(series=[{"name": "one", "starts": [CASE], "periods": [0.05]}], sample=1)
    first = fly_plan(short(1.0), GUIDANCE, plan, path)
    before, history = first.flights["start_r"][:], first.history(0)
    moved = plan_of(series=[{"name": "one", "starts": [(1.0, 0.0, 1.0)], "periods": [0.05]}])
    second = fly_plan(short(1.0), GUIDANCE, moved, path, overwrite=True)
    assert second.flights["start_r"][0] == 1.0
    assert first.flights["start_r"][:].tolist() == before.tolist() == [1.05]
    assert_same(first.history(0), history)


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("flights/series", 1, "flights/series is not from 0 to 0"),
        ("flights/ending", 4, "flights/ending is not from 1 to 3"),
        ("flights/arrived", 2, "flights/arrived is not from 0 to 1"),
        ("flights/start_u", np.nan, "flights/start_u is not finite"),
        ("flights/optimal_time", np.inf, "flights/optimal_time is not finite"),
        ("kept/flight", 1, "kept/flight names flights that are not there"),
        ("kept/flight", -1, "kept/flight names flights that are not there"),
        ("kept/records", 3, "kept/records does not share out the 20 rows of /records"),
    ],
)
def test_columns_that_contradict_are_refused(
    key: str, value: float, said: str, one: Path, tmp_path: Path
) -> None:
    """Signed as ours are: a stranger may have made them."""
    path = tmp_path / "x.h5"
    path.write_bytes(one.read_bytes())
    with h5py.File(path, "r+") as file:
        file[key][0] = value
        summed = hashlib.sha256(np.ascontiguousarray(file[key][:]).data).hexdigest()
        file[key].attrs["sha256"] = np.bytes_(summed.encode())
        file.attrs["sha256"] = np.bytes_(content_digest(file, LAYOUT).encode())
    with pytest.raises(CampaignError, match=f"is no sailnet results: {said}; fly the campaign again"):
        open_results(path)


@pytest.fixture(scope="module")
def one(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Results of a flight of 20 periods, and its trajectory."""
    path = tmp_path_factory.mktemp("one") / "x.h5"
    plan = plan_of(series=[{"name": "one", "starts": [CASE], "periods": [0.05]}], sample=1)
    fly_plan(short(1.0), GUIDANCE, plan, path)
    return path


def test_results_of_another_version_are_refused_with_a_remedy(tmp_path: Path) -> None:
    path = tmp_path / "old.h5"
    fly_plan(MISSION, GUIDANCE, plan_of(series=[{"name": "a", "starts": [CASE], "periods": [0.05]}]), path)
    with h5py.File(path, "r+") as file:
        file.attrs["schema"] = np.bytes_("sailnet-campaign/3")
    with pytest.raises(CampaignError, match=r"campaign/3', this version reads .*/5': fly the campaign again"):
        open_results(path)

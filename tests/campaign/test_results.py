"""Results read back are what was flown; nothing damaged or outdated goes unnoticed."""

from pathlib import Path

import h5py
import numpy as np
import pytest

from sailnet.campaign.results import Results, open_results
from sailnet.campaign.run import fly_plan
from sailnet.errors import CampaignError
from sailnet.flight.closed_loop import Flights
from tests.campaign.small_plan import CASE, GUIDANCE, MISSION, plan_of


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


def test_results_of_another_version_are_refused_with_a_remedy(tmp_path: Path) -> None:
    path = tmp_path / "old.h5"
    fly_plan(MISSION, GUIDANCE, plan_of(series=[{"name": "a", "starts": [CASE], "periods": [0.05]}]), path)
    with h5py.File(path, "r+") as file:
        file.attrs["schema"] = np.bytes_("sailnet-campaign/3")
    with pytest.raises(CampaignError, match=r"campaign/3', this version reads .*/5': fly the campaign again"):
        open_results(path)

"""Campaigns in three dimensions: five components of every state, both angles, the same rules."""

from pathlib import Path

import numpy as np
import pytest

from sailnet.artefacts.column_writing import write_columns
from sailnet.campaign.columns import LAYOUT
from sailnet.campaign.flown_columns import flight_columns
from sailnet.campaign.replay import replay
from sailnet.campaign.results import Results, open_results
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import in_si, scores_of
from sailnet.campaign.tables import score_tables
from sailnet.errors import CampaignError
from sailnet.flight.closed_loop import fly_recorded
from sailnet.physics.units import AU, AU_PER_TU
from sailnet.report.campaign_page import write_report
from tests.campaign.small_plan import CASE, MISSION, assert_same, plan_of
from tests.pilots_in_space import SPACE, START, lasting, wobbling

SHORT = lasting(0.5)
SERIES = [
    {"name": "from departure", "starts": [START], "periods": [0.05]},
    {"name": "rough", "flights": 12, "periods": [0.05], "disturbance": {"beta_noise": 0.1}},
]
PLAN = plan_of(series=SERIES, failures=3)


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Results:
    return fly_plan(SHORT, wobbling(), PLAN, tmp_path_factory.mktemp("space") / "space.h5")


def test_flights_and_histories_read_back_are_what_was_flown(flown: Results) -> None:
    flights, (history,) = fly_recorded(SHORT, wobbling(), [START], period=0.05)
    kept = flown.as_flights(np.array([0]))
    assert kept.starts.shape == (1, 5)
    for name, column in flight_columns(flights).items():
        np.testing.assert_array_equal(flight_columns(kept)[name], column, err_msg=name)
    assert_same(flown.history(0), history)
    assert flown.history(0).states.shape[1] == 6
    assert history.clock_angle is not None
    assert np.ptp(history.clock_angle) > 1.0


def test_a_flight_is_the_same_again(flown: Results) -> None:
    for place, row in enumerate(flown.kept.tolist()):
        assert_same(replay(flown, wobbling(), row), flown.history(place))


def test_scores_and_tables_tell_of_five_components(flown: Results) -> None:
    score = scores_of(flown)[1]
    error = flown.as_flights(flown.rows(1, 0.05)).terminal_error
    np.testing.assert_allclose(score.component_quantiles[1.0], error.max(axis=0))
    km, mps = AU / 1e3, AU_PER_TU
    assert in_si([1.0] * 5) == [km, km, mps, mps, mps]
    assert in_si([1.0] * 3) == [km, mps, mps]
    heads = score_tables([score])[3].heads
    assert "median error (r, latitude, u, v, w)" in heads


def test_the_page_shows_both_angles_and_a_path_that_can_be_turned(flown: Results, tmp_path: Path) -> None:
    write_report(flown, tmp_path, wobbling())
    assert "plotly.js (gl3d" in (tmp_path / "index.html").read_text("utf-8")
    row = int(flown.kept[-1])
    names = (tmp_path / "flights" / f"flight-{row}.csv").read_text("utf-8").partition("\n")[0].split(",")
    assert {"z", "clock", "latitude", "w", "off_latitude", "off_w"} <= {*names}


def test_starts_of_other_components_are_refused() -> None:
    planar = plan_of(series=[{"name": "planar", "starts": [CASE]}])
    with pytest.raises(CampaignError, match=r"'planar' .* not all of 5 components"):
        planar.flown_by(SPACE)
    with pytest.raises(CampaignError, match=r"'from departure' .* not all of 3 components"):
        PLAN.flown_by(MISSION)
    assert planar.flown_by(MISSION) == planar


def test_columns_of_a_plane_do_not_pass_for_those_of_space(tmp_path: Path) -> None:
    """Nor where all checksums are right."""
    planar = {
        f"{group}/{name}": np.ones(0 if group == "records" else 1) * (group != "kept")
        for group, names in LAYOUT.groups.items()
        for name in names
    }
    texts = {"mission": SHORT.to_json(), "campaign": PLAN.to_json(), "networks": "0"}
    write_columns(tmp_path / "x.h5", LAYOUT, iter([planar]), texts, {"run": {}})
    with pytest.raises(CampaignError, match="has states of 5 components, its flights not"):
        open_results(tmp_path / "x.h5")

"""``sailnet solve`` in three dimensions: what it prints, what it writes, and what it refuses."""

import csv
import json
import math
import re
from pathlib import Path

import numpy as np
import pytest

import sailnet
from sailnet.cli import main

AT_NODE = ["solve", "--mission", "earth_mars_3d"]
ABOVE = ["solve", "1.05", "0.05", "1.03", "--latitude", "1.5", "--northward", "-0.02", "--smoothing", "0"]


@pytest.mark.slow
def test_the_departure_of_an_inclined_mission_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*AT_NODE, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["time_of_flight"] == pytest.approx(7.0477059, abs=1e-6)
    i = math.radians(1.85)
    np.testing.assert_allclose(found["state"], [1.0, 0.0, 0.0, math.cos(i), math.sin(i)], atol=1e-15)
    assert len(found["costates"]) == 5
    assert found["residual"] <= 1e-9
    assert not found["complete"]
    assert 0.0 <= found["cone_angle"] <= math.pi / 3
    assert found["clock_angle"] == pytest.approx(
        math.atan2(-found["costates"][4], -found["costates"][3]), abs=1e-15
    )


@pytest.mark.slow
def test_a_state_off_the_plane_and_a_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = tmp_path / "optimum.csv"
    assert main([*ABOVE, "--output", str(table)]) == 0
    printed = capsys.readouterr()
    assert "latitude 1.5 deg" in printed.out
    assert " rad" not in printed.out.split("costates")[0]
    assert "clock angle at the start, from v to the north" in printed.out
    assert "this may not be the fastest" in printed.err
    with table.open() as file:
        rows = list(csv.DictReader(file))
    assert [float(rows[0][name]) for name in ("latitude [rad]", "w [AU/TU]")] == pytest.approx(
        [math.radians(1.5), -0.02]
    )
    last = [float(rows[-1][name]) for name in ("r [AU]", "latitude [rad]", "w [AU/TU]")]
    assert last == pytest.approx([1.524, 0.0, 0.0], abs=1e-9)
    cone = np.array([float(row["cone_angle [rad]"]) for row in rows])
    assert (cone >= 0.0).all()
    optimum = sailnet.solve(
        sailnet.load_mission("earth_mars").with_overrides(smoothing=0.0),
        (1.05, math.radians(1.5), 0.05, 1.03, -0.02),
    )
    assert optimum.time_of_flight == pytest.approx(float(rows[-1]["time [TU]"]), abs=1e-9)
    assert "clock angle" in repr(optimum)
    assert sailnet.sample(optimum, 11).units["lambda_latitude"] == "TU/rad"


@pytest.mark.slow
def test_many_states_by_python() -> None:
    optima = sailnet.solve_states(
        "earth_mars_3d", [(1.05, 0.02, 0.05, 1.0, -0.02), (1.05, -0.02, 0.05, 1.0, 0.02)]
    )
    assert optima.columns()["lambda_w"] == pytest.approx(-optima.columns()["lambda_w"][::-1], rel=1e-6)
    assert optima[0].time_of_flight == pytest.approx(optima[1].time_of_flight, abs=1e-9)


@pytest.mark.slow
def test_a_page_shows_the_path_in_space_and_both_angles(tmp_path: Path) -> None:
    page = tmp_path / "optimum.html"
    assert main([*ABOVE, "--plot", str(page)]) == 0
    text = page.read_text("utf-8")
    found = re.search(r'<script type="application/json" id="content">(.*?)</script>', text, re.DOTALL)
    assert found is not None
    charts = {chart["name"]: chart for chart in json.loads(found[1])["charts"]}
    assert list(charts) == ["path", "cone", "clock", "state", "latitude", "costates"]
    path = charts["path"]["columns"]
    x, y, z = (np.array(path[side]) for side in "xyz")
    latitude, r = np.radians(charts["latitude"]["columns"]["latitude"]), charts["state"]["columns"]["r"]
    np.testing.assert_allclose(np.linalg.norm([x, y, z], axis=0), r, rtol=1e-4)
    np.testing.assert_allclose(z, r * np.sin(latitude), atol=5e-6)
    assert charts["path"]["z"] == "Z [AU]"
    assert "plotly.js (gl3d" in text


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["1", "0", "1", "--latitude", "95"], "from -90 to 90 degrees, not 95"),
        (["1", "0", "1", "--latitude", "-90"], "on the axis of the target orbit"),
        (["1", "0", "1", "--latitude", "nan"], "five finite numbers"),
        (["1", "0", "1", "--northward", "inf"], "five finite numbers"),
        (["--latitude", "1"], "give R U V as well"),
    ],
)
def test_what_cannot_be_is_refused(options: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", *options]) == 1
    assert said in capsys.readouterr().err

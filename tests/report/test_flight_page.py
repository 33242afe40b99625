"""A page with charts as a browser shows it: nothing bent, dark where asked for, scrolled by a finger."""

import json
import re
from html import unescape
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sailnet.report.charts import IN_SPACE, Chart, Curve
from sailnet.report.flight_page import write_charts_page
from tests.browser import browse
from tests.tools import needs_browser

ASK = """
<pre id="told"></pre><script>
setTimeout(() => {
  const place = document.querySelector(".chart");
  document.getElementById("told").textContent = JSON.stringify({
    simplify: place.data[0].line.simplify, dragmode: place.layout.dragmode, paper: place.layout.paper_bgcolor,
    page: getComputedStyle(document.body).backgroundColor, ink: place.layout.font.color,
    touch: getComputedStyle(place.querySelector(".nsewdrag")).touchAction,
  });
}, 4000);
</script></body>"""

COARSE, DARK = "primaryPointerType=2,availablePointerTypes=2", "preferredColorScheme=0"


def shown(folder: Path, *settings: str) -> dict[str, Any]:
    """What a page of one chart is like in a browser with some settings."""
    page = folder / "page.html"
    columns = {"time": np.linspace(0.0, 1.0, 50), "cone": np.full(50, 60.0)}
    chart = Chart("cone", "Cone angle", "", "time [TU]", "cone angle [deg]", [Curve("time", "cone")], columns)
    write_charts_page(page, [chart], "One flight", "About it", {"seed": "3"}, "sailnet fly 1 0 1 --seed 3")
    page.write_text(page.read_text("utf-8").replace("</body>", ASK), "utf-8")
    given = [f"--blink-settings={','.join(settings)}"] if settings else []
    text = browse(folder / "profile", *given, page.as_uri())
    assert "Written again by <code>sailnet fly 1 0 1 --seed 3</code>" in text
    found = re.search(r'<pre id="told">(.*?)</pre>', text)
    assert found is not None
    said: dict[str, Any] = json.loads(unescape(found[1]))
    return said


@needs_browser()
def test_curves_are_drawn_as_they_are_and_a_mouse_zooms(tmp_path: Path) -> None:
    said = shown(tmp_path)
    assert said["simplify"] is False
    assert said["dragmode"] == "zoom"
    assert said["paper"] == "#fff"
    assert said["page"] == "rgb(255, 255, 255)"


@needs_browser()
@pytest.mark.parametrize("setting", [COARSE])
def test_a_finger_scrolls(tmp_path: Path, setting: str) -> None:
    said = shown(tmp_path, setting)
    assert said["dragmode"] is False
    assert said["touch"] == "auto"


@needs_browser()
def test_a_dark_page_has_dark_charts(tmp_path: Path) -> None:
    said = shown(tmp_path, DARK)
    assert said["page"] == "rgb(18, 24, 29)"
    assert said["paper"] == "#12181d"
    assert said["ink"] == "#dfe6ec"


PATH = """
<pre id="told"></pre><script>
setTimeout(() => {
  const place = document.querySelector(".chart"), scene = place.layout.scene;
  document.getElementById("told").textContent = JSON.stringify({
    types: place.data.map((one) => one.type), dragmode: scene.dragmode,
    canvas: place.querySelectorAll("canvas").length,
    z: place.data[0].z, ratio: scene.aspectratio,
  });
}, 4000);
</script></body>"""


@needs_browser()
def test_a_path_in_space_can_be_turned(tmp_path: Path) -> None:
    page, angle = tmp_path / "page.html", np.linspace(0.0, 3.0, 50)
    columns = {"x": np.cos(angle), "y": np.sin(angle), "z": 0.03 * np.sin(angle)}
    chart = Chart("path", "Path", "", "X", "Y", [Curve("x", "y", "flown", z="z")], columns, z="Z")
    write_charts_page(page, [chart], "One flight", "About it", {"seed": "3"})
    page.write_text(page.read_text("utf-8").replace("</body>", PATH), "utf-8")
    found = re.search(r'<pre id="told">(.*?)</pre>', browse(tmp_path / "profile", page.as_uri()))
    assert found is not None
    said = json.loads(unescape(found[1]))
    assert said["types"] == ["scatter3d"]
    assert said["dragmode"] == "orbit"
    assert said["canvas"] >= 1
    assert said["z"][25] == pytest.approx(columns["z"][25], rel=1e-4)
    assert (said["ratio"]["x"], said["ratio"]["y"], said["ratio"]["z"]) == IN_SPACE

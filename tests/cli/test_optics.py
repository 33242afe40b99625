"""``sailnet optics``: the table, the same numbers as JSON, the page, and what its README prints."""

import json
import re
import shlex
from importlib import resources
from pathlib import Path

import pytest

from sailnet.cli.command_line import main
from sailnet.report.flight_page import LIBRARY
from tests.browser import told
from tests.docs.test_readmes import commands, ours
from tests.paths import ROOT
from tests.tools import needs_browser

TEXT = ROOT / "sailnet/physics/README.md"


def mission_of_the_readme(folder: Path) -> Path:
    """The shipped mission with the coefficients that the README gives as an example."""
    (block,) = re.findall(r"```toml\n(.*?)```", TEXT.read_text("utf-8"), re.S)
    shipped = (resources.files("sailnet") / "mission" / "missions" / "earth_mars.toml").read_text("utf-8")
    other, count = re.subn(r"smoothing = .*\n", lambda _: block, shipped)
    assert count == 1
    path = folder / "mine.toml"
    path.write_text(other.replace('name = "earth_mars"', 'name = "mine"').replace("= 60.0", "= 70.0"))
    return path


def test_the_table_has_the_numbers_of_the_json(capsys: pytest.CaptureFixture[str]) -> None:
    """Golden: photons counted over a fine grid of cone angles."""
    assert main(["optics", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert list(found) == ["ideal", "jpl", "nasa"]
    jpl = found["jpl"]
    assert jpl["facing_share"] == pytest.approx(1.816 / 2.0, abs=2e-4)
    assert jpl["force_off_normal_deg"] == pytest.approx({"35": 3.816234, "60": 9.412737}, abs=1e-6)
    assert jpl["widest_useful_deg"] == pytest.approx(35.20969, abs=1e-5)
    assert jpl["largest_transverse"] == pytest.approx(0.347764, abs=1e-6)
    assert jpl["bounds"]["60"]["jumps_from_deg"] is None
    assert jpl["bounds"]["89"] == pytest.approx(
        {"jumps_from_deg": 73.4601, "active_from_theta_deg": 146.3220}, abs=1e-4
    )
    assert sum(found["nasa"]["force"][name] for name in ("square", "linear")) == pytest.approx(1.0)
    assert main(["optics"]) == 0
    lines = [re.split(r" {2,}", line.strip()) for line in capsys.readouterr().out.splitlines()]
    assert lines[0] == ["unit", "ideal", "jpl", "nasa"]
    table = {line[0]: line[1:] for line in lines[1:]}
    assert len(table) == 18
    assert table["largest useful cone angle"] == ["deg", "35.2644", "35.2097", "35.415"]
    assert table["force off the normal at 60°"] == ["deg", "0", "9.41274", "9.98749"]
    assert table["jumps to a bound of 89° from"] == ["deg", "–", "73.4601", "73.8581"]
    assert table["specularity s"] == ["1", "1", "0.94", "0.89"]


def test_a_mission_adds_its_sail_and_its_bound(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["optics", "jpl", "--mission", str(mission_of_the_readme(tmp_path)), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert list(found) == ["jpl", "mine"]
    assert found["mine"]["coefficients"]["specularity"] == 0.8
    assert list(found["mine"]["bounds"]) == ["60", "70", "89"]
    assert main(["optics", "ideal", "--mission", "earth_mars", "--json"]) == 0
    assert list(json.loads(capsys.readouterr().out)) == ["ideal"]


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("jpl", "foil"), "no sail 'foil': known are ideal, jpl, nasa; for coefficients of your own"),
        (("--output", "optics.png"), "--output writes FILE.html, not optics.png"),
        (("--mission", "nowhere.toml"), "nowhere.toml"),
        (
            ("--output", "/dev/null/optics.html"),
            "--output writes into a folder that is there, and /dev/null is not",
        ),
    ],
)
def test_what_cannot_be_shown_is_refused(
    arguments: tuple[str, ...], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["optics", *arguments]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert says in said.err


def test_the_commands_of_the_readme_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    mission_of_the_readme(tmp_path)
    monkeypatch.chdir(tmp_path)
    printed = [arguments for line in commands(TEXT) if (arguments := ours(line)) is not None]
    assert len(printed) == 3
    for arguments in printed:
        assert main(arguments) == 0, shlex.join(arguments)
    assert "Traceback" not in capsys.readouterr().err
    page = (tmp_path / "optics.html").read_text("utf-8").replace(LIBRARY.read_text("utf-8"), "")
    assert not re.findall(r"https?://", page)
    assert '<td class="number">35.2097</td>' in page
    assert "nasa" not in page


LOOK = """
const seen = [];
addEventListener("error", (event) => seen.push(event.message));
setTimeout(() => {
  const charts = [...document.querySelectorAll("[data-chart]")];
  parent.postMessage(JSON.stringify({
    errors: seen, width: document.documentElement.scrollWidth,
    curves: Object.fromEntries(charts.map((place) => [place.dataset.chart,
      [...place.querySelectorAll("svg .trace")].filter((one) => one.querySelector("path")).length])),
    head: [...document.querySelectorAll("#numbers th")].map((cell) => cell.textContent),
    rows: document.querySelectorAll("#numbers tbody tr").length,
  }), "*");
}, 6000);
"""


def test_the_page_says_by_which_command_it_was_written(tmp_path: Path) -> None:
    page = tmp_path / "optics.html"
    assert main(["optics", "ideal", "jpl", "--output", str(page)]) == 0
    assert f"<code>sailnet optics ideal jpl --output {page}</code>" in page.read_text("utf-8")


@needs_browser()
@pytest.mark.parametrize("width", [1280, 390])
def test_the_page_draws_every_sail(tmp_path: Path, width: int, capsys: pytest.CaptureFixture[str]) -> None:
    page = tmp_path / "optics.html"
    assert main(["optics", "--output", str(page)]) == 0
    assert capsys.readouterr().err == ""
    said = told(page, tmp_path, width, LOOK)
    assert said["errors"] == []
    assert said["width"] <= width
    # Three sails, their dots, and the jumps of those two that are not ideal.
    assert said["curves"] == {"radial": 3, "transverse": 6, "polar": 8, "lean": 3}
    assert said["head"] == ["quantity", "unit", "ideal", "jpl", "nasa"]
    assert said["rows"] == 18

"""The index of shipped missions: every mission once, with the figures that its tables have."""

import re
import sys
from pathlib import Path

import pytest

from export import shipped_index
from export.shipped_index import NONE, index_row, rows_of
from sailnet.artefacts.files import split_at_block
from sailnet.mission.mission import load_mission
from tests.paths import ROOT

ACCEPTANCE = """
Written by hand.

| flown | mean excess | no extra revolution | failed |
| --- | --- | --- | --- |
| nominal | 0.096 %, 0.488 days | 99.96 % | 2 |
| unknown bias | 0.113 %, 0.587 days | 98.00 % | 0 |
| unknown bias and white noise | 0.429 %, 2 days | 97.00 % | 3 |

| flown | slew |
| --- | --- |
| nominal | 7 |
"""

CAMPAIGNS = """
**Law** (`law`, networks `1`, seed 1)

| series | arrive |
| --- | --- |
| anywhere inside the domain | 1 % |

**Reach** (`reach`, networks `1`, seed 1)

*Time and arrivals*

| series | arrived | failed |
| --- | --- | --- |
| by 5 % | 99 % (98 to 100) | 1 |
| anywhere inside the domain | 97.60 % (95.85 to 98.62) | 12 |
"""


def test_the_first_table_of_a_text_is_read() -> None:
    assert [row["flown"] for row in rows_of(ACCEPTANCE)] == [
        "nominal",
        "unknown bias",
        "unknown bias and white noise",
    ]
    assert rows_of("no table") == []


def test_a_row_has_the_figures_of_the_tables() -> None:
    mission = load_mission("earth_mars")
    row = index_row(mission, ACCEPTANCE, CAMPAIGNS)
    assert row[1:] == [
        "1 to 1.524",
        "β 0.16892, 60°, ideal",
        "7.0184 TU (408 days)",
        "0.096 %; 99.96 %; 2",
        "0.113 %; 98.00 %; 0",
        "0.429 %; 97.00 %; 3",
        "97.60 % (95.85 to 98.62)",
    ]
    assert index_row(mission, ACCEPTANCE, CAMPAIGNS.partition("**Reach")[0])[-1] == NONE


def test_the_index_that_is_committed_is_of_the_tables_that_are() -> None:
    """Every mission with networks is in it, and no figure is older than its source."""
    shipped = ROOT / "sailnet" / "shipped"
    index = split_at_block(shipped / "README.md", shipped_index.MARK)[1]
    rows = {re.sub(r"\W*\[`(\w+)`\].*", r"\1", row["mission"]): row for row in rows_of(index)}
    assert set(rows) == {path.parent.name for path in shipped.glob("*/MODEL_CARD.md")}
    for name, row in rows.items():
        acceptance = split_at_block(ROOT / "RESULTS.md", f"acceptance {name}")[1]
        place = (ROOT / "sailnet/campaign" if name == "earth_mars" else shipped / name) / "RESULTS.md"
        campaigns = place.read_text("utf-8") if place.exists() else ""
        expected = index_row(load_mission(name), acceptance, campaigns)
        assert list(row.values()) == expected
    for picture in re.findall(r"!\[[^]]*\]\(([^)]*)\)", index):
        assert (shipped / picture).exists()


def test_networks_without_an_acceptance_are_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "earth_mars").mkdir()
    (tmp_path / "earth_mars" / "MODEL_CARD.md").write_text("a card")
    text, results = tmp_path / "README.md", tmp_path / "RESULTS.md"
    text.write_text("<!-- missions -->\nbefore\n<!-- /missions -->")
    results.write_text("nothing")
    monkeypatch.setattr(sys, "argv", ["shipped_index", str(text), "--results", str(results)])
    assert shipped_index.main() == 1
    assert "put <!-- acceptance earth_mars -->" in capsys.readouterr().err
    assert "before" in text.read_text()

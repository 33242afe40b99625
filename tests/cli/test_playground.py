"""``sailnet playground``: the page is written, and nothing is overwritten unasked."""

import json
from pathlib import Path

import pytest

from sailnet.cli import main


def test_it_writes_one_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = tmp_path / "fly.html"
    assert main(["playground", str(page), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said == {"page": str(page), "bytes": page.stat().st_size}
    assert f"<code>sailnet playground {page} --json</code>" in page.read_text("utf-8")
    page.write_text("mine")
    assert main(["playground", str(page)]) == 1
    assert "say --overwrite to replace it" in capsys.readouterr().err
    assert page.read_text() == "mine"
    assert main(["playground", str(page), "--overwrite"]) == 0
    assert page.stat().st_size == said["bytes"] - len(" --json") + len(" --overwrite")


@pytest.mark.parametrize(
    ("name", "says"),
    [("fly.png", "the page is FILE.html"), ("absent/fly.html", "writes into a folder that is there")],
)
def test_what_cannot_be_written_is_said_first(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str, says: str
) -> None:
    assert main(["playground", str(tmp_path / name)]) == 1
    assert says in capsys.readouterr().err


def test_a_damaged_module_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sailnet.report.playground.module.FOLDER", tmp_path)
    damaged = tmp_path / "earth_mars.wasm"
    damaged.write_bytes(b"\0asm")
    (tmp_path / "SHA256SUMS").write_text(f"{'0' * 64}  earth_mars.wasm\n")
    monkeypatch.setattr("sailnet.report.playground.module.MODULE", damaged)
    assert main(["playground", str(tmp_path / "fly.html")]) == 1
    assert "is damaged or was changed" in capsys.readouterr().err
    assert not (tmp_path / "fly.html").exists()

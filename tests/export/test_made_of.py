"""An export of the very same is kept, and no other is taken for it."""

import json
from pathlib import Path

import pytest

from export.command import main
from export.made_of import MADE_OF
from tests.few_graphs import no_graphs
from tests.random_networks import random_guidance, save_guidance


@pytest.mark.slow
def test_the_same_command_keeps_what_it_made_and_refuses_what_it_did_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    no_graphs(monkeypatch)
    networks, target = tmp_path / "networks", tmp_path / "target"
    save_guidance(random_guidance(seed=1), networks)
    command = [str(networks), str(target), "--resume"]
    source = target / "sailnet_guidance.c"
    assert main(command) == 0
    made = source.stat().st_mtime_ns
    assert main(command) == 0
    assert source.stat().st_mtime_ns == made
    assert "is there already, made by the same run" in capsys.readouterr().err

    # Killed after the old record went and before the new one came: nobody knows what that is.
    record = (target / MADE_OF).read_text()
    (target / MADE_OF).unlink()
    assert main(command) == 1
    (target / MADE_OF).write_text(record)

    whole = source.read_text()
    source.write_text(whole + "\n")
    assert main(command) == 1
    assert "holds an export" in capsys.readouterr().err
    source.write_text(whole)
    assert main(command) == 0

    save_guidance(random_guidance(seed=2), networks)
    assert main(command) == 1
    assert source.read_text() == whole
    assert main([*command, "--overwrite"]) == 0
    assert source.read_text() != whole
    assert json.loads((target / MADE_OF).read_text()) != json.loads(record)

"""The command that ships: what it does once it is alone is in tests/pipeline."""

import subprocess
import sys
from pathlib import Path

from sailnet.artefacts.ownership import LOCK, sole_owner
from tests.paths import ROOT


def test_who_comes_second_is_sent_away_before_what_takes_long_is_loaded(tmp_path: Path) -> None:
    package = tmp_path / "shipped"
    with sole_owner(package / LOCK, "it"):
        second = subprocess.run(
            [sys.executable, "-X", "importtime", "-m", "export.ship", str(tmp_path), str(package)],
            cwd=ROOT, capture_output=True, text=True, check=False,
        )  # fmt: skip
    assert second.returncode == 1
    assert f"error: another run is making networks in {package} (process " in second.stderr
    loaded = {line.rpartition("|")[2].strip() for line in second.stderr.splitlines()}
    assert "sailnet.artefacts.ownership" in loaded
    assert not loaded & {"torch", "heyoka", "numpy"}

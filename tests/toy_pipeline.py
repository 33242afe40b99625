"""Running the pipeline's commands on a mission made small."""

import re
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).parent.parent


def python(*arguments: str | Path, check: bool = True) -> subprocess.CompletedProcess[str]:
    """Run ``python`` with these arguments in the repository's root."""
    command = [sys.executable, *map(str, arguments)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=300)
    assert not check or done.returncode == 0, done.stderr
    return done


ANY = "{ mean_excess = 1e6, without_extra_revolution = 0.0, failed = 100.0, reversals = 1e6 }"
"""Criteria that whatever was trained for a second meets."""


def toy_mission(folder: Path, changes: Mapping[str, str]) -> Path:
    """A copy of the Earth-Mars mission under the name ``toy``, with other values wherever a key occurs.

    Where the changes do not say others, its acceptance criteria are met by any networks.
    """
    text = (ROOT / "sailnet" / "mission" / "missions" / "earth_mars.toml").read_text()
    text = text.replace('name = "earth_mars"', 'name = "toy"')
    changes = {**dict.fromkeys(("nominal", "unknown_bias", "white_noise", "slow_drift"), ANY), **changes}
    for key, value in changes.items():
        text, replaced = re.subn(rf"(?m)^{key} = [^#\n]*", f"{key} = {value} ", text)
        assert replaced, key
    path = folder / "toy.toml"
    path.write_text(text)
    return path

"""``python -m data`` with invented shards, and killed at a given moment of its end if KILL_AT says so."""

import os
import signal
import sys
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import patch

import data.command
from data.recipes import Prepared
from sailnet.workers.interruption import run_command
from tests.small_datasets import invented_shard


def _prepared(*_: object) -> Prepared:
    return Prepared(partial(invented_shard, 0.02), 1000, None, {"recipe": "invented"})


def _die(*_: object, **__: object) -> Any:
    os.kill(os.getpid(), signal.SIGKILL)


def _half_removed(folder: Path, **_: object) -> None:
    for path in sorted(folder.glob("*.safetensors"))[::2]:
        path.unlink()
    _die()


_rename = Path.replace


def _not_renamed(path: Path, target: Path) -> Path:
    return _die() if target == Path(sys.argv[1]) else _rename(path, target)


MOMENTS = {
    "header": ("sailnet.artefacts.column_writing.content_digest", _die),
    "rename": ("pathlib.Path.replace", _not_renamed),
    "removal": ("shutil.rmtree", _half_removed),
}

if __name__ == "__main__":
    patch("data.recipes.prepare", _prepared).start()
    if moment := os.environ.get("KILL_AT"):
        patch(*MOMENTS[moment]).start()
    sys.exit(run_command(data.command.main, "nothing is finished"))

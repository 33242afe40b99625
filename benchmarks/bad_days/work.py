"""Commands that write something, at toy size, and what of their product has to be the same every time.

Digests are of content: the date of an artefact is in none of them.
"""

import os
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.fuzz_loaders.hostile import as_toml
from sailnet.campaign.results import open_results
from sailnet.dataset import open_dataset
from sailnet.guidance.backends import exported_digest
from sailnet.guidance.facts import describe
from sailnet.mission.mission import load_mission
from sailnet.networks.guidance_networks import load_guidance_networks

ROOT = Path(__file__).parents[2]

LEARNED = "data, wide"
"""The work that networks learn from."""

CAMPAIGN = """schema = 1
name = "many"
title = "Many"
flights = 150
sample = 0
optima = 0
[[series]]
name = "a"
periods = [0.006, 0.007, 0.008, 0.009, 0.01, 0.011, 0.012, 0.013]
"""


@dataclass(frozen=True)
class Work:
    """One command.

    Attributes:
        name: in the table.
        arguments: after ``python -m``, writing into a folder; the same command goes on with what it left.
        digest: of what it wrote there; raises ``SailnetError`` where that is not whole.
        lock: the file in that folder that tells a second writer.
        spreads: whether it takes ``--scheduler``.
        reads: the work whose product it needs.
        prepare: makes what else it reads; once, before it is first run.
    """

    name: str
    arguments: Callable[[Path], Sequence[str]]
    digest: Callable[[Path], str]
    lock: str
    spreads: bool = False
    reads: str = ""
    prepare: Callable[[], None] = lambda: None

    def start(self, folder: Path, *more: str) -> "subprocess.Popen[str]":
        """Begin, in a session of its own."""
        return subprocess.Popen(
            [sys.executable, "-m", *self.arguments(folder), *more],
            cwd=ROOT, env=os.environ | {"PYTHONPATH": str(ROOT)}, text=True, start_new_session=True,
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
        )  # fmt: skip

    def complete(self, folder: Path, *more: str) -> tuple[int, str, float]:
        """Exit status, what was said on stderr, and seconds."""
        started = time.monotonic()
        run = self.start(folder, *more)
        _, said = run.communicate()
        return run.returncode, said, time.monotonic() - started

    def leftovers(self, folder: Path) -> list[str]:
        """Files of unfinished work beside the product."""
        return [
            path.name for path in folder.rglob(".*") if path.suffix in (".part", ".parts") and path.exists()
        ]


def toy_mission(folder: Path) -> Path:
    """The Earth-Mars mission with small recipes, as a file."""
    content: dict[str, Any] = load_mission("earth_mars").model_dump(by_alias=True, mode="json")
    content["name"] = "toy"
    content["generalisation"] = {"r": [1.0, 1.02], "u": [0.0, 0.02], "v": [1.0, 1.02]}
    content["flight"]["longest"] = 12.0
    content["disturbance"] = {}
    content["dataset"]["wide"] |= {"levels": 2, "starts": 8, "approaches": 40, "around": 4}
    content["dataset"]["domain"] |= {"trajectories": 200}
    content["dataset"]["box"] |= {"trajectories": 1500, "samples_per_trajectory": 31}
    small = {"hidden": [8, 8], "train_samples": 1500, "curvature_samples": 800, "validation_samples": 500}
    for recipe in content["training"].values():
        recipe |= {**small, "epochs": 40}
    (folder / "toy.toml").write_text(as_toml(content))
    return folder / "toy.toml"


def works(folder: Path) -> list[Work]:
    """Every command, in the order in which they read each other's products from ``folder/reference``."""
    mission, reference = str(toy_mission(folder)), folder / "reference"
    (folder / "many.toml").write_text(CAMPAIGN)

    def dataset_digest(path: Path) -> str:
        with open_dataset(path) as found:
            found.verify()
            return found.digest

    def data(recipe: str) -> Work:
        return Work(
            f"data, {recipe}",
            lambda into: ["data", str(into / "x.h5"), "--mission", mission, "--recipe", recipe, "--quiet"],
            lambda into: dataset_digest(into / "x.h5"),
            ".x.h5.parts/lock",
            spreads=True,
        )

    learned = reference / LEARNED / "x.h5"
    trained = reference / "training" / "networks"
    run, accepted = reference / "pipeline" / "x" / "wide", reference / "pipeline" / "x" / "mission.toml"
    return [
        *(data(recipe) for recipe in ("box", "domain", "wide")),
        Work(
            "training",
            lambda into: ["training", str(learned), str(into / "networks"), "--resume", "--quiet"],
            lambda into: _networks(into / "networks"),
            "networks/.lock",
            reads=LEARNED,
        ),
        Work(
            "export",
            lambda into: ["export", str(trained), str(into / "x"), "--mission", mission, "--overwrite"],
            lambda into: exported_digest(load_mission(mission), into / "x"),
            "x/.lock",
            reads="training",
        ),
        Work(
            "campaign",
            lambda into: [
                *("sailnet.cli", "evaluate", "--campaign", str(folder / "many.toml"), "--json"),
                *("--output", str(into)),
            ],
            lambda into: open_results(into / "many.h5").digest,
            ".many.h5.parts/lock",
            spreads=True,
        ),
        Work(
            "pipeline",
            lambda into: [
                *("sailnet.cli", "pipeline", mission, "--output", str(into / "x")),
                *("--flights", "10", "--json"),
            ],
            lambda into: _pipeline(into / "x", dataset_digest),
            "x/.lock",
        ),
        Work(
            "ship",
            lambda into: ["export.ship", str(run), str(into / "x"), "--mission", str(accepted)],
            lambda into: f"{_networks(into / 'x')} {exported_digest(load_mission(accepted), into / 'x')}",
            "x/.lock",
            reads="pipeline",
            prepare=lambda: _measure(run),
        ),
    ]


def _measure(run: Path) -> None:
    """What a model card tells of speed and agreement, in little time."""
    exported, networks, data = str(run / "export"), str(run / "networks"), str(run.with_suffix(".h5"))
    commands = {
        "bench": (
            "c_runtime.verification.bench",
            exported,
            "--networks",
            networks,
            "--json",
            "--batches",
            "3",
        ),
        "agreement": ("export.agreement", networks, exported, "--dataset", data, "--states", "1000"),
    }
    for name, arguments in commands.items():
        made = subprocess.run(
            [sys.executable, "-m", *arguments], cwd=ROOT, stdout=subprocess.PIPE, check=True
        )
        (run / f"{name}.json").write_bytes(made.stdout)


def _pipeline(folder: Path, dataset_digest: Callable[[Path], str]) -> str:
    """Of what every step made."""
    flown = folder / "wide"
    return " ".join((
        dataset_digest(folder / "wide.h5"),
        _networks(flown / "networks"),
        exported_digest(load_mission(folder / "mission.toml"), flown / "export"),
        open_results(flown / "acceptance.h5").digest,
    ))  # fmt: skip


def _networks(folder: Path) -> str:
    networks = load_guidance_networks(folder)
    return describe(networks, networks.mission).networks_digest

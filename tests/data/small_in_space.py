"""A small data set in three dimensions, for tests."""

from pathlib import Path

from data.generate import generate
from data.recipes import prepare
from sailnet.artefacts.provenance import software
from sailnet.dataset import write_dataset
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.propagation import TOLERANCE
from sailnet.workers.executors import Workers
from tests.small_datasets import Inline


def small_mission() -> Mission:
    """Starts near the departure from Earth, for two sails: an index of few bins."""
    mission = load_mission("earth_mars_3d")
    region = mission.generalisation.model_copy(
        update={
            "r": (1.0, 1.03),
            "u": (0.0, 0.03),
            "v": (0.98, 1.02),
            "latitude": (-2.0, 2.0),
            "w": (-0.03, 0.03),
        }
    )
    small = {"levels": 2, "starts": 24, "approaches": 60, "around": 0, "crossings": 2}
    wide = mission.dataset.wide.model_copy(update=small | {"beta": (0.97, 1.03), "margin": (0.0, 0.0, 0.0)})
    recipes = mission.dataset.model_copy(update={"wide": wide})
    return mission.model_copy(update={"generalisation": region, "dataset": recipes})


def quickly_trained(epochs: int) -> Mission:
    """The same, whose networks are trained for so many epochs on few samples."""
    mission = small_mission()
    samples = {"train_samples": 2000, "validation_samples": 500, "curvature_samples": 500}
    wide = mission.training.wide.model_copy(update={**samples, "epochs": epochs})
    return mission.model_copy(update={"training": mission.training.model_copy(update={"wide": wide})})


def in_space(mission: Mission, path: Path) -> Path:
    """Its data set, written."""
    made = prepare(mission, "wide")
    blocks = generate(made.shard_of, made.trajectories, Workers(Inline, 2), None, made.shards)
    write_dataset(path, mission, blocks, {**made.origin, "tolerance": TOLERANCE, **software()})
    return path

"""Mission and campaign files."""

import shutil
import tomllib
from importlib import resources
from pathlib import Path
from random import Random

from benchmarks.fuzz_loaders.hostile import as_toml, edited, flipped
from sailnet.campaign.batches import batches_of
from sailnet.campaign.budget import refuse_too_large
from sailnet.campaign.plan import load_plan
from sailnet.mission.mission import load_mission

PACKAGE = Path(str(resources.files("sailnet")))
MISSION = load_mission("earth_mars")


def make_mission(folder: Path) -> Path:
    """The mission of real optics, which has more to say."""
    shipped = PACKAGE / "mission" / "missions" / "earth_mars_jpl.toml"
    return Path(shutil.copy(shipped, folder / "mission.toml"))


def make_campaign(folder: Path) -> Path:
    """The campaign with the most disturbances."""
    return Path(shutil.copy(PACKAGE / "campaign" / "campaigns" / "everything.toml", folder / "campaign.toml"))


def spoil(path: Path, random: Random) -> None:
    """Another table; now and then other bytes."""
    content = path.read_bytes()
    if random.random() < 0.15:
        path.write_bytes(flipped(content, random))
    else:
        text = as_toml(edited(tomllib.loads(content.decode()), random))
        path.write_bytes(text.encode("utf-8", "surrogatepass"))


def load_mission_file(path: Path) -> None:
    """What every command does with a mission first."""
    mission = load_mission(path)
    mission.digest("flight", "generalisation", "disturbance", "dataset", "training")
    assert mission.problem.beta > 0.0
    assert mission.flight.turn_rate > 0.0


def load_campaign_file(path: Path) -> None:
    """Up to the moment it would fly."""
    plan = load_plan(path).flown_by(MISSION)
    refuse_too_large(plan, MISSION, path.parent / "results.h5")
    assert batches_of(plan, MISSION)
    plan.to_json()

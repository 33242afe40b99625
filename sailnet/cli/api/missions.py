"""A mission as people name it: by its name, its file, or itself."""

from pathlib import Path

from sailnet.mission.mission import Mission, load_mission

AnyMission = Mission | str | Path
"""A mission, the name of one that ships with the package, or a TOML file."""


def mission_of(given: AnyMission) -> Mission:
    """The mission itself.

    Raises:
        MissionError: neither a mission nor what one is loaded by.
    """
    return given if isinstance(given, Mission) else load_mission(given)

"""A mission as people name it: by its name, its file, or itself."""

from pathlib import Path

from sailnet.mission.mission import Mission, in_the_plane, load_mission

AnyMission = Mission | str | Path
"""A mission, the name of one that ships with the package, or a TOML file."""


def mission_of(given: AnyMission, *, in_space: bool = False) -> Mission:
    """The mission itself.

    Args:
        given: what it is named by.
        in_space: whoever asks can do with three dimensions.

    Raises:
        MissionError: neither a mission nor what one is loaded by; one of three dimensions, unless asked for.
    """
    mission = given if isinstance(given, Mission) else load_mission(given, in_space=True)
    return mission if in_space else in_the_plane(mission)

"""Missions as artefacts carry them: those that earlier versions wrote as well."""

from typing import Any

from sailnet.artefacts.untrusted import table_of
from sailnet.mission.mission import Mission, parse_mission
from sailnet.mission.sections import FlightRules


def stored_mission(text: str | bytes, source: str) -> Mission:
    """The mission in the metadata of networks, of a data set or of results.

    Keys that are retired since it was written are left out: weights, samples and results do not depend on
    them. In a mission file they are refused, by :func:`sailnet.mission.mission.load_mission`.

    Args:
        text: JSON, as ``Mission.to_json`` wrote it.
        source: names it in messages.

    Raises:
        ValueError: it is no table of JSON.
        MissionError: it is no mission.
    """
    content: dict[str, Any] = table_of(text)
    if isinstance(flight := content.get("flight"), dict):
        content["flight"] = {key: value for key, value in flight.items() if key not in FlightRules.retired}
    return parse_mission(content, source)

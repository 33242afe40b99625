"""A campaign of a few flights, and missions whose flights end soon."""

from dataclasses import fields
from typing import Any

import numpy as np

from sailnet.campaign.plan import Plan, parse_plan
from sailnet.guidance.backends import load_guidance
from sailnet.mission.mission import Mission, load_mission

MISSION = load_mission("earth_mars")
GUIDANCE = load_guidance(MISSION)
CASE = (1.05, 0.15, 1.03)


def short(longest: float) -> Mission:
    """Flights that take longer fail, soon."""
    return MISSION.model_copy(update={"flight": MISSION.flight.model_copy(update={"longest": longest})})


def plan_of(**changes: Any) -> Plan:
    """Two series, one with an optimum and one with noise; keys given replace those of the file."""
    content: dict[str, Any] = {"schema": 1, "name": "small", "title": "Small", "seed": 5, "sample": 2}
    content["optima"] = 0
    content["series"] = [
        {"name": "calm", "starts": [CASE, (1.0, 0.0, 1.0)], "periods": [0.02, 0.05], "optima": 1},
        {"name": "rough", "flights": 40, "periods": [0.05], "disturbance": {"beta_noise": 0.15}},
    ]
    return parse_plan(content | changes, "small")


def assert_same(one: Any, other: Any) -> None:
    """Every field to the last bit."""
    for item in fields(one):
        np.testing.assert_array_equal(getattr(one, item.name), getattr(other, item.name), err_msg=item.name)

"""How much of a mission's recipes is carried out: all that ships, or what minutes allow."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Literal, get_args

if TYPE_CHECKING:
    from sailnet.mission.mission import Mission

Size = Literal["quick", "full"]
SIZES: tuple[Size, ...] = get_args(Size)

QUICK: Mapping[str, Mapping[str, int]] = {
    "dataset": {"levels": 7, "starts": 192, "approaches": 300, "around": 128, "crossings": 0},
    "training": {"epochs": 90},
}
"""At most so much of [dataset.wide] and [training.wide], and no larger network of |alpha|: two or
three minutes on 2 cores."""

QUICK_SELECTION: Mapping[str, int] = {"flights": 250, "trainings": 2}
"""At most so much of [selection]."""

FLIGHTS: Mapping[Size, int] = {"quick": 1_000, "full": 10_000}
"""That accept the networks, a series."""


def sized(mission: "Mission", size: Size) -> "Mission":
    """The mission as it is, or with the quick recipes: same problem, fewer extremals, fewer epochs."""
    if size == "full":
        return mission
    from sailnet.mission.acceptance import widened
    from sailnet.mission.mission import parse_mission

    content = mission.model_dump(by_alias=True, mode="json", exclude_none=True)
    for section, most in QUICK.items():
        recipe = content[section]["wide"]
        recipe |= {key: min(recipe.get(key, 0), value) for key, value in most.items()}
    content["training"]["wide"].pop("command", None)
    for key, value in QUICK_SELECTION.items():
        content["selection"][key] = min(content["selection"][key], value)
    content["acceptance"] = widened(content["acceptance"])
    return parse_mission(content, f"{mission.name}, quick")

"""A mission's recipes: what each computes shard by shard, and what it says about its origin."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from data.box import box_recipe, box_shard
from data.domain import domain_shard, widened
from data.wide import wide_shard, wide_shards
from sailnet.dataset import Block
from sailnet.errors import DatasetError
from sailnet.expert.nominal import solve_nominal
from sailnet.mission.mission import Mission
from sailnet.mission.recipes import DomainRecipe, WideRecipe


@dataclass(frozen=True)
class Prepared:
    """A recipe ready to run.

    Attributes:
        shard_of: computes one shard from its number, anywhere.
        trajectories: how many the recipe asks for, at most.
        shards: how many shards there are; None where it takes as many as it takes.
        origin: for the file's provenance.
    """

    shard_of: Callable[[int], Block]
    trajectories: int
    shards: int | None
    origin: dict[str, object]


def prepare(mission: Mission, recipe: str) -> Prepared:
    """Solve what the shards of a recipe have in common.

    Raises:
        DatasetError: the mission lacks this recipe.
        SolveError: the nominal transfer could not be solved.
    """
    if recipe != "wide" and mission.inclined:
        raise DatasetError(
            f"mission {mission.name!r} has an inclination: in three dimensions the only recipe is 'wide'"
        )
    if recipe == "wide":
        wide = mission.dataset.wide
        most = wide.levels * (wide.starts + wide.approaches + wide.around + wide.levels * wide.crossings)
        title = "fastest extremals and approaches for a range of sails"
        return Prepared(partial(wide_shard, mission), most, wide_shards(wide), _origin(mission, title, wide))
    if recipe == "domain":
        aimed = mission.dataset.domain
        origin = _origin(mission, "fastest extremals from a domain", aimed)
        return Prepared(partial(domain_shard, mission), aimed.trajectories, None, origin)
    box = box_recipe(mission)
    nominal = solve_nominal(mission)
    arrival = nominal.smoothed.arrival_costates
    return Prepared(
        partial(box_shard, mission, (float(arrival[0]), float(arrival[1]))),
        box.trajectories,
        None,
        {
            "kind": "box",
            "recipe": "box of arrival costates, Eq. (22)",
            "nominal": {
                name: {
                    "time_of_flight": solution.time_of_flight,
                    "costates": solution.costates.tolist(),
                    "arrival_costates": solution.arrival_costates.tolist(),
                }
                for name, solution in vars(nominal).items()
                if name != "homotopy"
            },
            "homotopy_phi_max": nominal.homotopy.tolist(),
        },
    )


def _origin(mission: Mission, title: str, recipe: DomainRecipe | WideRecipe) -> dict[str, object]:
    low, high = widened(mission, recipe.margin)
    kind = "wide" if isinstance(recipe, WideRecipe) else "domain"
    kind += " in space" if mission.inclined else ""
    return {"kind": kind, "recipe": title, "lowest": low.tolist(), "highest": high.tolist()}

"""A mission's recipes: what each computes shard by shard, and what it says about its origin."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from data.box import box_recipe, box_shard
from data.domain import domain, domain_shard
from sailnet.dataset import Block
from sailnet.mission import Mission
from sailnet.nominal import solve_nominal

RECIPES = ("domain", "box")


@dataclass(frozen=True)
class Prepared:
    """A recipe ready to run.

    Attributes:
        shard_of: computes one shard from its number, anywhere.
        trajectories: how many the recipe asks for.
        origin: for the file's provenance.
    """

    shard_of: Callable[[int], Block]
    trajectories: int
    origin: dict[str, object]


def prepare(mission: Mission, recipe: str) -> Prepared:
    """Solve what the shards of a recipe have in common.

    Raises:
        DatasetError: the mission lacks this recipe.
        SolveError: the nominal transfer could not be solved.
    """
    if recipe == "domain":
        low, high = domain(mission)
        origin = {
            "recipe": "fastest extremals from a domain",
            "lowest": low.tolist(),
            "highest": high.tolist(),
        }
        return Prepared(partial(domain_shard, mission), mission.dataset.domain.trajectories, origin)
    box = box_recipe(mission)
    nominal = solve_nominal(mission)
    arrival = nominal.smoothed.arrival_costates
    return Prepared(
        partial(box_shard, mission, (float(arrival[0]), float(arrival[1]))),
        box.trajectories,
        {
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

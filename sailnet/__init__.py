"""sailnet: from Pontryagin's principle to the flight computer.

>>> import sailnet
>>> mission = sailnet.load_mission("earth_mars")
>>> optimum = sailnet.solve(mission, (1.05, 0.15, 1.03))
>>> flight = sailnet.fly(mission, (1.05, 0.15, 1.03))
>>> f"{flight.time_of_flight / optimum.time_of_flight:.4f} times the optimum"
'1.0000 times the optimum'
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from sailnet.errors import SailnetError

if TYPE_CHECKING:
    from sailnet.cli.api.evaluation import Evaluation, evaluate
    from sailnet.cli.api.exporting import export
    from sailnet.cli.api.flight import Flight, fly, load_guidance
    from sailnet.cli.api.optimum import OptimalTransfer, OptimalTransfers, sample, solve, solve_states
    from sailnet.dataset.reader import Dataset, open_dataset
    from sailnet.mission.mission import Mission, load_mission
    from sailnet.physics.transfer import Transfer

__version__ = "0.2.0"

_HOMES = {
    "sailnet.mission.mission": ("load_mission", "Mission"),
    "sailnet.cli.api.optimum": ("solve", "solve_states", "sample", "OptimalTransfer", "OptimalTransfers"),
    "sailnet.cli.api.flight": ("load_guidance", "fly", "Flight"),
    "sailnet.cli.api.evaluation": ("evaluate", "Evaluation"),
    "sailnet.cli.api.exporting": ("export",),
    "sailnet.dataset.reader": ("open_dataset", "Dataset"),
    "sailnet.physics.transfer": ("Transfer",),
}
"""Where what is offered is written. It is loaded when it is asked for: commands listen to signals before."""

__all__ = [
    "Dataset",
    "Evaluation",
    "Flight",
    "Mission",
    "OptimalTransfer",
    "OptimalTransfers",
    "SailnetError",
    "Transfer",
    "__version__",
    "evaluate",
    "export",
    "fly",
    "load_guidance",
    "load_mission",
    "open_dataset",
    "sample",
    "solve",
    "solve_states",
]


def __getattr__(name: str) -> Any:
    for home, names in _HOMES.items():
        if name in names:
            return getattr(import_module(home), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)

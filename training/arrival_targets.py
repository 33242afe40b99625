"""What the plan networks learn: the direction of the arrival costates, those of position scaled."""

from collections.abc import Callable, Mapping

import numpy as np

from sailnet.networks.plan_networks import ARRIVAL_NAMES, ARRIVAL_SCALE, position_scale, unit_vectors
from sailnet.physics.arrays import Array


def arrival_columns(components: int) -> tuple[str, ...]:
    """Columns of the trajectories that hold the arrival costates, in their order.

    Args:
        components: of a state, 3 or 5.
    """
    return tuple(f"{name.removeprefix('arrival_')}0" for name in ARRIVAL_NAMES[components])


def arrival_definition(row: int, components: int) -> str:
    """:func:`arrival_component` in words, as stored in a network's provenance."""
    names = arrival_columns(components)
    return (
        f"{names[row]} of the unit vector along ({', '.join(names)}), those of position times "
        f"s / (s + {ARRIVAL_SCALE:g} TU)"
    )


def arrival_component(row: int, components: int) -> Callable[[Mapping[str, Array]], Array]:
    """One component of the unit vector along the scaled arrival costates, from the columns of samples.

    See :mod:`sailnet.networks.plan_networks`; ``s`` must be among the columns.

    Args:
        row: which component.
        components: of a state, 3 or 5.
    """
    names = arrival_columns(components)

    def component(columns: Mapping[str, Array]) -> Array:
        costates = np.stack([columns[name] for name in names])
        costates[: components // 2] *= position_scale(columns["s"])
        return np.asarray(unit_vectors(costates.T)[:, row])

    return component

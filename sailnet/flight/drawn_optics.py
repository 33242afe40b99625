"""Optical coefficients of the very sails that fly: the mission's, a disturbance's, or drawn around these."""

from collections.abc import Sequence
from dataclasses import asdict, fields

import numpy as np

from sailnet.errors import SailnetError
from sailnet.flight.plant_library import plant
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.optics import Optics

COEFFICIENTS = tuple(item.name for item in fields(Optics))


def optics_of_flights(mission: Mission, disturbance: Disturbance, numbers: Sequence[int]) -> list[Optics]:
    """Of the sails of flights with these numbers.

    Raises:
        SailnetError: a coefficient that could be drawn outside what there is, by name.
    """
    middle = mission.optics_flown(disturbance)
    widths = {name: getattr(disturbance, f"{name}_spread") for name in COEFFICIENTS}
    for name, width in widths.items():
        value = getattr(middle, name)
        if not 0.0 <= value - width <= value + width <= 1.0:
            raise SailnetError(
                f"{name}_spread must leave {name}, {value:g}, between 0 and 1, and not be {width:g}"
            )
    if not any(widths.values()):
        return [middle] * len(numbers)
    draw = plant().functions.plant_coefficient_draw
    sails = []
    for number in numbers:
        own = asdict(middle)
        for which, name in enumerate(COEFFICIENTS):
            own[name] += widths[name] * draw(disturbance.seed, number, which)
        sails.append(Optics(**own))
    return sails


def forces(optics: Sequence[Optics]) -> Array:
    """(n, 3) ``Optics.force`` of each; of a sail that occurs often it is computed once."""
    known = {one: one.force for one in set(optics)}
    return np.array([known[one] for one in optics]).reshape(-1, 3)


def optics_errors(mission: Mission, disturbance: Disturbance, numbers: Sequence[int]) -> Array:
    """(n, 3) by how much the force of each sail differs from ``plant_rules.optics``."""
    own = forces(optics_of_flights(mission, disturbance, numbers))
    return np.asarray(own - mission.optics_flown(disturbance).force)

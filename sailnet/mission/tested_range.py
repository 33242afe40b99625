"""The range of problems that sailnet's answers are tested in; beyond it they come with a note.

A mission file may ask for more: nothing in the method stops there, but nobody has looked.
"""

import math

from sailnet.physics.transfer import Transfer

BETA = (0.05, 0.4)
CONE_ANGLE = (30.0, 85.0)
"""Bound on the cone angle [deg]; 90, no bound at all, is tested as well."""
SMOOTHING = (0.0, 1e-2)
TARGET_RADIUS = (0.387, 2.77)
"""Radius of the target orbit [AU]."""


def beyond(transfer: Transfer) -> list[str]:
    """One phrase for each quantity of the problem that is outside the tested range."""
    bound = math.degrees(transfer.phi_max)
    quantities = [
        ("beta", transfer.beta, BETA, ""),
        ("phi_max", CONE_ANGLE[1] if transfer.phi_max == math.pi / 2 else bound, CONE_ANGLE, " degrees"),
        ("delta", transfer.delta, SMOOTHING, ""),
        ("target radius", transfer.target_radius, TARGET_RADIUS, " AU"),
    ]
    return [
        f"{name} = {value:g}{unit} is outside the tested range, {low:g} to {high:g}{unit}"
        for name, value, (low, high), unit in quantities
        if not (low <= value or math.isclose(low, value)) or not (value <= high or math.isclose(high, value))
    ]

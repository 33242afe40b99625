"""Bounds that the C clamps to, or compares with: of states, inputs and attitudes."""

import math
from collections.abc import Sequence

import numpy as np

from export.errors import ExportError
from export.numbers import literal
from sailnet.guidance.facts import GuidanceFacts
from sailnet.guidance.rules import RULES
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks
from sailnet.networks.network import EXTRAPOLATION, Network
from sailnet.networks.plan_networks import ARRIVAL_SCALE
from sailnet.networks.trained_domain import KNOTS
from sailnet.physics.arrays import Array

ORDER = {3: [0, 1, 2], 5: [0, 2, 3, 1, 4]}
"""In which the C has the components of a state, by their number: in space r, u, v, latitude, w."""

NAMES = {3: "r, u, v", 5: "r, u, v, latitude, w"}
"""Of them."""


def limits(networks: AnyGuidanceNetworks, facts: GuidanceFacts) -> str:
    """C source of the bounds that are the mission's and the networks'.

    Raises:
        ExportError: a number does not fit single precision, or the networks do not fit each other.
    """
    names = NAMES[facts.components]
    edge_on = math.cos(facts.phi_max) ** 2 < RULES.least_cosine2
    return "\n".join(
        [
            "/* Whether the bound on the cone angle lets a sail be edge-on, which tells nothing of beta. */",
            f"#define SAILNET_MAY_BE_EDGE_ON {int(edge_on)}",
            *_attitude(facts),
            "/* The tube's last knot. */",
            f"#define SAILNET_LAST_KNOT R({literal(KNOTS - 1)})",
            f"/* Of each of {names}: the trained box, the widened box, and what is at the target. */",
            _rows("SAILNET_STATE_LIMITS", _state_limits(facts)),
            "/* Of each of the networks' inputs. */",
            _rows("SAILNET_INPUT_LIMITS", scaled_ranges(networks)[:, :2]),
        ]
    )


def _attitude(facts: GuidanceFacts) -> list[str]:
    """In space no attitude is measured yet."""
    if facts.components > 3:
        return []
    return [
        "/* A measured attitude counts for no more [rad]. */",
        f"#define SAILNET_LARGEST_ATTITUDE R({literal(RULES.largest_attitude(facts.phi_max))})",
    ]


def scale_of_plan() -> str:
    """C source of the constant that outputs of plan networks are scaled by: ``ARRIVAL_SCALE``."""
    return (
        "/* The time scale of the approach below which costates of position are scaled down [TU]. */\n"
        f"#define SAILNET_ARRIVAL_SCALE R({literal(ARRIVAL_SCALE)})"
    )


def scales_of(networks: AnyGuidanceNetworks) -> Array:
    """(k,) what the C's inputs are multiplied by: it has twice the first of approach coordinates."""
    inputs = max(len(network.inputs) for network in networks.all)
    return np.array([2.0 if networks.approach else 1.0, *np.ones(inputs - 1)])


def scaled_ranges(networks: AnyGuidanceNetworks) -> Array:
    """Rows of lower clamp, upper clamp and lower end, of the inputs as the C has them."""
    ranges: Array = scales_of(networks)[:, np.newaxis] * _input_ranges(networks.all)
    return ranges


def _input_ranges(trio: Sequence[Network]) -> Array:
    """Rows of lower clamp, upper clamp and lower end, of the inputs of all networks."""
    rows = [np.column_stack([*network.clamp, network.input_min]) for network in trio]
    longest = max(rows, key=len)
    for network, own in zip(trio, rows, strict=True):
        if not np.array_equal(own, longest[: len(own)]):
            raise ExportError(
                f"network {network.name} has other input ranges than the others: train them on the same data"
            )
    return longest


def refuse_other_ranges(networks: Sequence[Network], of: AnyGuidanceNetworks) -> None:
    """Refuse networks whose inputs have other ranges than those of the law.

    Raises:
        ExportError: one has.
    """
    _input_ranges([*of.all, *networks])


def _state_limits(facts: GuidanceFacts) -> Array:
    """Rows of bounds, of each component three: the box, the widened box, and what is at the target."""
    target, tolerance = np.array(facts.target_state), facts.tolerances
    low, high = np.array(facts.state_min), np.array(facts.state_max)
    margin = EXTRAPOLATION * (high - low)
    columns = [low, high, low - margin, high + margin, target - tolerance, target + tolerance]
    return np.column_stack(columns)[ORDER[facts.components]].reshape(-1, 2)


def _rows(name: str, pairs: Array) -> str:
    """A macro of initialisers of pairs."""
    rows = [f"{{R({literal(float(lower))}), R({literal(float(upper))})}}" for lower, upper in pairs]
    return f"#define {name} \\\n    " + ", \\\n    ".join(rows)

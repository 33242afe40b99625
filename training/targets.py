"""What the networks learn: inputs, target and how the cone angle's size is read from the output."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from sailnet.dataset import SAMPLES
from sailnet.mission.recipes import Training, TrainingRecipe
from sailnet.networks.approach import APPROACH_INPUTS, approach_coordinates
from sailnet.networks.guidance_networks import (
    APPROACH_SIGN_SCALE,
    COMMAND_INPUTS,
    SIGN_SCALE,
    STATE_INPUTS,
)
from sailnet.physics.arrays import Array
from sailnet.physics.jumps import cone_angle_size
from sailnet.physics.transfer import Transfer

Columns = Mapping[str, Array]


def _column(name: str) -> Callable[[Columns], Array]:
    return lambda columns: columns[name]


INTEGRALS: Mapping[str, Callable[[Columns], Array]] = {
    "momentum": lambda columns: columns["r"] * columns["v"],
    "energy": lambda columns: 0.5 * (columns["u"] ** 2 + columns["v"] ** 2) - 1.0 / columns["r"],
}
"""What a sail edge-on to the Sun would keep: inputs that data sets do not hold, AU^2/TU and AU^2/TU^2."""


@dataclass(frozen=True)
class Target:
    """One network to train.

    Attributes:
        name: file name of the network.
        inputs: what it reads: columns of the data set, ``INTEGRALS`` and approach coordinates.
        columns: columns of the data set its target is computed from.
        value: the target from those columns.
        definition: the target in words, as stored in the network's provenance.
        size: |alpha| [rad] from the network's output and phi_max, or None if it is no command.
        crossings: whether it learns what is optimal on the ways of other sails, where data have that. There
            the side is what matters; time and angle would only be less exact where sails are.
    """

    name: str
    inputs: tuple[str, ...]
    columns: tuple[str, ...]
    value: Callable[[Columns], Array]
    definition: str
    size: Callable[[Array, float], Array] | None = None
    crossings: bool = False

    @property
    def approach(self) -> bool:
        """Whether it reads approach coordinates, which have no direction at the target itself."""
        return not set(APPROACH_INPUTS).isdisjoint(self.inputs)

    @property
    def reads(self) -> tuple[str, ...]:
        """Columns of the data set that its samples are computed from and judged by."""
        inputs = [name for name in self.inputs if name in SAMPLES]
        if self.approach:
            inputs.append("beta")
        return tuple(dict.fromkeys(("r", "u", "v", *inputs, *self.columns, "alpha", "tau")))

    def complete(self, columns: Columns, transfer: Transfer) -> Columns:
        """Columns as read, with the inputs and with the target as ``value``."""
        known = dict(columns)
        known |= {name: of(known) for name, of in INTEGRALS.items() if name in self.inputs}
        if self.approach:
            states = np.column_stack([known[name] for name in ("r", "u", "v")])
            known |= zip(
                APPROACH_INPUTS, approach_coordinates(transfer, states, known["beta"]).T, strict=True
            )
            known["acceleration"] = known["beta"] / transfer.target_radius**2
        return known | {"value": self.value(known)}

    def recipe(self, training: Training) -> TrainingRecipe:
        """The mission's recipe for networks of this form."""
        return training.wide if self.inputs == APPROACH_INPUTS else training.paper


_PAPER = (
    Target("tau", STATE_INPUTS, ("tau",), _column("tau"), "tau: optimal time of flight [TU]"),
    Target(
        "alpha_pre",
        COMMAND_INPUTS,
        ("alpha",),
        lambda columns: np.abs(columns["alpha"]),
        "|alpha| [rad]: single-valued around the pinch; alpha = -sign(lambda_v) |alpha|",
        cone_angle_size,
    ),
    Target(
        "lambda_v",
        COMMAND_INPUTS,
        ("lambda_v",),
        lambda columns: np.arcsinh(columns["lambda_v"] / SIGN_SCALE),
        f"asinh(lambda_v / {SIGN_SCALE:g}): same sign, resolved best where the sign changes",
    ),
    Target(
        "lambda_v_printed",
        COMMAND_INPUTS,
        ("lambda_v",),
        _column("lambda_v"),
        "lambda_v: costate of v [TU^2/AU], as in Table 1",
    ),
    Target(
        "alpha",
        COMMAND_INPUTS,
        ("alpha",),
        _column("alpha"),
        "alpha [rad]: cone angle without preprocessing (the paper's second strategy)",
        cone_angle_size,
    ),
    Target(
        "alpha_pre_eq23",
        COMMAND_INPUTS,
        ("alpha_pre",),
        _column("alpha_pre"),
        "alpha_pre [rad] of Eq. (23) as printed: -alpha before the jump, alpha after it",
        cone_angle_size,
    ),
)

_WIDE = (
    Target(
        "tau",
        APPROACH_INPUTS,
        ("tau",),
        lambda columns: np.log(columns["tau"] / columns["s"]),
        "log(tau / s): optimal time of flight in units of the approach's own",
    ),
    Target(
        "alpha_pre",
        APPROACH_INPUTS,
        ("alpha",),
        lambda columns: np.abs(columns["alpha"]),
        "|alpha| [rad]: single-valued around the pinch; alpha = -sign(lambda_v) |alpha|",
        cone_angle_size,
    ),
    Target(
        "lambda_v",
        APPROACH_INPUTS,
        ("lambda_v",),
        lambda columns: np.arcsinh(columns["lambda_v"] * columns["acceleration"] / APPROACH_SIGN_SCALE),
        f"asinh(lambda_v beta / (r_f^2 {APPROACH_SIGN_SCALE:g})): same sign, resolved best where it changes",
        crossings=True,
    ),
)


def _named(targets: tuple[Target, ...]) -> Mapping[str, Target]:
    return {target.name: target for target in targets}


TARGETS: Mapping[str, Mapping[str, Target]] = {
    "wide": _named(_WIDE),
    "domain": _named(_PAPER),
    "box": _named(_PAPER),
}
"""By kind of data set and name: the three networks that fly, and those the report compares them with."""


def command_error(target: Target, output: Array, alpha: Array, phi_max: float) -> Array:
    """Error of |alpha| in units of 2 phi_max, the range the paper scales alpha_pre by (Table 1).

    One measure for every command target, whatever its own scaling.
    """
    assert target.size is not None
    return (target.size(output, phi_max) - np.abs(alpha)) / (2.0 * phi_max)


def cone_direction(lambda_u: Array, lambda_v: Array) -> Array:
    """|chi| [rad]: angle of (-3 lambda_u, sqrt(8) lambda_v), on which |alpha| alone depends."""
    return np.arctan2(math.sqrt(8.0) * np.abs(lambda_v), -3.0 * lambda_u)

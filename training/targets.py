"""What the networks learn: inputs, target and how the cone angle's size is read from the output."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from sailnet.dataset.schema import SAMPLES, SAMPLES_IN_SPACE
from sailnet.mission.recipes import Training, TrainingRecipe
from sailnet.networks.approach import (
    APPROACH_INPUTS,
    APPROACH_INPUTS_IN_SPACE,
    LATERAL_INPUTS,
    approach_coordinates,
    approach_coordinates_in_space,
)
from sailnet.networks.guidance_networks import (
    APPROACH_SIGN_SCALE,
    COMMAND_INPUTS,
    SIGN_SCALE,
    STATE_INPUTS,
)
from sailnet.networks.plan_networks import ARRIVAL_NAMES, factors_of_arrival
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import geometry_of
from sailnet.physics.jumps import cone_angle_size
from sailnet.physics.transfer import Transfer
from training.arrival_targets import arrival_columns, arrival_component, arrival_definition

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
        columns: columns of the data set, of its samples or trajectories, that its target is computed from.
        value: the target from those columns.
        definition: the target in words, as stored in the network's provenance.
        size: |alpha| [rad] from the network's output and phi_max, or None if it is no command.
        crossings: whether it learns what is optimal on the ways of other sails, where data have that. There
            the side is what matters; time and angle would only be less exact where sails are.
        factors: what the network's outputs are multiplied by, see :class:`sailnet.networks.network.Network`.
    """

    name: str
    inputs: tuple[str, ...]
    columns: tuple[str, ...]
    value: Callable[[Columns], Array]
    definition: str
    size: Callable[[Array, float], Array] | None = None
    crossings: bool = False
    factors: tuple[str, ...] = ()

    @property
    def approach(self) -> bool:
        """Whether it reads approach coordinates, which have no direction at the target itself."""
        return not {*APPROACH_INPUTS, *APPROACH_INPUTS_IN_SPACE}.isdisjoint(self.inputs)

    def reads(self, states: Sequence[str]) -> tuple[str, ...]:
        """Columns of the data set that its samples are computed from and judged by.

        Args:
            states: names of the components of a state.
        """
        inputs = [name for name in self.inputs if name in SAMPLES or name in SAMPLES_IN_SPACE]
        if self.approach:
            inputs.append("beta")
        return tuple(dict.fromkeys((*states, *inputs, *self.columns, "alpha", "tau")))

    def complete(self, columns: Columns, transfer: Transfer) -> Columns:
        """Columns as read, with the inputs and with the target as ``value``."""
        known = dict(columns)
        known |= {name: of(known) for name, of in INTEGRALS.items() if name in self.inputs}
        if self.approach:
            size = 5 if "latitude" in known else 3
            states = np.column_stack([known[name] for name in geometry_of(size).state_names])
            of_states = approach_coordinates if size == 3 else approach_coordinates_in_space
            names = APPROACH_INPUTS if size == 3 else (*APPROACH_INPUTS_IN_SPACE, *LATERAL_INPUTS)
            known |= zip(names, of_states(transfer, states, known["beta"]).T, strict=True)
            known["acceleration"] = known["beta"] / transfer.target_radius**2
        return known | {"value": self.value(known)}

    def recipe(self, training: Training) -> TrainingRecipe:
        """The mission's recipe for networks of this form."""
        own = (APPROACH_INPUTS, APPROACH_INPUTS_IN_SPACE)
        recipe = training.wide if self.inputs in own else training.paper
        if self.name in ARRIVAL_NAMES[5]:
            return recipe.of_plan
        return recipe if self.name == "tau" else recipe.of_command


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


def _primer(name: str) -> Callable[[Columns], Array]:
    """A component of (lambda_v, lambda_w): the direction of both, and the asinh of their size."""

    def component(columns: Columns) -> Array:
        size = np.hypot(columns["lambda_v"], columns["lambda_w"])
        scaled = size * columns["acceleration"] / APPROACH_SIGN_SCALE
        return np.asarray(columns[name] / np.where(size > 0.0, size, 1.0) * np.arcsinh(scaled))

    return component


_SPACE = (
    replace(_WIDE[0], inputs=APPROACH_INPUTS_IN_SPACE),
    replace(
        _WIDE[1], inputs=APPROACH_INPUTS_IN_SPACE, definition="|alpha| [rad]: the clock angle says where to"
    ),
    Target(
        "lambda_v",
        APPROACH_INPUTS_IN_SPACE,
        ("lambda_v", "lambda_w"),
        _primer("lambda_v"),
        "lambda_v asinh(p) / |(lambda_v, lambda_w)|, with p = |(lambda_v, lambda_w)| beta / "
        f"(r_f^2 {APPROACH_SIGN_SCALE:g})",
        crossings=True,
    ),
    Target(
        "lambda_w",
        APPROACH_INPUTS_IN_SPACE,
        ("lambda_v", "lambda_w"),
        _primer("lambda_w"),
        "lambda_w scaled as lambda_v: two outputs, times y_z and y_w",
        crossings=True,
        factors=LATERAL_INPUTS,
    ),
)


def _arrival(components: int, inputs: tuple[str, ...]) -> tuple[Target, ...]:
    """The networks of the arrival costates' direction."""
    columns, factors = arrival_columns(components), factors_of_arrival(components)
    return tuple(
        Target(
            name,
            inputs,
            columns,
            arrival_component(row, components),
            arrival_definition(row, components),
            factors=factors[row],
        )
        for row, name in enumerate(ARRIVAL_NAMES[components])
    )


def _named(targets: tuple[Target, ...]) -> Mapping[str, Target]:
    return {target.name: target for target in targets}


TARGETS: Mapping[str, Mapping[str, Target]] = {
    "wide": _named((*_WIDE, *_arrival(3, APPROACH_INPUTS))),
    "wide in space": _named((*_SPACE, *_arrival(5, APPROACH_INPUTS_IN_SPACE))),
    "domain": _named(_PAPER),
    "box": _named(_PAPER),
}
"""By kind of data set and name: the networks that fly, and those the report compares them with."""


def command_error(target: Target, output: Array, alpha: Array, phi_max: float) -> Array:
    """Error of |alpha| in units of 2 phi_max, the range the paper scales alpha_pre by (Table 1).

    One measure for every command target, whatever its own scaling.
    """
    assert target.size is not None
    return (target.size(output, phi_max) - np.abs(alpha)) / (2.0 * phi_max)

"""What the networks learn: inputs, target and how the cone angle's size is read from the output."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from sailnet.dynamics import Array
from sailnet.jumps import cone_angle_size
from sailnet.networks import COMMAND_INPUTS, STATE_INPUTS

Columns = Mapping[str, Array]


def _column(name: str) -> Callable[[Columns], Array]:
    return lambda columns: columns[name]


SIGN_SCALE = 10.0
"""Size of lambda_v [TU^2/AU] below which the sign network's target is nearly linear in it (README.md).

Only the sign of lambda_v is used, and it matters where lambda_v is small; its range is some 60.
"""


@dataclass(frozen=True)
class Target:
    """One network to train.

    Attributes:
        name: file name of the network.
        inputs: columns of the data set it reads.
        columns: columns of the data set its target is computed from.
        value: the target from those columns.
        definition: the target in words, as stored in the network's provenance.
        size: |alpha| [rad] from the network's output and phi_max, or None if it is no command.
    """

    name: str
    inputs: tuple[str, ...]
    columns: tuple[str, ...]
    value: Callable[[Columns], Array]
    definition: str
    size: Callable[[Array, float], Array] | None = None


_ALL = (
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

TARGETS: Mapping[str, Target] = {target.name: target for target in _ALL}
"""By name: the three networks that fly, and those they are compared with in the report."""


def command_error(target: Target, output: Array, alpha: Array, phi_max: float) -> Array:
    """Error of |alpha| in units of 2 phi_max, the range the paper scales alpha_pre by (Table 1).

    One measure for every command target, whatever its own scaling.
    """
    assert target.size is not None
    return (target.size(output, phi_max) - np.abs(alpha)) / (2.0 * phi_max)


def cone_direction(lambda_u: Array, lambda_v: Array) -> Array:
    """|chi| [rad]: angle of (-3 lambda_u, sqrt(8) lambda_v), on which |alpha| alone depends."""
    return np.arctan2(math.sqrt(8.0) * np.abs(lambda_v), -3.0 * lambda_u)

"""The golden vectors: states, beta and periods, and what the float64 reference in NumPy makes of them.

Made from a seed, so that every target and every machine gets the same. Where either of two answers
would be right, at the switch of the cone angle's sign or of the status, there is no golden vector.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from c_runtime.verification.targets.reference import ReferenceGuidance
from sailnet.errors import GuidanceError
from sailnet.flight.closed_loop import History, fly_recorded
from sailnet.flight.starts import random_starts
from sailnet.guidance.interface import GuidanceStatus, Precision, Steered
from sailnet.guidance.rules import LARGEST_PERIOD
from sailnet.mission.disturbances import Disturbance
from sailnet.physics.arrays import Array

SEED = 20261121
FLIGHTS = 40
COMMANDS = 1000
OUTSIDE, ARRIVING = 120, 40
"""Commands for states beyond the box of trained ones, some of them absurd, and within a period of arrival."""
SEQUENCES, PERIODS = 10, 20
"""Steering: pieces of flights, each steered from a fresh memory on."""

NUDGE = 2e-6
"""A state is clear of switches if the sign and status stay when what is missing to the target or beta,
relatively, change by this."""

ROUNDING = 1e-12
"""Rounding decides of steering whose answers such a relative change of states moves beyond their bounds."""

FAR = 0.3
"""Of a turn between two guidance periods [rad]."""

Bounds = tuple[float, float, float, float]
"""Largest |difference| / (1 + |reference|) of cone angle [rad], time of flight [TU], beta and hold [TU]."""

COMMAND_BOUNDS: dict[Precision, Bounds] = {
    "float32": (5e-5, 5e-6, 1e-7, 0.0),
    "float64": (1e-12, 1e-12, 1e-15, 0.0),
}
STEERING_BOUNDS: dict[Precision, Bounds] = {
    "float32": (1e-3, 1e-5, 2e-6, 2e-6),
    "float64": (1e-4, 4e-6, 1e-6, 1e-6),
}
"""A plan passes through the state to its goal of up to 4e-6: rounding decides where Newton's method ends."""


@dataclass(frozen=True)
class Golden:
    """Calls and what is expected of them.

    Attributes:
        inputs: (n, 4) r [AU], u, v [AU/TU] and beta or the period [TU], in the target's precision.
        expected: (n, 4) cone angle [rad], time of flight [TU], beta, hold [TU], float64.
        status: (n,) values of ``GuidanceStatus``.
        starts: (n,) whether steering forgets everything before.
    """

    inputs: NDArray[np.floating]
    expected: Array
    status: NDArray[np.int32]
    starts: NDArray[np.bool_]


def golden_flights(guidance: ReferenceGuidance) -> list[History]:
    """Flights of sails that are a little better or worse than the mission's; golden states are theirs."""
    starts = random_starts(guidance.mission, FLIGHTS, SEED)
    sails = Disturbance(beta_spread=0.1, seed=SEED)
    return fly_recorded(guidance.mission, guidance, starts, disturbance=sails)[1]


def golden_commands(guidance: ReferenceGuidance, histories: list[History], precision: Precision) -> Golden:
    """Calls of ``sailnet_guidance``: all phases of flight, outside the domain, and invalid.

    Raises:
        GuidanceError: the flights give too few states.
    """
    rng = np.random.default_rng([SEED, 1])
    invalid = _invalid(guidance, precision)
    flown = np.concatenate([history.ruv for history in histories])
    # As many near arrival, where units of the approach shrink, as on the way.
    to_go = np.concatenate([history.predicted_time_of_flight for history in histories])
    share = 1.0 / np.maximum(to_go, 1e-3)
    low, high = guidance.networks.state_range
    beyond = low + (high - low) * rng.uniform(-3.0, 4.0, (20 * OUTSIDE, 3))
    beyond = beyond[((beyond < low - 0.01) | (beyond > high + 0.01)).any(axis=1)]
    absurd = np.concatenate([sign * np.eye(3) * size for sign in (1.0, -1.0) for size in (1e6, 1e30, 1e-42)])
    beta_low, beta_high = guidance.beta_range
    target = np.array(guidance.mission.problem.target_state)
    last = np.repeat([history.ruv[-1] for history in histories], 2, axis=0)
    shorter = rng.uniform(0.05, 0.7, (len(last), 1))
    arriving = target + (last - target) * shorter ** np.array([2, 1, 1])
    count = COMMANDS - OUTSIDE - ARRIVING - len(invalid)
    rows: list[Array] = []
    for states, wanted in (
        (flown[rng.choice(len(flown), 2 * count, replace=False, p=share / share.sum())], count),
        (arriving, ARRIVING),
        (np.concatenate([absurd, beyond]), OUTSIDE),
    ):
        sails = rng.uniform(0.9 * beta_low, 1.1 * beta_high, len(states))
        inputs = np.column_stack([states, sails]).astype(precision)
        clear = inputs[_clear(guidance, inputs.astype(float))]
        rows.append(clear[:wanted])
    inputs = np.concatenate([*rows, invalid])
    if len(inputs) != COMMANDS:
        raise GuidanceError(
            f"{len(inputs)} golden commands instead of {COMMANDS}: the flights give too few states"
        )
    with np.errstate(invalid="ignore"):
        wide = inputs.astype(float)
    command = guidance.command(wide[:, :3], wide[:, 3])
    sail = np.where(np.isnan(wide[:, 3]), guidance.mission.sail.beta, wide[:, 3])
    expected = np.column_stack(
        [command.cone_angle, command.time_of_flight, np.clip(sail, beta_low, beta_high), np.zeros(len(wide))]
    )
    return Golden(inputs, expected, command.status, np.zeros(len(wide), bool))


def _clear(guidance: ReferenceGuidance, inputs: Array) -> NDArray[np.bool_]:
    at = guidance.command(inputs[:, :3], inputs[:, 3])
    clear = np.ones(len(inputs), bool)
    origin = (*guidance.mission.problem.target_state, 0.0)
    for column in range(inputs.shape[1]):
        for sign in (1.0, -1.0):
            nudged = inputs.copy()
            nudged[:, column] += sign * NUDGE * (inputs[:, column] - origin[column])
            near = guidance.command(nudged[:, :3], nudged[:, 3])
            clear &= (np.sign(near.cone_angle) == np.sign(at.cone_angle)) & (near.status == at.status)
    return clear


def _invalid(guidance: ReferenceGuidance, precision: Precision) -> NDArray[np.floating]:
    """Valid inputs of which one number in turn becomes a NaN, quiet or signalling, or an infinity."""
    width = np.dtype(precision).itemsize
    infinity = np.array(np.inf, precision).view(f"u{width}")
    quiet = infinity | (infinity >> np.uint8(1))
    sign = np.array(-0.0, precision).view(f"u{width}")
    patterns = [infinity, quiet, infinity + np.uint8(1), quiet + np.uint8(77)]
    valid = np.array([[1.05, 0.15, 1.03, guidance.mission.sail.beta]], precision).view(f"u{width}")
    rows = np.repeat(valid, 8 * 4, axis=0)
    for i, pattern in enumerate([*patterns, *(pattern | sign for pattern in patterns)]):
        for column in range(4):
            rows[4 * i + column, column] = pattern
    return rows.view(precision)


def _steered(guidance: ReferenceGuidance, given: Array) -> tuple[list[Steered], Array]:
    """What steering answers to states and periods, and (n, 4) of it as in ``Golden.expected``."""
    steering = guidance.steering(1)
    steered = [steering.steer(row[None, :3], float(row[3]), np.arange(1)) for row in given]
    return steered, np.array([[s.cone_angle[0], s.time_of_flight[0], s.beta[0], s.hold[0]] for s in steered])


def golden_steering(guidance: ReferenceGuidance, histories: list[History], precision: Precision) -> Golden:
    """Calls of ``sailnet_steer``: departures and arrivals.

    Raises:
        GuidanceError: too few flights are clear of switches.
    """
    inputs: list[NDArray[np.floating]] = []
    expected: list[Array] = []
    status: list[list[int]] = []
    for flight, history in enumerate(histories):
        if len(inputs) == SEQUENCES:
            break
        # Departures and arrivals in turn; in the middle of each two periods that are none and a state that is
        # no number: it is reckoned in departures, near the target it would magnify the state's rounding, and
        # unknown in arrivals, as it follows on a period that is none.
        departs = flight % 2 == 1
        piece = slice(PERIODS) if departs else slice(-PERIODS, None)
        states = history.ruv[piece].astype(precision)
        states[PERIODS // 2 + (0 if departs else 3), flight % 3] = np.nan
        period = np.full(PERIODS, guidance.mission.flight.period, precision)
        period[PERIODS // 2 + 2] = -1.0
        period[PERIODS // 2 + 4] = 1.01 * LARGEST_PERIOD
        given = np.column_stack([states, period])
        steered, outputs = _steered(guidance, given.astype(float))
        valid = np.array([s.status[0] for s in steered]) != GuidanceStatus.INVALID_INPUT
        # Nor any in which the sail turns far or keeps its side: rounding may decide when.
        angle, lambda_v = (
            np.array([getattr(s, name)[0] for s in steered])[valid] for name in ("cone_angle", "lambda_v")
        )
        if (abs(np.diff(angle)) > FAR).any() or (angle * lambda_v > 0.0).any():
            continue
        if not _clear(guidance, np.column_stack([states.astype(float), outputs[:, 2]])[valid]).all():
            continue
        # Nor any in which rounding decides whether Newton's method ends in a period.
        rounded = _steered(guidance, given * [*[1.0 + ROUNDING] * 3, 1.0])[1]
        if (abs(rounded - outputs) > STEERING_BOUNDS[precision] * (1.0 + abs(outputs))).any():
            continue
        inputs.append(given)
        expected.append(outputs)
        status.append([int(s.status[0]) for s in steered])
    if len(inputs) != SEQUENCES:
        raise GuidanceError(f"{len(inputs)} golden flights instead of {SEQUENCES}: too many cross a switch")
    starts = np.tile(np.arange(PERIODS) == 0, SEQUENCES)
    return Golden(np.concatenate(inputs), np.concatenate(expected), np.concatenate(status), starts)

"""Errors of commands in the C, over blocks of states and at the worst of them, refined."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from c_runtime.verification.accuracy.reference import Answers, reference
from c_runtime.verification.accuracy.states import Domain
from c_runtime.verification.bench.compiled import Library, Reals
from sailnet.guidance.interface import GuidanceStatus
from sailnet.networks.guidance_networks import GuidanceNetworks
from sailnet.physics.arrays import Array

QUANTITIES = ("size", "time_of_flight", "time_of_flight_per_s")
"""|cone angle| [rad]; time of flight [TU]; the same in units of s, the scale of the approach coordinates."""

BISECTIONS = 60
"""Steps from the size of the box to the spacing of double precision."""

KEPT = 200
"""Worst states of each quantity that are refined."""


@dataclass(frozen=True)
class Compared:
    """One block; arrays of length n, of the states in the domain.

    Attributes:
        inside: (m,) which of the states asked for are.
        inputs: (n, 4) as the C got them.
        errors: of each quantity.
        flipped: the sign of the cone angle is another.
        lambda_v: of the reference.
        beta: relative error of the beta that the command says it is for.
    """

    inside: NDArray[np.bool_]
    inputs: Array
    errors: dict[str, Array]
    flipped: Array
    lambda_v: Reals
    beta: Array


def compare(networks: GuidanceNetworks, libraries: Sequence[Library], inputs: Array) -> list[Compared]:
    """The C beside the reference at the same inputs: the nearest numbers of the C's precision.

    Args:
        networks: what was exported.
        libraries: builds of it, all of one precision.
        inputs: (n, 4) rows r [AU], u, v [AU/TU] and beta.
    """
    rounded = inputs.astype(libraries[0].shape.precision)
    given = rounded.astype(float)
    right = reference(networks, given)
    wanted = np.clip(given[:, 3], *networks.beta_range)
    found = []
    for library in libraries:
        outputs = library.evaluate(rounded).astype(float)
        inside = in_domain(outputs)
        angle, tau, beta = outputs.T[:3]
        found.append(
            Compared(
                inside,
                given[inside],
                {name: error[inside] for name, error in differences(angle, tau, right).items()},
                (angle * right.cone_angle < 0.0)[inside],
                right.lambda_v[inside],
                np.abs(beta / wanted - 1.0)[inside],
            )
        )
    return found


def in_domain(outputs: Reals) -> NDArray[np.bool_]:
    """(n,) whether the guard accepts the state, by (n, 4) outputs of the C."""
    return np.isin(outputs[:, 3], [GuidanceStatus.OK, GuidanceStatus.ARRIVED])


def differences(cone_angle: Reals, time_of_flight: Reals, right: Answers) -> dict[str, Array]:
    """Errors of each quantity, (n,) each."""
    late = np.abs(time_of_flight - right.time_of_flight)
    size = np.abs(np.abs(cone_angle) - np.abs(right.cone_angle))
    found = {"size": size, "time_of_flight": late, "time_of_flight_per_s": late / right.scale}
    return {name: error.astype(np.float64) for name, error in found.items()}


@dataclass
class Tally:
    """Errors over many blocks, kept in single precision, and the worst states.

    Attributes:
        errors: of each quantity, by block.
        worst: (n, 4) inputs of the largest errors of each quantity, by falling error.
        flips, nearest: number of other signs, and the largest |lambda_v| among them.
        beta: largest relative error of beta.
        states: in the domain.
    """

    errors: dict[str, list[Array]] = field(default_factory=lambda: {name: [] for name in QUANTITIES})
    worst: dict[str, Array] = field(default_factory=lambda: dict.fromkeys(QUANTITIES, np.empty((0, 4))))
    flips: int = 0
    nearest: float = 0.0
    beta: float = 0.0
    states: int = 0
    _at_worst: dict[str, Array] = field(default_factory=lambda: dict.fromkeys(QUANTITIES, np.empty(0)))

    def add(self, block: Compared) -> None:
        """Count a block."""
        self.states += len(block.inputs)
        self.flips += int(block.flipped.sum())
        self.nearest = max(self.nearest, np.abs(block.lambda_v[block.flipped]).max(initial=0.0))
        self.beta = max(self.beta, block.beta.max(initial=0.0))
        for name, error in block.errors.items():
            self.errors[name].append(error.astype(np.float32))
            all_errors = np.concatenate([self._at_worst[name], error])
            order = np.argsort(-all_errors)[:KEPT]
            self.worst[name] = np.concatenate([self.worst[name], block.inputs])[order]
            self._at_worst[name] = all_errors[order]

    def summary(self, name: str) -> dict[str, float]:
        """Largest error, its 99.9 % quantile and median."""
        error = np.concatenate(self.errors[name]).astype(float)
        quantile, median = np.quantile(error, [0.999, 0.5])
        return {
            "largest": float(self._at_worst[name].max(initial=0.0)),
            "quantile_999": float(quantile),
            "median": float(median),
        }


def refine(
    error: Callable[[Array], Array], starts: Array, domain: Domain, rounds: int, seed: int
) -> tuple[float, Array]:
    """The largest error near the worst states: a random search around each, in steps of all sizes.

    Args:
        error: (n, 4) inputs to (n,) errors; smaller than any, -1, outside the domain.
        starts: (n, 4).
        domain: states stay in its box.
        rounds: steps of each start.
        seed: of the steps.

    Returns:
        The error, and the (n, 4) states that the starts were led to.
    """
    rng = np.random.default_rng(seed)
    best = starts.copy()
    found = error(best)
    width = domain.highest - domain.lowest
    for _ in range(rounds):
        # From a hundredth of the box to the spacing of single precision, where errors are like noise.
        length = 10.0 ** rng.uniform(-7.5, -2.0, (len(best), 1))
        step = length * width * rng.normal(size=best.shape) * (rng.random(best.shape) < 0.5)
        tried = np.clip(best + step, domain.lowest, domain.highest)
        at_tried = error(tried)
        better = at_tried > found
        best[better], found[better] = tried[better], at_tried[better]
    return float(found.max(initial=0.0)), best


def at_sign_change(networks: GuidanceNetworks, library: Library, inputs: Array) -> dict[str, float]:
    """Bisection for lambda_v = 0 between states of either sign, watching where the C has another one.

    Args:
        networks: what was exported.
        library: one build of it.
        inputs: (2 n, 4): row i and row n + i are a pair.

    Returns:
        The number of pairs and of flips, and the largest |lambda_v| among the flips.
    """
    here, there = np.split(inputs, 2)
    sign_here, sign_there = (np.sign(reference(networks, ends).lambda_v) for ends in (here, there))
    apart = sign_here * sign_there < 0.0
    here, there, sign_here = here[apart], there[apart], sign_here[apart]
    flips, nearest = 0, 0.0
    for _ in range(BISECTIONS):
        middle = (here + there) / 2.0
        (compared,) = compare(networks, [library], middle)
        flips += int(compared.flipped.sum())
        nearest = max(nearest, float(np.abs(compared.lambda_v[compared.flipped]).max(initial=0.0)))
        same = reference(networks, middle).lambda_v * sign_here > 0.0
        here, there = np.where(same[:, None], middle, here), np.where(same[:, None], there, middle)
    return {"pairs": float(apart.sum()), "flips": float(flips), "nearest": nearest}

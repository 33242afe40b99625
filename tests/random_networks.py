"""Untrained networks with the scaling of the Earth-Mars box, whose outputs cover their range."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from scipy.special import expit

from sailnet import Mission, load_mission
from sailnet.networks.approach import APPROACH_INPUTS, APPROACH_INPUTS_IN_SPACE, LATERAL_INPUTS
from sailnet.networks.guidance_in_space import NAMES, AnyGuidanceNetworks, GuidanceNetworksInSpace
from sailnet.networks.guidance_networks import COMMAND_INPUTS, STATE_INPUTS, GuidanceNetworks
from sailnet.networks.known_plans import KnownPlans, save_known_plans
from sailnet.networks.network import Network, save_network
from sailnet.networks.plan_networks import ARRIVAL_NAMES, PlanNetworks, factors_of_arrival
from sailnet.networks.trained_domain import AXES, DIRECTIONS, KNOTS, ORBITS
from sailnet.physics.arrays import Array
from tests.guidance.tracker.plans import planned_starts

STATE_MIN, STATE_MAX = (0.35, -0.45, 0.59), (1.56, 0.45, 1.85)
WIDE = [[100.0] * (len(AXES) + 2)] * KNOTS
NO_TUBE = {
    "size_step": 10.0,
    "momentum_min": -10.0,
    "momentum_step": 10.0,
    "lower": (-np.array(WIDE)).tolist(),
    "upper": WIDE,
}
"""A trained domain that is as wide as the box."""
STATE_MIN_IN_SPACE, STATE_MAX_IN_SPACE = (0.6, -0.12, -0.45, 0.59, -0.15), (1.56, 0.12, 0.45, 1.2, 0.15)
WIDE_IN_SPACE = [[100.0] * (DIRECTIONS[5] + ORBITS[5])] * KNOTS
NO_TUBE_IN_SPACE = NO_TUBE | {"lower": (-np.array(WIDE_IN_SPACE)).tolist(), "upper": WIDE_IN_SPACE}
BETA_SHARES = (0.8, 1.2)
"""Range of beta of approach networks, in units of the mission's."""
OUTPUT_RANGE = {
    "tau": (0.0, 10.0),
    "alpha_pre": (-1.05, 1.05),
    "alpha": (-1.05, 1.05),
    "lambda_v": (-50.0, 14.0),
}
APPROACH_OUTPUT_RANGE = {
    **OUTPUT_RANGE,
    **{"tau": (-14.0, 1.0), "lambda_v": (-3.0, 3.0)},
    **dict.fromkeys(ARRIVAL_NAMES[5], (-1.0, 1.0)),
}
"""tau is log(tau / s) here: a wide range, so that there are arrivals among random states."""


def random_network(
    name: str,
    hidden: Sequence[int] = (20, 20, 20),
    seed: int = 0,
    mission: Mission | None = None,
    approach: bool = False,
) -> Network:
    """A network whose output covers its range, and a little more, over its box of inputs."""
    mission = mission or load_mission("earth_mars")
    inputs: tuple[str, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]
    if approach:
        smallest, largest = (share * mission.sail.beta for share in BETA_SHARES)
        inputs = APPROACH_INPUTS
        low, high = (-0.5, -1.0, -1.0, 0.0, smallest), (0.5, 1.0, 1.0, 16.0, largest)
    elif name == "tau":
        inputs, low, high = STATE_INPUTS, STATE_MIN, STATE_MAX
    else:
        inputs, low, high = COMMAND_INPUTS, (*STATE_MIN, 0.0), (*STATE_MAX, 10.0)
    weights, biases = _random_layers(len(inputs), hidden, 1, [seed, len(name), *name.encode()])
    output_min, output_max = (APPROACH_OUTPUT_RANGE if approach else OUTPUT_RANGE)[name]
    return Network(
        name=name,
        inputs=inputs,
        weights=weights,
        biases=biases,
        input_min=np.array(low),
        input_max=np.array(high),
        output_min=output_min,
        output_max=output_max,
        mission=mission,
        provenance={
            "dataset": "random */ weights",
            "state_min": STATE_MIN,
            "state_max": STATE_MAX,
            "domain": NO_TUBE,
        },
    )


def random_network_in_space(
    name: str, hidden: Sequence[int] = (20, 20, 20), seed: int = 0, mission: Mission | None = None
) -> Network:
    """A network of three dimensions whose outputs cover their range over its box of inputs."""
    mission = mission or load_mission("earth_mars_3d")
    smallest, largest = (share * mission.sail.beta for share in BETA_SHARES)
    low = (-0.5, -1.0, -1.0, 0.0, -1.0, 0.0, 0.0, smallest)
    high = (0.5, 1.0, 1.0, 0.5, 1.0, 1.0, 16.0, largest)
    of_arrival = dict(zip(ARRIVAL_NAMES[5], factors_of_arrival(5), strict=True))
    factors = LATERAL_INPUTS if name == "lambda_w" else of_arrival.get(name, ())
    weights, biases = _random_layers(
        len(low), hidden, max(1, len(factors)), [seed, len(name), *name.encode()]
    )
    output_min, output_max = (0.0, 3.0) if factors else APPROACH_OUTPUT_RANGE[name]
    return Network(
        name=name,
        inputs=APPROACH_INPUTS_IN_SPACE,
        weights=weights,
        biases=biases,
        input_min=np.array(low),
        input_max=np.array(high),
        output_min=output_min,
        output_max=output_max,
        mission=mission,
        provenance={
            "dataset": "random */ weights",
            "state_min": STATE_MIN_IN_SPACE,
            "state_max": STATE_MAX_IN_SPACE,
            "domain": NO_TUBE_IN_SPACE,
        },
        factors=factors,
    )


def _random_layers(
    inputs: int, hidden: Sequence[int], outputs: int, seed: Sequence[int]
) -> tuple[tuple[Array, ...], tuple[Array, ...]]:
    """Weights and biases; each output covers [0, 1], and a little more, over scaled inputs in [0, 1]."""
    rng = np.random.default_rng(seed)
    sizes = [inputs, *hidden]
    shapes = list(zip(sizes[1:], sizes[:-1], strict=True))
    weights = [rng.normal(scale=3.0 if i == 0 else 6.0 / np.sqrt(s[1]), size=s) for i, s in enumerate(shapes)]
    biases = [-w.sum(axis=1) / 2 + rng.normal(scale=0.5, size=len(w)) for w in weights]
    layer = rng.uniform(size=(4000, inputs))
    for weight, bias in zip(weights, biases, strict=True):
        layer = expit(layer @ weight.T + bias)
    last = rng.normal(size=(outputs, hidden[-1]))
    given = layer @ last.T
    lowest, highest = given.min(axis=0), given.max(axis=0)
    scale = 1.02 / (highest - lowest)
    return (*weights, scale[:, None] * last), (*biases, -scale * lowest - 0.01)


def random_guidance(
    tau: Sequence[int] = (20, 20, 20),
    alpha_pre: Sequence[int] = (20, 20, 20),
    lambda_v: Sequence[int] = (20, 20, 20),
    seed: int = 0,
    mission: Mission | None = None,
    approach: bool = False,
) -> GuidanceNetworks:
    """Three random networks with these hidden sizes."""
    return GuidanceNetworks(
        random_network("tau", tau, seed, mission, approach),
        random_network("alpha_pre", alpha_pre, seed, mission, approach),
        random_network("lambda_v", lambda_v, seed, mission, approach),
    )


def random_guidance_in_space(
    *hidden: Sequence[int], seed: int = 0, mission: Mission | None = None
) -> GuidanceNetworksInSpace:
    """Four random networks, with these hidden sizes if they are said."""
    sizes = hidden or ((20, 20, 20),) * len(NAMES)
    named = zip(NAMES, sizes, strict=True)
    return GuidanceNetworksInSpace(
        *(random_network_in_space(name, size, seed, mission) for name, size in named)
    )


def random_plan_networks(seed: int = 0, mission: Mission | None = None) -> PlanNetworks:
    """Random networks of the arrival costates, of the mission's dimensions, and known plans."""
    mission = mission or load_mission("earth_mars")
    names = ARRIVAL_NAMES[mission.components]
    if mission.inclined:
        networks = tuple(random_network_in_space(n, seed=seed, mission=mission) for n in names)
    else:
        networks = tuple(random_network(n, seed=seed, mission=mission, approach=True) for n in names)
    return PlanNetworks(networks, random_known_plans(mission, 40, seed))


def random_known_plans(mission: Mission, count: int, seed: int = 0) -> KnownPlans:
    """Extremals that are true, and not always the fastest."""
    states, trackers = planned_starts(mission, count, np.random.default_rng(seed))
    plans = trackers["plan"]
    shares, provenance = np.ones(count), {"dataset": "none"}
    return KnownPlans(states, shares, plans["direction"], plans["time_to_go"], mission, provenance)


def save_guidance(networks: AnyGuidanceNetworks | PlanNetworks, folder: Path) -> None:
    """Write the files that ``load_networks_of`` or ``load_plan_networks`` reads."""
    for network in networks.all:
        save_network(network, folder / f"{network.name}.safetensors")
    if isinstance(networks, PlanNetworks) and networks.known is not None:
        save_known_plans(networks.known, folder)

"""``python -m export.agreement``: the exported C against onnxruntime against PyTorch, state by state.

Two sets of states: samples of the data set, where the networks were trained, and uniform states of the
box around them, most of which no trajectory passes.
"""

import argparse
import json
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

import numpy as np
import torch

from export.torch_guidance import torch_guidance
from sailnet import SailnetError
from sailnet.dataset import open_dataset
from sailnet.errors import GuidanceError
from sailnet.guidance.backends import Backend, load_guidance
from sailnet.guidance.facts import describe
from sailnet.guidance.interface import FirstPlans, Precision
from sailnet.guidance.tilts import tilt_of, turned
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks, load_networks_of, network_outputs
from sailnet.networks.plan_networks import PlanNetworks, load_plan_networks, unit_vectors
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import geometry_of
from sailnet.workers.interruption import run_command

PRECISIONS: tuple[Precision, ...] = ("float64", "float32")
BACKENDS: Mapping[str, Backend] = {"C": "c", "onnxruntime": "onnx"}

SIGN_MARGIN: Mapping[str, float] = {"float64": 1e-9, "float32": 1e-3}
"""Costates [1], as the networks give them, below which rounding may decide to which side the sail turns."""

GOAL: Mapping[str, float] = {"float64": 1e-12, "float32": 1e-6}
"""Difference of the attitudes [rad] that is aimed at."""


@dataclass(frozen=True)
class Sails:
    """Where commands are compared.

    Attributes:
        states: (n, 3) rows r, u, v, or (n, 5) rows r, latitude, u, v, w.
        beta: (n,) normalised characteristic accelerations; without effect on networks that read none.
    """

    states: Array
    beta: Array

    def rounded(self, precision: Precision) -> "Sails":
        """The nearest sails of a precision."""
        return Sails(*(values.astype(precision).astype(float) for values in (self.states, self.beta)))


def sails_of_dataset(path: Path, mission: Mission, count: int, seed: int) -> Sails:
    """Samples drawn evenly from a data set of a mission.

    Raises:
        DatasetError: it cannot be read, or is another mission's.
    """
    names = geometry_of(mission.components).state_names
    with open_dataset(path, mission) as data:
        data.verify()
        rows = np.sort(np.random.default_rng(seed).choice(data.samples, count))
        columns = data.read([*names, "beta"], 0, data.samples)
        return Sails(np.column_stack([columns[name][rows] for name in names]), columns["beta"][rows])


def sails_of_box(networks: AnyGuidanceNetworks, count: int, seed: int) -> Sails:
    """Uniform in the box of trained states and the range of trained beta."""
    rng = np.random.default_rng(seed)
    facts = describe(networks, networks.mission)
    states = rng.uniform(facts.state_min, facts.state_max, (count, facts.components))
    return Sails(states, rng.uniform(*networks.beta_range, count))


def costate_size(networks: AnyGuidanceNetworks, sails: Sails) -> Array:
    """(n,) size of lambda_v, in space of (lambda_v, lambda_w), as the networks give it."""
    _tau, _size, *costates = network_outputs(networks, sails.states, sails.beta).T
    return np.asarray(np.linalg.norm(costates, axis=0))


def in_torch(networks: AnyGuidanceNetworks, sails: Sails, precision: Precision) -> tuple[Array, Array]:
    """Tilt of the sail [rad] and time of flight [TU] as PyTorch computes them; in the plane (n,) each.

    In space the tilt is (n, 2), see :mod:`sailnet.guidance.tilts`.
    """
    module = torch_guidance(networks, describe(networks, networks.mission))
    module = module.in_float32() if precision == "float32" else module
    given = (sails.states, sails.beta)[: 2 if networks.approach else 1]
    with torch.inference_mode():
        outputs = module(*(torch.tensor(values, dtype=getattr(torch, precision)) for values in given))
    cone, tau, _, *clock = (output.double().numpy() for output in outputs[:4])
    return tilt_of(cone, clock[0] if clock else None), tau


def compare_directions(plan: PlanNetworks, exported: Path, sails: Sails) -> list[dict[str, object]]:
    """Angles between the directions of the arrival costates that every pair of evaluations gives.

    Returns:
        Records as of :func:`compare`, over all states.
    """
    records = list[dict[str, object]]()
    for precision in PRECISIONS:
        given = sails.rounded(precision)
        directions = {"NumPy": plan.direction(given.states, given.beta)}
        for name, backend in BACKENDS.items():
            guidance = load_guidance(plan.mission, backend, precision, exported)
            assert isinstance(guidance, FirstPlans)
            found = guidance.arrival_directions(given.states, given.beta)
            if found is None:
                raise GuidanceError(f"{exported} holds no networks of a plan: export them again")
            directions[name] = unit_vectors(found)
        for one, other in combinations(directions, 2):
            apart = np.linalg.norm(directions[one] - directions[other], axis=1)
            angle = 2.0 * np.arcsin(0.5 * apart)
            records.append(_record(precision, f"{one} - {other}, arrival costates", angle, 1.0))
    return records


def _record(precision: Precision, pair: str, angle: Array, compared: float) -> dict[str, object]:
    return {
        "precision": precision,
        "pair": pair,
        "largest": float(angle.max()),
        "quantile_999": float(np.quantile(angle, 0.999)),
        "median": float(np.median(angle)),
        "share_within_goal": float((angle <= GOAL[precision]).mean()),
        "share_compared": compared,
    }


def compare(networks: AnyGuidanceNetworks, exported: Path, sails: Sails) -> list[dict[str, object]]:
    """Angles between the attitudes that every pair of evaluations commands, in both precisions.

    Returns:
        One record a precision and pair: largest angle between the sail's normals [rad], its 99.9 % quantile
        and median, and the share within ``GOAL``, over the states where the costates that decide to which
        side the sail turns are not within rounding of zero; and the share of those states.
    """
    mission, records = networks.mission, list[dict[str, object]]()
    for precision in PRECISIONS:
        given = sails.rounded(precision)
        commands = {
            name: load_guidance(mission, backend, precision, exported).command(given.states, given.beta)
            for name, backend in BACKENDS.items()
        }
        tilts = {name: tilt_of(done.cone_angle, done.clock_angle) for name, done in commands.items()}
        tilts["PyTorch"] = in_torch(networks, given, precision)[0]
        certain = costate_size(networks, given) > SIGN_MARGIN[precision]
        for one, other in combinations(tilts, 2):
            difference = turned(tilts[one], tilts[other])[certain]
            records.append(_record(precision, f"{one} - {other}", difference, float(certain.mean())))
    return records


def main() -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m export.agreement",
        description=__doc__,
        epilog="example: python -m export.agreement build/earth_mars/networks build/earth_mars/export "
        "--dataset build/earth_mars/box.h5",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("networks", type=Path, help="folder of the weights")
    parser.add_argument("exported", type=Path, help="folder written by python -m export")
    parser.add_argument("--dataset", type=Path, required=True, help="the HDF5 file they were trained on")
    parser.add_argument("--states", type=int, default=100_000, help="of each kind (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the draws (%(default)s)")
    options = parser.parse_args()
    try:
        with open_dataset(options.dataset, None) as data:
            networks = load_networks_of(data.mission, options.networks)
            plan = load_plan_networks(options.networks, data.mission)
        kinds = {
            "samples of the data set": sails_of_dataset(
                options.dataset, networks.mission, options.states, options.seed
            ),
            "uniform in the box": sails_of_box(networks, options.states, options.seed),
        }
        records = [
            {"states": kind, "count": options.states, **record}
            for kind, sails in kinds.items()
            for record in [
                *compare(networks, options.exported, sails),
                *(() if plan is None else compare_directions(plan, options.exported, sails)),
            ]
        ]
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print(json.dumps(records, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

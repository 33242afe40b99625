"""``python -m training.convergence``: from how many states the networks' plan converges to the optimum.

A plan of the networks, the direction of the arrival costates and the time to go, is corrected by the tracker
as on board, within a number of extremals. States are of the test trajectories, whose optimum is known, and
displaced ones around them, whose optimum is not.
"""

import argparse
import itertools
import json
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.campaign.tables import Table
from sailnet.dataset import open_dataset
from sailnet.errors import NetworkError, SailnetError
from sailnet.guidance.tracker.library import problem_of, tracker
from sailnet.networks.approach_inputs import approach_inputs, time_of_flight
from sailnet.networks.network import Network, load_network
from sailnet.networks.plan_networks import PlanNetworks, load_plan_networks
from sailnet.physics.transfer import Transfer
from sailnet.workers.interruption import run_command
from sailnet.workers.progress import progress
from training.plan_states import BANDS, DISPLACEMENT, States, displaced, states_of
from training.samples import PARTS

CALLS = {25: (25,), 80: (55,), 200: (60, 60)}
"""Extremals that are computed at most, and the calls of the tracker that lead there from the one before."""

SAME_OPTIMUM, LONGER = 0.002, 0.02
"""Relative difference to the known optimum; and to the networks' time of flight where none is known."""

TITLES = {
    "known": f"Held-out states: converged, and converged to the optimum within {SAME_OPTIMUM:.1%}",
    "displaced": f"Displaced by up to {DISPLACEMENT:.0%}: converged, and to an extremal no more than "
    f"{LONGER:.0%} longer than predicted",
}


@dataclass(frozen=True)
class Share:
    """What became of the plans in one band.

    Attributes:
        band: lowest and highest time to go [TU].
        states: how many.
        converged: share of them whose plan converged, for each budget of ``CALLS``.
        fastest: share whose plan converged to the known optimum; where none is known, to an extremal that is
            no longer than predicted.
    """

    band: tuple[float, float]
    states: int
    converged: tuple[float, ...]
    fastest: tuple[float, ...]


def first_plans(networks: PlanNetworks, tau: Network, given: States) -> NDArray[np.void]:
    """(n,) plans of the networks, as the tracker's.

    Args:
        networks: of the arrival costates.
        tau: of the time of flight.
        given: states.
    """
    predicted = time_of_flight(tau, approach_inputs(tau, given.states, given.beta))
    directions = networks.direction(given.states, given.beta)
    return tracker(networks.components).begun(directions, predicted, given.beta)


def corrected(
    transfer: Transfer, plans: NDArray[np.void], given: States, calls: Sequence[int]
) -> NDArray[np.bool_]:
    """(n,) whether plans are solved after some calls of the tracker; they are corrected in place.

    Args:
        transfer: the problem.
        plans: of :func:`first_plans`, of which those that are solved stay as they are.
        given: states to pass through.
        calls: extremals that each call computes at most.
    """
    problem = problem_of(transfer.optics, transfer.phi_max, transfer.beta, transfer.target_radius)
    corrector = tracker(given.states.shape[1])
    for most in calls:
        rows = np.flatnonzero(~corrector.solved(plans))
        own = plans[rows]
        corrector.correct(problem, own, given.states[rows], most)
        plans[rows] = own
    return corrector.solved(plans)


def shares(transfer: Transfer, plans: NDArray[np.void], given: States, known: bool) -> list[Share]:
    """What becomes of plans, by bands of the time to go, the last one all; the plans are corrected in place.

    Args:
        transfer: the problem.
        plans: of :func:`first_plans`.
        given: states to pass through.
        known: whether the optimum from them is.
    """
    predicted = plans["time_to_go"].copy()
    longest = (1.0 + SAME_OPTIMUM) * given.tau if known else (1.0 + LONGER) * predicted
    shortest = (1.0 - SAME_OPTIMUM) * given.tau if known else np.zeros(len(plans))
    reached = []
    for calls in CALLS.values():
        tau, converged = plans["time_to_go"], corrected(transfer, plans, given, calls)
        reached.append((converged, converged & (tau >= shortest) & (tau <= longest)))
    found = []
    for low, high in (*itertools.pairwise(BANDS), (BANDS[0], BANDS[-1])):
        here = (given.tau > low) & (given.tau <= high)
        if here.any():
            both = (tuple(float(of[here].mean()) for of in kind) for kind in zip(*reached, strict=True))
            found.append(Share((low, high), int(here.sum()), *both))
    return found


def table(title: str, rows: Sequence[Share]) -> Table:
    """A row for each band, with the share that converged and that of the fastest, for each budget."""
    heads = ["time to go [TU]", "states", *(f"{budget} extremals" for budget in CALLS)]
    cells = []
    for row in rows:
        low, high = row.band
        band = "all" if row is rows[-1] else f"over {low:g}" if high == np.inf else f"{low:g} to {high:g}"
        both = zip(row.converged, row.fastest, strict=True)
        cells.append([band, f"{row.states:,}", *(f"{one:.1%}, {other:.1%}" for one, other in both)])
    return Table(title, heads, cells)


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m training.convergence",
        description=__doc__,
        epilog="example: python -m training.convergence wide.h5 networks",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("dataset", type=Path, help="the HDF5 file the networks were trained on")
    parser.add_argument("networks", type=Path, help="folder of NAME.safetensors")
    parser.add_argument("--states", type=int, default=400, help="of each band of time to go (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the states (%(default)s)")
    parser.add_argument("--part", choices=PARTS[1:], default="test", help="of the trajectories (%(default)s)")
    parser.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    parser.add_argument("--text", type=Path, help="file with marks <!-- convergence MISSION -->")
    options = parser.parse_args()
    if options.states < 1:
        parser.error("--states must be at least 1")
    try:
        with open_dataset(options.dataset) as data:
            mission = data.mission
            networks = load_plan_networks(options.networks, mission)
            if networks is None:
                raise NetworkError(f"{options.networks} holds no networks of arrival costates")
            tau, record = load_network(options.networks / "tau.safetensors"), networks.all[0].provenance
            if record.get("dataset") != data.digest:
                raise NetworkError(
                    f"{options.networks} was trained on data set {record.get('dataset')}, and "
                    f"{options.dataset} is {data.digest}: name the one it was trained on"
                )
            with progress(3, "part", "convergence", quiet=options.json) as bar:
                known = states_of(data, options.part, int(str(record["seed"])), options.states, options.seed)
                bar.update()
                found: dict[str, list[Share]] = {}
                moved = displaced(mission.problem, known, options.seed)
                for name, states in {"known": known, "displaced": moved}.items():
                    plans = first_plans(networks, tau, states)
                    found[name] = shares(mission.problem, plans, states, name == "known")
                    bar.update()
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    printed = [table(TITLES[name], rows) for name, rows in found.items()]
    if options.text:
        made = software()
        origin = f"{made['machine']}, {made['date']}, revision {made['revision']}."
        blocks = [*(one.block() for one in printed), origin]
        fill_block(options.text, f"convergence {mission.name}", "\n\n".join(blocks))
    if options.json:
        print(json.dumps({name: [asdict(row) for row in rows] for name, rows in found.items()}))
    else:
        print("\n\n".join("\n".join(one.lines()) for one in printed))
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

"""``python -m c_runtime.verification.accuracy``: how far the exported C is from the reference.

Cone angle and time of flight of every layout and precision beside the float64 reference in NumPy, at the
same inputs: over the trained domain, along optimal flights, and at the worst of those states, refined.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

import numpy as np

from c_runtime.shared_library import CompilerError, find_compiler
from c_runtime.verification.accuracy import report
from c_runtime.verification.accuracy.errors import QUANTITIES
from c_runtime.verification.accuracy.judge import CHECKED, FLIGHTS, UNIFORM, Judge, compile_builds
from c_runtime.verification.accuracy.states import Domain
from c_runtime.verification.bench.subjects import read_facts
from sailnet import SailnetError
from sailnet.artefacts.files import fill_block, split_at_block
from sailnet.artefacts.provenance import software
from sailnet.networks.guidance_networks import load_guidance_networks


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m c_runtime.verification.accuracy", description=__doc__)
    parser.add_argument("exported", type=Path, help="folder written by python -m export")
    parser.add_argument("--networks", type=Path, help="folder of the weights (default: the exported one)")
    parser.add_argument("--dataset", type=Path, help="HDF5 file of optimal flights, to judge along them too")
    parser.add_argument("--states", type=int, default=1_000_000, help="of each kind (%(default)s)")
    parser.add_argument("--rounds", type=int, default=400, help="of refining the worst (%(default)s)")
    parser.add_argument("--seed", type=int, default=2, help="of every random number (%(default)s)")
    parser.add_argument("--json", action="store_true", help="print one JSON object instead of tables")
    parser.add_argument("--readme", type=Path, help="also write the tables into this file")
    return parser


def main(arguments: list[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    options = _parser().parse_args(arguments)
    try:
        if options.readme:
            split_at_block(options.readme, "accuracy")  # before, not after, all the work
        with tempfile.TemporaryDirectory() as folder:
            found = judge(options, Path(folder))
        if options.readme:
            fill_block(options.readme, "accuracy", report.markdown(found))
    except (CompilerError, SailnetError, OSError) as error:
        print(f"accuracy: {error}", file=sys.stderr)
        return 1
    print(json.dumps(found) if options.json else report.text(found))
    return 0


def judge(options: argparse.Namespace, folder: Path) -> report.Found:
    """Everything the command prints."""
    networks = load_guidance_networks(options.networks or options.exported)
    builds = compile_builds(find_compiler(), options.exported.resolve(), folder)
    one = Judge(networks, builds, Domain.of(read_facts(options.exported)), options.seed)
    kinds = {UNIFORM: one.uniform(options.states)}
    if options.dataset:
        kinds[FLIGHTS] = one.domain.along_flights(options.dataset, options.states, options.seed)
    tallies = {kind: one.count(blocks, options.states, kind) for kind, blocks in kinds.items()}
    starts = {
        build.name: {
            quantity: np.concatenate([tally[build.name].worst[quantity] for tally in tallies.values()])
            for quantity in QUANTITIES
        }
        for build in builds
    }
    some = [*one.uniform(CHECKED)]
    some += [starts[build.name][quantity] for build in builds for quantity in QUANTITIES]
    origin = software()
    return {
        "machine": origin["machine"],
        "date": origin["date"],
        "revision": origin["revision"],
        "seed": options.seed,
        "kinds": {
            kind: {
                name: {
                    "states": tally.states,
                    "flips": tally.flips,
                    "nearest": tally.nearest,
                    "beta": tally.beta,
                    **{quantity: tally.summary(quantity) for quantity in QUANTITIES},
                }
                for name, tally in by_build.items()
            }
            for kind, by_build in tallies.items()
        },
        "refined": one.refined(starts, options.rounds),
        "sign_changes": one.sign_changes(),
        "reference": one.reference_error(np.unique(np.concatenate(some), axis=0)),
        "extended_eps": float(np.finfo(np.longdouble).eps),
    }


if __name__ == "__main__":
    sys.exit(main())

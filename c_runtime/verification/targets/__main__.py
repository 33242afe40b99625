"""``python -m c_runtime.verification.targets``: build, run and check the flight file in emulation.

``python -m c_runtime.verification.targets fly`` lets emulated processors steer whole flights instead.
"""

import argparse
import json
import os
import subprocess
import sys
from datetime import UTC, datetime
from pathlib import Path

from c_runtime.builds import LAYOUTS
from c_runtime.verification.targets import fly
from c_runtime.verification.targets.build import TargetError
from c_runtime.verification.targets.machines import TARGETS, Target
from c_runtime.verification.targets.measure import Bench, Measured, left_out_of
from c_runtime.verification.targets.reference import ReferenceGuidance
from c_runtime.verification.targets.table import BLOCK, limits, table
from sailnet.artefacts.files import fill_block, split_at_block, write_text
from sailnet.errors import SailnetError
from sailnet.networks.guidance_networks import load_guidance_networks
from sailnet.networks.plan_networks import load_plan_networks
from sailnet.workers.interruption import run_command


def main(arguments: list[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    given = sys.argv[1:] if arguments is None else arguments
    if given[:1] == ["fly"]:
        return fly.main(given[1:])
    names = [target.name for target in TARGETS]
    parser = argparse.ArgumentParser(prog="python -m c_runtime.verification.targets", description=__doc__)
    parser.add_argument("exported", type=Path, help="folder written by python -m export")
    parser.add_argument("--networks", type=Path, help="folder of the weights (default: the exported folder)")
    parser.add_argument("--build", type=Path, required=True, help="folder for programs and targets.json")
    parser.add_argument(
        "--targets", nargs="+", choices=names, default=names, metavar="NAME", help=", ".join(names)
    )
    parser.add_argument("--layouts", nargs="+", choices=list(LAYOUTS), default=["flight"], metavar="LAYOUT")
    parser.add_argument("--table", type=Path, help="a text whose table is to be rewritten")
    parser.add_argument(
        "--require",
        action="store_true",
        default=os.environ.get("CI") == "true",
        help="a missing tool is an error (default where CI=true)",
    )
    parser.add_argument("--limits", action="store_true", help="a limit that is missed is an error")
    options = parser.parse_args(given)

    wanted = [target for target in TARGETS if target.name in options.targets]
    left_out = left_out_of(wanted)
    present = [target for target in wanted if target.name not in left_out]
    try:
        if options.table is not None:
            split_at_block(options.table, BLOCK)  # before, not after, all the work
        weights = options.networks or options.exported
        networks = load_guidance_networks(weights)
        guidance = ReferenceGuidance(networks, load_plan_networks(weights, networks.mission))
        bench = Bench(guidance, options.exported.resolve(), options.build.resolve()) if present else None
        measured, failed = _measure(bench, present, options.layouts) if bench else ([], False)
        checked = limits(measured)
        print("\n".join(map(str, checked)))
        report = {
            "date": datetime.now(UTC).isoformat(timespec="seconds"),
            "networks": guidance.networks_digest,
            "left_out": left_out,
            "limits": [{"what": str(limit), "kept": limit.kept} for limit in checked],
            "rows": [build.to_json() for build in measured],
        }
        stored = json.dumps(report, indent=1) + "\n"
        write_text(options.build / "targets.json", stored)
        if options.table is not None and not failed:
            if left_out:
                raise TargetError("the table would be without some targets: it stays as it was")
            fill_block(options.table, BLOCK, table(measured))
    except (SailnetError, OSError, subprocess.CalledProcessError) as error:
        print(f"targets: {error}", file=sys.stderr)
        return 1
    missed = options.limits and not all(limit.kept for limit in checked)
    return int(failed or missed or (options.require and bool(left_out)))


def _measure(bench: Bench, targets: list[Target], layouts: list[str]) -> tuple[list[Measured], bool]:
    """Every build of every target, and whether any of them failed."""
    measured, failed = [], False
    builds = [
        (target, precision, layout, contract)
        for target in targets
        for precision in target.precisions
        for layout in layouts
        for contract in ((False, True) if target.fuses else (False,))
    ]
    for target, precision, layout, contract in builds:
        name = f"{target.name:<12}{precision:<9}{layout:<9}{'fused' if contract else 'exact':<7}"
        try:
            build = bench.measure(target, precision, layout, contract)
        except TargetError as error:
            print(f"{name}FAILED: {error}")
            failed = True
            continue
        measured.append(build)
        print(f"{name}{_summary(build)}", flush=True)
        for wrong in build.wrong:
            print(f"    FAILED: {wrong}")
        failed |= bool(build.wrong)
    return measured, failed


def _summary(build: Measured) -> str:
    guidance, steering, sizes = build.run.guidance, build.run.steering, build.program.sizes
    if guidance.counts is None or steering.counts is None:
        return "not counted"
    return (
        f"guidance {guidance.counts.mean:>8,.0f} (most {guidance.counts.most:,}), "
        f"steering {steering.counts.mean:>8,.0f} (most {steering.counts.most:,}) instructions; "
        f"code {sizes.code:,} (law alone {build.program.law:,}), "
        f"constants {sizes.constants:,}, static {sizes.static}; "
        f"stack {guidance.stack} and {steering.stack} written, "
        f"{build.program.stack[0]} and {build.program.stack[1]} reserved; "
        f"error {build.errors[0, 0]:.1e} rad; {build.other_bits} numbers unlike the host's"
    )


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

"""Processors in the loop, in emulation: they steer, and the plant flies on the host."""

import argparse
import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from c_runtime.verification.targets.build import TargetError
from c_runtime.verification.targets.flights_table import table
from c_runtime.verification.targets.flown import Flown, Range, Sail
from c_runtime.verification.targets.machines import TARGETS, Target
from c_runtime.verification.targets.measure import compile_plugin, left_out_of
from sailnet.artefacts.files import fill_block, split_at_block, write_text
from sailnet.artefacts.provenance import software
from sailnet.errors import SailnetError
from sailnet.guidance.backends import missions_with_networks
from sailnet.mission.disturbances import disturbance_from
from sailnet.mission.mission import Mission, load_mission

STORED = "flights.json"
"""What was flown, in the folder of the programs."""

BLOCK = "flights"
"""Of the text that the table goes into."""

BETA_BIAS = -0.05
"""Of the sail that flies, unknown to its guidance: there is something to learn."""


def main(arguments: list[str]) -> int:
    """Run the command; returns its exit status."""
    parser = _parser()
    options = parser.parse_args(arguments)
    if options.reported and options.table is None:
        parser.error("--reported writes a table: name its text with --table")
    _refuse_unknown(parser, options)
    wanted = [target for target in TARGETS if target.name in (options.target or _names())]
    left_out = left_out_of(wanted)
    present = [target for target in wanted if target.name not in left_out]
    try:
        if options.table is not None:
            split_at_block(options.table, BLOCK)  # before, not after, all the work
        if options.reported:
            fill_block(options.table, BLOCK, table(json.loads((options.build / STORED).read_text("utf-8"))))
            return 0
        missions = [load_mission(name) for name in options.mission or missions_with_networks()]
        sail = Sail(
            options.start, disturbance_from({"beta_bias": options.beta_bias}, missions[0].disturbance)
        )
        options.build.mkdir(parents=True, exist_ok=True)
        flown, failed = _fly_all(options, sail, missions, present) if present else ([], False)
        told = {
            **software(),
            "start": options.start,
            "beta_bias": options.beta_bias,
            "left_out": left_out,
            "rows": [one.to_json() for one in flown],
        }
        stored = json.dumps(told, indent=1) + "\n"
        write_text(options.build / STORED, stored)
        if options.table is not None and not failed:
            if left_out:
                raise TargetError("the table would be without some targets: it stays as it was")
            fill_block(options.table, BLOCK, table(told))
    except (SailnetError, OSError, ValueError, KeyError) as error:
        print(f"targets: {error}", file=sys.stderr)
        return 1
    return int(failed or (options.require and bool(left_out)))


def _names() -> list[str]:
    return [target.name for target in TARGETS]


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m c_runtime.verification.targets fly",
        description=__doc__,
        epilog="example: python -m c_runtime.verification.targets fly --target leon3 --mission earth_mars",
    )
    targets = ", ".join(_names())
    parser.add_argument(
        "--target",
        action="append",
        choices=_names(),
        metavar="NAME",
        help=f"{targets}; may be repeated (all)",
    )
    parser.add_argument(
        "--mission",
        action="append",
        metavar="NAME",
        help=f"{', '.join(missions_with_networks())}; may be repeated (all that ship)",
    )
    parser.add_argument(
        "--exported",
        type=Path,
        metavar="DIR",
        help="written by python -m export, of the one mission that is named; that may be a file (what ships)",
    )
    parser.add_argument(
        "--start",
        nargs="+",
        type=float,
        metavar="X",
        help="R U V [AU, AU/TU], in space R LATITUDE U V W [AU, rad, AU/TU] (the departure orbit)",
    )
    parser.add_argument("--beta-bias", type=float, default=BETA_BIAS, metavar="X", help="(%(default)g)")
    parser.add_argument(
        "--build", type=Path, default=Path("build/flights"), metavar="DIR", help="for programs (%(default)s)"
    )
    parser.add_argument("--table", type=Path, metavar="FILE", help="a text whose table is to be rewritten")
    parser.add_argument(
        "--reported", action="store_true", help="fly nothing: the table of what lies in --build from before"
    )
    parser.add_argument(
        "--require",
        action="store_true",
        default=os.environ.get("CI") == "true",
        help="a missing tool is an error (default where CI=true)",
    )
    return parser


def _refuse_unknown(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """End with a message if there is no flight file of a mission that is named."""
    named = options.mission or []
    if options.exported is None:
        shipped = missions_with_networks()
        for name in set(named) - set(shipped):
            parser.error(f"--mission {name}: none of {', '.join(shipped)}; name its files with --exported")
    elif len(named) != 1:
        parser.error("--exported is of one mission: name it with --mission")
    elif options.table is not None:
        parser.error("--table is of missions that ship, and --exported of another")


def _fly_all(
    options: argparse.Namespace, sail: Sail, missions: Sequence[Mission], targets: Sequence[Target]
) -> tuple[list[Flown], bool]:
    """Every build of every target on every mission, and whether any of them failed."""
    flown, failed = [], False
    folder = options.build.resolve()
    exported = None if options.exported is None else options.exported.resolve()
    at = Range(sail, folder, compile_plugin(folder), exported)
    for target, mission in ((target, mission) for target in targets for mission in missions):
        for precision in target.precisions:
            for contract in (False, True) if target.fuses else (False,):
                name = (
                    f"{target.name:<12}{mission.name:<17}{precision:<9}{'fused' if contract else 'exact':<7}"
                )
                try:
                    one = at.fly(mission, target, precision, contract)
                except TargetError as error:
                    print(f"{name}FAILED: {error}", flush=True)
                    failed = True
                    continue
                flown.append(one)
                print(f"{name}{_summary(one)}", flush=True)
                for wrong in one.wrong:
                    print(f"    FAILED: {wrong}")
                failed |= bool(one.wrong)
    return flown, failed


def _summary(one: Flown) -> str:
    flights = one.flown.flights
    end = "bit for bit the host's" if one.same_bits else f"ends {one.end_difference:.1e} from the host's"
    most = "not counted" if one.flown.most is None else f"at most {one.flown.most:,} instructions a command"
    stack = f"{one.flown.stack} bytes of stack reserved"
    return f"{flights.periods[0]:,} periods, {flights.time_of_flight[0]:.6f} TU; {most}, {stack}; {end}"

"""``python -m benchmarks.ablation``: what each mechanism of steering is worth, by flights without it.

Each is taken out of a copy of an exported flight file by another value of a constant, or another line, and
the copy is flown from the same starts as the whole file. What was flown is kept.
"""

import argparse
import os
import re
import shutil
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.flown_tables import CELLS, add_options, cells_of, fly, mission_of, origin
from c_runtime.builds import BUILDS
from c_runtime.shared_library import CompilerError, compile_libraries
from sailnet.artefacts.files import fill_block
from sailnet.campaign.tables import Table
from sailnet.errors import SailnetError
from sailnet.guidance.backends import exported_folder
from sailnet.workers.executors import workers

FILES = "sailnet_guidance.c", "sailnet_guidance.h"
"""Where a mechanism is."""


@dataclass(frozen=True)
class Mechanism:
    """One, and how the flight file is without it.

    Attributes:
        title: in the table: what is flown instead.
        changes: a pattern of the file's text, and what stands there instead.
    """

    title: str
    changes: tuple[tuple[str, str], ...]


def constant(name: str, value: str) -> tuple[str, str]:
    """Another value of a macro."""
    return rf"(#define {name}) \S+", rf"\1 {value}"


MECHANISMS = {
    "whole": Mechanism("the whole law", ()),
    "networks": Mechanism("the networks command, no plan is flown", (constant("USABLE", "-1.0"),)),
    "first-plan": Mechanism(
        "the first plan is never corrected",
        (
            constant("CORRECT_AFTER", "1e9"),
            constant("CORRECT_AT_LATEST", "1e9"),
        ),
    ),
    "known": Mechanism("no known plan is tried", (constant("SAILNET_KNOWN_TRIED", "0"),)),
    "search": Mechanism("no other plan is sought while one is flown", (constant("SEARCH_EVERY", "1e9"),)),
    "per-vehicle": Mechanism(
        "no derivatives by the vehicle", ((r"\(plan->differentiated == 1\) && \(moves > 3\)", "0"),)
    ),
    "stride": Mechanism("the plan's vehicle moves at once", (constant("SAILNET_LARGEST_STRIDE", "1e9"),)),
    "hysteresis": Mechanism("no hysteresis", (constant("OF_TIME_TO_GO", "0.0"),)),
    "late": Mechanism("hysteresis of the side alone", (constant("LATE", "0.0"),)),
    "kept": Mechanism(
        "corrections go on while an attitude is kept", ((r"!\(tracker->regret > 0\.0\) &&\s+", ""),)
    ),
    "near": Mechanism(
        "an attitude is kept however far off",
        ((r"(\(regret < share\)) && \(sailnet_has_failed\(tracker\) == 0\)", r"\1"),),
    ),
    "spent": Mechanism(
        "the thrust margin is never spent",
        ((r"(const int32_t spent =) .* 1 : 0;", r"\1 0;"),),
    ),
    "reach": Mechanism(
        "a plan for a stronger vehicle is flown", ((r"\(plan->beta <= stronger\)", "(0 == 0)"),)
    ),
    "on-its-way": Mechanism(
        "no plan for a stronger vehicle is flown",
        ((r"\(tracker->stride >= SAILNET_LARGEST_STRIDE\)", "(0 != 0)"),),
    ),
    "failed": Mechanism(
        "a plan that has failed stays",
        ((r"\(\(sailnet_has_failed\(tracker\) != 0\) \|\| (\(time_to_go .*\))\) \? 1 : 0;", r"\1 ? 1 : 0;"),),
    ),
    "optics": Mechanism(
        "plans are for the mission's optics",
        ((r"sailnet_push_aside\(&own, \(double\).*\);", "(void)memory;"),),
    ),
    "reserve": Mechanism(
        "no thrust margin", ((r"(#define SAILNET_LARGEST_RESERVE SAILNET_REAL)\(\S+\)", r"\1(0.0)"),)
    ),
}


def without(mechanism: Mechanism, exported: Path, folder: Path) -> None:
    """A copy of an export without a mechanism, compiled.

    Raises:
        SailnetError: the flight file does not have what is to be changed.
        CompilerError: the compiler refused it.
    """
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(exported, folder)
    for pattern, instead in mechanism.changes:
        changed = 0
        for name in FILES:
            file = folder / name
            text, count = re.subn(pattern, instead, file.read_text(encoding="utf-8"))
            changed += count
            file.write_text(text, encoding="utf-8")
        if changed != 1:
            raise SailnetError(f"{exported} has {changed} places like {pattern}: one is to be changed")
    compile_libraries(folder, folder, [BUILDS["f64"]])


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.ablation",
        description=__doc__,
        epilog="example: python -m benchmarks.ablation build/ablation --mission earth_venus --flights 400",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("folder", type=Path, help="for copies and flights")
    parser.add_argument("--exported", type=Path, help="what python -m export wrote (default: what ships)")
    parser.add_argument(
        "--mechanisms",
        nargs="+",
        choices=MECHANISMS,
        default=list(MECHANISMS),
        metavar="NAME",
        help=f"{', '.join(MECHANISMS)} (all)",
    )
    add_options(parser, "ablation", 1000, 905)
    options = parser.parse_args(arguments)
    try:
        mission = mission_of(options)
        exported = exported_folder(mission, options.exported)
        rows: list[list[str]] = []
        heads: list[str] = []
        optima: Path | None = None
        with workers(os.cpu_count() or 1) as pool:
            for name in dict.fromkeys(["whole", *options.mechanisms]):
                folder, results = options.folder / name, options.folder / f"{name}.h5"
                without(MECHANISMS[name], exported, folder)
                scores = fly(mission, folder, results, pool, optima)
                optima = optima or results
                heads = ["flown", *(score.name for score in scores)]
                rows.append([MECHANISMS[name].title, *map(cells_of, scores)])
                print(" | ".join(rows[-1]), file=sys.stderr, flush=True)
        told = f"{options.flights:,} flights a series, seed {options.seed}. {CELLS}"
        lines = [told, "", *Table("", heads, rows).markdown(), "", origin()]
        if options.text:
            fill_block(options.text, f"ablation {mission.name}", "\n".join(lines))
    except (SailnetError, CompilerError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())

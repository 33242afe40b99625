"""Frama-C's Eva on one build of an exported guidance, and on the tracker alone."""

import re
import subprocess
from collections.abc import Iterable
from pathlib import Path

from c_runtime.builds import Build

FRAMA_C = "frama-c"
DRIVER = Path(__file__).parent / "eva.c"
TRACKER_DRIVER = Path(__file__).parent / "tracker.c"
TRACKER_ENTRIES = ("prove_tracker", "prove_take_plan")
CONTRACTS = (
    "sailnet_fraction",
    "sailnet_power",
    "sailnet_sigmoid",
    "sailnet_clamped",
    "sailnet_per_root",
    "sailnet_size",
    "sailnet_follow",
    "sailnet_take_plan",
)
OF_LAYOUTS = {
    "flight": (),
    "host": ("sailnet_inverse_fourth_root",),
}
"""With a contract, too, where networks need them."""
LEAST = ("-eva-precision", "0")
# Every loop is unrolled, so that each weight is seen with the interval of its own input.
UNROLLED = (*LEAST, "-eva-auto-loop-unroll", "100", "-eva-slevel", "200")
ENTRIES = {
    "prove_guidance": UNROLLED,
    "prove_steering": UNROLLED,
    "prove_plans": UNROLLED,
    "prove_saving": LEAST,
    "prove_null_pointers": UNROLLED,
}
"""Functions of the driver that are analysed, and how precisely: a checksum needs no unrolling."""
# What a tracker asks for says what it remembers: that known plans are left.
ASKED = "sailnet_asks:0:1:2"
# What stages and states are written in is unrolled; where a plan is flown what it commands is written.
OF_THE_TRACKER = (
    *LEAST,
    *("-eva-auto-loop-unroll", "12"),
    *("-eva-slevel-function", "sailnet_follow:20,keep_attitude:20,begin:20,prove_tracker:20"),
    *("-eva-split-return-function", f"sailnet_follow:0,{ASKED}"),
)


class ProofError(Exception):
    """The analysis did not run."""


def analyse(
    exported: Path, build: Build, timeout: float = 300.0, entries: Iterable[str] = tuple(ENTRIES)
) -> list[str]:
    """What Eva could not prove of a build: one line each, none if all is proved.

    NaN and infinity are values like others (``-warn-special-float none``): that none reaches a command
    is asserted in the driver.

    Args:
        exported: folder of its C.
        build: that is analysed.
        timeout: of the analysis of an entry [s].
        entries: functions of the driver that are analysed.

    Raises:
        ProofError: Eva failed to analyse the file.
    """
    source = (exported / build.source).read_text(encoding="utf-8")
    own = OF_LAYOUTS[build.layout]
    contracts = ",".join([*CONTRACTS, *(name for name in own if f"{name}(" in source)])
    # What is written where a function succeeds is read only there.
    succeed = f"sailnet_follow:0,sailnet_tracks:0,sailnet_propose_plan_{build.suffix}:0,{ASKED}"
    options = ("-eva-use-spec", contracts, "-eva-split-return-function", succeed)
    flags = (f"-I{exported}", *build.analysed)
    return [
        problem
        for entry in entries
        for problem in _unproved(DRIVER, entry, (*ENTRIES[entry], *options), flags, timeout)
    ]


def analyse_tracker(
    folder: Path, in_space: bool, timeout: float = 300.0, entries: Iterable[str] = TRACKER_ENTRIES
) -> list[str]:
    """What Eva could not prove of the tracker, in the plane or in space: one line each, none if all is.

    Args:
        folder: of its C.
        in_space: in three dimensions.
        timeout: of the analysis [s].
        entries: functions of the driver that are analysed.

    Raises:
        ProofError: Eva failed to analyse the files.
    """
    flags = (f"-I{folder}", f"-DSAILNET_IN_SPACE={int(in_space)}")
    return [
        problem
        for entry in entries
        for problem in _unproved(TRACKER_DRIVER, entry, OF_THE_TRACKER, flags, timeout)
    ]


def _unproved(
    driver: Path, entry: str, options: Iterable[str], flags: Iterable[str], timeout: float
) -> list[str]:
    """What Eva could not prove of one entry of a driver, for any bits of what is declared extern there."""
    command = [FRAMA_C, "-eva", *options, "-eva-no-show-progress", "-machdep", "x86_64"]
    command += ["-lib-entry", "-main", entry, "-warn-special-float", "none"]
    command += [f"-cpp-extra-args={' '.join((*flags, '-D__FLT_EVAL_METHOD__=0'))}", str(driver)]
    run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=timeout)
    if run.returncode or "ANALYSIS SUMMARY" not in run.stdout:
        raise ProofError(f"frama-c failed on {entry}:\n{(run.stdout + run.stderr)[-2000:]}")
    alarms = int(_found(r"(\d+) alarms? generated", run.stdout))
    unknown = [int(n) for n in re.findall(r"(\d+) unknown +\d+ invalid", run.stdout)]
    invalid = [int(n) for n in re.findall(r"unknown +(\d+) invalid", run.stdout)]
    if not (alarms or any(unknown) or any(invalid)):
        return []
    said = re.findall(r"\[eva:alarm\] [^\n]*\n?[^\n\[]*", run.stdout)
    return [f"{entry}: {' '.join(line.split())}" for line in said] or [f"{entry}: not proved"]


def _found(pattern: str, text: str) -> str:
    match = re.search(pattern, text)
    if match is None:
        raise ProofError("frama-c's summary reads differently: versions 25 and later were tried")
    return match.group(1)

"""Frama-C's Eva on one build of an exported guidance."""

import re
import subprocess
from pathlib import Path

from c_runtime.builds import Build

FRAMA_C = "frama-c"
DRIVER = Path(__file__).parent / "eva.c"
ENTRIES = ("prove_guidance", "prove_steering", "prove_null_pointers")
CONTRACTS = (
    "sailnet_fraction",
    "sailnet_power",
    "sailnet_sigmoid",
    "sailnet_clamped",
    "sailnet_per_root",
    "sailnet_size",
)
OF_LAYOUTS = {
    "flight": (),
    "host": ("sailnet_inverse_fourth_root",),
}
"""With a contract, too, where networks need them."""
# Every loop is unrolled, so that each weight is seen with the interval of its own input.
PRECISION = ("-eva-precision", "0", "-eva-auto-loop-unroll", "100", "-eva-slevel", "200")


class ProofError(Exception):
    """The analysis did not run."""


def analyse(exported: Path, build: Build, timeout: float = 300.0) -> list[str]:
    """What Eva could not prove of a build: one line each, none if all is proved.

    NaN and infinity are values like others (``-warn-special-float none``): that none reaches a command
    is asserted in the driver.

    Raises:
        ProofError: Eva failed to analyse the file.
    """
    source = (exported / build.source).read_text(encoding="utf-8")
    own = OF_LAYOUTS[build.layout]
    contracts = ",".join([*CONTRACTS, *(name for name in own if f"{name}(" in source)])
    flags = " ".join((f"-I{exported}", "-D__FLT_EVAL_METHOD__=0", *build.analysed))
    problems: list[str] = []
    for entry in ENTRIES:
        command = [FRAMA_C, "-eva", *PRECISION, "-eva-no-show-progress", "-machdep", "x86_64"]
        command += ["-lib-entry", "-main", entry, "-eva-use-spec", contracts]
        command += ["-warn-special-float", "none", f"-cpp-extra-args={flags}", str(DRIVER)]
        run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=timeout)
        if run.returncode or "ANALYSIS SUMMARY" not in run.stdout:
            raise ProofError(f"frama-c failed on {entry}:\n{(run.stdout + run.stderr)[-2000:]}")
        alarms = int(_found(r"(\d+) alarms? generated", run.stdout))
        unknown = [int(n) for n in re.findall(r"(\d+) unknown +\d+ invalid", run.stdout)]
        invalid = [int(n) for n in re.findall(r"unknown +(\d+) invalid", run.stdout)]
        if alarms or any(unknown) or any(invalid):
            said = re.findall(r"\[eva:alarm\] [^\n]*\n?[^\n\[]*", run.stdout)
            problems += [f"{entry}: {' '.join(line.split())}" for line in said] or [f"{entry}: not proved"]
    return problems


def _found(pattern: str, text: str) -> str:
    match = re.search(pattern, text)
    if match is None:
        raise ProofError("frama-c's summary reads differently: versions 25 and later were tried")
    return match.group(1)

"""Guards of the flight file, each taken away: the proof must then fail."""

import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from c_runtime.verification.proof.eva import ProofError, analyse
from c_runtime.verification.proof.lemmas import check_lemmas


@dataclass(frozen=True)
class Mutant:
    """One guard, as it stands in the flight file, and the file without it."""

    name: str
    guard: str
    without: str
    builds: str = ""
    """Only builds with this in their name are concerned."""

    def concerns(self, build: str) -> bool:
        """Whether this mutant changes that build."""
        return self.builds in build


MUTANTS = (
    Mutant(
        "cone angle unbounded",
        "const sailnet_real bounded = size < SAILNET_PHI_MAX ? size : SAILNET_PHI_MAX;",
        "const sailnet_real bounded = size;",
        builds="simd",
    ),
    Mutant(
        "cone angle unbounded, compact",
        "sailnet_size(sailnet_limited(&command->cone_angle, SAILNET_OF_CONE_ANGLE))",
        "sailnet_size(command->cone_angle)",
        builds="compact",
    ),
    Mutant(
        "clamp lets NaN through",
        "raised = value > lower ? value : lower;\n    return raised < upper ? raised : upper;",
        "raised = value < lower ? lower : value;\n    return raised > upper ? upper : raised;",
    ),
    Mutant(
        "clamp without upper end",
        "return raised < upper ? raised : upper;",
        "return raised + R(0.0) * upper;",
    ),
    Mutant(
        "s unbounded",
        "sailnet_clamped((s4 * per_s) * per_s2, R(0.0), R(2e6))",
        "(s4 * per_s) * per_s2",
        builds="f32 simd",
    ),
    Mutant(
        "fourth power of s may be zero",
        "sailnet_clamped(sum, SAILNET_SMALLEST_S4, R(1e24))",
        "sum",
        builds="simd",
    ),
    Mutant(
        "memory and estimate trusted",
        "memory->beta = sailnet_limited(&memory->beta, SAILNET_OF_BETA);",
        "",
    ),
    Mutant("any period held", "sailnet_limited(&command->hold, SAILNET_OF_PERIOD)", "command->hold"),
    Mutant("inputs not clamped", "shifted[i] = clamped -", "shifted[i] = input[i] -", builds="simd"),
    Mutant(
        "inputs not clamped, compact",
        "sailnet_limited(&input[i], SAILNET_OF_INPUTS + i) - numbers[0]",
        "input[i] - numbers[0]",
        builds="compact",
    ),
    Mutant("one weight too many read", "= &from[inputs];", "= &from[inputs + 1];", builds="compact"),
    Mutant(
        "a knot beyond the tables read",
        "sailnet_limited(&argument[table], SAILNET_OF_KNOTS)",
        "argument[table]",
        builds="compact",
    ),
    Mutant(
        "null command written",
        "    if (command == NULL) {\n        return SAILNET_INVALID_INPUT;\n    }\n",
        "",
        builds="simd",
    ),
    Mutant(
        "null command written, compact",
        "    if (command == NULL) {\n        return (uint32_t)SAILNET_INVALID_INPUT;\n    }\n",
        "",
        builds="compact",
    ),
)


def mutate(exported: Path, mutant: Mutant, folder: Path) -> bool:
    """Write the exported files without that guard into ``folder``; False if they have no such guard."""
    source = (exported / "sailnet_guidance.c").read_text(encoding="utf-8")
    shutil.copy(exported / "sailnet_guidance.h", folder)
    (folder / "sailnet_guidance.c").write_text(source.replace(mutant.guard, mutant.without), encoding="utf-8")
    return mutant.guard in source


def caught(folder: Path, defines: Sequence[str]) -> bool:
    """Whether the proof of an exported guidance fails: in what it concludes, or in what it assumes.

    Raises:
        CompilerError: there is no compiler.
        ProofError: Eva failed to analyse the file.
    """
    if analyse(folder, defines):
        return True
    try:
        check_lemmas(folder, defines)
    except ProofError:
        return True
    return False

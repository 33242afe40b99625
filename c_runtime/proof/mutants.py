"""Guards of the flight file, each taken away: the proof must then fail."""

import shutil
from dataclasses import dataclass
from pathlib import Path


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
        "sailnet_within(alpha_pre, SAILNET_PHI_MAX)",
        "alpha_pre",
        builds="compact",
    ),
    Mutant(
        "clamp lets NaN through",
        "const sailnet_real known = value == value ? value : lower;",
        "const sailnet_real known = value;",
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
        builds="simd",
    ),
    Mutant(
        "fourth power of s may be zero",
        "sailnet_clamped(sum, SAILNET_SMALLEST_S4, R(1e24))",
        "sum",
        builds="simd",
    ),
    Mutant(
        "estimate of beta unbounded",
        "memory->beta = sailnet_known_beta(beta + share * counted);",
        "memory->beta = beta + share * counted;",
    ),
    Mutant("memory trusted", "memory->beta = sailnet_known_beta(memory->beta);", ""),
    Mutant("any period held", "sailnet_clamped(period + (period - period), R(0.0), R(1e30))", "period"),
    Mutant("inputs not clamped", "shifted[i] = clamped -", "shifted[i] = input[i] -", builds="simd"),
    Mutant(
        "inputs not clamped, compact",
        "sailnet_clamped(input, range[0], range[1]) - range[2]",
        "input - range[2]",
        builds="compact",
    ),
    Mutant("one weight too many read", "in != &from[inputs]", "in != &from[inputs + 1]", builds="compact"),
    Mutant(
        "a knot too many read", "knot = (int32_t)within;", "knot = (int32_t)within + 1;", builds="compact"
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

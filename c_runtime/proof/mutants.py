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
    Mutant("s unbounded", "sailnet_clamped((s4 * per_s) * per_s2, R(0.0), R(2e6))", "(s4 * per_s) * per_s2"),
    Mutant("fourth power of s may be zero", "sailnet_clamped(sum, SAILNET_SMALLEST_S4, R(1e24))", "sum"),
    Mutant(
        "estimate of beta unbounded",
        "return sailnet_clamped(beta + share * counted, SAILNET_BETA_MIN, SAILNET_BETA_MAX);",
        "return beta + share * counted;",
    ),
    Mutant(
        "memory trusted",
        "memory->beta = sailnet_clamped(memory->beta, SAILNET_BETA_MIN, SAILNET_BETA_MAX);",
        "",
    ),
    Mutant(
        "any period held",
        "sailnet_is_finite(period) ? sailnet_clamped(period, R(0.0), R(1e30)) : R(0.0)",
        "period",
    ),
    Mutant("inputs not clamped", "shifted[i] = clamped -", "shifted[i] = input[i] -"),
    Mutant(
        "one weight too many read",
        "for (int32_t i = 0; i < inputs; i++) {\n            const sailnet_real x",
        "for (int32_t i = 0; i <= inputs; i++) {\n            const sailnet_real x",
        builds="compact",
    ),
    Mutant(
        "null command written",
        "    if (command == NULL) {\n        return SAILNET_INVALID_INPUT;\n    }\n",
        "",
    ),
)


def mutate(exported: Path, mutant: Mutant, folder: Path) -> bool:
    """Write the exported files without that guard into ``folder``; False if they have no such guard."""
    source = (exported / "sailnet_guidance.c").read_text(encoding="utf-8")
    shutil.copy(exported / "sailnet_guidance.h", folder)
    (folder / "sailnet_guidance.c").write_text(source.replace(mutant.guard, mutant.without), encoding="utf-8")
    return mutant.guard in source

"""Guards of the flight file, each taken away: the proof must then fail.

Guards whose absence intervals cannot see are taken away in the tests of the checks: unit tests and
fuzzing find them.
"""

import shutil
from dataclasses import dataclass
from pathlib import Path

from c_runtime.builds import HEADER, LAYOUTS, Build
from c_runtime.verification.proof.eva import ENTRIES, ProofError, analyse
from c_runtime.verification.proof.lemmas import check_lemmas


@dataclass(frozen=True)
class Mutant:
    """One guard, as it stands in the flight file, and the file without it."""

    name: str
    guard: str
    without: str
    layout: str = ""
    precision: str = ""
    """Where these are not empty, only such builds are concerned."""
    ages: bool = False
    """The guard is in files of sails that are known to age alone."""
    form: str = ""
    """``plane`` or ``space`` where the guard stands in such files alone."""

    def concerns(self, build: Build) -> bool:
        """Whether this mutant changes that build."""
        return self.layout in ("", build.layout) and self.precision in ("", build.precision)


MUTANTS = (
    Mutant(
        "cone angle unbounded on a host",
        "const sailnet_real bounded = size < SAILNET_PHI_MAX ? size : SAILNET_PHI_MAX;",
        "const sailnet_real bounded = size;",
        layout="host",
        form="plane",
    ),
    Mutant(
        "cone angle unbounded",
        "sailnet_size(sailnet_limited(&command->cone_angle, SAILNET_OF_CONE_ANGLE))",
        "sailnet_size(command->cone_angle)",
        layout="flight",
        form="plane",
    ),
    Mutant(
        "cone angle in space unbounded on a host",
        "command->cone_angle = size < SAILNET_PHI_MAX ? size : SAILNET_PHI_MAX;",
        "command->cone_angle = size;",
        layout="host",
        form="space",
    ),
    Mutant(
        "cone angle in space unbounded",
        "sailnet_size(sailnet_limited(&output, SAILNET_OF_CONE_ANGLE))",
        "sailnet_size(output)",
        layout="flight",
        form="space",
    ),
    Mutant(
        "cone angle below 0",
        "sailnet_size(sailnet_limited(&output, SAILNET_OF_CONE_ANGLE))",
        "sailnet_limited(&output, SAILNET_OF_CONE_ANGLE)",
        layout="flight",
        form="space",
    ),
    Mutant(
        "clock angle unbounded",
        "return sailnet_limited(&angle, SAILNET_OF_ANGLE);",
        "return angle;",
        form="space",
    ),
    Mutant(
        "pi rounded up",
        "#define SAILNET_LARGEST_ANGLE 3.1415925f",
        "#define SAILNET_LARGEST_ANGLE 3.1415927f",
        precision="float32",
        form="space",
    ),
    Mutant(
        "first factor unbounded",
        "input[9] = sailnet_limited(&input[9], SAILNET_OF_SHARE);",
        "",
        layout="flight",
        precision="float32",
        form="space",
    ),
    Mutant(
        "second factor unbounded",
        "input[10] = sailnet_limited(&input[10], SAILNET_OF_SHARE);",
        "",
        layout="flight",
        precision="float32",
        form="space",
    ),
    Mutant(
        "first factor unbounded on a host",
        "factors[0] = sailnet_clamped(y_z, R(-1.0), R(1.0));",
        "factors[0] = y_z;",
        layout="host",
        form="space",
    ),
    Mutant(
        "second factor unbounded on a host",
        "factors[1] = sailnet_clamped(y_w, R(-1.0), R(1.0));",
        "factors[1] = y_w;",
        layout="host",
        form="space",
    ),
    Mutant(
        "normal trusted",
        "estimate->normal[i] = sailnet_limited(&estimate->normal[i], SAILNET_OF_SHARE);",
        "",
        form="space",
    ),
    Mutant(
        "normal remembered as computed",
        "estimate->normal[i] = sailnet_limited(&normal[i], SAILNET_OF_SHARE);",
        "estimate->normal[i] = normal[i];",
        form="space",
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
        layout="host",
        precision="float32",
    ),
    Mutant(
        "fourth power of s may be zero",
        "sailnet_clamped(sum, SAILNET_SMALLEST_S4, R(1e24))",
        "sum",
        layout="host",
    ),
    Mutant(
        "memory and estimate trusted",
        "estimate->beta = sailnet_limited(&estimate->beta, SAILNET_OF_BETA);",
        "",
    ),
    Mutant(
        "angle told trusted",
        "estimate->cone_angle = sailnet_limited(&estimate->cone_angle, SAILNET_OF_CONE_ANGLE);",
        "",
        form="plane",
    ),
    Mutant(
        "tangential force trusted",
        "estimate->tangential = sailnet_limited(&estimate->tangential, SAILNET_OF_TANGENTIAL);",
        "",
    ),
    Mutant(
        "offset trusted",
        "estimate->offset = sailnet_limited(&estimate->offset, SAILNET_OF_OFFSET);",
        "",
        form="plane",
    ),
    Mutant(
        "angle corrected beyond its bound",
        "return sailnet_limited(&told, SAILNET_OF_CONE_ANGLE);",
        "return told;",
        form="plane",
    ),
    Mutant(
        "variance trusted", "estimate->variance = sailnet_limited(&estimate->variance, SAILNET_OF_SHARE);", ""
    ),
    Mutant(
        "autocovariance trusted",
        "estimate->autocovariance = sailnet_limited(&estimate->autocovariance, SAILNET_OF_SHARE);",
        "",
    ),
    Mutant(
        "aged estimate trusted",
        "estimate->beta = sailnet_limited(&aged, SAILNET_OF_BETA);",
        "estimate->beta = aged;",
        ages=True,
    ),
    Mutant("held beyond the step", "sailnet_clamped(share, R(0.0), R(1.0))", "share"),
    Mutant(
        "any period held", "hold = sailnet_clamped(period, R(0.0), SAILNET_LARGEST_PERIOD);", "hold = period;"
    ),
    Mutant(
        "inputs not clamped on a host", "shifted[i] = clamped -", "shifted[i] = input[i] -", layout="host"
    ),
    Mutant(
        "inputs not clamped",
        "sailnet_limited(&input[i], SAILNET_OF_INPUTS + i) - number[0]",
        "input[i] - number[0]",
        layout="flight",
    ),
    Mutant(
        "a plan's cone angle unbounded",
        "        command->cone_angle = sailnet_limited(&angle, SAILNET_OF_CONE_ANGLE);\n",
        "        command->cone_angle = angle;\n",
        form="plane",
    ),
    Mutant(
        "a plan's cone angle in space unbounded",
        "sailnet_size(sailnet_limited(&size, SAILNET_OF_CONE_ANGLE))",
        "sailnet_size(size)",
        form="space",
    ),
    Mutant("numbers of a plan trusted", "return sailnet_limited(&value, SAILNET_OF_PLAN);", "return value;"),
    Mutant("a plan uploaded that is not there", "(state != NULL) && (plan != NULL) &&", "(state != NULL) &&"),
    Mutant(
        "a plan uploaded for a mission that is not there",
        "(memory != NULL) && (mission_digest != NULL) &&",
        "(memory != NULL) &&",
    ),
    Mutant(
        "a memory restored that is not there",
        "    if (memory != NULL) {\n        if ((memory->version ==",
        "    {\n        if ((memory->version ==",
    ),
    Mutant("one weight too many read", "= &from[inputs];", "= &from[inputs + 1];", layout="flight"),
    Mutant(
        "a knot beyond the tables read",
        "sailnet_limited(&argument[table], SAILNET_OF_KNOTS)",
        "argument[table]",
        layout="flight",
    ),
    Mutant(
        "null command written on a host",
        "    if (command == NULL) {\n        return SAILNET_INVALID_INPUT;\n    }\n",
        "",
        layout="host",
    ),
    Mutant(
        "null command written",
        "    if (command == NULL) {\n        return (uint32_t)SAILNET_INVALID_INPUT;\n    }\n",
        "",
        layout="flight",
    ),
)


def mutate(exported: Path, mutant: Mutant, folder: Path) -> bool:
    """Write the exported files without that guard into ``folder``; False if they have no such guard."""
    shutil.copy(exported / HEADER, folder)
    found = False
    for layout, name in LAYOUTS.items():
        source = (exported / name).read_text(encoding="utf-8")
        if mutant.layout in ("", layout):
            found = found or mutant.guard in source
            source = source.replace(mutant.guard, mutant.without)
        (folder / name).write_text(source, encoding="utf-8")
    return found


def caught(folder: Path, build: Build) -> bool:
    """Whether the proof of an exported guidance fails: in what it concludes, or in what it assumes.

    Raises:
        CompilerError: there is no compiler.
        ProofError: Eva failed to analyse the file.
    """
    if any(analyse(folder, build, entries=[entry]) for entry in ENTRIES):
        return True
    try:
        check_lemmas(folder, build)
    except ProofError:
        return True
    return False

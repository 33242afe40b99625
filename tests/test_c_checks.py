"""The checks of the flight file pass on an export of either form, and each catches the defects it is for."""

import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from c_runtime.checks import coverage, misra
from c_runtime.checks.flight_file import defines, places, tags
from tests.conftest import Exported
from tests.tools import missing, needs

C_RUNTIME = Path(__file__).parent.parent / "c_runtime"
SHIPPED = C_RUNTIME.parent / "sailnet" / "shipped" / "earth_mars"
# What `make` calls for each, and the packages it is in.
TARGETS = {
    "fuzz": (missing("clang"), ("clang", "libclang-rt-14-dev")),
    "valgrind": (missing("valgrind"), ("valgrind",)),
    "misra": (missing("cppcheck"), ("cppcheck",)),
    "coverage-c": (missing("gcc", "gcov"), ("gcc",)),
    "warnings": (missing("gcc", "g++", "clang"), ("gcc", "g++", "clang", "libc6-dev-i386")),
}
BUDGET = (
    "FUZZ_RUNS=3000",
    "MEMCHECK_RUNS=300",
    "MEMCHECK_CASES=100",
)


def needs_tools_of(target: str) -> pytest.MarkDecorator:
    absent, packages = TARGETS[target]
    return needs("analyser", absent, *packages)


def make(target: str, exported: Path, build: Path, *settings: str) -> subprocess.CompletedProcess[str]:
    """Run a target of c_runtime; skips the test if a library of its tools is not here."""
    command = ["make", "-s", target, f"EXPORTED={exported}", f"BUILD={build}", "REQUIRE=", *BUDGET, *settings]
    run = subprocess.run(
        command, cwd=C_RUNTIME, capture_output=True, text=True, check=False, errors="replace", timeout=300
    )
    left_out = re.search(r"left out: .*", run.stdout)
    if left_out and run.returncode == 0:
        pytest.skip(left_out[0])
    return run


@pytest.mark.parametrize("target", [pytest.param(name, marks=needs_tools_of(name)) for name in TARGETS])
def test_nothing_is_found(exported: Exported, tmp_path: Path, target: str) -> None:
    builds = "f64" if exported.networks.approach else "f32_compact"
    run = make(target, exported.folder, tmp_path, f"BUILDS={builds}")
    assert run.returncode == 0, run.stdout + run.stderr


def mutated(exported: Path, folder: Path, old: str, new: str) -> Path:
    """A copy of the export with one defect in it."""
    shutil.copytree(exported, folder)
    path = folder / "sailnet_guidance.c"
    source = path.read_text()
    assert source.count(old) == 1, f"the flight file has {source.count(old)} of: {old}"
    path.write_text(source.replace(old, new))
    return folder


MUTANTS = {
    "twice the cone angle, without its bound": (
        "fuzz",
        "sailnet_size(sailnet_limited(&command->cone_angle, SAILNET_OF_CONE_ANGLE));",
        "R(2.0) * sailnet_size(command->cone_angle);",
        "promise broken: command->cone_angle",
    ),
    "a NaN let through": (
        "fuzz",
        "(state->u - state->u)",
        "R(0.0)",
        "promise broken",
    ),
    "held too long": (
        "fuzz",
        "    command->hold = hold;\n",
        "    command->hold = R(2.0) * hold;\n",
        "promise broken",
    ),
    "an arrival outside the domain": (
        "fuzz",
        "if (status != SAILNET_OUTSIDE_DOMAIN) {",
        "if (status != SAILNET_INVALID_INPUT) {",
        "promise broken: (of_law == SAILNET_OUTSIDE_DOMAIN)",
    ),
    "something remembered from call to call": (
        "fuzz",
        "    /* SAILNET_ARRIVED, or",
        "    static int32_t calls = 0;\n    calls = 1 - calls;\n"
        "    command->time_of_flight += (sailnet_real)calls;\n    /* SAILNET_ARRIVED, or",
        "promise broken",
    ),
    "index out of bounds": (
        "fuzz",
        "number = &number[SAILNET_KNOTS + 1];",
        "number = &number[300 * SAILNET_KNOTS];",
        "SUMMARY: ",
    ),
    "signed overflow": (
        "fuzz",
        "    int32_t there = 1;\n    /* All",
        "    int32_t there = INT32_MAX;\n    there = (there + 2) & 1;\n    /* All",
        "signed integer overflow",
    ),
    "undefined output": (
        "valgrind",
        "    command->hold = R(0.0);\n    if",
        "    if",
        "uninitialised value",
    ),
    "undefined variable": (
        "valgrind",
        "    const uint32_t seen = sailnet_law(",
        "    volatile int32_t unset[2];\n    volatile int32_t *volatile at = unset;\n"
        "    const uint32_t seen = *at == 7 ? 0u : sailnet_law(",
        "uninitialised value",
    ),
    "octal constant": (
        "misra",
        "    int32_t there = 1;\n    /* All",
        "    int32_t there = 01;\n    /* All",
        "misra-c2012-7.1",
    ),
    "a listed rule broken elsewhere": (
        "misra",
        "    if (memory != NULL) {\n",
        "    if (memory == NULL) {\n        return;\n    } else {\n",
        "(in sailnet_start): misra-c2012-15.5",
    ),
    "a variable without use": (
        "misra",
        "    int32_t there = 1;\n    /* All",
        "    int32_t unread = 3;\n    int32_t there = 1;\n    /* All",
        "unreadVariable",
    ),
    "dead branch of an expression": (
        "coverage-c",
        "    /* SAILNET_ARRIVED, or",
        "    command->hold = command->time_of_flight > R(1e30) ? R(1e30) : R(0.0);\n"
        "    /* SAILNET_ARRIVED, or",
        "0 line(s), 1 branch(es) of: command->hold",
    ),
    "dead line": (
        "coverage-c",
        "    /* SAILNET_ARRIVED, or",
        "    if (command->time_of_flight > R(1e30)) {\n        command->beta = R(0.0);\n    }\n"
        "    /* SAILNET_ARRIVED, or",
        "1 line(s), 0 branch(es) of: command->beta = R(0.0);",
    ),
    "constant of the wrong precision": (
        "warnings",
        "const sailnet_real distance = R(0.5) * (before",
        "const sailnet_real distance = 0.5 * (before",
        "double",
    ),
    "a type of 64 bit on some machines": (
        "warnings",
        "    if (memory != NULL) {\n",
        "    if (memory != NULL && (1L << 40) != 0) {\n",
        "shift",
    ),
}


@pytest.mark.parametrize(
    "mutant", [pytest.param(name, marks=needs_tools_of(mutant[0])) for name, mutant in MUTANTS.items()]
)
def test_defects_are_found(approach_exported: Exported, tmp_path: Path, mutant: str) -> None:
    target, old, new, message = MUTANTS[mutant]
    folder = mutated(approach_exported.folder, tmp_path / "exported", old, new)
    run = make(target, folder, tmp_path, "BUILDS=f32_compact", "FUZZ_RUNS=50000")
    assert run.returncode != 0, run.stdout
    assert message in run.stdout + run.stderr


@needs_tools_of("fuzz")
def test_a_knot_beyond_the_last_is_found(tmp_path: Path) -> None:
    """Of the networks that ship: the tube of random ones holds every state."""
    old = "before < SAILNET_KNOTS - 2 ? before : SAILNET_KNOTS - 2;"
    folder = mutated(SHIPPED, tmp_path / "exported", old, "before;")
    run = make("fuzz", folder, tmp_path, "BUILDS=f32", "FUZZ_RUNS=50000")
    assert run.returncode != 0
    assert "out of bounds" in run.stdout


@needs_tools_of("misra")
def test_a_listed_deviation_that_is_gone_fails(approach_exported: Exported, tmp_path: Path) -> None:
    listed = (C_RUNTIME / "MISRA.md").read_text()
    row = "| 12.1 | advisory |"
    assert row in listed
    table = tmp_path / "MISRA.md"
    table.write_text(listed.replace(row, f"| 7.1 | required | `sailnet_start` | all | none |\n{row}"))
    run = make("misra", approach_exported.folder, tmp_path, f"DEVIATIONS={table}", "BUILDS=f32_compact")
    assert run.returncode != 0
    assert (
        run.stdout.strip() == "MISRA.md lists a deviation from rule 7.1 in sailnet_start, but there is none"
    )


def test_a_missing_tool_is_told_in_a_line_and_fails_only_where_it_is_required(
    approach_exported: Exported, tmp_path: Path
) -> None:
    command = [
        "make",
        "-s",
        "fuzz",
        f"EXPORTED={approach_exported.folder}",
        f"BUILD={tmp_path}",
        "CLANG=absent",
    ]
    for required, status in (("", 0), ("1", 2)):
        run = subprocess.run(
            [*command, f"REQUIRE={required}"], cwd=C_RUNTIME, capture_output=True, text=True, check=False
        )
        assert run.stdout == "left out: fuzz (to have it: apt-get install clang libclang-rt-14-dev)\n"
        assert run.returncode == status


def test_deviations_need_a_reason() -> None:
    heading = "| Rule | Category | Where | In | Why |\n|---|---|---|---|---|\n"
    table = heading + "| 8.9 | advisory | `a`, `b*` | f64 | {} |\n"
    rows = misra.read_deviations(table.format("tables"))
    assert rows == [misra.Deviation("8.9", where, frozenset({"f64"})) for where in ("a", "b*")]
    with pytest.raises(ValueError, match="needs all of"):
        misra.read_deviations(table.format(""))
    with pytest.raises(ValueError, match="one table"):
        misra.read_deviations("nothing\n")


def test_deviations_are_told_apart_by_place_and_build() -> None:
    row = misra.Deviation("8.9", "sailnet_*_layer", frozenset({"compact"}))
    compact = frozenset({"f32", "compact", "approach"})
    assert row.covers("8.9", "sailnet_tau_layer", compact)
    assert not row.covers("8.9", "sailnet_start", compact)
    assert not row.covers("8.7", "sailnet_tau_layer", compact)
    assert not row.covers("8.9", "sailnet_tau_layer", frozenset({"f32", "simd", "approach"}))
    # Where the row does not apply it need not occur.
    assert misra.judge({"f32": []}, [row], {"f32": frozenset({"f32", "simd"})}) == []
    assert len(misra.judge({"f32_compact": []}, [row], {"f32_compact": compact})) == 1


def test_gaps_need_a_reason_and_go_when_they_are_filled() -> None:
    text = '[[gap]]\nfunction = "f"\ntext = "x = 1;"\nlines = 1\nin = ["paper"]\nreason = "{}"\n'
    listed = coverage.explained(text.format("it is dead"))
    gap = coverage.Gap("f", "x = 1;", lines=1)
    paper, approach = frozenset({"f32", "paper"}), frozenset({"f32", "approach"})
    assert coverage.judge([gap], listed, paper) == []
    assert coverage.judge([gap], listed, approach) == [str(gap)]
    assert "not so any more" in coverage.judge([], listed, paper)[0]
    assert coverage.judge([], listed, approach) == []
    with pytest.raises(ValueError, match="needs a reason"):
        coverage.explained(text.format(""))


def test_conditions_that_no_branch_counts_are_gaps() -> None:
    source = ["int f(int a) {", "    return a < 3 ? 1 : 0; /* why ? */", "    a = 2; /* if ? */", "}"]

    def report(*counts: int) -> str:
        lines = [
            {"function_name": "f", "line_number": 2, "count": 5, "branches": [{"count": n} for n in counts]},
            {"function_name": "f", "line_number": 3, "count": 5, "branches": []},
        ]
        return json.dumps({"files": [{"file": "x/f.c", "lines": lines}]})

    folded = coverage.Coverage()
    folded.add(report(), "f.c")
    assert folded.gaps(source) == [coverage.Gap("f", "return a < 3 ? 1 : 0; /* why ? */", uncounted=True)]
    counted = coverage.Coverage()
    counted.add(report(5, 0), "f.c")
    assert [gap.branches for gap in counted.gaps(source)] == [1]
    # Another program takes the other branch.
    counted.add(report(0, 1), "f.c")
    assert counted.gaps(source) == []


def test_lines_know_their_function_and_builds_their_tags(exported: Exported) -> None:
    path = exported.folder / "sailnet_guidance.c"
    source = path.read_text()
    where = dict(zip(source.splitlines(), places(source), strict=True))
    assert where["    command->hold = hold;"] == "sailnet_steer"
    assert where["    *weights = &w[1];"] == "sailnet_network"
    assert where["#include <string.h>"] == "file"
    form = "approach" if exported.networks.approach else "paper"
    assert tags("f64_compact", path) == {"f64", "compact", form}
    assert defines("f64") == ["-DSAILNET_FLOAT64", "-USAILNET_COMPACT", "-DSAILNET_PLAIN"]

"""The checks of the flight file pass on an export of either form, and each catches the defects it is for."""

import json
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

from c_runtime.builds import BUILDS
from c_runtime.verification.checks import coverage, misra
from c_runtime.verification.checks.flight_file import places, tags
from tests.conftest import Exported
from tests.paths import ROOT
from tests.tools import missing, needs

C_RUNTIME = ROOT / "c_runtime"
SHIPPED = ROOT / "sailnet" / "shipped" / "earth_mars"
# What `make` calls for each, and the packages it is in.
TARGETS = {
    "test": (missing("cc"), ("gcc",)),
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
    "CFLAGS=-O1 -DCASES=3000",
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
def test_nothing_is_found(exported_of_any_sail: Exported, tmp_path: Path, target: str) -> None:
    builds = "f64 f32_host" if exported_of_any_sail.networks.approach else "f32"
    run = make(target, exported_of_any_sail.folder, tmp_path, f"BUILDS={builds}")
    assert run.returncode == 0, run.stdout + run.stderr


@dataclass(frozen=True)
class Mutant:
    """A defect, which one of the checks has to find.

    Attributes:
        target: of make.
        function: that has it.
        old, new: its code, and what becomes of it. No comment is matched.
        says: what the check tells.
        build: that is checked.
    """

    target: str
    function: str
    old: str
    new: str
    says: str
    build: str = "f32"

    def write(self, exported: Path, folder: Path) -> Path:
        """A copy of an export with the defect in it."""
        shutil.copytree(exported, folder)
        path = folder / BUILDS[self.build].source
        source = path.read_text()
        lines = source.splitlines(keepends=True)
        own = [i for i, place in enumerate(places(source)) if place == self.function]
        body = "".join(lines[own[0] : own[-1] + 1])
        assert body.count(self.old) == 1, f"{self.function} has {body.count(self.old)} of: {self.old}"
        changed = body.replace(self.old, self.new)
        path.write_text("".join([*lines[: own[0]], changed, *lines[own[-1] + 1 :]]))
        return folder


THERE = "int32_t there = 1;"
LAST = "    return (seen =="
"""Where the law ends."""
MUTANTS = {
    "twice the cone angle, without its bound": Mutant(
        "fuzz",
        "sailnet_law",
        "sailnet_size(sailnet_limited(&command->cone_angle, SAILNET_OF_CONE_ANGLE));",
        "R(2.0) * sailnet_size(command->cone_angle);",
        "promise broken: command->cone_angle",
    ),
    "a NaN let through": Mutant(
        "fuzz", "sailnet_is_state", "(state->u - state->u)", "R(0.0)", "promise broken"
    ),
    "held too long": Mutant(
        "fuzz",
        "sailnet_steer",
        "    command->hold = hold;\n",
        "    command->hold = R(2.0) * hold;\n",
        "promise broken",
    ),
    "a period of days": Mutant(
        "fuzz", "sailnet_steer", "(period <= SAILNET_LARGEST_PERIOD)", "(period <= R(1e9))", "promise broken"
    ),
    "an arrival outside the domain": Mutant(
        "fuzz",
        "sailnet_ends",
        "status != SAILNET_OUTSIDE_DOMAIN ? 1 : 0;",
        "status != SAILNET_INVALID_INPUT ? 1 : 0;",
        "promise broken: of_law != SAILNET_OUTSIDE_DOMAIN",
    ),
    "something remembered from call to call": Mutant(
        "fuzz",
        "sailnet_law",
        LAST,
        "    static int32_t calls = 0;\n    calls = 1 - calls;\n"
        f"    command->time_of_flight += (sailnet_real)calls;\n{LAST}",
        "promise broken",
    ),
    "index out of bounds": Mutant(
        "fuzz",
        "sailnet_observed",
        "number = &number[SAILNET_KNOTS + 1];",
        "number = &number[300 * SAILNET_KNOTS];",
        "SUMMARY: ",
    ),
    "a time lost of any size": Mutant(
        "fuzz", "sailnet_keep_side", "sailnet_limited(&regret, SAILNET_OF_PERIOD)", "regret", "memory->regret"
    ),
    "a side for ever": Mutant(
        "test",
        "sailnet_keep_side",
        "memory->regret < SAILNET_PATIENCE",
        "memory->regret < R(9.0)",
        "failed: ",
    ),
    "late by any time": Mutant(
        "fuzz", "sailnet_time_passes", "sailnet_limited(&late, SAILNET_OF_PERIOD)", "late", "memory->late"
    ),
    "a wait of any length": Mutant(
        "fuzz",
        "sailnet_time_passes",
        "sailnet_clamped(memory->wait - held, R(0.0), SAILNET_LARGEST_WAIT)",
        "memory->wait - held",
        "memory->wait",
    ),
    "late for ever": Mutant(
        "test",
        "sailnet_time_passes",
        "held * (R(1.0) / SAILNET_LATE_MEMORY) * memory->late",
        "R(0.0)",
        "one.late",
    ),
    "late across a gap": Mutant(
        "test",
        "sailnet_time_passes",
        "held > R(0.0) ? (command->",
        "held >= R(0.0) ? (command->",
        "failed: ",
    ),
    "a wait on both sides": Mutant(
        "test", "sailnet_keep_side", "(memory->waited <= R(0.0))", "(memory->waited <= R(9.0))", "failed: "
    ),
    "a wait of who is hardly late": Mutant(
        "test",
        "sailnet_keep_side",
        "memory->late > SAILNET_LATE_TOLERATED",
        "memory->late > R(0.0)",
        "failed: ",
    ),
    "a reversal while it waits": Mutant(
        "test", "sailnet_keep_side", "(memory->wait > R(0.0))", "(memory->wait > R(9.0))", "failed: "
    ),
    "an end as the networks say": Mutant(
        "test",
        "sailnet_until_nearest",
        "return memory->held * sailnet_clamped(share, R(0.0), R(1.0));",
        "return sailnet_clamped(memory->time_of_flight + R(0.0) * share, R(0.0), memory->held);",
        "missed(memory, hold)",
    ),
    "a side kept for a small step": Mutant(
        "test", "sailnet_keep_side", "(step > SAILNET_REVERSAL)", "(step > R(0.0))", "failed: "
    ),
    "still turning for any time": Mutant(
        "test", "sailnet_steer", "sailnet_limited(&left, SAILNET_OF_PERIOD) +", "left +", "memory.slewing"
    ),
    "learnt while turning": Mutant(
        "test", "sailnet_learn", "(turned <= SAILNET_SLEW_BLUR * held)", "(turned <= R(9.0))", "failed: "
    ),
    "learnt while the sail was seen to turn": Mutant(
        "test", "sailnet_measured", "(turn * turn <= SAILNET_SLEW_BLUR)", "(turn * turn <= R(9.0))", "slewing"
    ),
    "a lag taken for an offset": Mutant(
        "test",
        "sailnet_measured",
        "(askew * askew <= SAILNET_LARGEST_OFFSET * SAILNET_LARGEST_OFFSET)",
        "(askew * askew <= R(9.0))",
        "memory.offset",
    ),
    "an attitude of any size": Mutant(
        "test",
        "sailnet_steer",
        "memory->attitude = sailnet_limited(&memory->attitude, SAILNET_OF_ATTITUDE);",
        "",
        "SAILNET_LARGEST_ATTITUDE",
    ),
    "learnt across an outage": Mutant(
        "test", "sailnet_learn", "(memory->unseen == R(0.0))", "(memory->unseen >= R(0.0))", "failed: "
    ),
    "reckoned for ever": Mutant(
        "test",
        "sailnet_known",
        "(memory->unseen <= SAILNET_LONGEST_RECKONING)",
        "(memory->unseen <= R(9.0))",
        "failed: ",
    ),
    "reckoned to be nowhere": Mutant(
        "fuzz",
        "sailnet_known",
        "(sailnet_is_state(&change->by) != 0)",
        "(memory->held > R(0.0))",
        "promise broken",
    ),
    "planned with any beta": Mutant(
        "test", "sailnet_steer", "sailnet_limited(&plan, SAILNET_OF_BETA)", "plan", "SAILNET_AT_LIMIT"
    ),
    "no reserve": Mutant(
        "test", "sailnet_reserve", "return bounded *", "return R(0.0) * bounded *", "unlike_the_law"
    ),
    "signed overflow": Mutant(
        "fuzz",
        "sailnet_observed",
        THERE,
        "int32_t there = INT32_MAX;\n    there = (there + 2) & 1;",
        "signed integer overflow",
    ),
    "undefined output": Mutant(
        "valgrind", "sailnet_law", "    command->hold = R(0.0);\n", "", "uninitialised value"
    ),
    "undefined variable": Mutant(
        "valgrind",
        "sailnet_steer",
        "const uint32_t seen = sailnet_law(",
        "volatile int32_t unset[2];\n    volatile int32_t *volatile at = unset;\n"
        "    const uint32_t seen = *at == 7 ? 0u : sailnet_law(",
        "uninitialised value",
    ),
    "octal constant": Mutant("misra", "sailnet_observed", THERE, "int32_t there = 01;", "misra-c2012-7.1"),
    "a listed rule broken elsewhere": Mutant(
        "misra",
        "sailnet_start",
        "if (memory != NULL) {\n",
        "if (memory == NULL) {\n        return;\n    } else {\n",
        "(in sailnet_start): misra-c2012-15.5",
    ),
    "a variable without use": Mutant(
        "misra", "sailnet_observed", THERE, f"int32_t unread = 3;\n    {THERE}", "unreadVariable"
    ),
    "dead branch of an expression": Mutant(
        "coverage-c",
        "sailnet_law",
        LAST,
        f"    command->hold = command->time_of_flight > R(1e30) ? R(1e30) : R(0.0);\n{LAST}",
        "0 line(s), 1 branch(es) of: command->hold",
    ),
    "dead line": Mutant(
        "coverage-c",
        "sailnet_law",
        LAST,
        f"    if (command->time_of_flight > R(1e30)) {{\n        command->beta = R(0.0);\n    }}\n{LAST}",
        "1 line(s), 0 branch(es) of: command->beta = R(0.0);",
    ),
    "constant of the wrong precision": Mutant(
        "warnings",
        "sailnet_learn",
        "const sailnet_real distance = R(0.5) * (before",
        "const sailnet_real distance = 0.5 * (before",
        "double",
    ),
    "a type of 64 bit on some machines": Mutant(
        "warnings",
        "sailnet_start",
        "if (memory != NULL) {\n",
        "if (memory != NULL && (1L << 40) != 0) {\n",
        "shift",
    ),
    # The last of the file for hosts.
    "a knot beyond the last": Mutant(
        "fuzz",
        "sailnet_find",
        "before < SAILNET_KNOTS - 2 ? before : SAILNET_KNOTS - 2;",
        "before;",
        "out of bounds",
        "f32_host",
    ),
}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=needs_tools_of(mutant.target)) for name, mutant in MUTANTS.items()]
)
def test_defects_are_found(approach_exported: Exported, tmp_path: Path, name: str) -> None:
    mutant = MUTANTS[name]
    # The tube of random networks holds every state.
    exported = SHIPPED if name == "a knot beyond the last" else approach_exported.folder
    folder = mutant.write(exported, tmp_path / "exported")
    if name == "an arrival outside the domain":
        # So many inputs come upon it only where all of the estimate is planned with.
        header = folder / "sailnet_guidance.h"
        kept = re.compile(r"(?<=SAILNET_LEAST_RESERVE SAILNET_REAL)\(.*\)")
        header.write_text(kept.sub("(0.0)", header.read_text(), count=1))
    run = make(mutant.target, folder, tmp_path, f"BUILDS={mutant.build}", "FUZZ_RUNS=50000")
    assert run.returncode != 0, run.stdout
    assert mutant.says in run.stdout + run.stderr


@needs_tools_of("misra")
def test_a_listed_deviation_that_is_gone_fails(approach_exported: Exported, tmp_path: Path) -> None:
    listed = (C_RUNTIME / "MISRA.md").read_text()
    row = "| 12.1 | advisory |"
    assert row in listed
    table = tmp_path / "MISRA.md"
    table.write_text(listed.replace(row, f"| 7.1 | required | `sailnet_start` | all | none |\n{row}"))
    run = make("misra", approach_exported.folder, tmp_path, f"DEVIATIONS={table}", "BUILDS=f32")
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
    row = misra.Deviation("8.9", "sailnet_*_layer", frozenset({"f64"}))
    double = frozenset({"f64", "flight", "approach"})
    assert row.covers("8.9", "sailnet_tau_layer", double)
    assert not row.covers("8.9", "sailnet_start", double)
    assert not row.covers("8.7", "sailnet_tau_layer", double)
    assert not row.covers("8.9", "sailnet_tau_layer", frozenset({"f32", "flight", "approach"}))
    # Where the row does not apply it need not occur.
    assert misra.judge({"f32": []}, [row], {"f32": frozenset({"f32", "flight"})}) == []
    assert len(misra.judge({"f64": []}, [row], {"f64": double})) == 1


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
    assert tags("f64", exported.folder) == {"f64", "flight", form, "plane"}
    assert tags("f32_host", exported.folder) == {"f32", "host", form, "plane"}

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
    "MEMCHECK_RUNS=50",
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


# The forms that `make checks` does not check: the released networks are those of an ideal sail.
# cppcheck reads one configuration where a macro is defined, and all of them where none is.
@pytest.mark.parametrize(
    ("exported_of_any_sail", "build"),
    [("paper", "f32"), ("jpl", "f64"), pytest.param("jpl", "f32_host", marks=pytest.mark.long)],
    indirect=["exported_of_any_sail"],
)
@pytest.mark.parametrize("target", [pytest.param(name, marks=needs_tools_of(name)) for name in TARGETS])
def test_nothing_is_found(exported_of_any_sail: Exported, tmp_path: Path, target: str, build: str) -> None:
    run = make(target, exported_of_any_sail.folder, tmp_path, f"BUILDS={build}")
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
    "a flight without an end": Mutant(
        "test", "sailnet_steer", "nearest < hold ?", "nearest < R(0.0) ?", "failed: "
    ),
    "a flight that ends somewhere": Mutant(
        "test", "sailnet_steer", "(seen & SAILNET_THERE) : 0u", "SAILNET_THERE : 0u", "failed: "
    ),
    "a plan that is not flown to its end": Mutant(
        "test",
        "sailnet_steer",
        "(memory->tracker.planned != 1)",
        "(memory->tracker.planned != 7)",
        "failed: ",
    ),
    "held to the end of the period": Mutant(
        "test",
        "sailnet_until_nearest",
        "return estimate->held * sailnet_clamped(share, R(0.0), R(1.0));",
        "return estimate->held + R(0.0) * share;",
        "missed(memory, hold)",
    ),
    "still turning for any time": Mutant(
        "test", "sailnet_steer", "sailnet_limited(&left, SAILNET_OF_PERIOD) +", "left +", "slewing"
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
        "estimate.offset",
    ),
    "an attitude of any size": Mutant(
        "test",
        "sailnet_steer",
        "estimate->attitude = sailnet_limited(&estimate->attitude, SAILNET_OF_ATTITUDE);",
        "",
        "SAILNET_LARGEST_ATTITUDE",
    ),
    "learnt across an outage": Mutant(
        "test", "sailnet_learn", "(estimate->unseen == R(0.0))", "(estimate->unseen >= R(0.0))", "failed: "
    ),
    "reckoned for ever": Mutant(
        "test",
        "sailnet_known",
        "(estimate->unseen <= SAILNET_LONGEST_RECKONING)",
        "(estimate->unseen <= R(9.0))",
        "failed: ",
    ),
    "reckoned to be nowhere": Mutant(
        "test",
        "sailnet_known",
        "(sailnet_is_state(&change->by) != 0)",
        "(estimate->held > R(0.0))",
        "INVALID_INPUT",
    ),
    "planned with any beta": Mutant(
        "test", "sailnet_steer", "sailnet_limited(&plan, SAILNET_OF_BETA)", "plan", "failed: plan->beta >="
    ),
    "no thrust margin": Mutant(
        "test", "sailnet_reserve", "return bounded *", "return R(0.0) * bounded *", "unlike_the_law"
    ),
    "more extremals than the budget": Mutant(
        "test",
        "sailnet_follow",
        "advance_candidate(problem, tracker, state, most - tracker->computed);",
        "advance_candidate(problem, tracker, state, most);",
        "computed <= SAILNET_EXTREMALS_PER_PERIOD",
    ),
    "a side that is no direction": Mutant(
        "test", "keep_attitude", "(sailnet_absolute(size2 - 1.0) < 1e-6)", "(size2 > 0.0)", "kept == (i == 0)"
    ),
    "a cone angle that is none": Mutant(
        "test",
        "keep_attitude",
        "(sailnet_absolute(square - 1.0) < 1e-6)",
        "(square > -1.0)",
        "memcmp(&command.attitude, &best",
    ),
    "an attitude kept until the end": Mutant(
        "test", "keep_attitude", "(regret < share)", "(regret < 9.0 + share)", "failed: kept == 11"
    ),
    "every attitude kept": Mutant(
        "test",
        "keep_attitude",
        " && ((alike < 0.0) || (planned->time_to_go < LATE))",
        "",
        "memcmp(&command.attitude, expected",
    ),
    "a cone angle that is never kept": Mutant(
        "test",
        "keep_attitude",
        "((alike < 0.0) || (planned->time_to_go < LATE))",
        "(alike < 0.0)",
        "memcmp(&command.attitude, expected",
    ),
    "time lost at any distance": Mutant(
        "test", "keep_attitude", "per_r * per_r * loss", "per_r * loss", "fabs(tracker.regret - regret)"
    ),
    "an attitude remembered without a plan": Mutant(
        "test",
        "sailnet_follow",
        "        (void)memset(&tracker->flown, 0, sizeof tracker->flown);\n",
        "",
        "tracker->flown.cosine == 0.0",
    ),
    "a time that never passes": Mutant(
        "test", "passed", "((now >= 0.0) && (now < 1.0)) ? now : 1.0;", "now;", "failed: "
    ),
    "an age of any size": Mutant(
        "test", "grow_older", "passed(plan->age, held)", "plan->age + held", "tracker.plan.age == 1.0"
    ),
    "an end that is not there": Mutant(
        "test",
        "sailnet_bring_up",
        "steps > 0 ? now.residual : NOWHERE;",
        "steps >= 0 ? now.residual : NOWHERE;",
        "missed.residual == UNSOLVED",
    ),
    "what is not a number misses by nothing": Mutant(
        "test", "compare", "size < NOWHERE ? size : NOWHERE;", "size;", "missed.residual == UNSOLVED"
    ),
    "two extremals of a budget of one": Mutant(
        "test", "begin", "(most > 1)", "(most > 0)", "memcmp(plan.direction, before.direction"
    ),
    "a derivative that leaves nothing to the correction": Mutant(
        "test", "sailnet_track", "(moves > 3)", "(moves > 0)", "plan.differentiated < 2"
    ),
    "a budget of one that is not used": Mutant(
        "test", "sailnet_track", "if (moves <= 0) {", "if (moves == 0) {", "computed >= 1"
    ),
    "a derivative by the push aside that says nothing": Mutant(
        "test", "begin", "plan->per_across[n] * at->change[1];", "0.0 * at->change[1];", "failed: enough > 5"
    ),
    "a vehicle that moves aside at once": Mutant(
        "test",
        "sailnet_track",
        "by_beta > by_aside ? by_beta : by_aside;",
        "by_beta + 0.0 * by_aside;",
        "failed: derived ||",
    ),
    "a plan brought up by another vehicle's force": Mutant(
        "test",
        "sailnet_problem_of",
        "    sailnet_push_aside(&own, plan->across - problem->across);\n",
        "",
        "failed: ",
    ),
    "a candidate for what was learnt since": Mutant(
        "test",
        "sailnet_advance_candidate",
        "sailnet_problem_of(problem, candidate);",
        "*problem;",
        "tracker.candidate.across == before",
    ),
    "a derivative by beta that says nothing": Mutant(
        "test", "begin", "plan->per_beta[n] * at->change[0] +", "0.0 * at->change[0] +", "failed: enough > 5"
    ),
    "a correction that is not gone on with": Mutant(
        "test",
        "sailnet_follow",
        "tracker->planned = 2 - sailnet_plan_is_solved(plan);",
        "tracker->planned = 1;",
        "tracker->planned == 2 - sailnet_plan_is_solved",
    ),
    "a plan flown however much it misses": Mutant(
        "test",
        "sailnet_is_usable",
        " && (tracker->plan.residual <= USABLE)",
        "",
        "flown == (i == 0)",
    ),
    "a plan for a much stronger vehicle": Mutant(
        "test",
        "sailnet_follow",
        "(plan->beta <= stronger)",
        "(plan->beta <= (9.0 * stronger))",
        "== (i != 1)",
    ),
    "a plan left on its way to another beta": Mutant(
        "test", "sailnet_follow", "(tracker->stride >= SAILNET_LARGEST_STRIDE)", "(0 != 0)", "== (i != 1)"
    ),
    "a plan that has failed, kept": Mutant(
        "test",
        "sailnet_has_failed",
        "!(tracker->plan.residual < FAILED)",
        "(0 != 0)",
        "sailnet_has_failed(tracker) ==",
    ),
    "a candidate that is hardly faster": Mutant(
        "test", "is_better", "(1.0 - FASTER) * ", "1.0 * ", "is_better(tracker, 0.995"
    ),
    "a failed plan that takes the budget": Mutant(
        "test",
        "sailnet_follow",
        "(tracker->planned == 1) && (sailnet_has_failed(tracker) == 0)",
        "tracker->planned == 1",
        "residual < residual) == (first == 0)",
    ),
    "a plan for a stronger vehicle, seldom corrected": Mutant(
        "test", "sailnet_follow", " && (plan->beta <= estimated)", "", "tracker->since == (i == 0"
    ),
    "a thrust margin that is never spent": Mutant(
        "test", "sailnet_steer", "spent != 0 ? own", "spent > 1 ? own", "cases[i].spent == 0"
    ),
    "a thrust margin spent at once": Mutant(
        "test", "sailnet_steer", " && (sailnet_has_failed(&memory->tracker) != 0)", "", "cases[i].spent == 0"
    ),
    "a failed plan that keeps its vehicle": Mutant(
        "test",
        "sailnet_follow",
        "(tracker->planned > 1) && (sailnet_has_failed(tracker) != 0)",
        "(0 != 0)",
        "moved > TRIALS / 4",
    ),
    "a plan that moves on to its vehicle at once": Mutant(
        "test",
        "sailnet_follow",
        "(tracker->planned > 1) && (sailnet_has_failed(tracker) != 0)",
        "tracker->planned > 1",
        "moved == 0",
    ),
    "a bound that stays where other optics leave it": Mutant(
        "test",
        "sailnet_push_aside",
        "    problem->edge_radial += tangential * s * (2.0 * c * c - s * s);\n",
        "",
        "pushed.edge_radial - expected.edge_radial",
    ),
    "a bound that other optics move the wrong way": Mutant(
        "test", "sailnet_push_aside", "(2.0 * s * s - c * c)", "(c * c - 2.0 * s * s)", "pushed.edge_lateral"
    ),
    "plans for optics of any size": Mutant(
        "test",
        "sailnet_own_problem",
        "sailnet_limited(&memory->estimate.tangential, SAILNET_OF_TANGENTIAL)",
        "memory->estimate.tangential",
        "own.across - sailnet_transfer.across",
    ),
    "networks asked for a sail of other optics": Mutant(
        "test", "sailnet_for_networks", "beta * (R(1.0) - lost)", "beta", "sailnet_for_networks"
    ),
    "a way to another vehicle that waits": Mutant(
        "test", "sailnet_follow", "? CORRECT_AT_LATEST : 0.0;", "? 0.0 : 0.0;", "tracker->since >= 0.1"
    ),
    "an end moved the wrong way": Mutant(
        "test", "sailnet_move_end", "fly(problem, -lapse,", "fly(problem, lapse,", "end.value[n] - expected"
    ),
    "a plan corrected while another attitude is flown": Mutant(
        "test", "sailnet_follow", "!(tracker->regret > 0.0)", "(0 == 0)", "tracker->computed == 0"
    ),
    "an attitude kept however far off": Mutant(
        "test",
        "keep_attitude",
        "(regret < share) && (sailnet_has_failed(tracker) == 0)",
        "(regret < share)",
        "(i < 2)",
    ),
    "a plan that is corrected hardly ever": Mutant(
        "test", "sailnet_follow", "!(tracker->since < CORRECT_AT_LATEST)", "(0 != 0)", "failed: "
    ),
    "a plan of infinite numbers": Mutant(
        "test",
        "sailnet_tracks",
        "(sailnet_are_numbers(&planned) == 0)",
        "(sailnet_are_numbers(&planned) > 1)",
        "SAILNET_FROM_NETWORKS : SAILNET_FROM_PLAN",
    ),
    "a plan for any beta": Mutant(
        "test",
        "sailnet_plan_upload",
        "(plan->beta >= (double)SAILNET_BETA_MIN) && (plan->beta <= (double)SAILNET_BETA_MAX)",
        "(plan->beta > 0.0)",
        "sailnet_plan_upload",
    ),
    "a plan of another mission": Mutant(
        "test", "sailnet_is_mission", "(same != 0) && (i < sizeof own)", "(i < 1u)", "sailnet_plan_upload"
    ),
    "a plan that was not converged": Mutant(
        "test", "sailnet_take_plan", "if (solved != 0) {", "if (solved >= 0) {", "memcmp(&after, memory"
    ),
    "a known plan that was tried already": Mutant(
        "test",
        "sailnet_propose_known",
        "(far > tracker->tried) && ",
        "",
        "next_of(&tracker, &state, turned) == i",
    ),
    "a known plan of a slower family begun": Mutant(
        "test",
        "sailnet_propose_known",
        "((double)known[i].time_to_go < longest)",
        "(longest == longest)",
        "tracker.candidate.time_to_go",
    ),
    "a known plan of a slower family flown": Mutant(
        "test",
        "sailnet_advance_candidate",
        "(candidate->time_to_go < longest_known(tracker))",
        "(tracker->tried > 0.0)",
        "flown == (i != 2)",
    ),
    "a plan of the networks held to their promise": Mutant(
        "test", "sailnet_advance_candidate", "!(tracker->tried > 0.0)", "(0 != 0)", "flown == (i != 2)"
    ),
    "known plans tried while one is flown": Mutant(
        "test",
        "sailnet_propose",
        "sailnet_is_usable(tracker) == 0 ? most : 0",
        "most",
        "tracker.untried == cases",
    ),
    "no known plans tried while one leads nowhere": Mutant(
        "test",
        "sailnet_propose",
        "sailnet_is_usable(tracker) == 0 ? most : 0",
        "tracker->planned == 0 ? most : 0",
        "tracker.untried == cases",
    ),
    "known plans without end": Mutant(
        "test", "sailnet_propose_known", "next >= 0 ? (left - 1) : 0", "next >= 0 ? left : 0", "failed: "
    ),
    "a promise that does not grow shorter": Mutant(
        "test", "sailnet_time_passes", "    tracker->promised -= held;\n", "", "tracker.promised - 0.15"
    ),
    "a byte that is not summed": Mutant(
        "test", "sailnet_checksum", "for (uint32_t i = 0u;", "for (uint32_t i = 1u;", "sailnet_restore"
    ),
    "a memory of another version": Mutant(
        "test",
        "sailnet_restore",
        "(memory->version == (uint32_t)SAILNET_API_VERSION)",
        "(memory->version != 0u)",
        "sailnet_restore",
    ),
    "damage that is flown on": Mutant(
        "test", "sailnet_restore", "            sailnet_start(memory);\n", "", "is_same_memory"
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
        "    uint32_t seen = 0u;\n",
        "    volatile int32_t unset[2];\n    volatile int32_t *volatile at = unset;\n"
        "    uint32_t seen = 0u;\n    if (*at == 7) {\n        hold = R(0.0);\n    }\n",
        "uninitialised value",
    ),
    "octal constant": Mutant(
        "misra", "sailnet_observed", THERE, "int32_t there = 01;", "misra-c2012-7.1", "f64"
    ),
    "a listed rule broken elsewhere": Mutant(
        "misra",
        "sailnet_start",
        "if (memory != NULL) {\n",
        "if (memory == NULL) {\n        return;\n    } else {\n",
        "(in sailnet_start): misra-c2012-15.5",
        "f64",
    ),
    "a variable without use": Mutant(
        "misra", "sailnet_observed", THERE, f"int32_t unread = 3;\n    {THERE}", "unreadVariable", "f64"
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
    run = make("misra", approach_exported.folder, tmp_path, f"DEVIATIONS={table}", "BUILDS=f64")
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
    assert [one.gap for one in listed] == [gap]
    paper, approach = frozenset({"f32", "paper"}), frozenset({"f32", "approach"})
    assert coverage.judge([gap], listed, paper) == []
    assert coverage.judge([gap], listed, approach) == [str(gap)]
    assert "not so any more" in coverage.judge([], listed, paper)[0]
    assert coverage.judge([], listed, approach) == []
    rare = coverage.explained(text.format("of some networks").replace("lines = 1", "rare = true"))
    assert coverage.judge([gap], rare, paper) == coverage.judge([], rare, paper) == []
    assert coverage.judge([gap], rare, approach) == [str(gap)]
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

"""The flight file on emulated processors, and the counter, sizes and checks themselves."""

import dataclasses
import json
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

from c_runtime.verification.targets import __main__ as command
from c_runtime.verification.targets import measure, run
from c_runtime.verification.targets.build import TargetError, link
from c_runtime.verification.targets.elf import address, deepest_stack, reached, sizes
from c_runtime.verification.targets.golden import (
    COMMANDS,
    PERIODS,
    SEQUENCES,
    Golden,
    golden_commands,
    golden_flights,
    golden_steering,
)
from c_runtime.verification.targets.machines import HOST, TARGETS, Target
from c_runtime.verification.targets.measure import Bench, compile_plugin, missing_tools
from c_runtime.verification.targets.reference import ReferenceGuidance
from c_runtime.verification.targets.table import Limit, limits
from sailnet.flight.closed_loop import History
from sailnet.guidance.interface import GuidanceStatus, Precision
from sailnet.guidance.rules import LARGEST_PERIOD
from sailnet.networks.guidance_networks import load_guidance_networks
from sailnet.networks.plan_networks import load_plan_networks
from tests.paths import ROOT
from tests.tools import needs

SHIPPED = ROOT / "sailnet" / "shipped" / "earth_mars"
RESULTS = ROOT / "c_runtime" / "RESULTS.md"
BEGIN, END = "<!-- targets -->", "<!-- /targets -->"


def needs_tools_of(target: Target) -> pytest.MarkDecorator:
    return needs("emulator", missing_tools(target), *target.packages)


every_target = pytest.mark.parametrize(
    "target",
    [pytest.param(target, id=target.name, marks=needs_tools_of(target)) for target in TARGETS],
)
# The first whose tools are here.
ANY_TARGET = next((target for target in TARGETS if not missing_tools(target)), TARGETS[0])
needs_any_target = needs_tools_of(ANY_TARGET)


@pytest.fixture(scope="module")
def reference() -> ReferenceGuidance:
    networks = load_guidance_networks(SHIPPED)
    return ReferenceGuidance(networks, load_plan_networks(SHIPPED, networks.mission))


@pytest.fixture(scope="module")
def flights(reference: ReferenceGuidance) -> list[History]:
    return golden_flights(reference)


@pytest.fixture
def flown(flights: list[History], monkeypatch: pytest.MonkeyPatch) -> None:
    """The flights of golden vectors take seconds; whole runs read these."""
    monkeypatch.setattr(measure, "golden_flights", lambda _: flights)


@pytest.fixture(scope="module")
def bench(reference: ReferenceGuidance, tmp_path_factory: pytest.TempPathFactory) -> Bench:
    return Bench(reference, SHIPPED, tmp_path_factory.mktemp("targets"))


@every_target
def test_flight_file_runs_as_the_reference_says(bench: Bench, target: Target) -> None:
    for precision in target.precisions:
        exact = bench.measure(target, precision, "flight", False)
        assert exact.wrong == ()
        assert exact.other_bits == 0
        assert exact.program.sizes.static == 0
        for calls, reserved in zip(
            (exact.run.guidance, exact.run.steering), exact.program.stack, strict=True
        ):
            # Not all that is reserved is written: room for arguments and register windows.
            assert 0.7 * reserved <= calls.stack <= reserved + 16
            assert calls.counts is not None
            # One multiplication and addition for each weight; at the target the tube is not asked.
            # The call that ends a flight predicts one step more.
            # What steering corrects of a plan is within a budget; doubles in software take ten times as many.
            steering = 3e8 if target.arithmetic else 3e7
            most = 1.03 * calls.counts.mean if calls is exact.run.guidance else steering
            assert 2700 < calls.counts.mean <= calls.counts.most < most
            assert (calls.counts.retired == calls.counts.total) == target.retires
        if target.fuses:
            fused = bench.measure(target, precision, "flight", True)
            assert fused.wrong == ()
            assert fused.other_bits > 0


@needs_tools_of(HOST)
def test_layouts_agree_on_the_host(bench: Bench) -> None:
    for precision in HOST.precisions:
        for layout in ("flight", "host"):
            assert bench.measure(HOST, precision, layout, False).wrong == ()


# Instructions of each before the loop and within it, in which SPARC fills the slot after a branch.
LOOPS = {
    "cortex_m": ("movs r0, #100\n1: subs r0, #1\nbne 1b", "r0", 1 + 2 * 100),
    "leon3": ("mov 100, %%o0\n1: subcc %%o0, 1, %%o0\nbne 1b\nnop", "o0", 1 + 3 * 100),
    "riscv": ("li a0, 100\n1: addi a0, a0, -1\nbnez a0, 1b", "a0", 1 + 2 * 100),
    "hosted": ("li 3, 100\n1: addic. 3, 3, -1\nbne 1b", "r3", 1 + 2 * 100),
}
LOOP_PROGRAM = """
#include "platform.h"
__attribute__((noipa)) void count_begin(void) { __asm__ volatile(""); }
__attribute__((noipa)) void count_end(void) { __asm__ volatile(""); }
int main(void)
{
    count_begin();
    count_end();
    count_begin();
    __asm__ volatile(LOOP ::: CLOBBERED, "cc");
    count_end();
    platform_print("done\\n");
    platform_stop();
    return 0;
}
"""


@every_target
def test_instructions_of_a_known_loop_are_counted(target: Target, tmp_path: Path) -> None:
    text, register, expected = LOOPS[target.folder]
    source, program, counted = (tmp_path / name for name in ("loop.c", "program", "counted"))
    source.write_text(
        f"#define LOOP {json.dumps(text)}\n#define CLOBBERED {json.dumps(register)}\n{LOOP_PROGRAM}"
    )
    link(target, [source], ["-Wno-missing-prototypes"], program)
    begin, end = (address(program, name) for name in ("count_begin", "count_end"))
    plugin = f"{compile_plugin(tmp_path)},begin={begin},end={end},output={counted}"
    emulator = [target.emulator[0], "-plugin", plugin, *target.emulator[1:], str(program)]
    subprocess.run(emulator, check=False, capture_output=True, stdin=subprocess.DEVNULL, timeout=20)
    nothing, loop = (int(line) for line in counted.read_text().split())
    assert loop - nothing == expected


def run_command(folder: Path, target: Target, *options: str) -> int:
    return command.main([str(SHIPPED), "--build", str(folder), "--targets", target.name, *options])


@needs_any_target
@pytest.mark.usefixtures("flown")
def test_a_mutated_golden_vector_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    target = ANY_TARGET

    def mutated(*arguments: object) -> Golden:
        golden = golden_commands(*arguments)  # type: ignore[arg-type]
        golden.expected[17, 0] += 1e-3
        return golden

    monkeypatch.setattr(measure, "golden_commands", mutated)
    assert run_command(tmp_path, target) == 1
    assert "1 calls differ from the reference" in capsys.readouterr().out
    rows = json.loads((tmp_path / "targets.json").read_text())["rows"]
    assert {row["exceeded"] for row in rows} == {1}


@needs_any_target
@pytest.mark.usefixtures("flown")
def test_a_mutated_status_fails(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    target = ANY_TARGET

    def mutated(*arguments: object) -> Golden:
        golden = golden_steering(*arguments)  # type: ignore[arg-type]
        outside = golden.status[3] == GuidanceStatus.OUTSIDE_DOMAIN
        golden.status[3] = GuidanceStatus.OK if outside else GuidanceStatus.OUTSIDE_DOMAIN
        return golden

    monkeypatch.setattr(measure, "golden_steering", mutated)
    assert run_command(tmp_path, target) == 1


@needs_any_target
@pytest.mark.usefixtures("flown")
def test_a_whole_run_rewrites_the_table_of_a_readme(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = ANY_TARGET
    readme = tmp_path / "README.md"
    readme.write_text(re.sub(rf"{BEGIN}.*{END}", f"{BEGIN}\nstale\n{END}", RESULTS.read_text(), flags=re.S))
    before, after = readme.read_text().split(f"{BEGIN}\nstale\n{END}")
    assert run_command(tmp_path, target, "--table", str(readme)) == 0
    written = readme.read_text()
    assert written.startswith(before + BEGIN)
    assert written.endswith(END + after)
    table = written.removeprefix(before).removesuffix(after)
    table_rows = [line for line in table.splitlines() if line.startswith(f"| {target.title} |")]
    assert len(table_rows) == len(target.precisions)
    row = json.loads((tmp_path / "targets.json").read_text())["rows"][-1]
    assert f"({row['instructions']['guidance']['most']:,})" in table_rows[-1]
    assert target.name in capsys.readouterr().out


def test_a_text_without_the_marks_is_told_before_all_the_work(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    readme = tmp_path / "README.md"
    readme.write_text("no marks")
    assert run_command(tmp_path, TARGETS[0], "--table", str(readme)) == 1
    assert "<!-- targets -->" in capsys.readouterr().err
    assert not (tmp_path / "targets.json").exists()


@pytest.mark.parametrize(("ci", "options", "status"), [("", [], 0), ("", ["--require"], 1), ("true", [], 1)])
def test_a_missing_tool_is_named(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    ci: str,
    options: list[str],
    status: int,
) -> None:
    monkeypatch.setenv("CI", ci)
    absent = dataclasses.replace(TARGETS[0], compiler="no-such-gcc", emulator=("sh",))
    monkeypatch.setattr(command, "TARGETS", (absent,))
    assert run_command(tmp_path, absent, *options) == status
    (line,) = capsys.readouterr().out.strip().splitlines()
    assert line.startswith(f"targets: {absent.name} left out, no-such-gcc not found: apt-get install gcc-arm")


@pytest.mark.parametrize(
    ("script", "message"),
    [("exec sleep 20", "printed no end within"), ("echo guidance; echo fault", "did not reach its end")],
)
def test_a_program_that_does_not_end_well_has_failed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str, message: str
) -> None:
    monkeypatch.setattr(run, "LONGEST", 0.3)
    target = dataclasses.replace(TARGETS[0], emulator=("sh", "-c", script))
    with pytest.raises(TargetError, match=message):
        run.run(target, tmp_path / "program", "float32", None)


def test_a_flight_file_of_other_networks_is_refused(reference: ReferenceGuidance, tmp_path: Path) -> None:
    other = (SHIPPED / "sailnet_guidance.h").read_text().replace(reference.networks_digest, "0" * 64)
    (tmp_path / "sailnet_guidance.h").write_text(other)
    with pytest.raises(TargetError, match="was not exported from the networks given"):
        Bench(reference, tmp_path, tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("precision", ["float32", "float64"])
def test_golden_vectors_cover_what_can_happen(
    reference: ReferenceGuidance, flights: list[History], precision: Precision
) -> None:
    commands, steering = (make(reference, flights, precision) for make in (golden_commands, golden_steering))
    assert (
        len(commands.status)
        == COMMANDS
        == len(np.unique(commands.inputs.view(np.uint8).reshape(COMMANDS, -1), axis=0))
    )
    of_steering = {GuidanceStatus.RECKONED, GuidanceStatus.AT_LIMIT}
    assert set(commands.status) == set(GuidanceStatus) - of_steering
    assert set(steering.status) >= {
        GuidanceStatus.OK,
        GuidanceStatus.ARRIVED,
        GuidanceStatus.INVALID_INPUT,
        GuidanceStatus.RECKONED,
    }
    assert (steering.inputs[:, 3] > LARGEST_PERIOD).sum() == SEQUENCES
    assert steering.starts.sum() == SEQUENCES == len(steering.status) / PERIODS
    valid = commands.status != GuidanceStatus.INVALID_INPUT
    assert not np.isfinite(commands.inputs[~valid]).all(axis=1).any()
    # All phases: both signs of the cone angle, hardly anything to go, and nearly all.
    assert (commands.expected[:, 0] > 0.1).sum() > 50
    assert (commands.expected[:, 0] < -0.1).sum() > 50
    assert (commands.expected[valid, 1] < 0.1).sum() > 50
    assert (commands.expected[valid, 1] > 3.0).sum() > 50
    again = golden_commands(reference, flights, precision)
    np.testing.assert_array_equal(commands.inputs.view(np.uint8), again.inputs.view(np.uint8))


@needs_tools_of(HOST)
def test_sizes_are_told_apart(tmp_path: Path) -> None:
    source, compiled = tmp_path / "file.c", tmp_path / "file.o"
    source.write_text(
        "extern int elsewhere(void); const int table[100] = {1}; static int zero[10]; int set[5] = {7};\n"
        "int *address(int i) { return zero + i + elsewhere(); }\n"
    )
    subprocess.run(
        [
            HOST.compiler,
            "-O2",
            "-fno-pie",
            "-fno-asynchronous-unwind-tables",
            "-c",
            str(source),
            "-o",
            str(compiled),
        ],
        check=True,
    )
    found = sizes(compiled)
    assert (found.constants, found.static, found.helpers) == (400, 60, ("elsewhere",))
    assert found.functions == {"address": found.code}


CALLS = """graph: {{ title: "file.c"
node: {{ title: "top" label: "top\\nfile.c:1:1\\n16 bytes (static)" }}
node: {{ title: "file.c:left" label: "left\\nfile.c:2:1\\n100 bytes (static)" }}
node: {{ title: "right" label: "right\\nfile.c:3:1\\n40 bytes ({kind})" }}
node: {{ title: "memcpy" label: "memcpy\\nstring.h:3:1" shape : ellipse }}
edge: {{ sourcename: "top" targetname: "file.c:left" label: "file.c:1:9" }}
edge: {{ sourcename: "top" targetname: "right" label: "file.c:1:9" }}
edge: {{ sourcename: "right" targetname: "{called}" label: "file.c:3:9" }}
}}
"""


def test_the_deepest_path_counts(tmp_path: Path) -> None:
    graph = tmp_path / "file.ci"
    graph.write_text(CALLS.format(kind="static", called="memcpy"))
    assert deepest_stack(graph, "top") == 116
    graph.write_text(CALLS.format(kind="static", called="file.c:left"))
    assert deepest_stack(graph, "top") == 156
    graph.write_text(CALLS.format(kind="dynamic,bounded", called="__aeabi_dmul"))
    assert deepest_stack(graph, "top") == 116
    for kind, called in (("dynamic", "memcpy"), ("static", "top")):
        graph.write_text(CALLS.format(kind=kind, called=called))
        with pytest.raises(ValueError, match="not fixed"):
            deepest_stack(graph, "top")
    with pytest.raises(ValueError, match="does not know absent"):
        deepest_stack(graph, "absent")


def test_what_a_function_needs_is_what_it_reaches(tmp_path: Path) -> None:
    graph = tmp_path / "file.ci"
    graph.write_text(CALLS.format(kind="static", called="memcpy"))
    assert reached(graph, "top") == {"top", "left", "right"}
    assert reached(graph, "left") == {"left"}
    with pytest.raises(ValueError, match="does not know absent"):
        reached(graph, "absent")


def test_limits_are_named_with_their_verdict() -> None:
    assert str(Limit("code", 2048, 2048)) == "PASS  code: 2,048 (limit 2,048)"
    assert str(Limit("code", 2049, 2048)).startswith("MISS")
    assert str(Limit("speed", 13000, 15000, 12000)).endswith("aim 12,000 not met)")
    assert limits([]) == []

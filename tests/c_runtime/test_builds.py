import re
import shlex
import subprocess
from pathlib import Path

import pytest

from c_runtime.builds import BUILDS, Build
from c_runtime.shared_library import find_compiler
from tests.conftest import Exported
from tests.guidance.space_export import export_c
from tests.paths import ROOT
from tests.random_networks import random_guidance_in_space
from tests.tools import every_compiler, missing, needs

C_RUNTIME = ROOT / "c_runtime"
STEERING = ("start", "steer", "seal", "restore", "plan_upload", "propose_plan", "report_plan")
"""Functions of the flight file that -DSAILNET_LAW_ONLY leaves out, and in the plane ``sailnet_measured``."""
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
FAST = "-O3 -march=native -fno-trapping-math -fno-tree-vectorize -ffp-contract=fast"
# Undefined behaviour ends the program; needs no library of the sanitizer.
TRAPPING = "-O1 -fsanitize=undefined -fsanitize-undefined-trap-on-error"
# Of every case with the flags that fly, of some with the others.
SOME = "-DCASES=1000"
every_build = pytest.mark.parametrize("build", BUILDS.values(), ids=BUILDS)


@every_compiler
@pytest.mark.parametrize(
    "flags",
    [
        FAST,
        pytest.param(f"-O2 {SOME}", marks=pytest.mark.long),
        pytest.param(f"{TRAPPING} {SOME}", marks=pytest.mark.exhaustive),
    ],
)
def test_unit_tests_in_c(exported: Exported, tmp_path: Path, compiler: list[str], flags: str) -> None:
    pass_unit_tests(exported.folder, tmp_path, compiler, flags)


@pytest.mark.slow
@every_compiler
@pytest.mark.parametrize(
    "flags", [f"-O2 {SOME}", pytest.param(f"{TRAPPING} {SOME}", marks=pytest.mark.exhaustive)]
)
def test_unit_tests_in_c_of_three_dimensions(tmp_path: Path, compiler: list[str], flags: str) -> None:
    """Every file compiles without a warning, too."""
    made = export_c(random_guidance_in_space(), tmp_path / "exported")
    pass_unit_tests(made.folder, tmp_path / "built", compiler, flags)


def pass_unit_tests(exported: Path, built: Path, compiler: list[str], flags: str) -> None:
    run = subprocess.run(
        [
            "make",
            "-s",
            "test",
            f"EXPORTED={exported}",
            f"BUILD={built}",
            f"CC={shlex.join(compiler)}",
            f"CFLAGS={flags}",
        ],
        cwd=C_RUNTIME,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert run.stdout.count("all passed") == len(BUILDS)


@every_compiler
@every_build
def test_flight_file_compiles_without_a_warning(
    exported: Exported, tmp_path: Path, compiler: list[str], build: Build
) -> None:
    """At -O3; at -O2 that which needs nothing."""
    for file in (build.source, "sailnet_batch.c"):
        command = [
            *compiler,
            "-std=c99",
            "-O3",
            *build.defines,
            *WARNINGS,
            "-c",
            file,
            "-o",
            str(tmp_path / "out.o"),
        ]
        subprocess.run(command, cwd=exported.folder, check=True)


@needs("analyser", missing("g++"), "g++")
@every_build
def test_flight_file_is_cplusplus_too(exported: Exported, tmp_path: Path, build: Build) -> None:
    command = ["g++", "-x", "c++", "-std=c++11", *build.defines, *WARNINGS, "-c", build.source]
    subprocess.run([*command, "-o", str(tmp_path / "out.o")], cwd=exported.folder, check=True)


@every_compiler
def test_fast_math_is_refused(exported: Exported, compiler: list[str]) -> None:
    command = [*compiler, "-std=c99", "-ffast-math", "-fsyntax-only", "sailnet_guidance.c"]
    run = subprocess.run(command, cwd=exported.folder, capture_output=True, text=True, check=False)
    assert run.returncode != 0
    assert "guards against NaN" in run.stderr


@every_compiler
@every_build
def test_flight_file_needs_nothing_and_writes_nothing_static(
    exported: Exported, tmp_path: Path, compiler: list[str], build: Build
) -> None:
    object_file = tmp_path / "guidance.o"
    command = [*compiler, "-std=c99", "-O2", *build.defines, *WARNINGS, "-c", build.source]
    subprocess.run([*command, "-o", str(object_file)], cwd=exported.folder, check=True)
    symbols = subprocess.run(["nm", object_file], capture_output=True, text=True, check=True).stdout
    kinds = {line.split()[-1]: line.split()[-2] for line in symbols.splitlines()}
    # Compilers may call these four on their own account, and a freestanding platform provides them.
    undefined = {name for name, kind in kinds.items() if kind == "U"}
    assert undefined <= {"memcpy", "memset", "memmove", "memcmp", "_GLOBAL_OFFSET_TABLE_"}
    assert not {name for name, kind in kinds.items() if kind in "dDbBC"}
    assert {name for name, kind in kinds.items() if kind == "T"} == {
        f"sailnet_{name}_{build.suffix}" for name in ("guidance", "measured", *STEERING)
    }


@every_build
def test_every_symbol_of_a_library_ends_in_its_precision(exported: Exported, build: Build) -> None:
    command = ["nm", "--dynamic", "--defined-only", str(exported.folder / build.library)]
    table = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    symbols = {line.split()[-1] for line in table.splitlines() if "sailnet" in line}
    assert symbols >= {f"sailnet_steer_batch_{build.suffix}", f"sailnet_networks_digest_{build.suffix}"}
    assert [name for name in symbols if not name.endswith(f"_{build.suffix}")] == []


LAW = """
#include "sailnet_guidance.h"
#include <stdio.h>
int main(void)
{
    for (int i = 0; i < 1000; i++) {
        const sailnet_real r = (sailnet_real)(0.8 + 0.001 * i);
        const sailnet_state state = {r, (sailnet_real)(0.0003 * i), (sailnet_real)0.9};
        sailnet_command command;
        const int status = (int)sailnet_guidance(&state, SAILNET_BETA, &command);
        printf("%d %a %a %a\\n", status, (double)command.cone_angle, (double)command.time_of_flight,
               (double)command.lambda_v);
    }
    return 0;
}
"""


@every_compiler
@pytest.mark.parametrize(
    "build", [build for build in BUILDS.values() if build.layout == "flight"], ids=lambda build: build.name
)
def test_the_law_alone_is_the_same_law(
    exported: Exported, tmp_path: Path, compiler: list[str], build: Build
) -> None:
    (tmp_path / "law.c").write_text(LAW)
    told = []
    # Clang counts a small function that only steering calls.
    for less in ([], ["-DSAILNET_LAW_ONLY", "-Wno-unused-function"]):
        flags = [
            "-std=c99",
            "-O2",
            "-ffp-contract=off",
            *build.defines,
            *WARNINGS,
            *less,
            f"-I{exported.folder}",
        ]
        object_file, program = tmp_path / "guidance.o", tmp_path / "law"
        command = [*compiler, *flags, "-c", str(exported.folder / build.source), "-o", str(object_file)]
        subprocess.run(command, check=True)
        symbols = subprocess.run(["nm", object_file], capture_output=True, text=True, check=True).stdout
        assert ("_steer_" in symbols) == (not less)
        assert not less or "sailnet_extremal" not in symbols
        command = [*compiler, *flags, str(tmp_path / "law.c"), str(object_file), "-o", str(program)]
        subprocess.run(command, check=True)
        told.append(subprocess.run([program], capture_output=True, text=True, check=True).stdout)
    assert told[0] == told[1]
    assert len(set(told[0].splitlines())) > 100


CALLER = """
#include "sailnet_batch.h"
int main(void)
{
    sailnet_memory memory;
    sailnet_command command;
    const sailnet_state state = {1, 0, 1};
    sailnet_start(&memory);
    sailnet_start_batch(1, &memory);
    (void)sailnet_guidance(&state, 0, &command);
    return (int)sailnet_steer(&memory, &state, (sailnet_real)0.005, &command);
}
"""
USED = ("start", "start_batch", "steer", "guidance")


@every_build
@pytest.mark.parametrize("caller", ["f32", "f64"])
def test_precisions_do_not_link(exported: Exported, tmp_path: Path, build: Build, caller: str) -> None:
    (tmp_path / "caller.c").write_text(CALLER)
    common = [*find_compiler(), "-std=c99", f"-I{exported.folder}"]
    for defines, source in (
        (BUILDS[caller].defines, tmp_path / "caller.c"),
        (build.defines, exported.folder / build.source),
        (build.defines, exported.folder / "sailnet_batch.c"),
    ):
        command = [*common, *defines, "-c", str(source), "-o", str(tmp_path / f"{source.stem}.o")]
        subprocess.run(command, check=True)
    objects = [str(file) for file in sorted(tmp_path.glob("*.o"))]
    command = [*find_compiler(), *objects, "-o", str(tmp_path / "program")]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (run.returncode == 0) == (caller == build.suffix)
    for name in USED:
        assert (f"sailnet_{name}_{caller}" in run.stderr) == (caller != build.suffix), run.stderr


def test_the_flight_file_is_what_a_reviewer_reads_in_a_morning() -> None:
    """In the plane; most of the bytes are weights and known plans, half of the lines the tracker."""
    file = ROOT / "sailnet" / "shipped" / "earth_mars" / "sailnet_guidance.c"
    assert file.stat().st_size <= 265_000
    assert "immintrin" not in file.read_text()
    logic = file.read_text().split("= 3. Clamps =")[1].split("*/", 1)[1]
    code = re.sub(r"/\*.*?\*/", "", logic, flags=re.DOTALL)
    assert len([line for line in code.splitlines() if line.strip()]) <= 1930

import shlex
import subprocess
from pathlib import Path

import pytest

from c_runtime.shared_library import BUILDS
from tests.conftest import Exported
from tests.tools import every_compiler, missing, needs

C_RUNTIME = Path(__file__).parent.parent / "c_runtime"
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
FAST = "-O3 -march=native -fno-trapping-math -fno-tree-vectorize -ffp-contract=fast"
# Undefined behaviour ends the program; needs no library of the sanitizer.
TRAPPING = "-O1 -fsanitize=undefined -fsanitize-undefined-trap-on-error"
every_build = pytest.mark.parametrize("defines", BUILDS.values(), ids=BUILDS)


@every_compiler
@pytest.mark.parametrize("flags", ["-O2", FAST, TRAPPING])
def test_unit_tests_in_c(exported: Exported, tmp_path: Path, compiler: list[str], flags: str) -> None:
    run = subprocess.run(
        [
            "make",
            "-s",
            "test",
            f"EXPORTED={exported.folder}",
            f"BUILD={tmp_path}",
            f"CC={shlex.join(compiler)}",
            f"CFLAGS={flags}",
        ],
        cwd=C_RUNTIME,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert run.stdout.count("all passed") == 4


@every_compiler
@every_build
@pytest.mark.parametrize("level", ["-O2", "-O3"])
def test_flight_file_compiles_without_a_warning(
    exported: Exported, tmp_path: Path, compiler: list[str], defines: tuple[str, ...], level: str
) -> None:
    for file in ("sailnet_guidance.c", "sailnet_batch.c"):
        command = [
            *compiler,
            "-std=c99",
            level,
            *defines,
            *WARNINGS,
            "-c",
            file,
            "-o",
            str(tmp_path / "out.o"),
        ]
        subprocess.run(command, cwd=exported.folder, check=True)


@needs("analyser", missing("g++"), "g++")
@every_build
def test_flight_file_is_cplusplus_too(exported: Exported, tmp_path: Path, defines: tuple[str, ...]) -> None:
    command = ["g++", "-x", "c++", "-std=c++11", *defines, *WARNINGS, "-c", "sailnet_guidance.c"]
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
    exported: Exported, tmp_path: Path, compiler: list[str], defines: tuple[str, ...]
) -> None:
    object_file = tmp_path / "guidance.o"
    command = [*compiler, "-std=c99", "-O2", *defines, "-c", "sailnet_guidance.c", "-o", str(object_file)]
    subprocess.run(command, cwd=exported.folder, check=True)
    symbols = subprocess.run(["nm", object_file], capture_output=True, text=True, check=True).stdout
    kinds = {line.split()[-1]: line.split()[-2] for line in symbols.splitlines()}
    # Compilers may call these four on their own account, and a freestanding platform provides them.
    undefined = {name for name, kind in kinds.items() if kind == "U"}
    assert undefined <= {"memcpy", "memset", "memmove", "memcmp", "_GLOBAL_OFFSET_TABLE_"}
    assert not {name for name, kind in kinds.items() if kind in "dDbBC"}
    assert {name for name, kind in kinds.items() if kind == "T"} == {
        "sailnet_guidance",
        "sailnet_start",
        "sailnet_steer",
    }

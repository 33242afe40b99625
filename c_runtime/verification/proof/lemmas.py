"""The contracts that the proof assumes, checked by running the functions."""

import shlex
import subprocess
import tempfile
from pathlib import Path

from c_runtime.builds import Build
from c_runtime.shared_library import FLAGS, find_compiler
from c_runtime.verification.proof.eva import ProofError

SOURCE = Path(__file__).parent / "lemmas.c"


def check_lemmas(exported: Path, build: Build) -> str:
    """Compile and run ``lemmas.c``; returns its last line.

    Raises:
        CompilerError: there is no compiler.
        ProofError: a function left its bounds, or did not compile.
    """
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "lemmas"
        command = [
            *find_compiler(),
            *FLAGS,
            *build.optimisation,
            *build.analysed,
            f"-I{exported}",
            "-o",
            str(program),
            str(SOURCE),
        ]
        for step in (command, [str(program)]):
            run = subprocess.run(step, capture_output=True, text=True, check=False)
            if run.returncode:
                raise ProofError(f"{shlex.join(step)}\n{run.stdout}{run.stderr}".strip())
    return run.stdout.splitlines()[-1]

"""``python -m c_runtime.verification.proof EXPORTED``: prove an exported guidance with Frama-C's Eva."""

import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tqdm import tqdm

from c_runtime.builds import BUILDS
from c_runtime.shared_library import TRACKER, CompilerError
from c_runtime.verification.proof.eva import FRAMA_C, ProofError, analyse, analyse_tracker
from c_runtime.verification.proof.lemmas import check_lemmas
from c_runtime.verification.proof.mutants import MUTANTS, caught, mutate

MISSING = "proof: left out, there is no frama-c (Debian: apt install frama-c-base)"


def main(arguments: list[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m c_runtime.verification.proof",
        description="Prove that an exported guidance commands bounded and finite numbers, always.",
        epilog="example: python -m c_runtime.verification.proof sailnet/shipped/earth_mars --mutants",
    )
    parser.add_argument("exported", type=Path, help="folder written by python -m export")
    parser.add_argument("--mutants", action="store_true", help="also break the file, and see the proof fail")
    parser.add_argument("--require", action="store_true", help="fail if frama-c is missing")
    options = parser.parse_args(arguments)
    if shutil.which(FRAMA_C) is None:
        print(MISSING)
        return int(options.require)
    try:
        failed = _prove(options.exported)
        if options.mutants:
            failed += _survivors(options.exported)
    except (ProofError, CompilerError, OSError, subprocess.SubprocessError) as error:
        print(f"proof: {error}", file=sys.stderr)
        return 1
    print("proof: FAILED" if failed else "proof: holds")
    return int(failed > 0)


def _prove(exported: Path) -> int:
    failed = 0
    for build in BUILDS.values():
        print(f"lemmas {build.name}: {check_lemmas(exported, build)}")
    for build in tqdm(BUILDS.values(), desc="proof", disable=None):
        problems = analyse(exported, build)
        print(f"{build.name}: {'proved' if not problems else 'NOT PROVED'}", *problems, sep="\n  ")
        failed += bool(problems)
    for geometry in ("plane", "space"):
        problems = analyse_tracker(TRACKER, geometry == "space")
        print(f"tracker, {geometry}: {'proved' if not problems else 'NOT PROVED'}", *problems, sep="\n  ")
        failed += bool(problems)
    return failed


def _survivors(exported: Path) -> int:
    survivors = 0
    for mutant in tqdm(MUTANTS, desc="mutants", disable=None):
        for build in BUILDS.values():
            if not mutant.concerns(build):
                continue
            with tempfile.TemporaryDirectory() as name:
                folder = Path(name)
                if not mutate(exported, mutant, folder):
                    print(f"mutant {mutant.name}: not in networks of this form")
                    break
                survived = not caught(folder, build)
                print(f"mutant {mutant.name}, {build.name}: {'SURVIVED' if survived else 'caught'}")
                survivors += survived
    return survivors


if __name__ == "__main__":
    sys.exit(main())

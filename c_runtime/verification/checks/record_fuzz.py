"""The long run of the fuzzers, one build a processor at a time, into a text with machine and date."""

import argparse
import hashlib
import os
import platform
import re
import shlex
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

_EXECUTED = re.compile(r"stat::number_of_executed_units:\s+(\d+)")
_EDGES = re.compile(r"\bcov: (\d+)")


@dataclass(frozen=True)
class Run:
    """What the fuzzer of one build did."""

    build: str
    executions: int
    seconds: float
    edges: int
    finding: str

    def row(self) -> str:
        """As a row of the table."""
        return f"| {self.build} | {self.executions:,} | {self.edges} | {self.seconds:.0f} | {self.finding} |"


def fuzz(build: str, fuzzer: Path, options: list[str]) -> Run:
    """Run one fuzzer to its end, or to its first finding."""
    start = time.monotonic()
    command = [str(fuzzer), *options, "-print_final_stats=1", f"-artifact_prefix={fuzzer}-"]
    run = subprocess.run(command, capture_output=True, text=True, check=False, errors="replace")
    executed, edges = _EXECUTED.search(run.stderr), _EDGES.findall(run.stderr)
    finding = "none"
    if run.returncode != 0 or executed is None:
        print(run.stderr, file=sys.stderr)
        broken = re.search(r"promise broken: (.*)|SUMMARY: (.*)", run.stderr)
        finding = broken[0] if broken else f"ended with {run.returncode}"
    return Run(
        build,
        int(executed[1]) if executed else 0,
        time.monotonic() - start,
        int(edges[-1]) if edges else 0,
        finding,
    )


def report(exported: Path, options: str, runs: list[Run]) -> str:
    """The text: what was fuzzed, where and when, and what came of it."""
    source = hashlib.sha256((exported / "sailnet_guidance.c").read_bytes()).hexdigest()
    mission = re.search(r'SAILNET_MISSION "(.*)"', (exported / "sailnet_guidance.h").read_text())
    compiler = subprocess.run(["clang", "--version"], capture_output=True, text=True, check=True).stdout
    lines = [
        "# The long run of the fuzzers",
        "",
        "Written by `make record-fuzz`: libFuzzer with the address and undefined-behaviour sanitizers on",
        "`fuzz_guidance.c`, each execution a sequence of up to six calls. Any finding fails it.",
        "",
        f"Executions in all: {sum(run.executions for run in runs):,}.",
        "",
        f"Mission {mission[1] if mission else 'unknown'}, sailnet_guidance.c {source[:16]};",
        f"{datetime.now(UTC):%Y-%m-%d}; {compiler.splitlines()[0]}; {_processor()};",
        f"options `{options}`.",
        "",
        "| build | executions | edges covered | seconds | findings |",
        "|---|---|---|---|---|",
        *(run.row() for run in runs),
    ]
    return "\n".join(lines) + "\n"


def _processor() -> str:
    """The name of the processor, as far as the system tells."""
    cpuinfo = Path("/proc/cpuinfo")
    names = re.findall(r"model name\s*: (.*)", cpuinfo.read_text()) if cpuinfo.exists() else []
    return str(names[0]) if names else platform.machine()


def main(arguments: list[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m c_runtime.verification.checks.record_fuzz", description=__doc__
    )
    parser.add_argument("exported", type=Path, help="folder written by python -m export")
    parser.add_argument("fuzzers", nargs="+", help="BUILD=PROGRAM of each build")
    parser.add_argument("--options", default="-runs=10000000", help="of libFuzzer (default: %(default)s)")
    parser.add_argument("--output", type=Path, required=True, help="the text to write")
    given = parser.parse_args(arguments)
    builds = [fuzzer.split("=", 1) for fuzzer in given.fuzzers]
    options = shlex.split(given.options)
    runs = []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for run in pool.map(lambda one: fuzz(one[0], Path(one[1]), options), builds):
            print(run.row(), flush=True)
            runs.append(run)
    given.output.write_text(report(given.exported, given.options, runs))
    return int(any(run.finding != "none" for run in runs))


if __name__ == "__main__":
    sys.exit(main())

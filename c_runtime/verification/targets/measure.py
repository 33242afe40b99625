"""Everything about one build on one target: agreement, sizes and counts; and what about it is wrong."""

import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path
from typing import get_args

import numpy as np

from c_runtime.builds import Build
from c_runtime.verification.targets.build import (
    HERE,
    Program,
    TargetError,
    build,
    flight_flags,
    golden_main,
    write_golden,
)
from c_runtime.verification.targets.elf import HELPERS_STACK
from c_runtime.verification.targets.golden import (
    COMMAND_BOUNDS,
    STEERING_BOUNDS,
    Golden,
    golden_commands,
    golden_flights,
    golden_steering,
)
from c_runtime.verification.targets.machines import HOST, Target
from c_runtime.verification.targets.reference import ReferenceGuidance
from c_runtime.verification.targets.run import Calls, Run, run
from sailnet.guidance.interface import Precision
from sailnet.physics.arrays import Array

PLUGIN_FLAGS = ("-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared")


def missing_tools(target: Target) -> list[str]:
    """Programs that a target needs and that are not installed."""
    needed = [target.compiler, *target.emulator[:1], HOST.compiler, "readelf"]
    return [program for program in needed if shutil.which(program) is None]


def left_out_of(targets: Sequence[Target]) -> dict[str, list[str]]:
    """Tools that are missing, by the targets that are left out for it; each is told with its packages."""
    missing = {target.name: missing_tools(target) for target in targets}
    for target in targets:
        if tools := missing[target.name]:
            install = f"apt-get install {' '.join(target.packages)}"
            print(f"targets: {target.name} left out, {', '.join(tools)} not found: {install}")
    return {name: tools for name, tools in missing.items() if tools}


def compile_plugin(folder: Path) -> Path:
    """The counter of instructions, for the host.

    Raises:
        TargetError: the compiler refused.
    """
    plugin = folder / "count_instructions.so"
    command = [HOST.compiler, *PLUGIN_FLAGS, "-o", str(plugin), str(HERE / "count_instructions.c")]
    compiled = subprocess.run(command, capture_output=True, text=True, check=False)
    if compiled.returncode:
        raise TargetError(f"the plugin does not compile:\n{compiled.stderr}")
    return plugin


@dataclass(frozen=True)
class Measured:
    """One build of one target, run.

    Attributes:
        target, precision, layout, contract: which; ``contract`` if products and sums may be fused.
        program: what was compiled.
        run: what it printed.
        errors: (2, 4) of guidance and steering, the largest |difference| / (1 + |reference|) of cone angle
            [rad], time of flight [TU], beta and hold [TU].
        other_bits: numbers, of all outputs, whose bits are not the host's.
        wrong: what should not be; empty if the target does as it should.
    """

    target: Target
    precision: Precision
    layout: str
    contract: bool
    program: Program
    run: Run
    errors: Array
    other_bits: int
    wrong: tuple[str, ...]

    def to_json(self) -> dict[str, object]:
        """As it is stored."""
        sizes, counts = self.program.sizes, (self.run.guidance.counts, self.run.steering.counts)
        names = ("guidance", "steering")
        return {
            "target": self.target.name,
            "precision": self.precision,
            "layout": self.layout,
            "compiler": f"{self.target.compiler} {compiler_version(self.target)}",
            "flags": " ".join(self.program.flags),
            "fused": self.contract,
            "instructions": {
                name: {"mean": round(count.mean, 1), "most": count.most}
                for name, count in zip(names, counts, strict=True)
                if count is not None
            },
            "bytes": {
                "code": sizes.code,
                "law": self.program.law,
                "constants": sizes.constants,
                "static": sizes.static,
            },
            "stack": {
                name: {"written": calls.stack, "reserved": reserved}
                for name, calls, reserved in zip(
                    names, (self.run.guidance, self.run.steering), self.program.stack, strict=True
                )
            },
            "functions": sizes.functions,
            "helpers": sizes.helpers,
            "largest_error": dict(zip(names, self.errors.tolist(), strict=True)),
            "outputs_sha256": self.run.digest(),
            "exceeded": self.run.exceeded,
            "bits_unlike_host": self.other_bits,
            "cycles_per_instruction_assumed": self.target.precisions[self.precision],
            "wrong": self.wrong,
        }


def compiler_version(target: Target) -> str:
    """Like 12.2.1."""
    command = [target.compiler, "-dumpfullversion"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


class Bench:
    """Golden vectors, the host's results and a place for programs.

    Args:
        guidance: the reference.
        exported: folder with the flight file of the same networks.
        folder: for what is built.

    Raises:
        TargetError: the flight file is of other networks.
    """

    def __init__(self, guidance: ReferenceGuidance, exported: Path, folder: Path) -> None:
        header = (exported / "sailnet_guidance.h").read_text(encoding="utf-8")
        if f'SAILNET_NETWORKS_DIGEST "{guidance.networks_digest}"' not in header:
            raise TargetError(f"{exported} was not exported from the networks given: export them again")
        self._exported, self._folder = exported, folder
        folder.mkdir(parents=True, exist_ok=True)
        self._plugin = compile_plugin(folder)
        flights = golden_flights(guidance)
        self._golden: dict[Precision, tuple[Golden, Golden]] = {}
        for precision in get_args(Precision):
            golden = (
                golden_commands(guidance, flights, precision),
                golden_steering(guidance, flights, precision),
            )
            self._golden[precision] = golden
            header_file = self._header(precision)
            header_file.parent.mkdir(exist_ok=True)
            write_golden(header_file, precision, *golden)
        self._host: dict[tuple[Precision, str], Run] = {}

    def _header(self, precision: Precision) -> Path:
        return self._folder / precision / "golden.h"

    def measure(self, target: Target, precision: Precision, layout: str, contract: bool) -> Measured:
        """Build and run.

        Raises:
            TargetError: it cannot be compiled, or does not run to its end.
        """
        host = self._host.get((precision, layout))
        if host is None:
            host = self._host[precision, layout] = self._run(HOST, precision, layout, False)[1]
        program, ran = self._run(target, precision, layout, contract)
        golden = self._golden[precision]
        errors = np.array(
            [_errors(calls, g) for calls, g in zip((ran.guidance, ran.steering), golden, strict=True)]
        )
        other_bits = sum(
            int((own.bits != hosts.bits).sum())
            for own, hosts in ((ran.guidance, host.guidance), (ran.steering, host.steering))
        )
        wrong = [f"{ran.exceeded} calls differ from the reference by more than the bound"] * (
            ran.exceeded > 0
        )
        wrong += _disagreement("guidance", ran.guidance, golden[0], errors[0], COMMAND_BOUNDS[precision])
        wrong += _disagreement("steering", ran.steering, golden[1], errors[1], STEERING_BOUNDS[precision])
        wrong += [f"{other_bits} numbers are not the host's, bit for bit"] * (other_bits > 0 and not contract)
        wrong += [f"{program.sizes.static} bytes of static memory are written"] * (program.sizes.static > 0)
        allowed = (*HELPERS_STACK, *target.arithmetic)
        strange = [name for name in program.sizes.helpers if not any(fnmatch(name, each) for each in allowed)]
        wrong += [f"functions that are elsewhere are called: {', '.join(strange)}"] * bool(strange)
        return Measured(target, precision, layout, contract, program, ran, errors, other_bits, tuple(wrong))

    def _run(self, target: Target, precision: Precision, layout: str, contract: bool) -> tuple[Program, Run]:
        chosen = Build(precision, layout)
        flags = flight_flags(target, chosen, contract)
        folder = self._folder / precision / f"{target.name}-{layout}-{'fused' if contract else 'exact'}"
        program = build(target, self._exported, chosen, golden_main(self._header(precision)), flags, folder)
        plugin = self._plugin if target.emulator else None
        return program, run(target, program.path, precision, plugin)


def _errors(calls: Calls, golden: Golden) -> Array:
    if calls.outputs.shape != golden.expected.shape:
        raise TargetError(f"{len(calls.outputs)} results for {len(golden.expected)} golden vectors")
    worst: Array = (np.abs(calls.outputs - golden.expected) / (1.0 + np.abs(golden.expected))).max(axis=0)
    return worst


def _disagreement(
    which: str, calls: Calls, golden: Golden, errors: Array, bounds: tuple[float, ...]
) -> list[str]:
    """What the numbers a target printed say, whatever it found itself."""
    wrong = []
    statuses = int((calls.status != golden.status).sum())
    if statuses:
        wrong.append(f"{statuses} status codes of {which} are not the reference's")
    # Comparing in float on the target rounds both sides; a thousandth is more than that.
    if not (errors <= 1.001 * np.array(bounds) + np.finfo(np.float32).tiny).all():
        wrong.append(f"{which} is off by {errors.tolist()}, more than {list(bounds)}")
    counts = calls.counts
    if counts is not None and counts.retired is not None and counts.retired != counts.total:
        wrong.append(
            f"{which}: {counts.total} instructions counted, {counts.retired} by the processor itself"
        )
    return wrong

"""``python -m c_runtime.bench``: the time of one command, on this machine, in one run.

The exported C in both precisions, beside onnxruntime (one thread), PyTorch eager and NumPy.
"""

import argparse
import json
import platform
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

import numpy as np
import onnxruntime

from c_runtime.shared_library import PRECISIONS, CompilerError, find_compiler

HERE = Path(__file__).parent
FLAGS = "-O3 -march=native -fno-trapping-math -ffp-contract=fast"
STATE = (1.05, 0.15, 1.03)
BETA = 0.17

Row = dict[str, str | float]


def main(arguments: list[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(prog="python -m c_runtime.bench", description=__doc__)
    parser.add_argument("exported", type=Path, help="folder written by python -m export")
    parser.add_argument(
        "--networks", type=Path, help="folder of the weights; adds PyTorch and NumPy to the table"
    )
    parser.add_argument("--flags", default=FLAGS, help="of the C compiler (default: %(default)s)")
    parser.add_argument("--json", action="store_true", help="print one JSON object instead of a table")
    options = parser.parse_args(arguments)
    try:
        compiler = find_compiler()
        rows = [
            row
            for precision in PRECISIONS
            for row in _time_c(compiler, options.flags, options.exported, precision)
        ]
    except (CompilerError, subprocess.CalledProcessError) as error:
        print(f"bench: {error}", file=sys.stderr)
        return 1
    rows += [_time_onnxruntime(options.exported, precision) for precision in PRECISIONS]
    if options.networks:
        rows += _time_python(options.networks)
    report = {"machine": _machine(), "date": datetime.now(UTC).isoformat(timespec="seconds")}
    report |= {"compiler": _version(compiler), "flags": options.flags}
    if options.json:
        print(json.dumps({**report, "unit": "ns per command", "rows": rows}))
    else:
        print("\n".join(f"{key}: {value}" for key, value in report.items()))
        print(f"{'one command':<28}{'precision':>10}{'min [ns]':>12}{'median [ns]':>14}")
        for row in rows:
            print(f"{row['what']:<28}{row['precision']:>10}{row['min_ns']:>12.0f}{row['median_ns']:>14.0f}")
    return 0


def _time_c(compiler: list[str], flags: str, exported: Path, precision: str) -> list[Row]:
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "bench"
        sources = [str(HERE / "bench_command.c"), str(exported / "sailnet_guidance.c")]
        command = [*compiler, "-std=c99", *shlex.split(flags), *PRECISIONS[precision], f"-I{exported}"]
        subprocess.run([*command, *sources, "-o", str(program)], check=True)
        measured = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    return [
        {
            "what": "exported C" if name == "command" else f"exported C, {name}",
            "precision": f"float{precision[1:]}",
        }
        | times
        for name, times in json.loads(measured).items()
    ]


def _time_onnxruntime(exported: Path, precision: str) -> Row:
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    session = onnxruntime.InferenceSession(
        exported / f"guidance_{precision}.onnx", options, providers=["CPUExecutionProvider"]
    )
    kind = f"float{precision[1:]}"
    given = {"state": np.array([STATE], kind), "beta": np.array([BETA], kind)}
    inputs = {entry.name: given[entry.name] for entry in session.get_inputs()}
    return _time("onnxruntime, merged graph", kind, lambda: session.run(None, inputs))


def _time_python(folder: Path) -> list[Row]:
    import torch

    from export.torch_networks import torch_guidance
    from sailnet.guidance_facts import describe
    from sailnet.networks import load_guidance_networks

    networks = load_guidance_networks(folder)
    state = np.array([STATE])
    rows = [_time("NumPy", "float64", lambda: networks.command(state))]
    guidance = torch_guidance(networks, describe(networks, networks.mission))
    torch.set_num_threads(1)
    for module, precision in ((guidance.in_float32(), "float32"), (guidance, "float64")):
        given = (np.array([STATE]), np.array([BETA]))[: 2 if networks.approach else 1]
        call = partial(module, *(torch.tensor(value, dtype=getattr(torch, precision)) for value in given))
        with torch.inference_mode():
            rows.append(_time("PyTorch eager", precision, call))
    return rows


def _time(
    what: str, precision: str, command: Callable[[], object], batches: int = 25, calls: int = 400
) -> Row:
    nanoseconds = []
    for _ in range(batches):
        start = time.perf_counter_ns()
        for _ in range(calls):
            command()
        nanoseconds.append((time.perf_counter_ns() - start) / calls)
    return {
        "what": what,
        "precision": precision,
        "min_ns": min(nanoseconds),
        "median_ns": float(np.median(nanoseconds)),
    }


def _machine() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        name = next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        name = platform.processor()
    return f"{name} ({platform.machine()}, {platform.system()})"


def _version(compiler: list[str]) -> str:
    run = subprocess.run([*compiler, "--version"], capture_output=True, text=True, check=False)
    return run.stdout.splitlines()[0] if run.stdout else compiler[0]


if __name__ == "__main__":
    sys.exit(main())

"""emlearn: the same networks as the C that it generates.

Less than a command: approach coordinates are given, not computed, the domain is not guarded, and a NaN
goes through. Single precision; it writes weights with six decimals. Its other style, `inline`, which lets the
compiler know the sizes of layers, is for classifiers, and 0.23.2 fails to generate it for sigmoids.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from c_runtime.verification.bench.compiled import Library, Shape, Unit
from c_runtime.verification.bench.rounds import Candidate
from c_runtime.verification.bench.subjects import Subjects, agree
from sailnet.errors import GuidanceError
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks
from sailnet.networks.network import Network

FLAGS = ("-O3", "-march=native")
BUILDS = {"": FLAGS, ", -ffast-math": (*FLAGS, "-ffast-math")}
ABSENT = (
    "left out: emlearn, which is not installed or does not load: "
    "pip install -c constraints.txt -e '.[benchmarks]'"
)
EMLEARN = "emlearn"


def emlearn_c(
    build: str, compiler: Sequence[str], networks: AnyGuidanceNetworks, subjects: Subjects, folder: Path
) -> list[Candidate]:
    """Its row.

    Args:
        build: one of ``BUILDS``; -ffast-math may make a NaN of a number that is large.
        compiler: command of the C compiler.
        networks: whose weights it gets.
        subjects: what is asked.
        folder: for generated and compiled files.

    Raises:
        GuidanceError: emlearn is not installed, or does not compute these networks.
        CompilerError: the compiler refused.
    """
    try:
        # It tells numpy to raise, even for numbers too small to matter, from its import on.
        with np.errstate():
            from emlearn import includedir
    except ImportError as error:
        raise GuidanceError(ABSENT) from error
    inputs = subjects.network_inputs(networks)
    source = folder / "networks.c"
    folder.mkdir(parents=True)
    source.write_text(_source(networks))
    # Its headers are not clean in C99, where they define functions that other files may too.
    unit = Unit(source, (*BUILDS[build], f"-I{includedir}", "-w"))
    shape = Shape("float32", inputs.shape[1], len(networks.all), len(networks.all))
    library = Library(compiler, [unit], shape, folder / "built")
    if not agree(library.evaluate(inputs), subjects.network_outputs(networks)):
        raise GuidanceError(f"left out: {EMLEARN}{build}: it does not compute the same networks")
    library.time_over(inputs)
    return [Candidate(f"{EMLEARN}{build}", "float32", library.in_a_chain, library.back_to_back)]


def _source(networks: AnyGuidanceNetworks) -> str:
    count = len(networks.tau.inputs)
    body = [f"float given[{count + 1}];", f"memcpy(given, input, {count} * sizeof given[0]);"]
    for i, network in enumerate(networks.all):
        body += _evaluated(network, i, count)
        # In the paper's form the others read the time of flight.
        body.append(f"given[{count}] = output[0];" if i == 0 else "")
    opening = "void candidate(const candidate_real *input, candidate_real *output) {"
    includes = ['#include "candidate.h"', "#include <string.h>"]
    return "\n".join([*includes, *(_generated(network) for network in networks.all), opening, *body, "}\n"])


def _evaluated(network: Network, i: int, count: int) -> list[str]:
    """Output ``i`` of the candidate: of several, each times its factor, which come behind the inputs."""
    read, outputs = len(network.inputs), len(network.factors)
    if not outputs:
        return [f"output[{i}] = {network.name}_regress1(given, {read});"]
    products = " + ".join(f"odd[{j}] * input[{count + j}]" for j in range(outputs))
    regress = f"{network.name}_regress(given, {read}, odd, {outputs});"
    return [f"float odd[{outputs}];", regress, f"output[{i}] = {products};"]


def _generated(network: Network) -> str:
    with np.errstate():
        from emlearn.net import c_generate_net_loadable

    activations = ["logistic"] * len(network.hidden) + ["identity"]
    weights, biases = _physical(network)
    transposed = [weight.T for weight in weights]
    return str(c_generate_net_loadable(activations, transposed, biases, prefix=network.name))


def _physical(network: Network) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Weights and biases with both scalings absorbed: emlearn has none."""
    weights, biases = list(network.weights), list(network.biases)
    weights[0] = weights[0] / (network.input_max - network.input_min)
    biases[0] = biases[0] - weights[0] @ network.input_min
    span = network.output_max - network.output_min
    weights[-1], biases[-1] = span * weights[-1], span * biases[-1] + network.output_min
    return weights, biases

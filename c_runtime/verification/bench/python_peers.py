"""The same commands from Python: onnxruntime, PyTorch eager and NumPy, one thread each."""

from functools import partial
from pathlib import Path

import onnxruntime

from c_runtime.verification.bench.rounds import Candidate, in_python
from c_runtime.verification.bench.subjects import Subjects
from sailnet.guidance.exported_files import SUFFIXES, graph_name
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks

ONNXRUNTIME = "onnxruntime, Python"


def onnxruntime_python(exported: Path, subjects: Subjects) -> list[Candidate]:
    """The merged graph, in both precisions."""
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    found = []
    for precision in SUFFIXES:
        session = onnxruntime.InferenceSession(
            exported / graph_name(precision), options, providers=["CPUExecutionProvider"]
        )
        names = [entry.name for entry in session.get_inputs()]
        calls = []
        for row in subjects.inputs.astype(precision):
            given = {"state": row[None, :-1], "beta": row[-1:]}
            calls.append(partial(session.run, None, {name: given[name] for name in names}))
        found.append(Candidate(ONNXRUNTIME, precision, in_python(calls)))
    return found


def numpy_reference(networks: AnyGuidanceNetworks, subjects: Subjects) -> Candidate:
    """The reference that everything is tested against."""
    calls = [partial(networks.command, row[None, :-1], float(row[-1])) for row in subjects.inputs]
    return Candidate("NumPy", "float64", in_python(calls))


def pytorch(networks: AnyGuidanceNetworks, subjects: Subjects) -> list[Candidate]:
    """The module that the graphs are traced from, in both precisions.

    Raises:
        ImportError: PyTorch is not installed.
    """
    import torch

    from export.torch_guidance import torch_guidance
    from sailnet.guidance.facts import describe

    torch.set_num_threads(1)
    guidance = torch_guidance(networks, describe(networks, networks.mission))
    found = []
    for module, precision in ((guidance.in_float32(), "float32"), (guidance, "float64")):
        calls = []
        for row in torch.tensor(subjects.inputs, dtype=getattr(torch, precision)):
            given = (row[None, :-1], row[-1:])[: 2 if networks.approach else 1]
            calls.append(partial(module, *given))
        found.append(Candidate("PyTorch eager", precision, torch.inference_mode()(in_python(calls))))
    return found

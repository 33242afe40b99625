"""onnxruntime's C interface, in the library that its wheel ships."""

import ctypes
from collections.abc import Sequence
from pathlib import Path

import onnxruntime

from c_runtime.verification.bench.compiled import HERE, Library, Reals, Shape, Unit
from c_runtime.verification.bench.exported_c import TOLD
from c_runtime.verification.bench.rounds import Candidate
from c_runtime.verification.bench.subjects import Subjects, agree, seamless
from sailnet.errors import GuidanceError
from sailnet.guidance.exported_files import SUFFIXES, graph_name

ONNXRUNTIME_C = "onnxruntime, C API"


def find_library() -> Path:
    """The shared library in the installed wheel.

    Raises:
        GuidanceError: this wheel has none.
    """
    folder = Path(onnxruntime.__file__).parent / "capi"
    for pattern in ("libonnxruntime.so*", "libonnxruntime*.dylib"):
        for path in sorted(folder.glob(pattern)):
            return path
    raise GuidanceError(f"left out: {ONNXRUNTIME_C}: the wheel of onnxruntime here ships no shared library")


def onnxruntime_c(
    compiler: Sequence[str], exported: Path, subjects: Subjects, expected: Reals, folder: Path
) -> list[Candidate]:
    """The merged graph, in both precisions; one thread, tensors made once.

    Args:
        compiler: command of the C compiler.
        exported: folder with the graphs.
        subjects: what is asked.
        expected: (n, k) what has to come out: ``TOLD``.
        folder: for compiled files.

    Raises:
        GuidanceError: the wheel has no such library, or it does not work as declared here.
        CompilerError: the compiler refused.
    """
    path = find_library()
    get_base = ctypes.CDLL(str(path))["OrtGetApiBase"]
    found = []
    for precision in SUFFIXES:
        graph = exported / graph_name(precision)
        units = [Unit(HERE / "candidate_onnxruntime.c")]
        asked = [name.encode() for name in TOLD[subjects.components]]
        shape = Shape(precision, subjects.components + 1, len(asked), len(asked))
        library = Library(compiler, units, shape, folder / precision)
        session = onnxruntime.InferenceSession(graph, providers=["CPUExecutionProvider"])
        inputs = [entry.name.encode() for entry in session.get_inputs()]
        # The C keeps pointers to the names: they live as long as the library.
        names = ((ctypes.c_char_p * len(inputs))(*inputs), (ctypes.c_char_p * len(asked))(*asked))
        library.kept.append(names)
        prepare = library.loaded["prepare"]
        prepare.restype = ctypes.c_char_p
        problem = prepare(get_base, str(graph).encode(), names[0], ctypes.c_uint64(len(inputs)), names[1])
        if problem is not None:
            raise GuidanceError(f"left out: {ONNXRUNTIME_C}: {problem.decode()}")
        if not agree(seamless(library.evaluate(subjects.inputs)), seamless(expected)):
            raise GuidanceError(f"left out: {ONNXRUNTIME_C}: {path.name} does not give the same commands")
        library.time_over(subjects.inputs)
        found.append(Candidate(ONNXRUNTIME_C, precision, library.in_a_chain, library.back_to_back))
    return found

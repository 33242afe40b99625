"""C that onnx2c generated elsewhere, from the graphs of an export; see c_runtime/README.md."""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from c_runtime.verification.bench.compiled import Library, Reals, Shape, Unit
from c_runtime.verification.bench.rounds import Candidate
from c_runtime.verification.bench.subjects import Subjects, agree
from sailnet.errors import GuidanceError
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks

NAME = "onnx2c"
FLAGS = ("-O3", "-march=native")
BUILDS = {"": FLAGS, ", -ffast-math": (*FLAGS, "-ffast-math")}
TRIO = ("tau", "alpha_pre", "lambda_v")

_ENTRY = re.compile(r"^\s*void\s+entry\s*\(([^)]*)\)", re.MULTILINE)
_PARAMETER = re.compile(r"(const\s+)?(float|double)\s+(\w+)((?:\s*\[\s*\d+\s*\])+)")


@dataclass(frozen=True)
class Entry:
    """``void entry(const float in[1][3], ..., float out[1][1])`` as a file defines it.

    Attributes:
        parameters: as they are declared.
        kind: ``float`` or ``double``.
        inputs, outputs: how many numbers each has.
    """

    parameters: str
    kind: str
    inputs: tuple[int, ...]
    outputs: tuple[int, ...]

    @classmethod
    def of(cls, source: Path) -> "Entry":
        """Read the definition in a file.

        Raises:
            GuidanceError: there is none of this form.
        """
        try:
            found = _ENTRY.search(source.read_text(encoding="utf-8"))
        except (OSError, UnicodeDecodeError) as error:
            raise GuidanceError(f"cannot read {source}: {error}") from error
        declared = _PARAMETER.findall(found.group(1)) if found else []
        kinds = {kind for _, kind, _, _ in declared}
        if found is None or len(kinds) != 1 or len(declared) != found.group(1).count(",") + 1:
            raise GuidanceError(
                f"{source} defines no `void entry(const float in[1][3], float out[1][1])` "
                "of float or double arrays: give the C that onnx2c printed"
            )
        sizes = [(const, math.prod(map(int, re.findall(r"\d+", size)))) for const, _, _, size in declared]
        inputs = tuple(size for const, size in sizes if const)
        outputs = tuple(size for const, size in sizes if not const)
        return cls(" ".join(found.group(1).split()), kinds.pop(), inputs, outputs)

    def declaration(self, name: str) -> str:
        """C, under another name."""
        return f"void {name}({self.parameters});"


def onnx2c(
    compiler: Sequence[str],
    path: Path,
    networks: AnyGuidanceNetworks | None,
    subjects: Subjects,
    expected: Reals,
    folder: Path,
) -> list[Candidate]:
    """Rows for generated C, with and without -ffast-math.

    Args:
        compiler: command of the C compiler.
        path: the C file of the merged graph, ``guidance_f32.onnx``; or a folder with ``tau.c``,
            ``alpha_pre.c`` and ``lambda_v.c``, of the graphs of those names.
        networks: what the three of a folder are compared with.
        subjects: what is asked.
        expected: (n, 2) cone angles and times of flight that have to come out of the merged graph.
        folder: for compiled files.

    Raises:
        GuidanceError: it is not such C, or does not compute the same.
        CompilerError: the compiler refused.
    """
    if subjects.components > 3:
        raise GuidanceError(
            "what onnx2c generates is timed for exports of the plane alone: leave out --onnx2c"
        )
    merged = not path.is_dir()
    sources = {NAME: path} if merged else {name: path / f"{name}.c" for name in TRIO}
    entries = {name: Entry.of(source) for name, source in sources.items()}
    kinds = {entry.kind for entry in entries.values()}
    if len(kinds) > 1:
        raise GuidanceError(f"the files in {path} mix float and double: generate them from one precision")
    precision = {"float": "float32", "double": "float64"}[kinds.pop()]
    if merged:
        glue, inputs, right = _merged(entries[NAME], path), subjects.inputs, expected
    else:
        if networks is None:
            raise GuidanceError("to check the networks in a folder, --networks is needed")
        inputs, right = subjects.network_inputs(networks), subjects.network_outputs(networks)
        glue = _three(entries, networks, path)
    folder.mkdir(parents=True)
    wrapper = folder / "candidate.c"
    wrapper.write_text(glue)
    shape = Shape(precision, inputs.shape[1], right.shape[1], right.shape[1])
    what = f"{NAME}, {'merged graph' if merged else 'three networks'}"
    found = []
    for build, flags in BUILDS.items():
        units = [Unit(source, (*flags, f"-Dentry=entry_{name}", "-w")) for name, source in sources.items()]
        place = folder / f"build{build}"
        library = Library(compiler, [*units, Unit(wrapper)], shape, place)
        if not agree(library.evaluate(inputs), right):
            raise GuidanceError(f"{path} does not compute the networks of this export: generate it from them")
        library.time_over(inputs)
        found.append(Candidate(f"{what}{build}", precision, library.in_a_chain, library.back_to_back))
    return found


def _merged(entry: Entry, path: Path) -> str:
    if entry.inputs not in ((3,), (3, 1)) or entry.outputs != (1, 1):
        raise GuidanceError(
            f"{path} reads {entry.inputs} and writes {entry.outputs} numbers, the merged graph reads the "
            "state (3) and, if its networks do, beta (1), and writes cone angle and time of flight (1 each): "
            "generate it for one row (onnx2c -d n:1)"
        )
    given = ["(const void *)input", "(const void *)(input + 3)"][: len(entry.inputs)]
    return _function(
        [entry.declaration(f"entry_{NAME}")],
        [f"entry_{NAME}({', '.join(given)}, (void *)output, (void *)(output + 1));"],
    )


def _three(entries: dict[str, Entry], networks: AnyGuidanceNetworks, path: Path) -> str:
    count = len(networks.tau.inputs)
    body = [f"candidate_real given[{count + 1}];", f"memcpy(given, input, {count} * sizeof given[0]);"]
    for i, name in enumerate(TRIO):
        wanted = len(getattr(networks, name).inputs)
        if entries[name].inputs != (wanted,) or entries[name].outputs != (1,):
            raise GuidanceError(f"{path}/{name}.c does not read {wanted} numbers and write one")
        body.append(f"entry_{name}((const void *)given, (void *)(output + {i}));")
        # In the paper's form the others read the time of flight.
        body.append(f"given[{count}] = output[0];" if i == 0 else "")
    return _function([entries[name].declaration(f"entry_{name}") for name in TRIO], body)


def _function(declarations: Sequence[str], body: Sequence[str]) -> str:
    opening = "void candidate(const candidate_real *input, candidate_real *output) {"
    includes = ['#include "candidate.h"', "#include <string.h>"]
    return "\n".join([*includes, *declarations, opening, *body, "}\n"])

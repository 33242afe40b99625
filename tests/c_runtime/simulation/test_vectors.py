"""The flight file computes the same on vectors as on single numbers, which is what is proved."""

import ctypes
import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from c_runtime.builds import BUILDS, Build
from c_runtime.shared_library import SHARED, find_compiler
from c_runtime.verification.bench.exported_c import instruction_sets
from export.to_c import write_c
from sailnet.guidance.facts import describe
from sailnet.mission.mission import Mission
from tests.paths import ROOT
from tests.random_networks import STATE_MAX, STATE_MIN, random_guidance

Reals = NDArray[np.floating]
Trio = tuple[Sequence[int], Sequence[int], Sequence[int]]
COUNT = 20_000

# No product and sum in one operation: which of them are is the compiler's choice.
FLAGS = ("-std=c99", "-O3", "-fno-trapping-math", "-fno-tree-vectorize", "-ffp-contract=off")
PLAIN = ("-DSAILNET_PLAIN",)
ON_VECTORS = [build for build in BUILDS.values() if build.layout == "host"]
VERIFICATION = ROOT / "c_runtime" / "verification"
WRAPPER = """
#include "tested.h"
#ifdef SAILNET_VECTORS
int lanes(void) { return SAILNET_LANES; }
#else
int lanes(void) { return 1; }
#endif
void commands(int n, const sailnet_real (*given)[4], sailnet_real (*out)[3])
{
    for (int i = 0; i < n; i++) {
        const sailnet_state state = {given[i][0], given[i][1], given[i][2]};
        sailnet_command command;
        out[i][0] = (sailnet_real)sailnet_guidance(&state, given[i][3], &command);
        out[i][1] = command.cone_angle;
        out[i][2] = command.time_of_flight;
    }
}
"""


def compiled(source: Path, name: str, flags: Sequence[str]) -> ctypes.CDLL:
    library = source / f"{name}.so"
    wrapper = source / "wrapper.c"
    wrapper.write_text(WRAPPER)
    command = [*find_compiler(), *FLAGS, *SHARED, *flags, f"-I{source}", f"-I{VERIFICATION}"]
    command += ["-o", str(library), str(wrapper)]
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(library))


def commands(library: ctypes.CDLL, given: Reals) -> Reals:
    out = np.empty((len(given), 3), given.dtype)
    library.commands(len(given), ctypes.c_void_p(given.ctypes.data), ctypes.c_void_p(out.ctypes.data))
    return out


def states(kind: type[np.floating], beta: float) -> Reals:
    """States of the trained box, near the target and far from anything; and any bits."""
    rng = np.random.default_rng(20261121)
    low, high = np.array([*STATE_MIN, 0.9 * beta]), np.array([*STATE_MAX, 1.1 * beta])
    trained = rng.uniform(low, high, (COUNT, 4))
    trained[::2, 3] = beta
    near = np.array([1.52, 0.0, 0.81, beta]) + rng.normal(scale=1e-3, size=(COUNT, 4))
    far = rng.normal(scale=1e3, size=(COUNT, 4))
    bits = rng.integers(0, 256, COUNT * 4 * np.dtype(kind).itemsize, dtype=np.uint8)
    return np.concatenate(
        [*(part.astype(kind) for part in (trained, near, far)), bits.view(kind).reshape(-1, 4)]
    )


@pytest.mark.slow
@pytest.mark.parametrize("build", ON_VECTORS, ids=lambda build: build.name)
@pytest.mark.parametrize(
    ("sizes", "approach"),
    [
        (((20, 20, 20),) * 3, True),
        pytest.param(((20, 20, 20),) * 3, False, marks=pytest.mark.exhaustive),
        pytest.param(((7,), (33, 5), (12, 12, 12, 12)), True, marks=pytest.mark.exhaustive),
        (((64, 64), (31,), (1, 2, 3)), False),
    ],
    ids=["approach", "paper", "odd sizes", "odd sizes, paper"],
)
def test_vectors_and_single_numbers_give_the_same_bits(
    tmp_path: Path, mission: Mission, build: Build, sizes: Trio, approach: bool
) -> None:
    networks = random_guidance(*sizes, approach=approach)
    write_c(networks, describe(networks, mission), tmp_path)
    defines = build.tested
    given = states(np.float64 if build.suffix == "f64" else np.float32, mission.sail.beta)
    plain = compiled(tmp_path, "plain", (*defines, *PLAIN))
    expected = commands(plain, given)
    assert plain.lanes() == 1
    assert len(set(expected[:, 0])) >= 3
    for name, flags in instruction_sets().items():
        library = compiled(tmp_path, name.replace(" ", ""), (*defines, *flags))
        assert library.lanes() > 1
        np.testing.assert_array_equal(commands(library, given), expected, err_msg=name)


@pytest.mark.slow
def test_the_flight_file_agrees_however_near_the_target(tmp_path: Path, mission: Mission) -> None:
    """Where the scale of what is missing meets its least value, too."""
    networks = random_guidance(approach=True)
    facts = describe(networks, mission)
    write_c(networks, facts, tmp_path)
    rng = np.random.default_rng(8)
    missing = rng.normal(size=(COUNT, 3)) * 10.0 ** rng.uniform(-14.0, -2.0, (COUNT, 1))
    given = np.column_stack([np.array(facts.target_state) + missing, np.full(COUNT, mission.sail.beta)])
    hosts, flight = (
        np.abs(commands(compiled(tmp_path, name, BUILDS[name].tested), given)) for name in ("f64_host", "f64")
    )
    np.testing.assert_allclose(flight[:, 1], hosts[:, 1], atol=1e-9)
    np.testing.assert_allclose(flight[:, 2], hosts[:, 2], rtol=1e-9)

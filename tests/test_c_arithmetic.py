"""The flight file's own elementary functions against NumPy's, in extended precision."""

import ctypes
import subprocess
from collections.abc import Callable
from functools import partial

import numpy as np
import pytest
from numpy.typing import NDArray

from c_runtime.shared_library import FLAGS, PRECISIONS, SHARED, find_compiler
from sailnet.networks.approach import SMALLEST_SCALE
from tests.conftest import Exported

Reals = NDArray[np.floating]
Function = Callable[[Reals], Reals]

WRAPPERS = """
#include "sailnet_guidance.c"
void exp2_of(int n, const sailnet_real *x, sailnet_real *y)
{ for (int i = 0; i < n; i++) y[i] = sailnet_exp2(x[i]); }
#ifdef SAILNET_VECTORS
void sigmoid(int n, const sailnet_real *x, sailnet_real *y)
{
    const sailnet_lanes none = {0};
    for (int i = 0; i < n; i++) y[i] = sailnet_lanes_sigmoid(x[i] + none)[0];
}
#else
void sigmoid(int n, const sailnet_real *x, sailnet_real *y)
{ for (int i = 0; i < n; i++) y[i] = sailnet_sigmoid(x[i]); }
#endif
void inverse_fourth_root(int n, const sailnet_real *x, sailnet_real *y)
{ for (int i = 0; i < n; i++) y[i] = sailnet_inverse_fourth_root(x[i]); }
void cosine(int n, const sailnet_real *x, sailnet_real *y)
{ for (int i = 0; i < n; i++) { sailnet_real other; sailnet_cosine_sine(x[i], &y[i], &other); } }
void sine(int n, const sailnet_real *x, sailnet_real *y)
{ for (int i = 0; i < n; i++) { sailnet_real other; sailnet_cosine_sine(x[i], &other, &y[i]); } }
"""


@pytest.fixture(scope="module", params=list(PRECISIONS))
def functions(
    request: pytest.FixtureRequest, approach_exported: Exported, tmp_path_factory: pytest.TempPathFactory
) -> tuple[type, Callable[[str], Function]]:
    """The type of a precision, and the functions of the flight file in it, by name."""
    folder = tmp_path_factory.mktemp(request.param)
    source, library = folder / "wrappers.c", folder / "wrappers.so"
    source.write_text(WRAPPERS)
    include = f"-I{approach_exported.folder}"
    command = [*find_compiler(), *FLAGS, *SHARED, *PRECISIONS[request.param], include, "-o", str(library)]
    subprocess.run([*command, str(source)], check=True)
    loaded = ctypes.CDLL(str(library))
    kind = np.float64 if request.param == "f64" else np.float32

    def call(name: str, x: Reals) -> Reals:
        y = np.empty_like(x)
        loaded[name](len(x), ctypes.c_void_p(x.ctypes.data), ctypes.c_void_p(y.ctypes.data))
        return y

    return kind, lambda name: partial(call, name)


Functions = tuple[type, Callable[[str], Function]]


def test_inverse_fourth_root_over_all_it_is_given(functions: Functions) -> None:
    kind, named = functions
    # From the smallest scale, whose fourth power this is, to what the flight file clamps to.
    x: Reals = np.geomspace(SMALLEST_SCALE**4, 1e30, 1_000_001).astype(kind)
    exact = np.sqrt(np.sqrt(x.astype(np.longdouble)))
    relative = np.abs(named("inverse_fourth_root")(x) * exact - 1.0)
    assert relative.max() < 1.2 * np.finfo(kind).eps


def test_scale_from_the_inverse_root_is_a_scale(functions: Functions) -> None:
    kind, named = functions
    s4: Reals = np.geomspace(SMALLEST_SCALE**4, 1e30, 100_001).astype(kind)
    per_s = named("inverse_fourth_root")(s4)
    s = (s4 * per_s) * (per_s * per_s)
    np.testing.assert_allclose(
        s, np.sqrt(np.sqrt(s4.astype(np.longdouble))), rtol=5 * float(np.finfo(kind).eps)
    )


def test_powers_of_two(functions: Functions) -> None:
    kind, named = functions
    x: Reals = np.linspace(-60.0, 60.0, 1_000_001).astype(kind)
    relative = np.abs(named("exp2_of")(x) / np.exp2(x.astype(np.longdouble)) - 1.0)
    assert relative.max() < 2.0 * np.finfo(kind).eps
    whole: Reals = np.arange(-60, 61).astype(kind)
    np.testing.assert_array_equal(named("exp2_of")(whole), np.exp2(whole))


def test_sigmoids(functions: Functions) -> None:
    kind, named = functions
    # The largest argument, in octaves, that an export may hold is 1000.
    x: Reals = np.concatenate([np.linspace(-40.0, 40.0, 1_000_001), np.linspace(-1000, 1000, 10_001)]).astype(
        kind
    )
    sigmoids = named("sigmoid")(x)
    exact = -np.tanh(x.astype(np.longdouble) * np.log(np.longdouble(2)) / 2)
    assert np.abs(sigmoids - exact).max() < 1.2 * np.finfo(kind).eps
    assert np.abs(sigmoids).max() <= 1.0
    np.testing.assert_array_equal(sigmoids[np.abs(x) >= 60], -np.sign(x[np.abs(x) >= 60]))
    assert named("sigmoid")(np.zeros(1, kind))[0] == 0.0


@pytest.mark.parametrize("name", ["cosine", "sine"])
def test_cosine_and_sine_of_cone_angles(functions: Functions, name: str) -> None:
    kind, named = functions
    x: Reals = np.linspace(-np.pi / 2, np.pi / 2, 1_000_001).astype(kind)
    exact = {"cosine": np.cos, "sine": np.sin}[name](x.astype(np.longdouble))
    assert np.abs(named(name)(x) - exact).max() < 2.0 * np.finfo(kind).eps
    assert named(name)(np.zeros(1, kind))[0] == (1.0 if name == "cosine" else 0.0)

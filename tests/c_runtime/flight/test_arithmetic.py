"""The flight file's own elementary functions against NumPy's, in extended precision."""

import ctypes
import subprocess
from collections.abc import Callable
from functools import partial

import numpy as np
import pytest
from numpy.typing import NDArray

from c_runtime.builds import BUILDS, Build
from c_runtime.shared_library import FLAGS, SHARED, find_compiler
from sailnet.networks.approach import SMALLEST_SCALE
from tests.conftest import Exported
from tests.paths import ROOT

VERIFICATION = ROOT / "c_runtime" / "verification"
Reals = NDArray[np.floating]
Function = Callable[[Reals], Reals]

WRAPPERS = """
#include "tested.h"
#ifndef TESTED_HOST
#define sailnet_all_lanes(x) (x)
#define sailnet_first_lane(x) (x)
#endif
#define OF_EACH(name, value) \\
    void name(int n, const sailnet_real *x, sailnet_real *y) { for (int i = 0; i < n; i++) y[i] = (value); }
OF_EACH(exp2_of, sailnet_first_lane(sailnet_exp2(sailnet_all_lanes(x[i]))))
OF_EACH(sigmoid, sailnet_first_lane(sailnet_sigmoid(sailnet_all_lanes(x[i]))))
#ifdef TESTED_HOST
OF_EACH(inverse_root, sailnet_inverse_fourth_root(x[i]))
#else
OF_EACH(inverse_root, sailnet_per_root(&x[i]))
#endif
void cosine(int n, const sailnet_real *x, sailnet_real *y)
{ for (int i = 0; i < n; i++) { sailnet_real other; sailnet_cosine_sine(x[i], &y[i], &other); } }
void sine(int n, const sailnet_real *x, sailnet_real *y)
{ for (int i = 0; i < n; i++) { sailnet_real other; sailnet_cosine_sine(x[i], &other, &y[i]); } }
"""


@pytest.fixture(scope="module", params=BUILDS.values(), ids=list(BUILDS))
def build(request: pytest.FixtureRequest) -> Build:
    chosen: Build = request.param
    return chosen


@pytest.fixture(scope="module")
def functions(
    build: Build, approach_exported: Exported, tmp_path_factory: pytest.TempPathFactory
) -> tuple[type, Callable[[str], Function]]:
    """The type of a build, and its functions by name."""
    folder = tmp_path_factory.mktemp(build.name)
    source, library = folder / "wrappers.c", folder / "wrappers.so"
    source.write_text(WRAPPERS)
    headers = [f"-I{approach_exported.folder}", f"-I{VERIFICATION}"]
    command = [*find_compiler(), *FLAGS, *build.optimisation, *SHARED, *build.tested, *headers]
    command += ["-o", str(library)]
    subprocess.run([*command, str(source)], check=True)
    loaded = ctypes.CDLL(str(library))
    kind = np.float64 if build.suffix == "f64" else np.float32

    def call(name: str, x: Reals) -> Reals:
        y = np.empty_like(x)
        loaded[name](len(x), ctypes.c_void_p(x.ctypes.data), ctypes.c_void_p(y.ctypes.data))
        return y

    return kind, lambda name: partial(call, name)


Functions = tuple[type, Callable[[str], Function]]


# Of each layout: the root that it has, and what it is clamped to.
ROOTS = {"host": (4, SMALLEST_SCALE**4, 1e30), "flight": (2, 1e-24, 1e24)}


def test_inverse_roots_over_all_they_are_given(functions: Functions, build: Build) -> None:
    kind, named = functions
    degree, least, largest = ROOTS[build.layout]
    x: Reals = np.geomspace(least, largest, 200_001).astype(kind)
    exact = x.astype(np.longdouble) ** (np.longdouble(1) / degree)
    relative = np.abs(named("inverse_root")(x) * exact - 1.0)
    # Newton's last step rounds more often than the polynomial.
    assert relative.max() < (1.2 if degree == 4 else 2.2) * np.finfo(kind).eps


def test_scale_from_the_inverse_root_is_a_scale(functions: Functions, build: Build) -> None:
    kind, named = functions
    s4: Reals = np.geomspace(SMALLEST_SCALE**4, 1e24, 100_001).astype(kind)
    per = named("inverse_root")(s4)
    s = (s4 * per) * (per * per) if build.layout == "host" else 1 / named("inverse_root")(1 / per)
    np.testing.assert_allclose(
        s, np.sqrt(np.sqrt(s4.astype(np.longdouble))), rtol=5 * float(np.finfo(kind).eps)
    )


def test_powers_of_two(functions: Functions) -> None:
    kind, named = functions
    x: Reals = np.linspace(-60.0, 60.0, 200_001).astype(kind)
    relative = np.abs(named("exp2_of")(x) / np.exp2(x.astype(np.longdouble)) - 1.0)
    assert relative.max() < 2.0 * np.finfo(kind).eps
    whole: Reals = np.arange(-60, 61).astype(kind)
    np.testing.assert_array_equal(named("exp2_of")(whole), np.exp2(whole))


def test_sigmoids(functions: Functions) -> None:
    kind, named = functions
    # The largest argument, in octaves, that an export may hold is 1000.
    x: Reals = np.concatenate([np.linspace(-40.0, 40.0, 200_001), np.linspace(-1000, 1000, 10_001)]).astype(
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
    x: Reals = np.linspace(-np.pi / 2, np.pi / 2, 200_001).astype(kind)
    exact = {"cosine": np.cos, "sine": np.sin}[name](x.astype(np.longdouble))
    assert np.abs(named(name)(x) - exact).max() < 2.0 * np.finfo(kind).eps
    assert named(name)(np.zeros(1, kind))[0] == (1.0 if name == "cosine" else 0.0)

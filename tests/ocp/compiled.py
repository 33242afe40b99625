"""Compiled functions are dropped between modules of tests: all together they would fill gigabytes."""

import ctypes
import gc
from collections.abc import Iterator

import pytest

from sailnet.ocp.definition import kernels
from sailnet.ocp.propagation import flow, tangents


@pytest.fixture(scope="module", autouse=True)
def compiled_code_is_dropped() -> Iterator[None]:
    """After a module, give back what it has compiled; heyoka keeps the object code, a small part of it."""
    yield
    for kept in (flow._integrator, tangents.tangents_of, kernels.compiled):
        kept.cache_clear()
    gc.collect()
    # What the compiler has used is free by now, and the C library keeps it unless it is told.
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim is not None:
        trim(0)

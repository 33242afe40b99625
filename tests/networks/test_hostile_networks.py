"""Networks that somebody made to do harm, their checksums right: refused in words before much is read."""

import json
import os
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from safetensors import safe_open
from safetensors.numpy import save_file

from sailnet.errors import NetworkError
from sailnet.networks.network import load_network, save_network
from sailnet.networks.stored_tensors import tensors_digest
from tests.random_networks import random_network


@pytest.fixture
def stored(tmp_path: Path) -> Path:
    save_network(random_network("tau", (4,)), tmp_path / "tau.safetensors")
    return tmp_path / "tau.safetensors"


def read(path: Path) -> tuple[dict[str, str], dict[str, Any]]:
    with safe_open(path, framework="numpy") as file:
        return dict(file.metadata()), {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118


def sign(path: Path, metadata: dict[str, str], tensors: dict[str, Any]) -> None:
    metadata.pop("sha256", None)
    save_file(tensors, path, {**metadata, "sha256": tensors_digest(tensors, metadata)})


@pytest.mark.parametrize(
    ("name", "tensor", "said"),
    [
        ("bias0", np.zeros(()), r"bias0 has the shape \(\)"),
        ("bias0", np.zeros(4, "<f4"), "bias0 is of type F32"),
        ("weight0", np.zeros((4, 9)), r"weight0 has the shape \(4, 9\)"),
        ("weight1", np.zeros((0, 4)), r"weight1 has the shape \(0, 4\)"),
        ("output_range", np.zeros(1), r"output_range has the shape \(1,\)"),
        ("input_max", np.full(3, np.inf), "not finite and ordered"),
        ("weight7", np.zeros((1, 4)), "its tensors are"),
        ("other", np.zeros(1), "its tensors are"),
    ],
)
def test_another_tensor_is_refused(stored: Path, name: str, tensor: Any, said: str) -> None:
    metadata, tensors = read(stored)
    sign(stored, metadata, tensors | {name: tensor})
    with pytest.raises(NetworkError, match=said):
        load_network(stored)


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("provenance", "null", "it holds None, not a table"),
        ("provenance", "[" * 100_000, "nested without end"),
        ("mission", "[]", "not a table"),
        ("mission", '{"schema": 1}', "missing"),
        ("other", "x", "its metadata is"),
        ("schema", "x" * 5000, "has schema"),
    ],
)
def test_other_metadata_is_refused_in_a_few_words(stored: Path, name: str, text: str, said: str) -> None:
    metadata, tensors = read(stored)
    sign(stored, metadata | {name: text}, tensors)
    with pytest.raises(NetworkError, match=said) as refused:
        load_network(stored)
    assert len(str(refused.value)) < 2000


def test_types_that_numpy_has_not_are_refused(stored: Path) -> None:
    content = stored.read_bytes()
    (length,) = struct.unpack_from("<Q", content)
    header = json.loads(content[8 : 8 + length])
    header["bias0"] |= {"dtype": "F8_E5M2", "shape": [32]}
    text = json.dumps(header).encode()
    stored.write_bytes(struct.pack("<Q", len(text)) + text + content[8 + length :])
    with pytest.raises(NetworkError, match="bias0 is of type F8_E5M2"):
        load_network(stored)


def test_what_is_no_file_or_too_long_is_not_read(stored: Path, tmp_path: Path) -> None:
    with stored.open("r+b") as file:
        file.truncate(1 << 40)
    with pytest.raises(NetworkError, match="longer than"):
        load_network(stored)
    os.mkfifo(tmp_path / "pipe.safetensors")
    with pytest.raises(NetworkError, match="it is no file"):
        load_network(tmp_path / "pipe.safetensors")

"""A shell completes commands, options and what they may be."""

import shlex
import subprocess

import pytest

from sailnet.cli import main


@pytest.fixture(scope="module")
def script() -> str:
    import contextlib
    import io

    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        assert main(["completion"]) == 0
    return printed.getvalue()


@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        (["so"], {"solve"}),
        (["fly", "1", "0", "1", "--beta-b"], {"--beta-bias"}),
        (["fly", "--backend", ""], {"c", "onnx"}),
        (["evaluate", "--campaign", "bad"], {"bad-days"}),
        (["solve", "--mission", "earth_v"], {"earth_venus", "earth_venus_3d"}),
        (["solve", "--plot", "no_such_file"], set()),
        (["data", "--rec"], {"--recipe"}),
        (["data", "x.h5", "--recipe", "b"], {"box"}),
        (["train", "--ep"], {"--epochs"}),
        (["export", "--plain"], {"--plain-law"}),
        (["export", "--mission", "earth_v"], {"earth_venus", "earth_venus_3d"}),
    ],
)
def test_what_is_offered(script: str, typed: list[str], offered: set[str]) -> None:
    words = ["sailnet", *typed]
    asked = f"COMP_WORDS=({shlex.join(words)}); COMP_CWORD={len(words) - 1}; _sailnet; echo ${{COMPREPLY[@]}}"
    done = subprocess.run(
        ["bash", "-c", f"{script}\n{asked}"], capture_output=True, text=True, check=True
    )  # fmt: skip
    assert set(done.stdout.split()) == offered
    assert not done.stderr

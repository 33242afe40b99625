"""What was probably meant, and letters that a terminal does not have."""

import io
import shlex

import pytest

from sailnet.cli.command_line import main, parser
from sailnet.cli.spelling import in_letters_it_has
from sailnet.cli.stage import STAGES


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("slove", "1", "0", "1"), "did you mean solve?"),
        (("solve", "1", "0", "1", "--smothing", "0"), "--smothing 0; did you mean --smoothing?"),
        (("fly", "1", "0", "1", "--beta-nose=0.1"), "did you mean --beta-noise?"),
        (("guide", "1", "0", "1", "--guidance", "exprt"), "did you mean expert?"),
        (("solve", "--mission", "earth_mras"), "did you mean earth_mars?"),
        (("evaluate", "--campaign", "everythin"), "did you mean everything?"),
        (("optics", "jlp"), "did you mean jpl?"),
        (("papers", "godard"), "did you mean goddard?"),
        (("data", "x.h5", "--recepi", "box"), "did you mean --recipe?"),
        (("data", "x.h5", "--recipe", "boxx"), "did you mean box?"),
        (("train", "x.h5", "x", "--epoch-s", "1"), "did you mean --epochs?"),
        (("export", "x", "y", "--plainlaw"), "did you mean --plain-law?"),
    ],
)
def test_a_misspelt_name_is_answered_with_the_nearest(
    arguments: tuple[str, ...], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    try:
        status = main(arguments)
    except SystemExit as stop:
        status = int(stop.code or 0)
    assert status != 0
    assert says in capsys.readouterr().err.replace("\n", " ")


def test_nothing_is_guessed_of_what_is_like_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    for arguments in (["xyzzy"], ["solve", "1", "0", "1", "--xyzzy"], ["solve", "1", "0", "1", "7"]):
        with pytest.raises(SystemExit):
            main(arguments)
        said = capsys.readouterr().err
        assert "did you mean" not in said
        assert arguments[-1] in said
    with pytest.raises(SystemExit):
        main(["solve", "1", "0", "1", "--seed", "3"])
    assert "usage: sailnet solve" in capsys.readouterr().err


def test_an_error_is_not_lost_below_all_options(capsys: pytest.CaptureFixture[str]) -> None:
    for command in (["evaluate", "--workers", "0"], ["fly", "1", "0"]):
        with pytest.raises(SystemExit):
            main(command)
        said = capsys.readouterr().err.splitlines()
        assert len(said) == 2
        assert said[0].endswith(f"[OPTIONS]; sailnet {command[0]} --help has them")
        assert said[1].startswith(f"sailnet {command[0]}: error: ")
    assert said[0].startswith("usage: sailnet fly R U V ")


@pytest.mark.parametrize("command", ["solve", "evaluate", "pipeline", "papers", "export"])
def test_an_example_is_a_line_that_can_be_copied(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main([command, "--help"])
    _, _, examples = capsys.readouterr().out.partition("example: ")
    lines = examples.strip().splitlines()
    assert lines
    for line in lines:
        words = shlex.split(line)
        assert words[0] == "sailnet"
        if words[1] not in STAGES:
            parser().parse_args(words[1:])


@pytest.mark.parametrize(
    ("encoding", "written"),
    [
        ("utf-8", "β within ±15 %, 40° – λ_v 帆"),
        ("latin-1", "beta within ±15 %, 40° - lambda_v ?"),
        ("ascii", "beta within +-15 %, 40 deg - lambda_v ?"),
    ],
)
def test_letters_that_an_encoding_has_not_are_spelt(encoding: str, written: str) -> None:
    content = io.BytesIO()
    stream = io.TextIOWrapper(content, encoding=encoding)
    in_letters_it_has(stream)
    print("β within ±15 %, 40° – λ_v 帆", end="", file=stream, flush=True)
    assert content.getvalue().decode(encoding) == written

"""``sailnet evaluate --campaign``: what it replaces, flies twice, and explains."""

import json
import shlex
import shutil
from argparse import Namespace
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import resources
from pathlib import Path

import pytest

from sailnet import report
from sailnet.campaign import batches, budget
from sailnet.campaign.results import open_results
from sailnet.cli import main
from sailnet.cli.arguments import workers_of
from sailnet.cli.campaign import flown_again_by
from sailnet.cli.command_line import parser
from sailnet.report import campaign_page
from sailnet.workers import executors


def error_of(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert main(["evaluate", *arguments]) == 1
    captured = capsys.readouterr()
    assert captured.out == ""
    return captured.err


def test_the_command_explains_what_it_cannot_do(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    out = ("--output", str(tmp_path / "out"))
    assert "known are acceptance, actuation, ageing, bad-days, beta-bias" in error_of(
        capsys, "--campaign", "weather", *out
    )
    assert "cannot read campaign" in error_of(capsys, "--campaign", str(tmp_path / "no.toml"), *out)
    (tmp_path / "bad.toml").write_text("name = ")
    assert "not valid TOML" in error_of(capsys, "--campaign", str(tmp_path / "bad.toml"), *out)
    said = error_of(capsys, "--campaign", "paper", "--beta-noise", "0.1", "--period", "0.01", *out)
    assert "put --period, --beta-noise into its TOML" in said
    assert "flights = 0" in error_of(capsys, "--campaign", "generalisation", "--flights", "0", *out)
    assert "earth_pluto" in error_of(capsys, "--campaign", "paper", "--mission", "earth_pluto", *out)
    damaged = tmp_path / "networks"
    shutil.copytree(str(resources.files("sailnet") / "shipped" / "earth_mars"), damaged)
    library = damaged / "guidance_f64.so"
    library.write_bytes(library.read_bytes()[:-9])
    assert "damaged" in error_of(capsys, "--campaign", "paper", "--networks", str(damaged), *out)
    monkeypatch.setattr(report, "PACKAGES", ("matplotlib", "no_such_package"))
    said = error_of(capsys, "--campaign", "paper", *out)
    assert "without no_such_package: pip install 'sailnet[report]'" in said
    monkeypatch.undo()
    (tmp_path / "file").write_text("in the way")
    said = error_of(capsys, "--campaign", "paper", "--output", str(tmp_path / "file" / "x"))
    assert said.startswith(f"error: cannot write campaign paper in {tmp_path / 'file' / 'x'}: ")
    assert not (tmp_path / "out").exists()


def test_a_campaign_that_cannot_end_is_refused_before_its_batches_are_listed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Four million of them took ten seconds and a gigabyte."""
    path, out = tmp_path / "endless.toml", str(tmp_path / "out")
    path.write_text('schema = 1\nname = "x"\ntitle = "X"\n[[series]]\nname = "a"\nflights = 1000000000\n')
    monkeypatch.setattr(batches, "batches_of", lambda *_: pytest.fail("listed"))
    monkeypatch.setattr(budget, "_memory", lambda: 10**9)
    said = error_of(capsys, "--campaign", str(path), "--output", out)
    assert "flies 1,000,000,000 flights, which take some 500.0 GB of memory at once; there are 1.0 GB" in said


@pytest.mark.parametrize(
    ("wanted", "pieces", "started"), [(1000, 3, 3), (2, 3, 2), (1000, 1, None), (1, 9, None), (4, 0, None)]
)
def test_no_more_processes_start_than_have_something_to_do(
    wanted: int, pieces: int, started: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    @contextmanager
    def counted(count: int, _: str | None, *, wait: float) -> Iterator[int]:
        assert wait == 600.0
        yield count

    monkeypatch.setattr(executors, "workers", counted)
    options = Namespace(workers=wanted, scheduler=None, wait=600.0)
    for cores, expected in ((64, started), (2, None if started is None else 2)):
        monkeypatch.setattr("os.cpu_count", lambda cores=cores: cores)
        with workers_of(options, pieces) as pool:
            found: object = pool
        assert found == expected


@pytest.mark.slow
def test_a_finished_campaign_is_not_replaced_unasked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, out = tmp_path / "small.toml", ("--output", str(tmp_path / "out"))
    file.write_text(
        'schema = 1\nname = "small"\ntitle = "Small"\nflights = 12\nsample = 1\noptima = 0\n'
        'periods = [0.05]\n[[series]]\nname = "a"\n'
    )
    small = ("evaluate", "--campaign", str(file), "--json", *out)
    assert main([*small]) == 0
    digest = json.loads(capsys.readouterr().out)["digest"]
    page = (tmp_path / "out" / "small" / "index.html").read_text("utf-8")
    assert f"sailnet evaluate --campaign {file}</code>" in page
    said = error_of(capsys, *small[1:], "--flights", "3")
    assert "is finished, with another campaign" in said
    assert open_results(tmp_path / "out" / "small.h5").digest == digest
    left = tmp_path / "out" / "small" / ".index.html.x1y2.part"  # by one that was killed
    left.touch()
    assert main([*small, "--flights", "3", "--overwrite"]) == 0
    assert not left.exists()
    page = (tmp_path / "out" / "small" / "index.html").read_text("utf-8")
    assert f"--campaign {file} --flights 3</code>" in page
    assert len(open_results(tmp_path / "out" / "small.h5").flights["number"]) == 3


@pytest.mark.exhaustive
def test_both_precisions_are_flown_one_after_the_other(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    file, out = tmp_path / "small.toml", tmp_path / "out"
    file.write_text(
        'schema = 1\nname = "small"\ntitle = "Small"\nflights = 12\noptima = 0\nperiods = [0.05]\n'
        '[[series]]\nname = "a"\n'
    )
    assert (
        main(["evaluate", "--campaign", str(file), "--output", str(out), "--precision", "both", "--json"])
        == 0
    )
    answer = json.loads(capsys.readouterr().out)
    for name, said in (("small", answer), ("small-float32", answer["float32"])):
        found = open_results(out / f"{name}.h5")
        assert found.provenance["run"]["precision"] == (name.partition("-")[2] or "float64")
        assert said["digest"] == found.digest
        assert said["scores"][0]["flights"] == 12
        assert (out / name / "index.html").exists()
    assert answer["digest"] != answer["float32"]["digest"]
    monkeypatch.setattr(campaign_page, "write_report", lambda *_, **__: [])
    assert main(["evaluate", "--campaign", str(file), "--output", str(out), "--precision", "both"]) == 0
    lines = capsys.readouterr().out.splitlines()
    place = lines.index("Time and arrivals, float64 and float32:")
    assert [line.split()[:2] for line in lines[place + 1 : place + 4]] == [
        ["series", "flown"], ["a", "float64"], ["a", "float32"],
    ]  # fmt: skip
    assert "guidance in float32" in (out / "small-float32" / "index.html").read_text("utf-8")
    assert error_of(capsys, "--flights", "2", "--precision", "both").startswith(
        "error: --precision both is for"
    )


@pytest.mark.parametrize("usual", [True, False])
def test_the_command_of_a_page_is_the_one_that_was_given(usual: bool) -> None:
    given = ["evaluate", "--campaign", "law"]
    if not usual:
        given += ["--layout", "host", "--flights", "7", "--precision", "float32", "--seed", "3"]
        given += ["--mission", "earth_mars_jpl", "--networks", "a folder", "--guidance", "expert"]
    options = parser().parse_args(given)
    again = shlex.split(flown_again_by(options, options.precision))
    assert len(again) == len(given) + 1
    assert parser().parse_args(again[1:]) == options

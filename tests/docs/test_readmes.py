"""What the texts promise: commands that exist, an install line that is enough for them, links with an end."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sailnet.cli.command_line import main, parser
from tests.paths import ROOT

TEXTS = sorted(path for path in ROOT.glob("**/*.md") if not {".venv", "build"} & set(path.parts))
README = ROOT / "README.md"


def commands(text: Path) -> list[str]:
    """Lines of the shell blocks of a text, without comments."""
    blocks = re.findall(r"```(?:sh|bash|console)\n(.*?)```", text.read_text("utf-8"), re.S)
    lines = [line.split("  #")[0].strip() for block in blocks for line in block.splitlines()]
    return [line for line in lines if line and not line.startswith("#")]


def ours(line: str) -> list[str] | None:
    """The arguments of a ``sailnet`` command."""
    words = shlex.split(line, comments=True)
    return words[1:] if words and Path(words[0]).name == "sailnet" else None


def test_the_readme_prints_commands_of_each_kind() -> None:
    lines = commands(README)
    assert sum(ours(line) is not None for line in lines) >= 6
    assert sum(line.startswith("make") for line in lines) >= 2
    assert sum("pip install" in line for line in lines) == 1
    text = README.read_text("utf-8").splitlines()
    assert len(text) <= 90
    assert max(len(line) for line in text if not line.startswith("Written by")) <= 120


@pytest.mark.slow
def test_the_readme_s_first_flight_takes_as_long_as_it_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for line in commands(README)[1:3]:
        assert main(ours(line)) == 0
    said = re.search(r"the shortest flight: (\S+ days)", README.read_text("utf-8"))
    assert said is not None
    assert f"({said[1]})" in capsys.readouterr().out


@pytest.mark.slow
def test_the_readme_s_python_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (block,) = re.findall(r"```python\n(.*?)```", README.read_text("utf-8"), re.S)
    exec(compile(block, str(README), "exec"), {})
    assert (tmp_path / "flight.png").stat().st_size > 10_000


@pytest.mark.parametrize("text", TEXTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_commands_are_understood(text: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for line in commands(text):
        arguments = ours(line)
        if arguments is not None:
            try:
                parser().parse_args(arguments)
            except SystemExit as stopped:
                pytest.fail(f"{text.relative_to(ROOT)} prints `{line}`: {capsys.readouterr().err}{stopped}")
        if line.split()[0] == "make":
            done = subprocess.run(
                ["make", "-n", *shlex.split(line, comments=True)[1:]],
                cwd=ROOT, capture_output=True, text=True, check=False,
            )  # fmt: skip
            assert done.returncode == 0, f"{text.relative_to(ROOT)} prints `{line}`: {done.stderr}"
        if match := re.match(r"(?:\S*/)?python3? -m ([\w.]+)", line):
            module = ROOT / Path(*match[1].split("."))
            known = module.with_suffix(".py").exists() or (module / "__main__.py").exists()
            assert known or match[1] in ("venv", "build", "pip"), f"{text.relative_to(ROOT)} prints `{line}`"


@pytest.mark.parametrize("text", TEXTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_links_and_paths_lead_somewhere(text: Path) -> None:
    content = text.read_text("utf-8")
    links = re.findall(r"\]\((?!https?:|#|mailto:)([^)#\s]+)", content)
    absent = [link for link in links if not (text.parent / link).exists()]
    assert not absent, f"{text.relative_to(ROOT)} leads to {absent}"
    if text.name != "CHANGELOG.md":  # which speaks of what was
        files = re.findall(
            r"`((?:sailnet|data|training|export|c_runtime|tests|benchmarks)/[\w/]+\.(?:py|c|h|md|toml))`",
            content,
        )
        absent = [file for file in files if not (ROOT / file).exists()]
        assert not absent, f"{text.relative_to(ROOT)} speaks of {absent}"


@pytest.mark.install
def test_after_the_install_line_of_the_readme_its_commands_run(tmp_path: Path) -> None:
    """In an empty folder, with an environment that has nothing but what that line installs."""
    tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True)
    checkout = tmp_path / "sailnet"
    for name in filter(None, tracked.stdout.split("\0")):
        (checkout / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, checkout / name)
    plain = {name: value for name, value in os.environ.items() if name not in ("VIRTUAL_ENV", "PYTHONPATH")}
    plain["PATH"] = os.pathsep.join(
        folder for folder in plain["PATH"].split(os.pathsep) if Path(folder) != Path(sys.executable).parent
    )
    lines = [line for line in commands(README) if not line.startswith("make")]
    assert "pip install" in lines[0]
    for line in lines:
        done = subprocess.run(
            ["bash", "-ec", line], cwd=checkout, env=plain, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, f"`{line}` says:\n{done.stdout[-1000:]}{done.stderr[-2000:]}"
        assert "Traceback" not in done.stderr
    for left in ("flight.html", "fly.html", "optimum.csv"):
        assert (checkout / left).stat().st_size > 10_000

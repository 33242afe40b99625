"""``sailnet papers``: its forms, what makes it fail, and what it says before minutes are spent."""

import json
import os
import pickle
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from sailnet import cli
from sailnet.errors import SailnetError
from sailnet.ocp import ConvergenceError, Exact, shooting
from sailnet.papers import command, delta, parts
from sailnet.papers.parts import Part
from sailnet.papers.row import Row

ROW = Row(
    paper="900",
    problem="cart, gain = 2",
    quantity="t_f [s]",
    printed="2.01",
    ours=2.0,
    check=2.0 + 1e-9,
    check_method="closed form",
    verdict="paper in error",
    reason="|a| is rounded",
    seconds=0.25,
    paper_seconds=None,
)


OTHER = replace(ROW, paper="901", problem="kite", quantity="J", printed="7", ours=7.0, check=7.0, seconds=1.5,
                paper_seconds=3.0, verdict="agrees", reason="")  # fmt: skip


def _stalled() -> list[Row]:
    raise ConvergenceError("shooting stalled", {"boundary": 0.5})


@pytest.fixture
def stage(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Puts parts in the place of the papers' own."""

    def put(*those: parts.Part) -> None:
        monkeypatch.setattr(command, "PARTS", those)

    return put


@pytest.fixture
def two_papers(stage: Callable[..., None]) -> None:
    stage(
        parts.Part("900", ("cart", "sled"), lambda: [ROW, replace(ROW, problem="sled", printed="5")]),
        parts.Part("901", ("kite",), lambda: [OTHER]),
    )


@pytest.mark.usefixtures("two_papers")
def test_json_is_a_list_of_rows(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["papers", "--json"]) == 0
    rows: list[dict[str, Any]] = json.loads(capsys.readouterr().out)
    assert [row["problem"] for row in rows] == ["cart, gain = 2", "sled", "kite"]
    assert rows[0] == {
        "paper": "900", "problem": "cart, gain = 2", "quantity": "t_f [s]", "printed": "2.01", "ours": 2.0,
        "check": 2.0 + 1e-9, "check_method": "closed form", "verdict": "paper in error",
        "reason": "|a| is rounded", "seconds": 0.25, "paper_seconds": None, "same": True,
    }  # fmt: skip


@pytest.mark.usefixtures("two_papers")
def test_a_table_a_paper(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["papers"]) == 0
    assert capsys.readouterr().out == (
        "Paper 900\n"
        "problem         quantity  printed  ours  check (method)   verdict         s     paper's s\n"
        "cart, gain = 2  t_f [s]   2.01     2     2 (closed form)  paper in error  0.25\n"
        "sled            t_f [s]   5        2     2 (closed form)  paper in error  0.25\n"
        "\n"
        "Paper 901\n"
        "problem  quantity  printed  ours  check (method)   verdict  s    paper's s\n"
        "kite     J         7        7     7 (closed form)  agrees   1.5  3\n"
    )


@pytest.mark.usefixtures("two_papers")
@pytest.mark.parametrize(
    ("name", "problems"),
    [
        ("900", ["cart, gain = 2", "sled"]),
        ("sled", ["sled"]),
        ("cart", ["cart, gain = 2"]),
        ("901", ["kite"]),
    ],
)
def test_name_is_a_paper_or_a_problem(
    name: str, problems: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["papers", name, "--json"]) == 0
    assert [row["problem"] for row in json.loads(capsys.readouterr().out)] == problems


def test_only_what_was_asked_for_is_computed(stage: Callable[..., None]) -> None:
    stage(parts.Part("900", ("cart",), lambda: [ROW]), parts.Part("901", ("kite",), _stalled))
    assert cli.main(["papers", "cart"]) == 0


@pytest.mark.usefixtures("two_papers")
def test_an_unknown_name_lists_the_known_ones(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["papers", "904", "--json"]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err == (
        "error: no paper or problem is called 904; the papers are 900, 901, the problems cart, sled, kite\n"
    )


@pytest.mark.parametrize(
    ("change", "status"),
    [
        ({"check": 2.0 * (1.0 + 0.9e-6)}, 0),
        ({"check": 2.0 * (1.0 + 1.2e-6)}, 1),
        ({"check": 2.0 * (1.0 - 1.2e-6)}, 1),
        ({"check": -2.0}, 1),
        ({"check": 3.0, "same": False}, 0),
        ({"check": float("nan")}, 1),
        ({"ours": float("inf"), "check": float("inf")}, 1),
        ({"ours": float("nan"), "same": False}, 1),
        ({"ours": 0.0, "check": 0.0}, 0),
    ],
)
def test_two_methods_that_differ_are_a_failure(
    change: dict[str, Any], status: int, stage: Callable[..., None], capsys: pytest.CaptureFixture[str]
) -> None:
    stage(parts.Part("900", ("cart",), lambda: [OTHER, replace(ROW, **change)]))
    assert cli.main(["papers", "--json"]) == status
    said = capsys.readouterr()
    assert len(json.loads(said.out, parse_constant=pytest.fail)) == 2
    assert ("cart, gain = 2, t_f [s]" in said.err) == bool(status)
    assert "kite" not in said.err


def test_what_does_not_converge_costs_no_other_row(
    stage: Callable[..., None], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    stage(parts.Part("900", ("cart",), _stalled), parts.Part("901", ("kite",), lambda: [OTHER]))
    readme = tmp_path / "README.md"
    before = "<!-- papers -->\nof yesterday\n<!-- /papers -->\n"
    readme.write_text(before)
    assert cli.main(["papers", "--json", "--readme", str(readme)]) == 1
    said = capsys.readouterr()
    assert [row["problem"] for row in json.loads(said.out)] == ["kite"]
    assert "error: paper 900, cart: shooting stalled; boundary residual 5.00e-01" in said.err
    assert readme.read_text() == before


@pytest.mark.usefixtures("two_papers")
def test_files_and_readme(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    made = {"machine": "an abacus", "date": "1999-12-31", "revision": "abc"}
    monkeypatch.setattr("sailnet.papers.tables.software", lambda: made)
    readme = tmp_path / "README.md"
    readme.write_text("before\n<!-- papers -->\nold\n<!-- /papers -->\nafter\n")
    folder = tmp_path / "new" / "papers"
    assert cli.main(["papers", "--json", "--output", str(folder), "--readme", str(readme)]) == 0
    assert json.loads((folder / "papers.json").read_text()) == json.loads(capsys.readouterr().out)
    again = f"sailnet papers --json --output {folder} --readme {readme}"
    assert f"<code>{again}</code>" in (folder / "index.html").read_text("utf-8")
    table = (folder / "papers.md").read_text()
    assert "Written by `sailnet papers` on an abacus, 1999-12-31, revision abc." in table
    assert (
        "| cart, gain = 2 | t_f [s] | 2.01 | 2 | 2 (closed form) | paper in error | 0.25 |  "
        "| \\|a\\| is rounded |\n"
    ) in table
    assert readme.read_text() == (f"before\n<!-- papers -->\n{table.rstrip()}\n<!-- /papers -->\nafter\n")


def test_a_readme_is_looked_at_before_minutes_are_spent(stage: Callable[..., None], tmp_path: Path) -> None:
    stage(parts.Part("900", ("cart",), lambda: pytest.fail("computed")))
    readme = tmp_path / "README.md"
    readme.write_text("no block\n")
    with pytest.raises(SailnetError, match="<!-- papers -->"):
        command.run(None, as_json=True, readme=readme)
    readme.write_text("<!-- papers -->\n<!-- /papers -->\n")
    with pytest.raises(SailnetError, match="whole table"):
        command.run("cart", as_json=True, readme=readme)


def test_nothing_is_solved_where_nothing_can_be_drawn(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def missing(module: str) -> None:
        raise SailnetError(f"no pictures here ({module}): pip install 'sailnet[report]'")

    part = Part("900", ("kite",), lambda: pytest.fail("computed"))
    monkeypatch.setattr(command, "PARTS", (part,))
    monkeypatch.setattr(command, "report", missing)
    assert cli.main(["papers", "--output", str(tmp_path)]) == 1
    assert "pip install" in capsys.readouterr().err


def test_a_folder_that_cannot_be_written(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setattr(command, "PARTS", (Part("900", ("kite",), list),))
    assert cli.main(["papers", "--output", str(tmp_path / "file")]) == 1
    said = capsys.readouterr().err
    assert "error: cannot write" in said
    assert "Errno" not in said


def _pid() -> list[Row]:
    return [replace(ROW, ours=float(os.getpid()), same=False)]


def _other_pid() -> list[Row]:
    time.sleep(0.2)
    return [replace(OTHER, ours=float(os.getpid()), same=False)]


@pytest.mark.slow
def test_workers_solve_side_by_side_and_keep_the_order(
    stage: Callable[..., None], capsys: pytest.CaptureFixture[str]
) -> None:
    stage(
        parts.Part("901", ("kite",), _other_pid),
        parts.Part("900", ("lost",), _stalled),
        parts.Part("900", ("cart",), _pid),
    )
    assert cli.main(["papers", "--json", "--workers", "2"]) == 1
    said = capsys.readouterr()
    rows = json.loads(said.out)
    assert [row["problem"] for row in rows] == ["kite", "cart, gain = 2"]
    assert os.getpid() not in [row["ours"] for row in rows]
    assert "error: paper 900, lost: shooting stalled; boundary residual 5.00e-01" in said.err
    assert cli.main(["papers", "--workers", "0"]) == 1
    assert "give at least 1" in capsys.readouterr().err


@pytest.mark.slow
def test_solutions_come_back_from_workers_whole() -> None:
    (row,) = pickle.loads(pickle.dumps(delta._asteroid()))
    solved = row.solved
    assert shooting.solve(solved.problem, solved.solution, options=shooting.Options(Exact())).converged


@pytest.mark.usefixtures("two_papers")
def test_a_log_is_told_what_is_done(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["papers", "--json"]) == 0
    assert capsys.readouterr().err.splitlines() == [
        "papers: 1 of 2, paper 900, cart, sled",
        "papers: 2 of 2, paper 901, kite",
    ]

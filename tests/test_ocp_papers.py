"""The table of the papers' figures: its forms, what makes the command fail, and the README's example."""

import inspect
import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from sailnet import cli
from sailnet.errors import SailnetError
from sailnet.ocp import ConvergenceError
from sailnet.ocp.papers import bbsr, command, delta, ponn
from sailnet.ocp.papers.row import Row

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
README = Path(__file__).parent.parent / "sailnet/ocp/README.md"


def _stalled() -> list[Row]:
    raise ConvergenceError("shooting stalled", {"boundary": 0.5})


@pytest.fixture
def stage(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Puts parts in the place of the papers' own."""

    def put(*parts: command.Part) -> None:
        monkeypatch.setattr(command, "PARTS", parts)

    return put


@pytest.fixture
def two_papers(stage: Callable[..., None]) -> None:
    stage(
        command.Part("900", ("cart", "sled"), lambda: [ROW, replace(ROW, problem="sled", printed="5")]),
        command.Part("901", ("kite",), lambda: [OTHER]),
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
    stage(command.Part("900", ("cart",), lambda: [ROW]), command.Part("901", ("kite",), _stalled))
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
    stage(command.Part("900", ("cart",), lambda: [OTHER, replace(ROW, **change)]))
    assert cli.main(["papers", "--json"]) == status
    said = capsys.readouterr()
    assert len(json.loads(said.out, parse_constant=pytest.fail)) == 2
    assert ("cart, gain = 2, t_f [s]" in said.err) == bool(status)
    assert "kite" not in said.err


def test_what_does_not_converge_costs_no_other_row(
    stage: Callable[..., None], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    stage(command.Part("900", ("cart",), _stalled), command.Part("901", ("kite",), lambda: [OTHER]))
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
    monkeypatch.setattr(command, "software", lambda: made)
    readme = tmp_path / "README.md"
    readme.write_text("before\n<!-- papers -->\nold\n<!-- /papers -->\nafter\n")
    folder = tmp_path / "new" / "papers"
    assert cli.main(["papers", "--json", "--output", str(folder), "--readme", str(readme)]) == 0
    assert json.loads((folder / "papers.json").read_text()) == json.loads(capsys.readouterr().out)
    table = (folder / "papers.md").read_text()
    assert "Written by `sailnet papers` on an abacus, 1999-12-31, revision abc." in table
    assert (
        "| cart, gain = 2 | t_f [s] | 2.01 | 2 | 2 (closed form) | paper in error | 0.25 |  "
        "| \\|a\\| is rounded |\n"
    ) in table
    assert readme.read_text() == (f"before\n<!-- papers -->\n{table.rstrip()}\n<!-- /papers -->\nafter\n")


def test_a_readme_is_looked_at_before_minutes_are_spent(stage: Callable[..., None], tmp_path: Path) -> None:
    stage(command.Part("900", ("cart",), lambda: pytest.fail("computed")))
    readme = tmp_path / "README.md"
    readme.write_text("no block\n")
    with pytest.raises(SailnetError, match="<!-- papers -->"):
        command.run(None, as_json=True, readme=readme)
    readme.write_text("<!-- papers -->\n<!-- /papers -->\n")
    with pytest.raises(SailnetError, match="whole table"):
        command.run("cart", as_json=True, readme=readme)


def test_every_function_that_gives_rows_is_in_the_table() -> None:
    listed = {part.rows for part in command.PARTS}
    inner = {bbsr.goddard_rows, ponn.fuel_rows}
    giving = {
        function
        for module in (bbsr, delta, ponn)
        for name, function in inspect.getmembers(module, inspect.isfunction)
        if inspect.get_annotations(function, eval_str=True).get("return") == list[Row]
        and not name.startswith("_")
    }
    assert inner < giving
    assert giving - inner <= listed


def test_a_real_row_through_the_table() -> None:
    rows = bbsr.goddard_rows(2.5)
    assert all(map(command.agree, rows))
    assert "2.024430e-01" in command.tables(rows)


def test_the_example_of_the_readme() -> None:
    found = re.search(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    assert found
    names: dict[str, Any] = {}
    exec(found[1], names)
    # By hand: full thrust one way for 1, the other way for 1.
    for solution in (names["limit"], names["check"]):
        assert solution.final_time == pytest.approx(2.0, abs=1e-9)
        assert [switch.time for switch in solution.switches] == pytest.approx([1.0], abs=1e-9)

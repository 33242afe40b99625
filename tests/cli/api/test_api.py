"""What ``import sailnet`` offers: names that are there, examples that run, results in units."""

import doctest
import importlib
import subprocess
import sys
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest

import sailnet
from sailnet import Evaluation, Flight, OptimalTransfer, SailnetError
from tests.paths import ROOT

mpl.use("agg")

CASE_2 = (1.05, 0.15, 1.03)


@pytest.fixture(scope="module")
def optimum() -> OptimalTransfer:
    return sailnet.solve("earth_mars", CASE_2)


@pytest.fixture(scope="module")
def flight() -> Flight:
    return sailnet.fly("earth_mars", CASE_2, beta_bias=-0.05, seed=3)


@pytest.fixture(scope="module")
def evaluation() -> Evaluation:
    return sailnet.evaluate("earth_mars", 12, optima=False, beta_spread=0.1)


@pytest.mark.slow
@pytest.mark.parametrize(
    "module",
    [
        "sailnet",
        "sailnet.cli.api.optimum",
        "sailnet.cli.api.flight",
        "sailnet.cli.api.evaluation",
        "sailnet.cli.api.exporting",
        "sailnet.dataset.reader",
    ],
)
def test_the_examples_of_the_docstrings_run(module: str) -> None:
    found = doctest.testmod(importlib.import_module(module))
    assert found.attempted > 0
    assert found.failed == 0


def test_every_name_that_is_offered_is_there_and_described() -> None:
    for name in sailnet.__all__:
        offered = getattr(sailnet, name)
        assert name == "__version__" or offered.__doc__
    assert set(dir(sailnet)) == set(sailnet.__all__)
    assert not hasattr(sailnet, "nothing")


def test_importing_it_loads_nothing_that_takes_time() -> None:
    code = "import sailnet, sys; print({'numpy', 'heyoka', 'h5py', 'pydantic'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


@pytest.mark.parametrize("wrong", [3, None])
def test_what_is_no_mission_is_said(wrong: object) -> None:
    with pytest.raises(SailnetError, match="by its name or the path of its file, not by"):
        sailnet.solve(wrong, CASE_2)  # type: ignore[arg-type]


@pytest.mark.slow
def test_an_optimum_prints_units_and_gives_a_table(optimum: OptimalTransfer) -> None:
    text = repr(optimum)
    assert "6.1551724 TU (357.815 days)" in text
    assert "AU/TU" in text
    path = sailnet.sample(optimum, 11)
    assert path["time"][-1] == pytest.approx(optimum.time_of_flight)
    assert np.array([path[name][0] for name in "ruv"]) == pytest.approx(CASE_2)
    assert "time        0 to 6.155172 TU" in repr(path)
    assert len(optimum.plot().axes) == 4


@pytest.mark.slow
def test_several_optima_are_a_table_and_a_sequence(optimum: OptimalTransfer) -> None:
    optima = sailnet.solve_states("earth_mars", [CASE_2, (1.05, 0.14, 1.03)])
    assert optima[0].time_of_flight == pytest.approx(optimum.time_of_flight)
    assert len(optima[-1:]) == 1
    assert optima[-1:][0].time_of_flight == optima[1].time_of_flight
    with pytest.raises(IndexError):
        optima[2]
    columns = optima.columns()
    assert columns["u"].tolist() == [0.15, 0.14]
    assert columns.units["lambda_v"] == "TU^2/AU"
    assert repr(optima).startswith("2 of 2 states solved\n")


@pytest.mark.slow
def test_a_flight_is_that_of_the_command_line(flight: Flight, capsys: pytest.CaptureFixture[str]) -> None:
    from sailnet.cli import main

    assert main(["fly", *map(str, CASE_2), "--beta-bias", "-0.05", "--seed", "3"]) == 0
    printed = capsys.readouterr().out
    assert repr(flight) in printed
    columns = flight.columns()
    assert columns["time"][1] == flight.mission.flight.period
    assert columns["beta"] == pytest.approx(0.95 * flight.mission.sail.beta)
    assert len(flight.plot().axes) >= 5


@pytest.mark.slow
def test_an_evaluation_has_a_row_a_flight(evaluation: Evaluation) -> None:
    columns = evaluation.columns()
    assert columns.rows == 12
    assert int(columns["arrived"].sum()) == evaluation.arrived.count
    assert np.isnan(columns["time_above_optimum"]).all()
    assert "95 % interval of that share" in repr(evaluation)
    with pytest.raises(SailnetError, match="optima=True"):
        evaluation.plot()


@pytest.mark.slow
def test_an_evaluation_with_optima_is_drawn() -> None:
    evaluation = sailnet.evaluate("earth_mars", 3)
    assert (evaluation.columns()["time_above_optimum"] < 0.02).all()
    (axes,) = evaluation.plot().axes
    assert sum(len(line.get_xdata()) for line in axes.get_lines()) == 3


@pytest.mark.slow
def test_what_cannot_be_flown_is_said() -> None:
    with pytest.raises(SailnetError, match="did you mean beta_bias"):
        sailnet.fly("earth_mars", CASE_2, beta_bia=0.1)
    with pytest.raises(SailnetError, match="evaluate flies many"):
        sailnet.fly("earth_mars", [CASE_2, CASE_2])


def test_without_torch_export_names_the_line_that_installs_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sailnet.cli.api.exporting.find_spec", lambda _: None)
    with pytest.raises(SailnetError, match=r"torch.*pip install -c constraints.txt -e '\.\[train\]'"):
        sailnet.export(tmp_path, tmp_path / "out")


def test_without_pandas_a_table_names_the_line_that_installs_it(monkeypatch: pytest.MonkeyPatch) -> None:
    from sailnet.artefacts.named_columns import NamedColumns

    monkeypatch.setattr("sailnet.artefacts.named_columns.find_spec", lambda _: None)
    with pytest.raises(SailnetError, match="pip install pandas"):
        NamedColumns({"time": ("TU", [0.0])}).to_frame()


def test_an_export_is_not_replaced_unasked(tmp_path: Path) -> None:
    (tmp_path / "SHA256SUMS").touch()
    with pytest.raises(SailnetError, match="overwrite=True"):
        sailnet.export(tmp_path, tmp_path)

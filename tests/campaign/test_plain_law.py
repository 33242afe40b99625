"""The plain law as a flight file: exported by a command, flown beside the law without being taken for it."""

import json
from pathlib import Path

import numpy as np
import pytest

from export.command import main as export_main
from sailnet.cli import main
from sailnet.flight.closed_loop import fly
from sailnet.guidance.backends import exported_digest, load_guidance
from sailnet.guidance.interface import FirstPlans
from sailnet.guidance.rules import PLAIN, RULES
from sailnet.guidance.with_rules import WithRules
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import load_mission
from tests.few_graphs import no_graphs
from tests.paths import ROOT

MISSION = load_mission("earth_mars")
SHIPPED = ROOT / "sailnet" / "shipped" / "earth_mars"
STARTS = [(1.05, 0.15, 1.03), (1.0, 0.0, 1.0), (1.1, 0.18, 0.93)]
ROUGH = Disturbance(beta_bias=-0.1, beta_noise=0.1, outage_probability=0.002, outage_duration=0.1, seed=6)


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """But for the graphs, which take long to make and know no law."""
    folder = tmp_path_factory.mktemp("plain")
    with pytest.MonkeyPatch.context() as patch:
        no_graphs(patch)
        assert export_main([str(SHIPPED), str(folder), "--plain-law"]) == 0
    return folder


def test_the_exported_c_is_the_plain_law(exported: Path) -> None:
    plain, shipped = load_guidance(MISSION, folder=exported), load_guidance(MISSION)
    assert isinstance(plain, FirstPlans)
    assert plain.arrival_directions(STARTS) is None
    assert isinstance(shipped, FirstPlans)
    assert shipped.arrival_directions(STARTS) is not None
    assert exported_digest(MISSION, exported) != exported_digest(MISSION)
    for disturbance in (Disturbance(), ROUGH):
        c, reference = (
            fly(MISSION, guidance, STARTS, disturbance=disturbance)
            for guidance in (plain, WithRules(plain, PLAIN))
        )
        np.testing.assert_allclose(c.time_of_flight, reference.time_of_flight, rtol=1e-9)
        np.testing.assert_array_equal(c.reversals, reference.reversals)
        assert c.reckoned.sum() == 0
    assert c.outages.sum() > 0


def test_what_the_law_flew_is_not_taken_for_the_plain_law_s(
    exported: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The flight files tell them apart."""
    file = tmp_path / "case.toml"
    file.write_text(
        'schema = 1\nname = "case"\ntitle = "Case"\noptima = 0\n'
        '[[series]]\nname = "a"\nstarts = [[1.05, 0.15, 1.03]]\n'
    )
    command = ["evaluate", "--campaign", str(file), "--json", "--output", str(tmp_path / "out")]
    assert main(command) == 0
    law = json.loads(capsys.readouterr().out)["scores"][0]["reversals"]["1"]
    assert main([*command, "--networks", str(exported)]) == 1
    assert "exported C: name another folder" in capsys.readouterr().err
    assert main([*command, "--networks", str(exported), "--overwrite"]) == 0
    assert json.loads(capsys.readouterr().out)["scores"][0]["reversals"]["1"] > law


@pytest.mark.exhaustive
def test_the_exported_c_is_told_how_the_sail_ages(
    tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As the reference of a mission that says so; in the median flight it gains nothing, see the campaign."""
    no_graphs(monkeypatch)
    folder = tmp_path_factory.mktemp("told")
    assert export_main([str(SHIPPED), str(folder), "--degradation", "0.3"]) == 0
    ages = Disturbance(degradation_loss=0.3)
    told, knows = load_guidance(MISSION, folder=folder), MISSION.with_degradation(0.3)
    by_c = fly(MISSION, told, STARTS, disturbance=ages)
    by_reference = fly(knows, WithRules(load_guidance(knows), RULES), STARTS)
    # Rounding decides where a plan's correction ends.
    np.testing.assert_allclose(by_c.time_of_flight, by_reference.time_of_flight, rtol=1e-6)
    unaware = fly(MISSION, load_guidance(MISSION), STARTS, disturbance=ages)
    assert (by_c.time_of_flight != unaware.time_of_flight).all()
    assert (by_c.arrived & unaware.arrived).all()

"""The delta method's table keeps what a search found."""

from dataclasses import replace

import pytest

from sailnet.ocp.solvers.delta import Fourier, GaPso
from sailnet.papers import delta_table


def test_the_table_keeps_what_a_search_found(monkeypatch: pytest.MonkeyPatch) -> None:
    heuristic = GaPso(population=20, flights=2)
    monkeypatch.setattr(delta_table, "HEURISTICS", [heuristic])
    monkeypatch.setattr(delta_table, "BASES", [Fourier()])
    monkeypatch.setattr(delta_table, "RESTARTS", 1)
    made = list(delta_table.entries(600, 1, problems=["lunar-landing"]))
    assert [one.method for one in made] == ["alone", "polished", "restarted"]
    alone, polished, restarted = made
    assert alone.evaluations == 600 < polished.evaluations
    assert restarted.evaluations <= 600
    assert alone.history[-1][1] <= alone.history[0][1]
    for one in (polished, restarted):
        assert one.converged
        assert one.end_error < 2e-6
        assert abs(one.cost_error) < 1e-5
        assert one.reference == pytest.approx(1.716681344829, rel=1e-9)
        assert one.switches == pytest.approx(one.reference_switches, abs=1e-4)
    again = delta_table.entry("lunar-landing", Fourier(), heuristic, "alone", 600, 0)
    assert again is not None
    assert replace(again, cpu_seconds=alone.cpu_seconds) == alone
    # What is known already is not searched for again.
    monkeypatch.setattr(delta_table, "entry", None)
    assert list(delta_table.entries(600, 1, made, ["lunar-landing"])) == made
    origin = {"machine": "a machine", "date": "today", "revision": "abc"}
    table = delta_table.markdown([replace(alone, converged=False), *made[1:]], origin)
    assert "on a machine, today, revision abc; 1 seeds." in table
    assert "| lunar-landing | GA-PSO | Fourier | 0 of 1, " in table
    assert table.count("1 of 1, ") == 2
    assert table.count(", 0 % |") >= 1
    assert table.rstrip().endswith("| 91.73 |")

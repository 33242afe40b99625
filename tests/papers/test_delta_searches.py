"""The delta method's searches: three methods, and nothing searched for twice."""

from dataclasses import replace

import pytest

from sailnet.ocp.solvers.delta import Fourier, GaPso
from sailnet.papers import delta_searches


@pytest.mark.slow
def test_three_methods_on_the_landing(monkeypatch: pytest.MonkeyPatch) -> None:
    heuristic = GaPso(population=20, flights=2)
    monkeypatch.setattr(delta_searches, "HEURISTICS", [heuristic])
    monkeypatch.setattr(delta_searches, "BASES", [Fourier()])
    monkeypatch.setattr(delta_searches, "RESTARTS", 1)
    made = list(delta_searches.entries(600, 1, problems=["lunar-landing"]))
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
    again = delta_searches.entry("lunar-landing", Fourier(), heuristic, "alone", 600, 0)
    assert again is not None
    assert replace(again, cpu_seconds=alone.cpu_seconds) == alone
    # What is known already is not searched for again.
    monkeypatch.setattr(delta_searches, "entry", None)
    assert list(delta_searches.entries(600, 1, made, ["lunar-landing"])) == made

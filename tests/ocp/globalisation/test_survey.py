"""Many random starts: the best extremal, and the one that must not be taken for it."""

import numpy as np
import pytest

from sailnet.ocp import ConvergenceError, Exact, L2Norm, Schedule, Solution, shooting, survey, switch_times
from sailnet.ocp.problems import intercept, reorientation


def exact(smooth: Solution) -> Solution:
    """The bang-bang extremal near a smoothed one."""
    problem = reorientation.problem()
    path = shooting.Options(L2Norm(), Schedule(0.1, 1e-4, 0.3), goal=1e-9)
    sharp = shooting.solve(problem, smooth, options=path)
    return shooting.solve(problem, sharp, options=shooting.Options(Exact()))


@pytest.mark.exhaustive
def test_first_reorientation_and_its_decoy() -> None:
    problem = reorientation.problem()
    starts = shooting.RandomCostates(1.0, seed=2, starts=30)
    found = survey.extremals(problem, starts, options=survey.Options(L2Norm(), 0.1))
    costs = [one.solution.cost for one in found]
    assert costs == sorted(costs)
    assert np.all(np.diff(costs) > 1e-6 * costs[0])
    assert 0 < sum(one.starts for one in found) <= 30
    best, decoy = (exact(one.solution) for one in found[:2])
    assert round(best.final_time, 3) == 2.479
    assert decoy.final_time == pytest.approx(2.4817, abs=5e-5)
    assert [switch.name for switch in best.switches] == ["S_1", "S_3", "S_1", "S_2", "S_3"]
    even = switch_times.solve(problem, best, options=switch_times.Options([1.0 / 3.0] * 6))
    assert even.final_time == pytest.approx(best.final_time, rel=1e-8)
    for one in (best, decoy):
        direct = switch_times.solve(problem, one)
        assert direct.final_time == pytest.approx(one.final_time, rel=1e-8)
        for ours, other in zip(direct.switches, one.switches, strict=True):
            assert (ours.name, ours.rising) == (other.name, other.rising)
            assert ours.time == pytest.approx(other.time, abs=1e-5)
        # The program's multipliers are the costates, which no equation of it mentions.
        np.testing.assert_allclose(direct.costate[0], one.costate[0], atol=1e-5)
        np.testing.assert_allclose(direct.hamiltonian, -1.0, atol=1e-6)
        assert direct.residuals["transversality"] < 1e-6
        np.testing.assert_allclose(one.hamiltonian, -1.0, atol=1e-9)


def test_no_start_that_converges_says_so() -> None:
    with pytest.raises(ConvergenceError, match=r"none of 1 random starts .*try more"):
        survey.extremals(
            intercept.problem(),
            shooting.RandomCostates(1e-9, starts=1),
            options=survey.Options(Exact(), 0.0, iterations=1),
        )

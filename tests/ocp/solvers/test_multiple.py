"""Multiple shooting where single shooting loses every digit."""

from dataclasses import replace

import numpy as np
import pytest

from sailnet.errors import SailnetError
from sailnet.ocp import (
    TIME,
    ConvergenceError,
    L2Norm,
    Schedule,
    collocation,
    multiple,
    shooting,
    switch_times,
)
from sailnet.ocp.problems import goddard, reorientation
from tests.ocp.posed import differences


@pytest.mark.exhaustive
def test_second_reorientation_has_no_digit_more() -> None:
    problem = reorientation.problem(three_torques=False)
    smooth = shooting.solve(problem, [-0.25, -2.16, -0.07, -2.22], options=shooting.Options(L2Norm(), 0.1))
    at_rho = collocation.solve(
        problem, smooth, options=collocation.Options(L2Norm(), Schedule(0.07, 9.66e-6, 0.7), tolerance=1e-4)
    )
    pieces = multiple.solve(problem, at_rho, options=multiple.Options(L2Norm(), 9.66e-6))
    assert pieces.final_time == pytest.approx(at_rho.final_time, rel=1e-8)
    assert pieces.final_time == pytest.approx(2.883892, abs=2e-6)
    limit = collocation.solve(
        problem, at_rho, options=collocation.Options(L2Norm(), Schedule(7e-6, 1e-7, 0.7), tolerance=1e-4)
    )
    direct = switch_times.solve(problem, limit)
    # A control that meets the end: no lower bound, so that the printed time is not the least.
    assert direct.residuals["boundary"] < 1e-12
    assert limit.final_time < direct.final_time < 2.8838915
    assert direct.final_time == pytest.approx(limit.final_time, rel=1e-7)


@pytest.mark.slow
def test_multiple_shooting_where_single_fails() -> None:
    problem = goddard.problem(3.5)
    path = Schedule(1.0, goddard.PRINTED_RHO, 0.5)
    smooth = collocation.solve(problem, options=collocation.Options(L2Norm(), path, final_tolerance=1e-8))
    with pytest.raises(ConvergenceError):
        shooting.solve(problem, smooth, options=shooting.Options(L2Norm(), goddard.PRINTED_RHO))
    pieces = multiple.solve(
        problem, smooth, options=multiple.Options(L2Norm(), goddard.PRINTED_RHO, pieces=80)
    )
    assert pieces.final_time == pytest.approx(smooth.final_time, rel=1e-7)
    assert pieces["h"][-1] == pytest.approx(smooth["h"][-1], rel=1e-9)
    # The smoothed control does not minimise H, which may therefore change by as much as rho.
    np.testing.assert_allclose(pieces.hamiltonian, 0.0, atol=goddard.PRINTED_RHO)
    assert abs(pieces.hamiltonian[-1]) < 1e-9
    assert np.all(np.diff(pieces.time) > 0.0)
    equations = multiple.Pieces(problem, L2Norm(), 4, 1e-13)
    z = equations.unknowns(smooth)
    _, jacobian = equations.linearise(z, 0.5)
    expected = differences(lambda at: equations.linearise(at, 0.5)[0], z, 1e-7)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-4, atol=1e-6 * np.abs(expected).max())


def test_a_problem_that_depends_on_time_is_refused() -> None:
    late = replace(goddard.problem(), running_cost=TIME)
    with pytest.raises(SailnetError, match="depends on time"):
        multiple.Pieces(late, L2Norm(), 2, 1e-9)

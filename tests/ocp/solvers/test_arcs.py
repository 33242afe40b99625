"""Arcs of known structure, bounds and singular ones."""

import numpy as np
import pytest

from sailnet.ocp import (
    Bounded,
    ConvergenceError,
    FreeTime,
    L2Norm,
    Problem,
    Schedule,
    Solution,
    arcs,
    collocation,
    shooting,
    symbols,
)
from sailnet.ocp.problems import earth_mars, goddard
from tests.ocp.posed import differences


def down_to(rho: float) -> collocation.Options:
    return collocation.Options(L2Norm(), Schedule(1.0, rho, 0.5))


TABLE_1 = [
    (1.5, 2.215761e-01, 1.009172, "+ -"),
    (2.5, 2.024430e-01, 1.012205, "+ s + -"),
    (3.5, 1.989015e-01, 1.012837, "+ s -"),
    (4.5, 1.977102e-01, 1.013105, "+ s -"),
]


@pytest.mark.slow
@pytest.mark.parametrize(("thrust", "time", "altitude", "structure"), TABLE_1)
def test_goddard_table_1(thrust: float, time: float, altitude: float, structure: str) -> None:
    problem = goddard.problem(thrust)
    path = Schedule(1.0, goddard.PRINTED_RHO, 0.5)
    printed = collocation.solve(problem, options=collocation.Options(L2Norm(), path, final_tolerance=1e-7))
    assert printed.final_time == pytest.approx(time, abs=6e-8)
    assert printed["h"][-1] == pytest.approx(altitude, abs=6e-7)
    limit = arcs.solve(problem, printed)
    assert limit.message == f"arcs {structure}"
    assert 0.0 < printed.final_time - limit.final_time < 9e-5
    assert limit["h"][-1] == pytest.approx(altitude, abs=6e-7)
    assert limit["h"][-1] > printed["h"][-1]
    np.testing.assert_allclose(limit.hamiltonian, 0.0, atol=1e-9)
    singular = 0
    for first, second in zip(limit.switches[:-1], limit.switches[1:], strict=True):
        middle = np.argmin(np.abs(limit.time - 0.5 * (first.time + second.time)))
        if -0.99 < limit["u"][middle] < 0.99:
            singular += 1
            h, v, m = limit.state[middle]
            # The singular surface.
            drag = 310 * v**2 * np.exp(500 * (1 - h))
            assert m / h**2 == pytest.approx((1 + v / goddard.EXHAUST_VELOCITY) * drag, rel=1e-8)
    assert singular == structure.count("s")


def test_arcs_have_the_exact_jacobian() -> None:
    problem = goddard.problem(2.5)
    smooth = collocation.solve(problem, options=down_to(1e-4))
    equations = arcs.Arcs(problem, ["+", "s", "+", "-"])
    z = np.concatenate([equations.ends.unknowns(smooth), [0.0497, 0.0612, 0.0811]])
    _, jacobian = equations.linearise(z)
    expected = differences(equations.residual, z, 1e-8)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-4, atol=1e-5 * np.abs(expected).max())


def test_arcs_refuse_a_root_that_the_law_would_not_fly() -> None:
    """An oscillator stopped in the least time: one arc less has a root too, whose S has the wrong sign."""
    x, v, u = symbols("x v u")
    problem = Problem(
        "oscillator",
        "",
        {x: v, v: u - x},
        [Bounded(u, -1.0, 1.0)],
        FreeTime(6.0),
        {x: 3.0, v: 0.0},
        {x: 0.0, v: 0.0},
        running_cost=1.0,
    )
    smooth = shooting.solve(
        problem, shooting.RandomCostates(), options=shooting.Options(L2Norm(), Schedule(1.0, 1e-2))
    )
    right = arcs.solve(problem, smooth)
    # By hand: half circles around (1, 0) and (-1, 0), the middle one whole, so the switches are pi apart.
    assert right.message == "arcs - + -"
    assert np.diff([switch.time for switch in right.switches]) == pytest.approx(np.pi, abs=1e-9)
    with pytest.raises(ConvergenceError, match="break the control law in between") as caught:
        arcs.solve(problem, smooth, options=arcs.Options([(0.0, "+"), (2.0, "-")]))
    assert caught.value.residuals["largest"] < 1e-10
    assert caught.value.residuals["law"] > 0.1


def test_arcs_that_do_not_meet_say_so() -> None:
    smooth = collocation.solve(goddard.problem(3.5), options=down_to(1e-3))
    wrong = arcs.Options([(0.0, "+"), (0.02, "-")], iterations=15)
    with pytest.raises(ConvergenceError, match=r"arcs \+ - on goddard: the guess itself fails"):
        arcs.solve(goddard.problem(3.5), smooth, options=wrong)
    with pytest.raises(ConvergenceError, match="do not meet; another structure may") as caught:
        arcs.solve(goddard.problem(3.5), smooth, options=arcs.Options(iterations=1))
    assert caught.value.residuals["largest"] > 1e-10


def test_arcs_of_a_transfer_are_its_limit(transfer: Solution) -> None:
    found = arcs.solve(earth_mars.problem(), transfer)
    assert found.message == "arcs + - + - +"
    assert found.cost == pytest.approx(transfer.cost, rel=1e-6)

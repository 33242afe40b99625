"""The direct method for bang-bang controls, against a cart by hand."""

from dataclasses import replace

import numpy as np
import pytest

from sailnet.errors import SailnetError
from sailnet.ocp import TIME, Bounded, ConvergenceError, FreeTime, Problem, Solution, switch_times, symbols
from sailnet.ocp.definition.solution import Switch
from sailnet.ocp.problems import goddard


def cart() -> Problem:
    """From rest at 1 to rest at 0, fastest: full thrust one way for 1, the other way for 1."""
    x, v, u = symbols("x v u")
    return Problem(
        name="cart",
        source="Pontryagin et al.",
        dynamics={x: v, v: u},
        controls=[Bounded(u, -1.0, 1.0)],
        final_time=FreeTime(3.0),
        initial={x: 1.0, v: 0.0},
        final={x: 0.0, v: 0.0},
        terminal_cost=TIME,
    )


def structure(*times: float, stop: float) -> Solution:
    """A guess of which nothing but the first sign, the switches and the end is read."""
    clock, empty = np.array([0.0, stop]), np.zeros((2, 0))
    switches = [Switch(time, "S", k % 2 == 0) for k, time in enumerate(times)]
    return Solution(
        "cart", "", clock, empty, empty, empty, np.array([[1.0], [-1.0]]), clock, stop, {}, switches
    )


@pytest.mark.parametrize("lengths", [None, [0.3, 2.0], [3.0, 0.1], [0.0, 5.0]])
def test_the_cart_by_hand(lengths: list[float] | None) -> None:
    guess = structure(0.8, stop=2.5)
    found = switch_times.solve(cart(), guess, options=switch_times.Options(lengths, samples=50))
    assert found.final_time == found.cost == pytest.approx(2.0, abs=1e-9)
    (switch,) = found.switches
    assert (switch.name, switch.rising) == ("S", True)
    assert switch.time == pytest.approx(1.0, abs=1e-8)
    np.testing.assert_allclose(found.state[-1], 0.0, atol=1e-9)
    np.testing.assert_array_equal(found["u"][[0, -1]], [-1.0, 1.0])
    # H = lambda_x v + lambda_v u = -1 from end to end, with lambda_v = 0 at the switch.
    np.testing.assert_allclose(found["lambda_x"], 1.0, atol=1e-7)
    np.testing.assert_allclose(found["lambda_v"], 1.0 - found.time, atol=1e-7)
    np.testing.assert_allclose(found["S"], found["lambda_v"], atol=1e-12)
    np.testing.assert_allclose(found.hamiltonian, -1.0, atol=1e-7)
    assert found.residuals["boundary"] < 1e-9
    assert found.residuals["transversality"] < 1e-7
    assert found.converged
    assert found.history[-1].residual == found.residuals["boundary"]
    assert len(found.time) >= 50


def test_arcs_of_no_length_are_no_switches() -> None:
    found = switch_times.solve(cart(), structure(0.5, 0.6, 1.4, stop=2.2))
    assert found.final_time == pytest.approx(2.0, abs=1e-8)
    assert [switch.rising for switch in found.switches] == [True]


def test_what_has_no_solution_says_so() -> None:
    with pytest.raises(ConvergenceError, match="do not meet the end; begin elsewhere") as caught:
        switch_times.solve(cart(), structure(stop=2.0))
    assert caught.value.residuals["boundary"] > 0.1
    with pytest.raises(SailnetError, match="lengths of 2 arcs"):
        switch_times.solve(cart(), structure(1.0, stop=2.0), options=switch_times.Options([1.0] * 3))


def test_problems_that_are_none_for_the_method() -> None:
    with pytest.raises(SailnetError, match="not of minimum time"):
        switch_times.SwitchTimes(goddard.problem(), np.ones(1), [0])
    x, v = cart().states
    for other in (
        replace(cart(), running_cost=v),
        replace(cart(), initial={x: 1.0}),
        replace(cart(), final={}, final_equations=[x]),
    ):
        with pytest.raises(SailnetError, match="not of minimum time"):
            switch_times.solve(other, structure(1.0, stop=2.0))

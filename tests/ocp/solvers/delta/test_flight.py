"""Flights under series, and the costates that fit them."""

import numpy as np

from sailnet.ocp import (
    Bounded,
    Problem,
    symbols,
)
from sailnet.ocp.solvers import delta
from sailnet.ocp.solvers.delta.controls import Controls
from sailnet.ocp.solvers.delta.flight import Flyer
from tests.ocp.solvers.delta.cases import double_integrator


def test_a_switch_within_an_interval_is_flown_as_if_at_a_node() -> None:
    # The mean of the throttle alone would leave an error of second order in the position.
    problem = double_integrator()
    controls = Controls(problem, delta.Legendre(), 2)
    flyer = Flyer(problem, controls)
    errors = []
    for share in (0.37, 0.61):
        # f_s falls through zero: first u = -1, then +1, from a series that begins negative.
        z = np.array([[1.0 - 2.0 * share, 1.0, 1.0]])
        time, switch = 1.7, share * 1.7
        left = time - switch
        exact = [1.0 + 0.5 * switch**2 + switch * left - 0.5 * left**2, switch - left]
        for count in (10, 20, 23):
            state = flyer.fly(z, np.linspace(0.0, 1.0, count + 1)).final_state[0]
            errors.append(np.abs(state - exact).max())
    assert max(errors) < 1e-12


def test_a_running_cost_of_the_state_drives_the_costate() -> None:
    x, u = symbols("x u")
    problem = Problem(
        name="ramp",
        source="x = t, so lambda' = -x gives (4 - t^2) / 2 + 3",
        dynamics={x: u},
        controls=[Bounded(u, -1.0, 1.0)],
        final_time=2.0,
        initial={x: 0.0},
        running_cost=0.5 * x**2,
        terminal_cost=3.0 * x,
    )
    flyer = Flyer(problem, Controls(problem, delta.Legendre(), 1))
    flights = flyer.fly(np.array([[-1.0]]), np.linspace(0.0, 1.0, 6))
    last, _ = flyer.final_costates(flights)
    costate = flyer.costates(flights, last)[0, :, :, 0, 0]
    np.testing.assert_allclose(costate, 5.0 - 0.5 * flights.time[0] ** 2, atol=1e-13)


def test_soft_switches_become_sharp() -> None:
    controls = Controls(double_integrator(), delta.Legendre(), 2)
    flyer = Flyer(double_integrator(), controls)
    z, s = np.array([[0.2, 1.0, 1.0]]), np.linspace(0.0, 1.0, 401)
    sharp = flyer.fly(z, s).final_state
    gaps = [np.abs(flyer.fly(z, s, softness).final_state - sharp).max() for softness in (0.5, 0.1, 0.02)]
    assert gaps == sorted(gaps, reverse=True)
    assert gaps[0] > 0.05
    assert gaps[-1] < 2e-3

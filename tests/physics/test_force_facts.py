"""What the optics of a sail amount to, by counting photons over a fine grid of cone angles."""

import math
from dataclasses import astuple

import numpy as np
import pytest

from sailnet.physics.force_facts import ForceFacts
from sailnet.physics.optics import OPTICS, Optics
from tests.photons import push

SAILS = {
    **OPTICS,
    "rough": Optics(0.8, 0.6, 0.1, 0.3, 0.7, 0.6),
    "white": Optics(0.95, 0.0, 0.4, 0.4, 0.6, 0.7),
}
BOUNDS = (60.0, 75.0, 89.0)


@pytest.mark.parametrize("name", SAILS)
def test_beyond_the_largest_useful_angle_the_transverse_force_falls(name: str) -> None:
    facts = ForceFacts.of(SAILS[name], ())
    grid = np.linspace(0.0, np.pi / 2.0, 900_001)
    transverse = push(astuple(SAILS[name]), grid)[1]
    assert facts.widest_useful == pytest.approx(grid[transverse.argmax()], abs=2e-6)
    assert facts.largest_transverse == pytest.approx(transverse.max(), rel=1e-11)


@pytest.mark.parametrize("name", SAILS)
@pytest.mark.parametrize("degrees", [0.0, 35.0, 60.0])
def test_the_force_leans_away_from_the_sun(name: str, degrees: float) -> None:
    angle = math.radians(degrees)
    radial, transverse = push(astuple(SAILS[name]), angle)
    normal, along = math.cos(angle), math.sin(angle)
    lean = math.atan2(radial * along - transverse * normal, radial * normal + transverse * along)
    assert ForceFacts.of(SAILS[name], ()).lean(angle) == pytest.approx(lean, abs=1e-14)
    assert (lean > 1e-3) == (name != "ideal" and degrees > 0.0)


@pytest.mark.parametrize("name", SAILS)
@pytest.mark.parametrize("degrees", BOUNDS)
def test_the_law_meets_a_bound_where_the_best_angle_does(name: str, degrees: float) -> None:
    """The best of all cone angles, for wanted directions halved until the bound takes over."""
    phi_max = math.radians(degrees)
    (met,) = ForceFacts.of(SAILS[name], (phi_max,)).at_bounds
    grid = np.linspace(0.0, phi_max, 40_001)
    radial, transverse = push(astuple(SAILS[name]), grid)
    inside, beyond = 0.0, math.pi
    for _ in range(40):
        theta = (inside + beyond) / 2.0
        best = int((math.cos(theta) * radial + math.sin(theta) * transverse).argmax())
        if best == len(grid) - 1:
            beyond = theta
        else:
            inside = theta
    best = int((math.cos(inside) * radial + math.sin(inside) * transverse).argmax())
    assert met.phi_max == phi_max
    assert met.takeover == pytest.approx(beyond, abs=1e-4)
    assert met.last == pytest.approx(grid[best], abs=1e-4)
    assert met.jumps == (grid[best] < phi_max - 1e-3)


def test_a_sail_that_gains_next_to_nothing_gains_most_within_a_degree_of_the_sun() -> None:
    """Its mirror hardly outweighs the heat of its back; its transverse force goes as sin cos (a cos - b)."""
    sail = Optics(0.25 + 2e-5, 1.0, 0.0, 1.0, 2 / 3, 2 / 3)
    a, b = 2.0 * sail.reflectivity, (1.0 - sail.reflectivity) * sail.back_lambertian
    # Where the derivative, 3 a cos^3 - 2 b cos^2 - 2 a cos + b, vanishes first.
    widest = math.acos(max(np.roots([3.0 * a, -2.0 * b, -2.0 * a, b]).real))
    assert 0.0 < math.degrees(widest) < 1.0
    facts = ForceFacts.of(sail, ())
    assert facts.widest_useful == pytest.approx(widest, rel=1e-6)
    assert facts.largest_transverse == pytest.approx(push(astuple(sail), widest)[1], rel=1e-6)


def test_a_sail_that_only_radiates_gains_nothing_by_turning() -> None:
    black = Optics(reflectivity=0.0)
    assert push(astuple(black), np.linspace(0.0, 1.5, 1000))[1].max() == 0.0
    facts = ForceFacts.of(black, (1.0,))
    assert (facts.widest_useful, facts.largest_transverse, facts.at_bounds) == (0.0, 0.0, ())

"""Optima of sails that are not ideal against a direct method that shares nothing but six coefficients.

CasADi and Ipopt know the force as tests.photons counts it, and nothing of Pontryagin. Constant controls in
equal intervals are slower than the best: by a share that falls with the mesh, and bounds the optimum from
above. Two meshes, one of them twice as fine, show how fast, and say what a mesh without end would find.
"""

import dataclasses

import numpy as np
import pytest

from sailnet.expert.fastest import solve
from sailnet.mission.mission import load_mission
from sailnet.physics.optics import OPTICS
from tests.direct import minimise

INTERVALS = (100, 200)

COARSE, FINE, EXTRAPOLATED = 1e-4, 3e-5, 5e-6
"""How much slower, relatively, the flights of the two meshes may be; and how far off their limit."""

EARTH = (1.0, 0.0, 1.0)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["jpl", "nasa"])
@pytest.mark.parametrize("title", ["earth_mars", "earth_venus"])
def test_a_direct_method_finds_the_same_transfer(title: str, name: str) -> None:
    transfer = load_mission(title).with_optics(OPTICS[name]).problem
    optimum = solve(transfer, EARTH).time_of_flight
    coarse, fine = (minimise(transfer, EARTH, intervals) for intervals in INTERVALS)
    assert min(coarse.agreeing, fine.agreeing) >= 3
    slower = np.array([coarse.time_of_flight, fine.time_of_flight]) / optimum - 1.0
    assert 0.0 < slower[1] < slower[0] < COARSE
    assert slower[1] < FINE
    assert abs(slower[1] - (slower[0] - slower[1]) / 3.0) < EXTRAPOLATED


@pytest.mark.exhaustive
def test_the_direct_method_tells_sails_apart() -> None:
    """JPL's sail and NASA's differ by 0.2 % in time: that agreement means something."""
    jpl = load_mission("earth_mars").with_optics(OPTICS["jpl"]).problem
    nasa = dataclasses.replace(jpl, optics=OPTICS["nasa"])
    assert minimise(nasa, EARTH).time_of_flight / solve(jpl, EARTH).time_of_flight - 1.0 > COARSE

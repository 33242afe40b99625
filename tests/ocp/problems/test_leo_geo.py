"""The transfer from LEO to GEO against the paper's equations, put right."""

import math

import numpy as np
import pytest

from sailnet.ocp.definition.functions import ProblemFunctions
from sailnet.ocp.problems import leo_geo


def test_transfer_is_equations_45_to_52_put_right() -> None:
    problem = leo_geo.minimum_fuel()
    rng = np.random.default_rng(0)
    p, ex, ey, hx, hy, longitude = rng.uniform(0.2, 0.6, 6)
    mass, phi, psi, on = 0.8, 0.3, -1.1, 0.7
    q, s, w = math.sin(phi), math.cos(phi) * math.cos(psi), math.cos(phi) * math.sin(psi)
    thrust, c = problem.parameters["T_max"] * on, problem.parameters["c"]
    sin, cos = math.sin(longitude), math.cos(longitude)
    z = 1.0 + ex * cos + ey * sin
    a1, a2, x = ex + (1.0 + z) * cos, ey + (1.0 + z) * sin, 1.0 + hx**2 + hy**2
    push, tilt = thrust / mass * math.sqrt(p) / z, hx * sin - hy * cos
    expected = [
        2.0 * thrust / mass * math.sqrt(p**3) * s / z,
        push * (z * sin * q + a1 * s - ey * tilt * w),
        push * (-z * cos * q + a2 * s + ex * tilt * w),
        push * x / 2.0 * cos * w,
        push * x / 2.0 * sin * w,
        math.sqrt(1.0 / p**3) * z**2 + push * tilt * w,
        -thrust / c,
    ]
    found = ProblemFunctions(problem).dynamics(0.0, [p, ex, ey, hx, hy, longitude, mass], [q, s, w, on])[0]
    np.testing.assert_allclose(found, expected, rtol=1e-13)
    # Eq. (53): a = 10000 km, e = 0.186, i = 25 deg, and a longitude of zero.
    begin = leo_geo.start()
    assert begin[0] * leo_geo.LENGTH == pytest.approx(10000.0 * (1.0 - 0.186**2))
    assert math.hypot(begin[1], begin[2]) == pytest.approx(0.186)
    assert 2.0 * math.degrees(math.atan(math.hypot(begin[3], begin[4]))) == pytest.approx(25.0)
    assert begin[5] == pytest.approx(0.0, abs=1e-15)

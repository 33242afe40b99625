"""Equinoctial motion against Cartesian motion."""

import heyoka as hy
import numpy as np

from sailnet.ocp import (
    symbols,
)
from sailnet.ocp.problems import (
    equinoctial,
)


def test_equinoctial_motion_is_cartesian_motion() -> None:
    elements = equinoctial.Elements.named()
    push = symbols("a_r a_t a_n")
    rates = equinoctial.motion(elements, push)
    compiled = hy.cfunc(list(rates.values()), vars=[*rates, *push])
    rng = np.random.default_rng(6)
    for _ in range(10):
        r, v, a = rng.normal(size=3), rng.normal(size=3), rng.normal(size=3)
        radial, normal = r / np.linalg.norm(r), np.cross(r, v) / np.linalg.norm(np.cross(r, v))
        frame = np.array([radial, np.cross(normal, radial), normal])
        at = equinoctial.from_position(r, v)
        back = equinoctial.to_position(at)
        np.testing.assert_allclose(np.concatenate(back), [*r, *v], rtol=1e-9, atol=1e-10)
        slope = np.array([*v, *(a - r / np.linalg.norm(r) ** 3)])
        step = 1e-6
        ahead, behind = (
            equinoctial.from_position(*np.split(np.array([*r, *v]) + h * slope, 2)) for h in (step, -step)
        )
        change = ahead - behind
        change[5] = (change[5] + np.pi) % (2 * np.pi) - np.pi
        np.testing.assert_allclose(compiled([*at, *(frame @ a)]), change / (2 * step), rtol=1e-4, atol=1e-5)

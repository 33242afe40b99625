"""The optimum that a flight is drawn beside: how far round the Sun it has gone."""

import numpy as np
import pytest

from sailnet.report.optimum import COLUMNS, COLUMNS_IN_SPACE, Optimum

TIME = np.linspace(0.0, 3.0, 31)


def of(columns: dict[str, str], **values: float) -> Optimum:
    """One whose columns are constant, those not given 0.3, which no other column may be taken for."""
    return Optimum(TIME, np.tile([values.get(name, 0.3) for name in columns], (len(TIME), 1)))


def test_in_the_plane_the_angle_grows_by_v_over_r() -> None:
    assert of(COLUMNS, r=2.0, v=0.8).angle == pytest.approx(0.4 * TIME)


def test_in_space_it_grows_the_faster_the_nearer_the_pole() -> None:
    there = of(COLUMNS_IN_SPACE, r=2.0, latitude=np.pi / 3, v=0.8)
    assert there.in_space
    assert there.angle == pytest.approx(0.8 * TIME)

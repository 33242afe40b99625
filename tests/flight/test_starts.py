"""Random starts of closed-loop flights."""

import numpy as np
import pytest

from sailnet.flight.starts import random_starts
from sailnet.mission.mission import load_mission

MISSION = load_mission("earth_mars")


def test_starts_fill_the_generalisation_set() -> None:
    region = MISSION.generalisation
    starts = random_starts(MISSION, 2000, seed=9)
    for column, (low, high) in enumerate((region.r, region.u, region.v)):
        values = (starts[:, column] - low) / (high - low)
        assert values.min() > 0.0
        assert values.max() < 1.0
        assert values.mean() == pytest.approx(0.5, abs=0.03)
        assert values.std() == pytest.approx(1 / np.sqrt(12), abs=0.01)
    np.testing.assert_array_equal(random_starts(MISSION, 5, seed=9, first=7), starts[7:12])

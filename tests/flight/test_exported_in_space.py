"""The exported C of three dimensions in the loop: called by the plant itself, or back through Python."""

import numpy as np
import pytest

from c_runtime.builds import BUILDS
from sailnet.flight.closed_loop import fly_recorded
from sailnet.flight.starts import random_starts
from sailnet.guidance.by_networks import NetworksInSpace
from sailnet.mission.disturbances import Disturbance
from sailnet.physics.arrays import Array
from tests.flight.test_plant import Indirect, same
from tests.guidance.space_export import MISSION, CInSpace, export_c
from tests.pilots_in_space import lasting
from tests.random_networks import random_guidance_in_space

pytestmark = pytest.mark.slow

DISTURBED = Disturbance(
    beta_spread=0.1,
    beta_noise=0.1,
    latitude_noise=1e-6,
    latitude_wander=1e-6,
    w_bias=1e-6,
    w_noise=1e-6,
    r_noise=1e-6,
    rate_limit=40.0,
    delay=0.007,
    resolution=1e-3,
    misalignment_spread=0.01,
    outage_probability=0.01,
    seed=3,
)


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> CInSpace:
    """Of random networks whose flights do not end at once everywhere."""
    return export_c(random_guidance_in_space(seed=3, mission=MISSION), tmp_path_factory.mktemp("space"))


def starts_of(exported: CInSpace) -> Array:
    """Where they say that it is far to go."""
    drawn = random_starts(MISSION, 400, 2)
    far = NetworksInSpace(exported.networks).command(drawn).time_of_flight > 0.5
    assert far.sum() > 20
    return drawn[far]


@pytest.mark.parametrize("build", ["f64", "f32"])
@pytest.mark.parametrize("disturbance", [Disturbance(), DISTURBED], ids=["nominal", "disturbed"])
def test_called_directly_or_back_through_python_is_one_flight(
    exported: CInSpace, build: str, disturbance: Disturbance
) -> None:
    guidance = exported.guidance(BUILDS[build])
    starts = starts_of(exported)
    flown = [
        fly_recorded(lasting(2.0), pilot, starts, disturbance=disturbance, period=0.01, first=9)
        for pilot in (guidance, Indirect(guidance))
    ]
    flights, histories = zip(*flown, strict=True)
    same(*flights)
    for one, other in zip(*histories, strict=True):
        for name, values in vars(one).items():
            np.testing.assert_array_equal(values, getattr(other, name), err_msg=name)
    assert np.median(flights[0].periods) > 10
    if disturbance is DISTURBED:
        assert flights[0].outages.sum() > 0
        assert flights[0].attitude_slew.sum() > 0.0


def test_it_flies_as_its_reference_in_numpy(exported: CInSpace) -> None:
    """Before roundings have grown: random networks steer wildly."""
    starts = starts_of(exported)
    pilots = exported.guidance(BUILDS["f64"]), NetworksInSpace(exported.networks)
    one, other = (
        fly_recorded(lasting(0.2), pilot, starts, disturbance=DISTURBED, period=0.01)[0].ends
        for pilot in pilots
    )
    np.testing.assert_allclose(one, other, rtol=0, atol=1e-9)

"""The law in three dimensions: the exported C, in every build, against the networks in NumPy."""

import ctypes
import dataclasses
import itertools
import subprocess
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from c_runtime.builds import BUILDS, Build
from c_runtime.shared_library import FLAGS, SHARED, find_compiler
from sailnet.errors import GuidanceError
from sailnet.guidance.facts import GuidanceFacts, round_down
from sailnet.guidance.interface import Commands, GuidanceStatus, Steered
from sailnet.networks.trained_domain import KNOTS, momentum_and_orbit, size_and_direction
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import target_of
from tests.guidance.space_export import MISSION, CInSpace, export_c
from tests.paths import ROOT
from tests.random_networks import STATE_MAX_IN_SPACE, STATE_MIN_IN_SPACE, random_guidance_in_space

LOW, HIGH = np.array(STATE_MIN_IN_SPACE), np.array(STATE_MAX_IN_SPACE)
TARGET = target_of(MISSION.problem, 5)
MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
BETA = MISSION.sail.beta
PHI_MAX = MISSION.problem.phi_max
BOUNDS = {"f64": (1e-12, 1e-12), "f32": (3e-6, 2e-5)}
"""Of differences: of angles [rad], and of times, relative. These weights are rougher than trained ones."""

every_build = pytest.mark.parametrize("build", BUILDS.values(), ids=BUILDS)
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> CInSpace:
    return export_c(random_guidance_in_space(), tmp_path_factory.mktemp("space"))


def kind_of(build: Build) -> type[np.floating]:
    return np.float64 if build.suffix == "f64" else np.float32


def some_sails(build: Build, count: int = 20_000) -> tuple[Array, Array]:
    """In the box, around it and near the target; rounded as the build rounds them."""
    rng = np.random.default_rng(1)
    states = rng.uniform(LOW - 0.05, HIGH + 0.05, (count, 5))
    near = 10.0 ** rng.uniform(-6, -1, (count // 4, 1)) * rng.uniform(-1.0, 1.0, (count // 4, 5))
    states[: count // 4] = TARGET + near
    states[count // 4 : count // 2, [1, 4]] *= 10.0 ** rng.uniform(-8, 0, (count // 4, 1))
    beta = BETA * rng.uniform(0.82, 1.18, count)
    kind = kind_of(build)
    return states.astype(kind).astype(float), beta.astype(kind).astype(float)


def apart(one: Array, other: Array) -> Array:
    """(n,) by how much clock angles differ [rad]."""
    return np.asarray(np.abs(np.angle(np.exp(1j * (one - other)))))


@every_build
def test_the_c_computes_what_the_networks_give(exported: CInSpace, build: Build) -> None:
    states, beta = some_sails(build)
    given, expected = exported.guidance(build).command(states, beta), exported.networks.command(states, beta)
    angle, time = BOUNDS[build.suffix]
    assert given.clock_angle is not None
    assert given.lambda_w is not None
    np.testing.assert_allclose(given.cone_angle, expected.cone_angle, rtol=0, atol=angle)
    np.testing.assert_allclose(given.time_of_flight, expected.time_of_flight, rtol=time, atol=0)
    np.testing.assert_allclose(given.lambda_v, expected.lambda_v, rtol=0, atol=angle)
    np.testing.assert_allclose(given.lambda_w, expected.lambda_w, rtol=0, atol=angle)
    # Where both costates are small, a rounding error of theirs turns the clock angle far.
    size = np.hypot(expected.lambda_v, expected.lambda_w)
    assert (apart(given.clock_angle, expected.clock_angle) * np.minimum(size, 1.0)).max() < 3.0 * angle
    assert np.ptp(given.clock_angle) > 6.0
    assert 0.0 <= given.cone_angle.min() < 0.01
    assert given.cone_angle.max() <= round_down(PHI_MAX, kind_of(build))
    assert set(np.unique(given.status)) == {0, 1, 2}


@every_build
def test_a_mirror_mirrors_every_command_to_the_bit(exported: CInSpace, build: Build) -> None:
    states, beta = some_sails(build)
    guidance = exported.guidance(build)
    north, south = guidance.command(states, beta), guidance.command(states * MIRROR, beta)
    assert north.clock_angle is not None
    off = north.clock_angle != 0.0
    assert off.mean() > 0.99
    assert_mirrored(south, north)


def assert_mirrored(south: Commands | Steered, north: Commands | Steered) -> None:
    for name in ("cone_angle", "time_of_flight", "lambda_v", "status"):
        np.testing.assert_array_equal(getattr(south, name), getattr(north, name))
    for name in ("clock_angle", "lambda_w"):
        np.testing.assert_array_equal(getattr(south, name), -getattr(north, name))


@every_build
def test_in_the_plane_there_is_no_way_out_of_it(exported: CInSpace, build: Build) -> None:
    states, beta = some_sails(build)
    states[:, [1, 4]] = np.where(np.arange(len(states))[:, None] % 2, 0.0, -0.0)
    command = exported.guidance(build).command(states, beta)
    assert command.clock_angle is not None
    assert command.lambda_w is not None
    assert not command.lambda_w.any()
    largest = largest_clock(build)
    expected = np.where(command.lambda_v > 0.0, largest, 0.0)
    np.testing.assert_array_equal(command.clock_angle, expected)
    assert 0.1 < (command.clock_angle > 0.0).mean() < 0.9


def largest_clock(build: Build) -> float:
    """The largest number of a build that is below pi."""
    kind = kind_of(build)
    return float(np.nextafter(kind(np.pi), kind(0.0)))


@every_build
def test_any_bits_give_a_bounded_command(exported: CInSpace, build: Build) -> None:
    rng, kind = np.random.default_rng(9), kind_of(build)
    word = np.uint64 if build.suffix == "f64" else np.uint32
    count = 50_000
    bits = rng.integers(0, np.iinfo(word).max, (count, 6), dtype=word, endpoint=True)
    numbers = bits.view(kind)
    numbers[::2] = np.where(
        rng.random((count // 2, 6)) < 0.5, rng.uniform(-1.0, 2.0, (count // 2, 6)), numbers[::2]
    )
    information = np.finfo(kind)
    special = [
        np.nan,
        np.inf,
        -np.inf,
        information.max,
        -information.max,
        information.smallest_subnormal,
        0.0,
        -0.0,
    ]
    places = list(itertools.product(range(6), special))
    for row, (place, value) in enumerate(places):
        numbers[row] = [1.2, 0.02, 0.1, 0.9, -0.03, BETA]
        numbers[row, place] = value
    states = numbers[:, :5]
    command = exported.guidance(build).command(states, numbers[:, 5])
    assert command.clock_angle is not None
    assert command.lambda_w is not None
    valid = np.isfinite(states).all(axis=1)
    assert 0.3 < valid.mean() < 1.0
    np.testing.assert_array_equal(command.status == GuidanceStatus.INVALID_INPUT, ~valid)
    for values in (command.time_of_flight, command.lambda_v, command.lambda_w):
        assert np.isfinite(values).all()
    assert 0.0 <= command.cone_angle.min() <= command.cone_angle.max() <= round_down(PHI_MAX, kind)
    assert -np.pi < command.clock_angle.min() <= command.clock_angle.max() <= np.pi
    for safe in (command.cone_angle, command.clock_angle, command.lambda_v, command.lambda_w):
        assert not safe[~valid].any()
    longest = exported.facts.largest_time_of_flight
    np.testing.assert_allclose(command.time_of_flight[~valid], longest, rtol=1e-6)


@every_build
def test_beyond_the_widened_box_nothing_changes(exported: CInSpace, build: Build) -> None:
    guidance = exported.guidance(build)
    middle = np.array([1.1, 0.0, 0.0, 0.9, 0.0])
    for component in range(5):
        outward = np.eye(5)[component]
        inside, near, far, absurd = (
            guidance.command([middle + step * outward]) for step in (0.0, HIGH[component] + 0.02, 1e3, 1e30)
        )
        assert inside.status != GuidanceStatus.OUTSIDE_DOMAIN
        assert near.status == far.status == absurd.status == GuidanceStatus.OUTSIDE_DOMAIN
        assert far.time_of_flight == absurd.time_of_flight != near.time_of_flight
        assert far.cone_angle == absurd.cone_angle


def with_tube(tmp_path: Path) -> CInSpace:
    """Of which the tube decides: bounds of its quantities that change from knot to knot."""
    plain = random_guidance_in_space(*[(4, 4)] * 4)
    rng = np.random.default_rng(4)
    states = rng.uniform(LOW, HIGH, (20_000, 5))
    values = np.hstack([size_and_direction(states, BETA, TARGET)[1], momentum_and_orbit(states)[1]])
    low, high = np.quantile(values, [0.02, 0.98], axis=0)
    room = 0.2 * (high - low)
    lower, upper = (edge + room * rng.uniform(-1.0, 1.0, (KNOTS, len(low))) for edge in (low, high))
    tube = {
        "size_step": 0.8,
        "momentum_min": 0.5,
        "momentum_step": 0.12,
        "lower": lower.tolist(),
        "upper": upper.tolist(),
    }
    tau = dataclasses.replace(plain.tau, provenance={**plain.tau.provenance, "domain": tube})
    return export_c(dataclasses.replace(plain, tau=tau), tmp_path)


def certain(facts: GuidanceFacts, states: Array, rounding: float) -> NDArray[np.bool_]:
    """(n,) where no rounding decides what is inside."""
    clear = np.abs(facts.domain.excess(states, BETA, facts.target_state)) > 100 * rounding
    box = np.array([facts.state_min, facts.state_max])
    clear &= np.abs(states[:, None] - box).min(axis=(1, 2)) > rounding
    clear &= np.abs(np.abs(states - facts.target_state) - facts.tolerances).min(axis=1) > rounding
    return np.asarray(clear)


def test_every_build_draws_the_same_line(tmp_path: Path) -> None:
    made = with_tube(tmp_path)
    rng = np.random.default_rng(5)
    states = rng.uniform(LOW - 0.02, HIGH + 0.02, (20_000, 5))
    states[:5000] = TARGET + 3.0 * made.facts.tolerances * rng.uniform(-1.0, 1.0, (5000, 5))
    for build in BUILDS.values():
        told = made.guidance(build).command(states).status == GuidanceStatus.OUTSIDE_DOMAIN
        kind = kind_of(build)
        expected = ~made.facts.contains(states.astype(kind), np.full(len(states), BETA, kind))
        sure = certain(made.facts, states, 1e-12 if build.suffix == "f64" else 1e-7)
        assert sure.mean() > 0.5
        assert 0.1 < told[5000:].mean() < 0.99
        assert 0.1 < told[:5000].mean() < 0.99
        np.testing.assert_array_equal(told[sure], expected[sure])


@pytest.mark.parametrize(
    "hidden",
    [
        pytest.param(((20, 20, 20), (8,), (16, 21, 3, 5), (7, 4)), id="other depths"),
        pytest.param(((2,),) * 4, id="fewer than inputs"),
    ],
)
def test_the_c_takes_any_hidden_sizes(hidden: tuple[tuple[int, ...], ...], tmp_path: Path) -> None:
    made = export_c(random_guidance_in_space(*hidden, seed=3), tmp_path)
    for build in (BUILDS["f64"], BUILDS["f64_host"]):
        states, beta = some_sails(build, 5000)
        given, expected = made.guidance(build).command(states, beta), made.networks.command(states, beta)
        np.testing.assert_allclose(given.cone_angle, expected.cone_angle, rtol=0, atol=1e-12)
        np.testing.assert_allclose(given.time_of_flight, expected.time_of_flight, rtol=1e-11)
        for name in ("lambda_v", "lambda_w"):
            np.testing.assert_allclose(getattr(given, name), getattr(expected, name), rtol=0, atol=1e-11)


def test_states_of_the_plane_are_refused(exported: CInSpace) -> None:
    with pytest.raises(GuidanceError, match=r"\(n, 5\) array of \(r, latitude, u, v, w\)"):
        exported.guidance(BUILDS["f64"]).command([[1.0, 0.0, 1.0]])


CLOCK = """
#include "tested.h"
void clock_angles(int n, const sailnet_real *x, const sailnet_real *y, sailnet_real *angle)
{
    for (int i = 0; i < n; i++) {
        angle[i] = sailnet_angle(&x[i], &y[i]);
    }
}
"""


@every_build
def test_the_clock_angle_is_an_arctangent_without_libm(
    exported: CInSpace, build: Build, tmp_path: Path
) -> None:
    (tmp_path / "clock.c").write_text(CLOCK)
    headers = [f"-I{exported.folder}", f"-I{ROOT / 'c_runtime' / 'verification'}"]
    command = [*find_compiler(), *FLAGS, *build.optimisation, *SHARED, *build.tested, *headers]
    subprocess.run([*command, "-o", tmp_path / "clock.so", tmp_path / "clock.c"], check=True)
    loaded = ctypes.CDLL(str(tmp_path / "clock.so"))
    kind, information = kind_of(build), np.finfo(kind_of(build))

    def clock(x: Array, y: Array) -> Array:
        along, north = np.ascontiguousarray(x, kind), np.ascontiguousarray(y, kind)
        angle = np.empty_like(along)
        loaded.clock_angles(len(along), *(ctypes.c_void_p(a.ctypes.data) for a in (along, north, angle)))
        return angle

    rng = np.random.default_rng(2)
    sizes = 10.0 ** rng.uniform(-30, 30, (2, 200_000))
    x, y = (sizes * rng.choice([-1.0, 1.0], sizes.shape)).astype(kind)
    turn = rng.uniform(-np.pi, np.pi, 200_000)
    x, y = np.append(x, np.cos(turn).astype(kind)), np.append(y, np.sin(turn).astype(kind))
    exact = np.arctan2(y.astype(np.longdouble), x.astype(np.longdouble))
    error = np.abs(clock(x, y) - exact) / np.maximum(np.abs(exact), information.tiny)
    assert error.max() < 4.0 * information.eps
    assert (np.abs(clock(x, y)) <= largest_clock(build)).all()
    np.testing.assert_array_equal(clock(x, -y), -clock(x, y))
    numbers = (0.0, information.smallest_subnormal, information.tiny, 1.0, information.max / 4)
    edge = [float(number) for number in numbers]
    x, y = np.array(list(itertools.product([*edge, *(-e for e in edge)], edge)), kind).T
    angles = clock(x, y)
    expected = np.arctan2(y.astype(float), x.astype(float) + 0.0)
    np.testing.assert_allclose(angles, expected, rtol=4.0 * float(information.eps), atol=edge[1])
    up = y > 0.0
    np.testing.assert_array_equal(clock(x, -y)[up], -angles[up])

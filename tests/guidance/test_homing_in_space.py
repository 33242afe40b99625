"""The model flown ahead out of the plane: plans of tilts end at the target, what would be missed is not."""

from dataclasses import replace

import numpy as np
import pytest

from sailnet import load_mission
from sailnet.flight.closed_loop import fly
from sailnet.guidance import homing
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.memory import ARCS
from sailnet.guidance.plans import LEAST_ARC, LEAST_TILT, Corrected, Correction
from sailnet.guidance.rules import rules_for
from sailnet.guidance.with_rules import WithRules
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from tests.guidance.before_the_target import before_the_target, sails_of

MISSION = load_mission("earth_venus_3d")
PLANAR = load_mission("earth_venus")
PHI_MAX = MISSION.problem.phi_max
HOMES = replace(rules_for(MISSION), homing=0.35)
HORIZON = HOMES.homing_horizon(MISSION.transfer.target_radius)
STEP = HORIZON / homing.STEPS
MIRROR, NORTH = np.array([1.0, -1.0, 1.0, 1.0, -1.0]), np.array([1.0, -1.0])


def correction(mission: Mission = MISSION) -> Correction:
    return Correction(mission, HORIZON, STEP)


def plans(count: int, seed: int) -> tuple[Array, Array]:
    """Tilts and times; the thrust of each goes to two directions, anywhere."""
    rng = np.random.default_rng(seed)
    cone, clock = rng.uniform(0.2, 0.8, (2, count)) * PHI_MAX, rng.uniform(-np.pi, np.pi, (2, count))
    pair = (cone[..., None] * np.stack([np.cos(clock), np.sin(clock)], axis=-1)).transpose(1, 0, 2)
    return np.repeat(pair, ARCS // 2, axis=1), np.full((count, ARCS), 2.0 * STEP)


def corrected(states: Array, tilts: Array, times: Array, rounds: int) -> list[Corrected]:
    steps = []
    for _ in range(rounds):
        steps.append(correction().of(states, tilts, times, sails_of(MISSION, len(states))))
        tilts, times = steps[-1].tilts, steps[-1].times
    return steps


def test_a_plan_beside_one_that_arrives_is_corrected_until_it_arrives() -> None:
    rng = np.random.default_rng(5)
    tilts, times = plans(16, 6)
    states = before_the_target(MISSION, tilts, times, 20)
    tilts = tilts + rng.uniform(-0.05, 0.05, tilts.shape)
    steps = corrected(states, tilts, times * rng.uniform(0.9, 1.1, times.shape), 12)
    assert (steps[0].missed > 1.0).sum() > 8
    assert (steps[-1].missed < 0.05).all()
    for step in steps:
        assert np.hypot(step.tilts[..., 0], step.tilts[..., 1]).max() <= PHI_MAX * (1.0 + 1e-15)
        assert (step.times >= LEAST_ARC).all()
    ends = states
    for k in range(ARCS):
        ends = sails_of(MISSION, 16).after(ends, steps[-1].tilts[:, k], steps[-1].times[:, k], 20)
    off = abs((ends - correction().target) * correction().lengths)
    assert off.max() < 0.1 * MISSION.flight.arrival_tolerance


def test_a_mirror_mirrors_how_plans_are_corrected() -> None:
    tilts, times = plans(8, 7)
    states = before_the_target(MISSION, tilts, times, 20) + np.array([1e-3, 2e-3, 0.0, -1e-3, 2e-3])
    north = corrected(states, tilts, times, 6)
    south = corrected(states * MIRROR, tilts * NORTH, times, 6)
    for one, other in zip(north, south, strict=True):
        # As far as small differences, which are all to the north, are derivatives.
        np.testing.assert_allclose(other.tilts * NORTH, one.tilts, rtol=0, atol=3e-3)
        np.testing.assert_allclose(other.times, one.times, rtol=0, atol=0.03 * STEP)
    assert abs(north[-1].tilts[..., 1] - tilts[..., 1]).max() > 0.03


def test_in_the_plane_a_plan_is_corrected_as_there() -> None:
    angles, times = np.repeat([[0.5, -0.4]], ARCS // 2, axis=1), np.full((1, ARCS), 2.0 * STEP)
    tilts = np.stack([angles, 0.0 * angles], axis=-1)
    states = before_the_target(MISSION, tilts, times, 20) + np.array([3e-3, 0.0, -2e-3, 4e-3, 0.0])
    one = correction().of(states, tilts, times, sails_of(MISSION, 1))
    other = correction(PLANAR).of(states[:, [0, 2, 3]], angles, times, sails_of(MISSION, 1))
    np.testing.assert_allclose(one.tilts[..., 0], other.tilts, rtol=0, atol=1e-3)
    np.testing.assert_allclose(one.times, other.times, rtol=0, atol=0.01 * STEP)
    assert abs(one.tilts[..., 1]).max() < 1e-3
    assert abs(other.tilts - angles).max() > 1e-2
    assert one.missed[0] == pytest.approx(other.missed[0])
    assert one.left[0] == pytest.approx(other.left[0], abs=1e-3)


def test_a_tilt_at_the_bound_still_turns_about_the_sun_line() -> None:
    """Where the target asks for another latitude, the clock angle changes though the cone angle cannot."""
    tilts, times = plans(8, 8)
    tilts *= PHI_MAX / np.hypot(tilts[..., 0], tilts[..., 1])[..., None]
    states = before_the_target(MISSION, tilts, times, 20) + np.array([0.0, 2e-3, 0.0, 0.0, 2e-3])
    now = corrected(states, tilts, times, 15)[-1]
    clock = np.arctan2(now.tilts[..., 1], now.tilts[..., 0]) - np.arctan2(tilts[..., 1], tilts[..., 0])
    at_bound = np.hypot(now.tilts[..., 0], now.tilts[..., 1]) > PHI_MAX - 1e-9
    assert (at_bound.sum(axis=1) > 0).all()
    assert (abs(np.sin(clock)) * at_bound).max(axis=1).min() > 1e-3
    assert (now.missed < 0.3).sum() > 4


def test_a_sail_that_faces_the_sun_has_no_direction_of_its_own() -> None:
    tilts, times = plans(4, 9)
    tilts[0], tilts[1], tilts[2, 0] = 0.0, 0.5 * LEAST_TILT, [0.0, -0.5 * LEAST_TILT]
    states = before_the_target(MISSION, tilts, times, 20) + np.array([0.0, 1e-3, 0.0, 2e-3, 1e-3])
    steps = corrected(states, tilts, times, 8)
    assert all(np.isfinite(step.tilts).all() for step in steps)
    assert (steps[0].missed > 1.0).all()
    assert (steps[-1].missed < 0.3).all()


def test_what_the_networks_would_miss_is_not_missed() -> None:
    low, high = MISSION.generalisation.corners_in_space
    starts = np.random.default_rng(11).uniform(low, high, (60, 5))
    guidance = load_guidance(MISSION)
    without, with_plans = (
        fly(MISSION, WithRules(guidance, replace(HOMES, homing=share)), starts) for share in (0.0, 0.35)
    )
    late = without.time_of_flight > 1.5 * with_plans.time_of_flight
    assert late.sum() >= 2
    assert with_plans.arrived.all()
    assert (with_plans.time_of_flight < 1.5 * without.time_of_flight).all()
    assert with_plans.time_of_flight.mean() < 0.98 * without.time_of_flight.mean()

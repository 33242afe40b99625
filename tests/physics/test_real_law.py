"""The law of a sail that is not ideal, by brute force; its extremals by energy and by differences."""

import dataclasses
import math

import numpy as np
import pytest

from sailnet.errors import SolveError
from sailnet.expert.shooting import shoot
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.optics import OPTICS, Optics
from sailnet.physics.pontryagin import evaluate_hamiltonian, guidance_law
from sailnet.physics.propagation import propagator
from sailnet.physics.real_law import RealLaw, force_curve
from sailnet.physics.transfer import Transfer, Transfers
from tests.reference import Array

BENDS = {"ideal": 90.0, "jpl": 79.748836, "nasa": 79.897959}
"""Cone angle [deg] beyond which the force curve bends inwards."""

DIRECTION = np.array([-20.81666, 7.31994, -45.17494])
"""Of Case 2, whose cone angle jumps once."""


def sail(name: str, degrees: float = 60.0) -> Transfer:
    return Transfer(0.16892, math.radians(degrees), 0.0, 1.524, OPTICS[name])


def push(angle: Array, name: str) -> tuple[Array, Array]:
    """The force per beta / r^2 as METHOD's formula has it, written out."""
    square, linear, across = OPTICS[name].force
    c, s = np.cos(angle), np.sin(angle)
    radial = c * (square * c**2 + linear * c + across * s**2)
    return radial, c * s * (square * c + linear - across * c)


@pytest.mark.parametrize("name", ["ideal", "jpl", "nasa"])
@pytest.mark.parametrize("degrees", [30.0, 60.0, 79.7488361, 79.75, 79.9, 80.0, 89.0, 90.0])
def test_the_law_minimises_the_hamiltonian(name: str, degrees: float) -> None:
    """At wide bounds the minimum jumps from an inner angle to the bound; of some bounds here, by a hair."""
    law = RealLaw.of(np.array([OPTICS[name].force]), math.radians(degrees))
    theta = np.random.default_rng(3).uniform(-np.pi, np.pi, 1000)
    lambda_u, lambda_v = -3.0 * np.cos(theta), -3.0 * np.sin(theta)
    grid = np.linspace(-law.phi_max, law.phi_max, 8001)
    radial, transverse = push(grid, name)
    least = (lambda_u[:, None] * radial + lambda_v[:, None] * transverse).min(axis=1)
    angle, bound = law.angle(lambda_u, lambda_v)
    radial, transverse = push(angle, name)
    assert (lambda_u * radial + lambda_v * transverse <= least + 1e-14).all()
    assert (np.abs(angle[bound]) == law.phi_max).all()
    slope = force_curve(angle, law.coefficients)[1]
    assert np.abs(lambda_u * slope[0] + lambda_v * slope[1])[~bound].max() < 1e-14
    assert bound.any() == (law.takeover[0] < 3.14)
    assert (law.last[0] < law.phi_max) == (degrees > BENDS[name])


@pytest.mark.parametrize("degrees", [39.0, 45.0, 60.0])
def test_a_sail_that_its_heat_pushes_back_is_best_turned_the_other_way_at_the_bound(degrees: float) -> None:
    """From 38.9 degrees on; below 50 its force curve does not bend inwards anywhere."""
    law = RealLaw.of(np.array([Optics(0.3, 1.0, 0.0, 1.0, 2 / 3, 2 / 3).force]), math.radians(degrees))
    theta = np.random.default_rng(6).uniform(0.0, np.pi, 1000)
    lambda_u, lambda_v = -np.cos(theta), -np.sin(theta)
    radial, transverse = force_curve(np.linspace(-law.phi_max, law.phi_max, 8001), law.coefficients)[0]
    least = (lambda_u[:, None] * radial + lambda_v[:, None] * transverse).min(axis=1)
    angle, bound = law.angle(lambda_u, lambda_v)
    radial, transverse = force_curve(angle, law.coefficients)[0]
    assert (lambda_u * radial + lambda_v * transverse <= least + 1e-14).all()
    assert bound.any()
    assert (angle[bound] == -law.phi_max).all()
    assert (angle[~bound] >= 0.0).all()


def test_the_ideal_law_is_eq_11() -> None:
    theta = np.linspace(-3.1, 3.1, 101)
    lambda_u, lambda_v = -np.cos(theta), -np.sin(theta)
    exact = guidance_law(sail("ideal"), lambda_u, lambda_v)
    law = RealLaw.of(np.array([OPTICS["ideal"].force]), math.radians(60.0))
    np.testing.assert_allclose(law.angle(lambda_u, lambda_v)[0], exact, rtol=0, atol=1e-14)


def test_a_real_sail_has_no_smoothed_law() -> None:
    with pytest.raises(SolveError, match=r"delta must be 0, not 0\.001"):
        dataclasses.replace(sail("jpl"), delta=1e-3)


@pytest.mark.parametrize("degrees", [60.0, 89.0, 89.9])
def test_the_hamiltonian_is_zero_along_extremals(degrees: float) -> None:
    transfer = sail("jpl", degrees)
    directions = DIRECTION * np.random.default_rng(1).uniform(0.8, 1.2, (20, 3))
    costates = directions / -arrival_gain(transfer, directions)[:, None]
    states = propagate_extremals(transfer, costates, np.linspace(0.0, 8.0, 81)).states
    assert np.isfinite(states).all()
    x = states.reshape(-1, 6)
    alpha = guidance_law(transfer, x[:, 4], x[:, 5])
    energy = evaluate_hamiltonian(transfer, x[:, :3], x[:, 3:], alpha)
    assert np.abs(energy).max() < 1e-10
    used = np.unique(np.abs(alpha) == transfer.phi_max)
    assert len(used) == 2  # inside the bound and at it


def test_mirrored_costates_turn_the_sail_the_other_way() -> None:
    transfer = sail("nasa")
    lambda_u, lambda_v = np.random.default_rng(2).normal(size=(2, 200))
    there, back = guidance_law(transfer, lambda_u, lambda_v), guidance_law(transfer, lambda_u, -lambda_v)
    np.testing.assert_array_equal(there, -back)
    assert guidance_law(transfer, 0.0, 0.0) == guidance_law(transfer, -0.0, -0.0) == 0.0
    rows = np.column_stack([np.zeros(200), lambda_u, lambda_v])
    np.testing.assert_allclose(
        arrival_gain(transfer, rows), arrival_gain(transfer, rows * [1.0, 1.0, -1.0]), rtol=1e-14
    )


@pytest.mark.slow
@pytest.mark.parametrize(("degrees", "duration"), [(60.0, 4.0), (60.0, 12.0), (89.0, 12.0), (89.9, 12.0)])
def test_the_tangents_are_derivatives_across_every_event(degrees: float, duration: float) -> None:
    transfer = sail("jpl", degrees)
    costates = DIRECTION / -arrival_gain(transfer, DIRECTION[None])[0]
    engine = propagator(transfer, variational=True)
    along = np.random.default_rng(5).normal(size=(3, 2))
    tangents = np.zeros((6, 2, engine.lanes))
    tangents[3:] = along[:, :, None]
    start = np.array([*transfer.target_state, *costates])
    engine.start(transfer, np.tile(start[:, None], engine.lanes), tangents)
    engine.integrator.propagate_until([duration] * engine.lanes)
    found = engine.tangents()[:, :, 0]
    assert engine.jumps[0] == (1 if duration > 10.0 else 0)
    step = 2e-5
    moved = np.concatenate([costates + step * along.T, costates - step * along.T])
    ends = propagate_extremals(transfer, moved, [0.0, duration]).states[:, 1]
    expected = (ends[:2] - ends[2:]).T / (2 * step)
    scale = np.abs(expected).max(axis=1, keepdims=True)
    np.testing.assert_allclose(found / scale, expected / scale, rtol=0, atol=2e-5)


def test_every_row_may_have_optics_of_its_own() -> None:
    names = ["nasa", "jpl", "ideal", "jpl"]
    force = np.array([OPTICS[name].force for name in names])
    beta = 0.16892 * np.array([1.0, 0.9, 1.1, 1.2])
    together = Transfers(sail("ideal"), beta, RealLaw.of(force, math.radians(60.0)))
    directions = np.tile(DIRECTION, (4, 1))
    costates = directions / -arrival_gain(together, directions)[:, None]
    found = propagate_extremals(together, costates, [0.0, 5.8])
    shots = shoot(together, found.states[:, 1, :3], directions + 0.02, np.full(4, 5.78))
    assert shots.residual.max() <= 1e-10
    for row, name in enumerate(names):
        own = dataclasses.replace(sail(name), beta=float(beta[row]))
        alone = propagate_extremals(own, costates[row], [0.0, 5.8])
        np.testing.assert_allclose(alone.states[0], found.states[row], rtol=1e-9, atol=1e-9)
        assert shots.tau[row] == pytest.approx(5.8, abs=1e-8)

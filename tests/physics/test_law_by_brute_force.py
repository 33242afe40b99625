"""The law of the cone angle against angles that are tried, and the force against photons that are counted."""

import math
from dataclasses import astuple, replace

import numpy as np
import pytest

from sailnet.errors import SolveError
from sailnet.physics.optics import OPTICS, Optics
from sailnet.physics.pontryagin import evaluate_hamiltonian, guidance_law
from sailnet.physics.transfer import Transfer
from tests.photons import best_angle, push
from tests.reference import Array

BOUNDS = (30.0, 60.0, 89.0, 89.8, 90.0)
"""Cone angles [deg]; as many again are drawn. Beyond 89.65 the end of JPL's curve is across the Sun line."""

COUNT = 1250
"""Costates for every sail and bound: 100,000 for the eight sails."""

PLAIN = Transfer(0.16892, math.pi / 3, 0.0, 1.524)

DRAWN = (
    Optics(0.846, 0.734, 0.132, 0.478, 0.683, 0.521),
    Optics(0.655, 0.291, 0.617, 0.384, 0.942, 0.236),
    Optics(0.748, 0.443, 0.209, 0.905, 0.017, 0.304),
    Optics(0.307, 0.958, 0.822, 0.114, 0.405, 0.771),
    Optics(0.0, 0.5, 0.6, 0.1, 0.7, 0.4),
)
"""Anything that light pushes and that has a law, down to a sail that reflects nothing."""

SAILS = {**OPTICS, **{f"drawn {row}": optics for row, optics in enumerate(DRAWN)}}


def takeover(optics: Optics, phi_max: float) -> float:
    """The angle of -(lambda_u, lambda_v) from the Sun line at which the best angle gets to the bound."""
    low, high = 0.0, math.pi
    for _ in range(10):
        theta = np.linspace(low, high, 41)
        best = best_angle(astuple(optics), phi_max, -np.cos(theta), -np.sin(theta))
        first = int(np.argmax(np.append(np.abs(best) > phi_max - 1e-6, True)))
        low, high = theta[max(first - 1, 0)], theta[min(first, 40)]
    return high


def costates(optics: Optics, phi_max: float, rng: np.random.Generator) -> tuple[Array, Array]:
    """lambda_u and lambda_v everywhere, near both jumps of the command and on the Sun line; any size."""
    everywhere = rng.uniform(-np.pi, np.pi, COUNT - 450)
    sides = rng.choice([-1.0, 1.0], (2, 200))
    near = takeover(optics, phi_max) + sides[0] * 10.0 ** rng.uniform(-14.0, -1.0, 200)
    theta = np.concatenate([everywhere, sides[1] * near])
    size = 10.0 ** rng.uniform(-6.0, 6.0, COUNT)
    lambda_u = np.concatenate([-np.cos(theta), rng.choice([-1.0, 1.0], 250)])
    almost = rng.choice([-1.0, 1.0], 150) * 10.0 ** rng.uniform(-300.0, -3.0, 150)
    lambda_v = np.concatenate([-np.sin(theta), almost, np.copysign(0.0, rng.normal(size=100))])
    return size * lambda_u, size * lambda_v


@pytest.mark.slow
@pytest.mark.parametrize("name", SAILS)
def test_no_angle_makes_the_hamiltonian_less(name: str) -> None:
    optics, rng = SAILS[name], np.random.default_rng([*name.encode()])
    sail, count = astuple(optics), 0
    for degrees in (*BOUNDS, *rng.uniform(30.0, 90.0, len(BOUNDS))):
        transfer = replace(PLAIN, phi_max=math.radians(degrees), optics=optics)
        lambda_u, lambda_v = costates(optics, transfer.phi_max, rng)
        alpha = guidance_law(transfer, lambda_u, lambda_v)
        best = best_angle(sail, transfer.phi_max, lambda_u, lambda_v)
        assert (np.abs(alpha) <= transfer.phi_max).all()

        def share(angle: Array, at: tuple[Array, Array] = (lambda_u, lambda_v)) -> Array:
            radial, transverse = push(sail, angle)
            return np.asarray(at[0] * radial + at[1] * transverse)

        # Per beta / r^2 and the costates' size: as small as rounding lets any two of the values be.
        size = np.hypot(lambda_u, lambda_v)
        assert (share(alpha) - share(best) <= 3e-15 * size).all()
        r, u, v = rng.uniform((0.3, -0.3, 0.5), (3.0, 0.3, 1.5), (COUNT, 3)).T
        lambda_r = size * rng.normal(size=COUNT)
        terms = np.array(
            [
                np.ones(COUNT),
                lambda_r * u,
                lambda_u * (v**2 / r - 1.0 / r**2) - lambda_v * u * v / r,
                transfer.beta / r**2 * share(best),
            ]
        )
        found = evaluate_hamiltonian(
            transfer, np.column_stack([r, u, v]), np.column_stack([lambda_r, lambda_u, lambda_v]), alpha
        )
        assert (np.abs(found - terms.sum(axis=0)) <= 1e-12 * np.abs(terms).max(axis=0)).all()
        # H hardly changes with an angle that is a little off, its derivative does: by a complex step.
        inside = np.abs(alpha) < transfer.phi_max * (1.0 - 1e-12)
        radial, transverse = push(sail, alpha[inside] + 1e-30j)
        slope = (lambda_u[inside] * radial.imag + lambda_v[inside] * transverse.imag) / 1e-30
        assert (np.abs(slope) <= 1e-13 * size[inside]).all()
        count += len(alpha)
    assert count == 100_000 // len(SAILS)


@pytest.mark.slow
def test_a_sail_without_a_law_is_one_that_heat_pushes_back() -> None:
    """Any six shares: the law is right, or there is none, since the best angles are of the wrong sign."""
    rng = np.random.default_rng(7)
    theta = np.linspace(1e-3, np.pi - 1e-3, 600)  # such angles may be the best in a narrow range alone
    lambda_u, lambda_v = -np.cos(theta), -np.sin(theta)
    refused = 0
    for shares in rng.uniform(size=(200, 6)):
        optics, phi_max = Optics(*shares.tolist()), math.radians(rng.uniform(30.0, 90.0))
        best = best_angle(astuple(optics), phi_max, lambda_u, lambda_v)
        try:
            alpha = guidance_law(replace(PLAIN, phi_max=phi_max, optics=optics), lambda_u, lambda_v)
        except SolveError:
            assert ((best < -1e-6) & (best > -phi_max + 1e-6)).any()
            refused += 1
            continue
        tried, found = (np.array(push(astuple(optics), angle)) for angle in (best, alpha))
        assert (lambda_u * (found - tried)[0] + lambda_v * (found - tried)[1] <= 3e-15).all()
    assert 0 < refused < 40

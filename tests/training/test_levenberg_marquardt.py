"""The trainer's derivatives against automatic differentiation, and its convergence."""

import math
from itertools import pairwise

import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st
from torch import Tensor
from torch.func import jacrev, jvp

from training import levenberg_marquardt
from training.layers import Layers, augment, forward
from training.least_squares import LeastSquares
from training.levenberg_marquardt import Iterate, advance, begin

# More threads only wait for each other on matrices this small.
torch.set_num_threads(1)

WIDTHS = st.lists(st.integers(1, 5), min_size=2, max_size=4)


def _problem(layers: Layers, samples: int, chunk: int = 7, seed: int = 0) -> LeastSquares:
    generator = torch.Generator().manual_seed(seed)
    inputs = torch.rand(layers.widths[0], samples, generator=generator, dtype=torch.float64)
    targets = torch.rand(samples, generator=generator, dtype=torch.float64)
    factors = None
    if layers.widths[-1] > 1:
        factors = torch.randn(layers.widths[-1], samples, generator=generator, dtype=torch.float64)
    return LeastSquares.of(layers, inputs, targets, chunk, factors)


def _random(layers: Layers, seed: int) -> Tensor:
    return torch.randn(layers.parameters, generator=torch.Generator().manual_seed(seed), dtype=torch.float64)


def _plain_outputs(layers: Layers, inputs: Tensor, parameters: Tensor) -> Tensor:
    """The textbook network, on (k, n) inputs, for automatic differentiation."""
    layer = inputs
    matrices = layers.matrices(parameters)
    for matrix in matrices[:-1]:
        layer = torch.sigmoid(matrix[:, :-1] @ layer + matrix[:, -1:])
    return matrices[-1][:, :-1] @ layer + matrices[-1][:, -1:]


@pytest.mark.slow
@settings(deadline=None, max_examples=20)
@given(widths=WIDTHS, outputs=st.integers(1, 3), samples=st.integers(1, 40), seed=st.integers(0, 99))
def test_derivatives_equal_automatic_differentiation(
    widths: list[int], outputs: int, samples: int, seed: int
) -> None:
    layers = Layers((*widths, outputs))
    problem = _problem(layers, samples, seed=seed)
    parameters = _random(layers, seed)

    def residual(at: Tensor) -> Tensor:
        outputs = _plain_outputs(layers, problem.inputs[:-1], at)
        return (problem.factors * outputs).sum(dim=0) - problem.targets

    jacobian = jacrev(residual)(parameters)
    errors = residual(parameters)
    gradient, loss = problem.gradient(parameters)
    assert loss == pytest.approx(float(errors @ errors) / samples, rel=1e-12)
    assert problem.loss(parameters) == pytest.approx(loss, rel=1e-12)
    torch.testing.assert_close(gradient, jacobian.T @ errors / samples, rtol=1e-10, atol=1e-12)
    torch.testing.assert_close(
        problem.curvature(parameters).tril(), (jacobian.T @ jacobian / samples).tril(), rtol=1e-10, atol=1e-12
    )

    direction = _random(layers, seed + 1)

    def slope(at: Tensor) -> Tensor:
        change: Tensor = jvp(residual, (at,), (direction,))[1]
        return change

    second = jvp(slope, (parameters,), (direction,))[1]
    torch.testing.assert_close(
        problem.bend(parameters, direction), jacobian.T @ second / samples, rtol=1e-9, atol=1e-11
    )


@pytest.mark.slow
@settings(deadline=None, max_examples=20)
@given(chunk=st.integers(1, 300))
def test_chunks_change_nothing_but_rounding(chunk: int) -> None:
    layers = Layers((3, 6, 5, 1))
    whole, cut = _problem(layers, 211, chunk=1000), _problem(layers, 211, chunk=chunk)
    parameters = _random(layers, 1)
    torch.testing.assert_close(cut.curvature(parameters), whole.curvature(parameters), rtol=1e-12, atol=1e-14)
    torch.testing.assert_close(
        cut.gradient(parameters)[0], whole.gradient(parameters)[0], rtol=1e-12, atol=1e-14
    )
    assert cut.loss(parameters) == pytest.approx(whole.loss(parameters), rel=1e-13)


def test_blocks_walk_through_all_samples() -> None:
    problem = _problem(Layers((2, 3, 1)), 60)
    seen = torch.cat([problem.block(number, 20).targets for number in range(3)])
    assert torch.equal(seen, problem.targets)
    assert torch.equal(problem.block(3, 20).targets, problem.block(0, 20).targets)
    assert problem.block(5, 60) is problem


def _representable(layers: Layers, samples: int) -> tuple[LeastSquares, Tensor]:
    teacher = _random(layers, 5)
    inputs = _problem(layers, samples).inputs[:-1]
    return LeastSquares.of(layers, inputs, _plain_outputs(layers, inputs, teacher)[0], 64), teacher


def test_convergence_is_quadratic_where_the_target_is_representable() -> None:
    layers = Layers((2, 3, 1))
    problem, teacher = _representable(layers, 200)
    nearby = teacher + 0.03 * _random(layers, 0)
    at = Iterate(nearby, torch.zeros_like(nearby), 1e-13, 0, problem.loss(nearby))
    errors = [math.sqrt(at.loss)]
    while errors[-1] > 1e-12:
        following = advance(problem, at, problem.samples)
        assert following is not None
        at = following
        errors.append(math.sqrt(at.loss))
    # The constant is set by the conditioning; linear convergence would soon break any.
    assert 3 <= len(errors) <= 5
    assert all(after < 3e3 * before**2 for before, after in pairwise(errors))


def test_training_from_scratch_recovers_a_representable_function() -> None:
    layers = Layers((2, 4, 1))
    problem, _ = _representable(layers, 400)
    at = begin(problem, layers.initial(3))
    losses = [at.loss]
    # J^T J from a quarter of the samples at a time: the minimum must not depend on that.
    for _ in range(150):
        following = advance(problem, at, 100)
        if following is None or following.loss < 1e-16:
            break
        at = following
        losses.append(at.loss)
    assert losses == sorted(losses, reverse=True)
    assert losses[-1] < 1e-6 * losses[0]


def test_a_minimum_is_recognised() -> None:
    layers = Layers((2, 3, 1))
    problem, teacher = _representable(layers, 50)
    assert problem.loss(teacher) < 1e-30
    exact = LeastSquares.of(layers, problem.inputs[:-1], problem.value(teacher))
    assert advance(exact, begin(exact, teacher), 50) is None


def test_start_is_set_by_the_seed_and_spreads_the_neurons() -> None:
    layers = Layers((3, 20, 20, 1))
    assert torch.equal(layers.initial(4), layers.initial(4))
    assert not torch.equal(layers.initial(4), layers.initial(5))
    inputs = torch.rand(3, 500, generator=torch.Generator().manual_seed(0), dtype=torch.float64)
    activations, _ = forward(layers.matrices(layers.initial(4)), augment(inputs))
    for layer in activations[1:]:
        spread = layer[:-1].std(dim=1)
        assert float(spread.median()) > 0.02


@pytest.mark.cuda
@pytest.mark.skipif(not torch.cuda.is_available(), reason="no CUDA device")
def test_cuda_takes_the_same_steps() -> None:
    layers = Layers((3, 8, 8, 1))
    on_cpu = _problem(layers, 500, chunk=128)
    on_cuda = LeastSquares.of(layers, on_cpu.inputs[:-1].cuda(), on_cpu.targets.cuda(), 128)
    start = layers.initial(0)
    here, there = begin(on_cpu, start), begin(on_cuda, start.cuda())
    for _ in range(5):
        one, other = advance(on_cpu, here, 250), advance(on_cuda, there, 250)
        assert one is not None
        assert other is not None
        here, there = one, other
    assert there.loss == pytest.approx(here.loss, rel=1e-6)
    torch.testing.assert_close(there.parameters.cpu(), here.parameters, rtol=1e-5, atol=1e-7)


@pytest.mark.parametrize(("damping", "dtype"), [(1e-3, torch.float32), (1e-7, torch.float64)])
def test_curvature_is_as_precise_as_the_damping_asks(
    damping: float, dtype: torch.dtype, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And the step is the same to what that precision is."""
    layers = Layers((2, 6, 1))
    problem, start = _problem(layers, 300), layers.initial(3)
    at = Iterate(start, torch.zeros_like(start), damping, 0, problem.loss(start))
    formed: list[torch.dtype] = []
    real = LeastSquares.curvature

    def curvature(self: LeastSquares, parameters: Tensor) -> Tensor:
        formed.append(parameters.dtype)
        return real(self, parameters)

    monkeypatch.setattr(LeastSquares, "curvature", curvature)
    steps = []
    for single in (levenberg_marquardt.SINGLE, math.inf):
        monkeypatch.setattr(levenberg_marquardt, "SINGLE", single)
        steps.append(advance(problem, at, 300))
    assert formed == [dtype, torch.float64]
    assert steps[0] is not None
    assert steps[1] is not None
    assert steps[0].parameters.dtype == torch.float64
    torch.testing.assert_close(steps[0].parameters, steps[1].parameters, rtol=0, atol=1e-4)

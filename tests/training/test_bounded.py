"""Whatever is trained can be exported: no neuron is steeper than the C takes."""

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from sailnet.networks.network import EXTRAPOLATION
from sailnet.networks.steepness import LARGEST_OCTAVES, octaves
from training.bounded import bounded
from training.layers import Layers, augment, forward
from training.least_squares import LeastSquares
from training.levenberg_marquardt import advance, begin

LAYERS = Layers((2, 4, 3, 1))


def steepest(layers: Layers, parameters: torch.Tensor) -> list[np.ndarray]:
    hidden = [matrix.numpy() for matrix in layers.matrices(parameters)[:-1]]
    return [octaves(m[:, :-1], m[:, -1], number == 0) for number, m in enumerate(hidden)]


@given(st.integers(0, 2**32 - 1), st.sampled_from([1.0, 10.0, 100.0, 1e4]))
def test_no_neuron_is_left_too_steep_and_the_others_keep_their_bits(seed: int, size: float) -> None:
    generator = torch.Generator().manual_seed(seed)
    parameters = size * torch.randn(LAYERS.parameters, generator=generator, dtype=torch.float64)
    given_before = parameters.clone()
    kept = bounded(LAYERS, parameters)
    assert torch.equal(parameters, given_before)
    before, after = steepest(LAYERS, parameters), steepest(LAYERS, kept)
    pairs = zip(LAYERS.matrices(parameters), LAYERS.matrices(kept), strict=True)
    for number, (old, new) in enumerate(pairs):
        if number == len(before):
            assert torch.equal(old, new)
            continue
        assert after[number].max() <= LARGEST_OCTAVES
        for neuron, steepness in enumerate(before[number]):
            if steepness <= (1.0 - 1e-9) * LARGEST_OCTAVES:
                assert torch.equal(old[neuron], new[neuron])
            else:  # its zero stays where it is
                ratio = new[neuron] / old[neuron]
                assert torch.allclose(ratio, ratio[0].expand_as(ratio), rtol=1e-12)
                assert after[number][neuron] == pytest.approx(LARGEST_OCTAVES, rel=1e-8)


@given(st.integers(0, 2**32 - 1))
def test_octaves_are_the_largest_that_any_input_brings(seed: int) -> None:
    """Against the arguments themselves, at the corners of what a layer reads, where they are largest."""
    generator = torch.Generator().manual_seed(seed)
    first, second, _ = LAYERS.matrices(
        3.0 * torch.randn(LAYERS.parameters, generator=generator, dtype=torch.float64)
    )
    signs = torch.tensor([[a, b, c, d] for a in (0, 1) for b in (0, 1) for c in (0, 1) for d in (0, 1)]).T
    corners = -EXTRAPOLATION + (1.0 + 2.0 * EXTRAPOLATION) * signs[:2].double()
    arguments = (first @ augment(corners)).abs().amax(dim=1) / np.log(2.0)
    bounds, inner = steepest(LAYERS, torch.cat([first.reshape(-1), second.reshape(-1), torch.zeros(4)]))
    assert (arguments.numpy() <= bounds * (1.0 + 1e-12)).all()
    # Centred: sigmoids of 0 and 1 are -1/2 and 1/2 around what the biases absorb.
    bias = second[:, -1] + second[:, :-1].sum(dim=1) / 2.0
    centred = ((second[:, :-1] @ (signs.double() - 0.5)).abs().amax(dim=1) + bias.abs()) / np.log(2.0)
    assert inner == pytest.approx(centred.numpy(), rel=1e-12)


def test_a_step_is_learnt_as_steep_as_can_be_flown_and_no_steeper() -> None:
    """The target is a jump: without a bound the neuron that has it grows past what the C takes."""
    layers = Layers((1, 2, 1))
    inputs = torch.linspace(0.0, 1.0, 2001, dtype=torch.float64)[None, :]
    targets = (inputs[0] > 0.5).double()
    problem = LeastSquares.of(layers, inputs, targets)
    parameters = layers.initial(1)
    layers.matrices(parameters)[0][0] = torch.tensor([150.0, -75.01])  # well on its way
    layers.matrices(parameters)[1][0] = torch.tensor([1.0, 0.0, 0.0])
    at, reached = begin(problem, parameters), 0.0
    for _ in range(60):
        following = advance(problem, at, problem.samples)
        if following is None:
            break
        at = following
        reached = max(reached, float(steepest(layers, at.parameters)[0].max()))
        assert reached <= LARGEST_OCTAVES
    assert reached > 0.99 * LARGEST_OCTAVES, "the bound is never met: nothing is shown"
    outputs = forward(layers.matrices(at.parameters), problem.inputs)[1][0]
    assert float((outputs - targets).abs().median()) < 0.01

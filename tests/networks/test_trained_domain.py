"""The trained domain: what it contains, and that NumPy and every build of the C draw the same line."""

import dataclasses
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from c_runtime.builds import BUILDS, Build
from c_runtime.shared_library import find_compiler
from export.to_c import write_c
from export.write import export
from sailnet import load_mission
from sailnet.dataset import open_dataset
from sailnet.errors import NetworkError
from sailnet.guidance.backends import Backend, load_guidance
from sailnet.guidance.facts import GuidanceFacts, describe
from sailnet.guidance.interface import GuidanceStatus, Precision
from sailnet.networks.guidance_networks import GuidanceNetworks
from sailnet.networks.network import load_network, save_network
from sailnet.networks.trained_domain import (
    AXES,
    KNOTS,
    TrainedDomain,
    momentum_and_orbit,
    size_and_direction,
)
from sailnet.physics.arrays import Array
from tests.few_graphs import only_whole_graphs
from tests.paths import ROOT
from tests.random_networks import (
    NO_TUBE,
    STATE_MAX,
    STATE_MIN,
    random_guidance,
    random_network,
    save_guidance,
)
from training.fit_domain import MARGIN, Extremes, add_domain, fit_domain
from training.samples import split_trajectories

MISSION = load_mission("earth_mars")
TARGET = np.array(MISSION.problem.target_state)
TOLERANCE = MISSION.flight.arrival_tolerance
BETA = MISSION.sail.beta
SEED = 3


@pytest.fixture(scope="module")
def domain(stored: Path) -> TrainedDomain:
    with open_dataset(stored) as data:
        return fit_domain(data, SEED)


@pytest.fixture(scope="module")
def samples(stored: Path) -> Array:
    """(n, 3) states of the training trajectories."""
    with open_dataset(stored) as data:
        columns = data.read(["r", "u", "v"], 0, data.samples)
        part = np.repeat(split_trajectories(data.families(), SEED), np.diff(data.first_sample))
    states = np.column_stack([columns[name] for name in "ruv"])
    return np.asarray(states[part == 0])


@pytest.fixture(
    scope="module",
    params=[pytest.param(False, marks=pytest.mark.exhaustive, id="paper"), pytest.param(True, id="approach")],
)
def networks(request: pytest.FixtureRequest, domain: TrainedDomain) -> GuidanceNetworks:
    """Random networks of either form with the domain of the small data set."""
    plain = random_guidance((4, 4), (4, 4), (4, 4), approach=request.param)
    tau = dataclasses.replace(plain.tau, provenance={**plain.tau.provenance, "domain": asdict(domain)})
    return dataclasses.replace(plain, tau=tau)


ROUNDING: dict[Precision, float] = {"float64": 1e-12, "float32": 1e-7}


def some_sails(samples: Array, networks: GuidanceNetworks, count: int) -> tuple[Array, Array]:
    """(n, 3) states in and around the domain, most of them near its bounds, and (n,) beta."""
    rng = np.random.default_rng(6)
    near = samples[rng.integers(len(samples), size=count)]
    reach = 10.0 ** rng.uniform(-4, -0.5, (count, 1))
    shifted = near + reach * rng.uniform(-1.0, 1.0, (count, 3))
    at_target = TARGET + 10.0 ** rng.uniform(-4, -1, (count, 1)) * rng.uniform(-1.0, 1.0, (count, 3))
    farther = TARGET + rng.uniform(1.0, 1.5, (count, 1)) * (near - TARGET)
    anywhere = rng.uniform(STATE_MIN, STATE_MAX, (count, 3))
    states = np.concatenate([samples, shifted, at_target, farther, anywhere])
    low, high = networks.beta_range
    beta = np.where(rng.random(len(states)) < 0.5, BETA, rng.uniform(0.9 * low, 1.1 * high, len(states)))
    return states, beta


def certain(facts: GuidanceFacts, states: Array, beta: Array, rounding: float) -> NDArray[np.bool_]:
    """(n,) where no rounding of state, bounds and arithmetic decides what is inside."""
    box = np.array([facts.state_min, facts.state_max])
    tolerance = np.abs(np.abs(states - facts.target_state) - facts.arrival_tolerance).min(axis=1)
    sail = np.minimum(np.abs(beta - facts.beta_min), np.abs(beta - facts.beta_max))
    clear = np.abs(facts.domain.excess(states, beta, facts.target_state)) > 100 * rounding
    clear &= (np.abs(states[:, None] - box).min(axis=(1, 2)) > rounding) & (tolerance > rounding)
    return np.asarray(clear & ((sail > rounding) | (beta == facts.beta)))


def test_the_direction_is_one_of_all_sizes() -> None:
    rng = np.random.default_rng(1)
    step = rng.normal(size=(1000, 3))
    size, direction = size_and_direction(TARGET + step, BETA, TARGET)
    x, across = direction[:, :3], direction[:, 3:]
    np.testing.assert_allclose(np.abs(x[:, 0]) + x[:, 1] ** 2 + x[:, 2] ** 2, 1.0, rtol=1e-12)
    np.testing.assert_array_equal(np.sign(x), np.sign(step))
    sums = [x[:, i] + sign * x[:, j] for i, j in ((0, 1), (0, 2), (1, 2)) for sign in (1.0, -1.0)]
    np.testing.assert_allclose(across.T, sums, atol=1e-15)
    # Distances shrink with the square of the time, speeds with the time.
    shrunk = size_and_direction(TARGET + step * [1e-4, 1e-2, 1e-2], BETA, TARGET)
    np.testing.assert_allclose(shrunk[0], 1e-2 * size, rtol=1e-8)
    np.testing.assert_allclose(shrunk[1], direction, atol=1e-8)
    # By hand: a speed of a alone is missing for 1 TU.
    slow = TARGET - np.array([0.0, 0.0, BETA / TARGET[0] ** 2])
    (one,), ((*_, last),) = size_and_direction([slow], BETA, TARGET)
    assert (one, last) == (pytest.approx(1.0), pytest.approx(1.0))


def test_momentum_and_energy_are_those_of_the_orbit() -> None:
    """Circles; and a parabola, whose energy is nothing, at its nearest point and on its way out."""
    radius = np.array([0.7, 1.0, 1.5])
    momentum, orbit = momentum_and_orbit(np.column_stack([radius, 0.0 * radius, radius**-0.5]))
    np.testing.assert_allclose(momentum, np.sqrt(radius), rtol=1e-15)
    np.testing.assert_allclose(orbit, np.column_stack([0.0 * radius, -0.5 / radius]), rtol=1e-14)
    escape = np.sqrt(2.0 / radius)
    for u, v in ((0.0, 1.0), (0.6, 0.8)):
        _, orbit = momentum_and_orbit(np.column_stack([radius, u * escape, v * escape]))
        np.testing.assert_allclose(orbit, np.column_stack([u * escape, 0.0 * radius]), atol=1e-15)


def test_bounds_lie_on_all_samples_and_nowhere_without_need() -> None:
    rng = np.random.default_rng(2)
    position = rng.uniform(0.0, KNOTS - 1.0, 50_000)
    values = np.column_stack([np.interp(position, np.arange(KNOTS), rng.normal(size=KNOTS)), position])
    extremes = Extremes.none(2)
    for part in np.array_split(np.arange(len(values)), 7):
        extremes.include(position[part], values[part])
    lower, upper = extremes.bounds(np.array([0.0, 0.0]))
    for bound, sign in ((lower, -1.0), (upper, 1.0)):
        above = np.column_stack([np.interp(position, np.arange(KNOTS), column) for column in bound.T])
        slack = sign * (above - values)
        assert slack.min() >= -1e-9
        assert slack.max() < 0.03  # what a column of samples spans
    whole = Extremes.none(2)
    whole.include(position, values)
    np.testing.assert_array_equal(whole.highest, extremes.highest)


def test_where_there_are_no_samples_nothing_is_inside() -> None:
    extremes = Extremes.none(1)
    extremes.include(np.array([0.5, 7.5]), np.array([[1.0], [2.0]]))
    lower, upper = extremes.bounds(np.array([0.0]))
    assert (lower[3:6] > upper[3:6]).all()


def test_all_training_samples_are_inside_in_every_precision(
    samples: Array, networks: GuidanceNetworks
) -> None:
    facts = describe(networks, MISSION)
    for precision in (np.float32, np.float64):
        states = samples.astype(precision)
        assert facts.contains(states, np.full(len(states), BETA, precision)).all()


def test_margins_are_what_they_are_said_to_be(samples: Array, domain: TrainedDomain) -> None:
    beyond = samples[(np.abs(samples - TARGET) > TOLERANCE).any(axis=1)]
    _, direction = size_and_direction(beyond, BETA, TARGET)
    assert np.all(direction.max(axis=0) <= np.max(domain.upper, axis=0)[: len(AXES)] - MARGIN + 1e-12)
    assert domain.excess(beyond, BETA, TARGET).max() <= -min(MARGIN, TOLERANCE) + 1e-9


def test_outside_states_are_told(samples: Array, networks: GuidanceNetworks) -> None:
    facts = describe(networks, MISSION)

    def share_inside(states: Array) -> float:
        return float(facts.contains(states, np.full(len(states), BETA)).mean())

    last_hours = samples[(np.abs(samples - TARGET) > TOLERANCE).any(axis=1) & (samples[:, 0] > 1.5)]
    assert share_inside(2 * TARGET - last_hours) == 0.0
    assert share_inside(last_hours * [1.0, -1.0, 1.0]) < 0.2
    assert share_inside(np.random.default_rng(4).uniform(STATE_MIN, STATE_MAX, (20_000, 3))) < 0.04
    at_target = TARGET + TOLERANCE * np.random.default_rng(5).uniform(-0.99, 0.99, (1000, 3))
    assert share_inside(at_target) == 1.0
    bad = np.array([[np.nan, 0.0, 0.81], [1.5, np.inf, 0.81], [np.inf, 0.0, -np.inf], [0.0, 0.0, 0.0]])
    assert share_inside(bad) == 0.0


def test_a_sail_of_another_beta_is_outside(networks: GuidanceNetworks) -> None:
    facts = describe(networks, MISSION)
    low, high = networks.beta_range
    states = np.tile(TARGET, (4, 1))
    inside = facts.contains(states, np.array([low * 0.999, low, high, high * 1.001]))
    np.testing.assert_array_equal(inside, [False, True, True, False])
    assert not facts.contains(states[:1], np.array([np.nan])).any()


@pytest.mark.slow
def test_every_back_end_draws_the_same_line(
    samples: Array, networks: GuidanceNetworks, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    only_whole_graphs(monkeypatch)
    save_guidance(networks, tmp_path / "networks")
    export(tmp_path / "networks", tmp_path / "out", MISSION, progress=False)
    facts = describe(networks, MISSION)
    states, beta = some_sails(samples, networks, 20_000)
    backends: list[Backend] = ["c", "onnx"]
    for backend in backends:
        for precision, rounding in ROUNDING.items():
            guidance = load_guidance(MISSION, backend, precision, tmp_path / "out")
            told = guidance.command(states, beta).status == GuidanceStatus.OUTSIDE_DOMAIN
            expected = ~facts.contains(states.astype(precision), beta.astype(precision))
            sure = certain(facts, states, beta, rounding)
            assert sure.mean() > 0.5
            np.testing.assert_array_equal(told[sure], expected[sure])
            assert not told[: len(samples)][beta[: len(samples)] == BETA].any()
            assert 0.05 < told.mean() < 0.95


VERIFICATION = ROOT / "c_runtime" / "verification"
LINES = """
#include <stdio.h>
#include "tested.h"
int main(void)
{
    double given[4];
    while (fread(given, sizeof given, 1, stdin) == 1) {
        const sailnet_state state = {(sailnet_real)given[0], (sailnet_real)given[1], (sailnet_real)given[2]};
        sailnet_command command;
        putchar(sailnet_guidance(&state, (sailnet_real)given[3], &command) == SAILNET_OUTSIDE_DOMAIN);
    }
    return 0;
}
"""

BOUND = "!(value >= bound[0] + weight * (bound[1] - bound[0]))"
MUTANTS = {
    "an axis mirrored": ("direction[i] + direction[i + 1]", "direction[i] - direction[i + 1]"),
    "only lower bounds": (BOUND, f"((i & 1) == 0) && {BOUND}"),
    "only upper bounds": (BOUND, f"((i & 1) != 0) && {BOUND}"),
    "no direction": (BOUND, f"(table == 1) && {BOUND}"),
    "no orbit": (BOUND, f"(table == 0) && {BOUND}"),
    "no energy": ("- R(1.0) / known[0];", "- R(9.0) / known[0];"),
    "no speed": ("known[0] = R(0.5)", "known[1] = R(0.0);\n    known[0] = R(0.5)"),
    "the knot before": ("weight * (bound[1] - bound[0])", "R(0.0)"),
    "the knot after": ("weight * (bound[1] - bound[0])", "(bound[1] - bound[0])"),
    "inwards missing": ("speed2 + sailnet_size(missing[0])", "speed2 + missing[0]"),
    "half the size": ("(argument[table] - number[0]) *", "R(0.5) * (argument[table] - number[0]) *"),
    "no root": ("i < SAILNET_NEWTON_STEPS", "i < 0"),
    "no target": ("there | in_tube", "in_tube"),
    "no box": ("*inside &= sailnet_within", "(void)sailnet_within"),
    "any sail": ("int32_t inside = sailnet_within(&command->beta, SAILNET_OF_BETA);", "int32_t inside = 1;"),
}
"""Of the flight file."""


def outside_in_c(folder: Path, states: Array, beta: Array, *flags: str) -> NDArray[np.bool_]:
    """(n,) whether the C in a folder calls them outside."""
    (folder / "lines.c").write_text(LINES)
    program = folder / "lines"
    command = [*find_compiler(), "-std=c99", "-O1", *flags, f"-I{folder}", f"-I{VERIFICATION}"]
    command += [str(folder / "lines.c")]
    subprocess.run([*command, "-o", str(program)], check=True)
    run = subprocess.run(
        [program], input=np.column_stack([states, beta]).tobytes(), capture_output=True, check=True
    )
    return np.asarray(np.frombuffer(run.stdout, np.uint8) > 0)


@pytest.mark.slow
@pytest.mark.parametrize("build", BUILDS.values(), ids=BUILDS)
def test_every_build_draws_the_same_line(
    samples: Array, networks: GuidanceNetworks, tmp_path: Path, build: Build
) -> None:
    facts = describe(networks, MISSION)
    write_c(networks, facts, tmp_path)
    states, beta = some_sails(samples, networks, 10_000)
    precision, rounding = (np.float64, 1e-12) if build.suffix == "f64" else (np.float32, 1e-7)
    outside = outside_in_c(tmp_path, states, beta, *build.analysed)
    sure = certain(facts, states, beta, rounding)
    expected = ~facts.contains(states.astype(precision), beta.astype(precision))
    assert sure.mean() > 0.5
    np.testing.assert_array_equal(outside[sure], expected[sure])
    assert not outside[: len(samples)][beta[: len(samples)] == BETA].any()


@pytest.mark.slow
@pytest.mark.parametrize("mutant", list(MUTANTS))
def test_mutants_of_the_guard_are_noticed(
    samples: Array, domain: TrainedDomain, tmp_path: Path, mutant: str
) -> None:
    plain = random_guidance((4, 4), (4, 4), (4, 4), approach=True)
    # A box as tight as that of trained networks, so that there are states out of it within the tube.
    box = {"state_min": samples.min(axis=0).tolist(), "state_max": samples.max(axis=0).tolist()}
    trained = {**plain.tau.provenance, **box, "domain": asdict(domain)}
    networks = dataclasses.replace(plain, tau=dataclasses.replace(plain.tau, provenance=trained))
    facts = describe(networks, MISSION)
    write_c(networks, facts, tmp_path)
    source = (tmp_path / "sailnet_guidance.c").read_text()
    old, new = MUTANTS[mutant]
    assert source.count(old) == 1
    (tmp_path / "sailnet_guidance.c").write_text(source.replace(old, new))
    states, beta = some_sails(samples, networks, 40_000)
    sure = certain(facts, states, beta, 1e-12)
    outside = outside_in_c(tmp_path, states, beta, "-DSAILNET_FLOAT64")
    assert (outside == facts.contains(states, beta))[sure].any()


@pytest.mark.slow
@pytest.mark.parametrize("change", [{"size_step": 0.5}, {"momentum_min": 0.0, "momentum_step": 0.12}])
def test_beyond_the_last_knot_is_outside(change: dict[str, float], tmp_path: Path) -> None:
    plain = random_guidance((4, 4), (4, 4), (4, 4), approach=True)
    short = {**plain.tau.provenance, "domain": NO_TUBE | change}
    networks = dataclasses.replace(plain, tau=dataclasses.replace(plain.tau, provenance=short))
    facts = describe(networks, MISSION)
    states = np.random.default_rng(8).uniform(STATE_MIN, STATE_MAX, (5000, 3))
    beta = np.full(len(states), BETA)
    size, _ = size_and_direction(states, beta, TARGET)
    beyond = size > 0.5 * (KNOTS - 1) if "size_step" in change else states[:, 0] * states[:, 2] > 1.2
    assert KNOTS == 11
    assert 0.1 < beyond.mean() < 0.9
    np.testing.assert_array_equal(~facts.contains(states, beta), beyond)
    write_c(networks, facts, tmp_path)
    np.testing.assert_array_equal(outside_in_c(tmp_path, states, beta, "-DSAILNET_FLOAT64"), beyond)


def test_a_domain_survives_storage(domain: TrainedDomain, networks: GuidanceNetworks) -> None:
    facts = describe(networks, MISSION)
    assert facts.domain == domain
    assert GuidanceFacts.from_json(facts.to_json()) == facts


@pytest.mark.parametrize(
    "change",
    [
        {"size_step": 0.0},
        {"momentum_min": float("nan")},
        {"momentum_step": "wide"},
        {"lower": [[0.0]]},
        {"upper": None},
        {"other": 1.0},
    ],
)
def test_a_damaged_domain_is_refused(domain: TrainedDomain, change: dict[str, object]) -> None:
    with pytest.raises(NetworkError, match="trained domain is damaged"):
        TrainedDomain.parse(asdict(domain) | change)


def test_networks_without_a_domain_are_refused() -> None:
    networks = random_guidance((4,), (4,), (4,))
    provenance = {name: value for name, value in networks.tau.provenance.items() if name != "domain"}
    bare = dataclasses.replace(networks, tau=dataclasses.replace(networks.tau, provenance=provenance))
    with pytest.raises(NetworkError, match=r"add it with python -m training\.fit_domain"):
        describe(bare, MISSION)


@pytest.mark.slow
def test_the_command_adds_the_domain_and_nothing_else(
    stored: Path, domain: TrainedDomain, tmp_path: Path
) -> None:
    with open_dataset(stored) as data:
        provenance = {"dataset": data.digest, "seed": SEED, "kept": "this"}
    before = dataclasses.replace(random_network("tau"), provenance=provenance)
    save_network(before, tmp_path / "tau.safetensors")
    command = [sys.executable, "-m", "training.fit_domain", str(stored), str(tmp_path)]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    assert "samples of held-out trajectories are outside" in run.stdout
    after = load_network(tmp_path / "tau.safetensors")
    assert TrainedDomain.parse(after.provenance["domain"]) == domain
    held_out = after.provenance["held_out_outside_domain"]
    assert isinstance(held_out, float)
    assert 0.0 <= held_out < 1.0
    assert after.provenance["kept"] == "this"
    for old, new in zip((*before.weights, *before.biases), (*after.weights, *after.biases), strict=True):
        np.testing.assert_array_equal(old, new)


def test_a_domain_of_another_data_set_is_refused(stored: Path, tmp_path: Path) -> None:
    tau = dataclasses.replace(random_network("tau"), provenance={"dataset": "another", "seed": SEED})
    save_network(tau, tmp_path / "tau.safetensors")
    with pytest.raises(NetworkError, match="name the one it was trained on"):
        add_domain(stored, tmp_path, quiet=True)
    assert "domain" not in load_network(tmp_path / "tau.safetensors").provenance

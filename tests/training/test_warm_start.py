"""Training that begins with another mission's networks begins with its law."""

import numpy as np
import pytest

from sailnet.errors import MissionError, NetworkError
from sailnet.guidance.backends import exported_folder, missions_with_networks
from sailnet.mission.derived import BEGUN_WITH
from sailnet.mission.mission import load_mission, parse_mission
from sailnet.mission.recipes import PLAN_EPOCHS, PLAN_SAMPLES, CommandRecipe, TrainingRecipe
from sailnet.mission.sizes import sized
from sailnet.networks.guidance_networks import NAMES
from sailnet.networks.network import Network, load_network
from sailnet.networks.plan_networks import ARRIVAL_NAMES
from training.judged import network_of
from training.layers import Layers
from training.samples import Part, SampleSet
from training.targets import TARGETS, Target
from training.warm_start import OWN, begins_with, first_parameters

MARS = load_mission("earth_mars")
GUIDANCE = tuple(TARGETS["wide"][name] for name in NAMES)
RECIPE = MARS.training.wide.model_copy(update={"start": "earth_mars"})
NOTHING = Part(*np.empty((4, 0)))


def samples(target: Target, seed: int = 0) -> SampleSet:
    """Of other ranges than any network was trained with, and no sample."""
    rng = np.random.default_rng(seed)
    low = rng.uniform(-2.0, 0.0, len(target.inputs))
    high = low + rng.uniform(0.5, 3.0, len(low))
    state = np.zeros(3)
    return SampleSet(NOTHING, NOTHING, NOTHING, low, high, -0.7, 1.9, state, state + 1.0)


def begun(target: Target, given: SampleSet, recipe: TrainingRecipe = RECIPE) -> Network:
    layers = Layers((len(target.inputs), *recipe.hidden, 1))
    parameters = first_parameters(layers, target, recipe, given)
    assert len(parameters) == layers.parameters
    return network_of(target, given, MARS, layers, parameters, {})


@pytest.mark.parametrize("kind", ["wide", "wide in space"])
@pytest.mark.parametrize("name", NAMES)
def test_it_is_the_same_function_of_the_inputs_that_both_have(kind: str, name: str) -> None:
    target = TARGETS[kind][name]
    source, given = load_network(exported_folder(MARS) / f"{name}.safetensors"), samples(target)
    ours = begun(target, given)
    rng = np.random.default_rng(1)
    theirs = rng.uniform(source.input_min, source.input_max, (500, len(source.inputs)))
    inputs = rng.uniform(given.input_min, given.input_max, (500, len(target.inputs)))
    for column, common in enumerate(source.inputs):
        here = target.inputs.index(common)
        values = theirs[:, column]
        if common in OWN:  # as far up its range
            low, high = source.input_min[column], source.input_max[column]
            share = (values - low) / (high - low)
            values = given.input_min[here] + share * (given.input_max[here] - given.input_min[here])
        inputs[:, here] = values
    inside = ((inputs >= ours.clamp[0]) & (inputs <= ours.clamp[1])).all(axis=1)
    assert inside.sum() > 100
    np.testing.assert_allclose(ours(inputs[inside]), source(theirs[inside]), rtol=0, atol=1e-10)


def test_a_command_of_another_size_begins_with_random_weights() -> None:
    more = {"hidden": [32, 32, 32], "train_samples": 600_000, "curvature_samples": 32_000}
    wide = RECIPE.model_copy(update={"command": CommandRecipe.model_validate(more)})
    own = MARS.training.model_copy(update={"wide": wide})
    assert own.wide.command is not None
    for target in GUIDANCE:
        recipe, of_time = target.recipe(own), target.name == "tau"
        assert (recipe.command is None) is not of_time
        assert recipe.hidden == (own.wide.hidden if of_time else own.wide.command.hidden)
        assert (begins_with(target, recipe) == "random weights") is not of_time
        assert target.recipe(MARS.training) == MARS.training.wide
    command = TARGETS["wide"]["alpha_pre"].recipe(own)
    assert command.train_samples == own.wide.command.train_samples
    assert command.epochs == own.wide.epochs


def test_what_that_mission_has_not_begins_with_random_weights() -> None:
    target = TARGETS["wide in space"]["lambda_w"]
    assert begins_with(target, RECIPE) == "random weights"
    layers = Layers((len(target.inputs), *RECIPE.hidden, len(target.factors)))
    cold = first_parameters(layers, target, RECIPE, samples(target))
    np.testing.assert_array_equal(cold, layers.initial(RECIPE.seed))


def test_it_is_told_which_weights_these_are() -> None:
    target = TARGETS["wide"]["tau"]
    assert begins_with(target, MARS.training.wide) == "random weights"
    of_each = {
        begins_with(target, RECIPE.model_copy(update={"start": name}))
        for name in ("earth_mars", "earth_venus")
    }
    assert len(of_each) == 2
    assert all("SHA-256" in words for words in of_each)


def test_networks_of_another_size_or_of_other_inputs_are_refused() -> None:
    target = TARGETS["wide"]["tau"]
    small = RECIPE.model_copy(update={"hidden": (8, 8)})
    with pytest.raises(NetworkError, match=r"tau of earth_mars.*leave out `start`"):
        begins_with(target, small)
    with pytest.raises(NetworkError, match=r"reads x_r.*leave out `start`"):
        begins_with(TARGETS["box"]["tau"], RECIPE)
    with pytest.raises(MissionError, match="no mission named 'earth_moon'"):
        begins_with(target, RECIPE.model_copy(update={"start": "earth_moon"}))


def test_missions_of_ones_own_begin_with_the_nearest_that_ships() -> None:
    for name, ratio in BEGUN_WITH.items():
        orbits = load_mission(name).transfer
        assert orbits.target_radius / orbits.departure_radius == ratio
        assert name in missions_with_networks()
    sail = {"beta": 0.12, "max_cone_angle": 55.0}
    nearest = {0.3: "mercury", 0.9: "venus", 1.2: "mars", 2.0: "mars", 2.7: "mars"}
    for target, name in nearest.items():
        own = parse_mission({"sail": sail, "transfer": {"target_radius": target}}, "own")
        assert own.training.wide.start == f"earth_{name}"
        quick = sized(own, "quick").training
        for network in GUIDANCE:
            assert f"earth_{name}, SHA-256" in begins_with(network, network.recipe(quick))


def test_a_file_that_says_how_to_train_begins_as_it_says() -> None:
    """Missions and artefacts that were written before there was such a start are what they were."""
    content = {
        "sail": {"beta": 0.12, "max_cone_angle": 55.0},
        "transfer": {"target_radius": 0.9},
        "training": {"wide": {"epochs": 20}},
    }
    assert parse_mission(content, "own").training.wide.start is None
    assert '"start"' not in MARS.to_json()
    content["training"] = {"wide": {"start": 3}}
    with pytest.raises(MissionError, match=r"training\.wide\.start"):
        parse_mission(content, "own")
    for wrong in (3, 3.0, True, "wide"):
        with pytest.raises(MissionError, match="training"):
            parse_mission({**content, "training": wrong}, "own")


def test_networks_of_the_arrival_costates_begin_with_random_weights_and_learn_less() -> None:
    more = {"epochs": 300, "command": CommandRecipe(hidden=(32,), train_samples=600_000, curvature_samples=9)}
    training = MARS.training.model_copy(update={"wide": RECIPE.model_copy(update=more)})
    for kind, components in (("wide", 3), ("wide in space", 5)):
        for name in ARRIVAL_NAMES[components]:
            target = TARGETS[kind][name]
            recipe = target.recipe(training)
            assert begins_with(target, recipe) == "random weights"
            assert (recipe.epochs, recipe.train_samples) == (PLAN_EPOCHS, PLAN_SAMPLES)
            assert (recipe.hidden, recipe.command) == (RECIPE.hidden, None)
    few = RECIPE.model_copy(update={"epochs": 3, "train_samples": 500})
    toy = target.recipe(training.model_copy(update={"wide": few}))
    assert (toy.epochs, toy.train_samples) == (3, 500)

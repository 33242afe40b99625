"""The checks of a flight file in three dimensions pass, and catch defects that there are only there."""

from pathlib import Path

import pytest

from tests.c_runtime.verification.test_checks import TARGETS, Mutant, make, needs_tools_of
from tests.guidance.space_export import AGEING, write_only
from tests.random_networks import random_guidance_in_space


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of networks so small that they are smooth: far off they promise long flights. The sail ages."""
    networks = random_guidance_in_space(*[(4, 4)] * 4, mission=AGEING)
    return write_only(networks, tmp_path_factory.mktemp("space")).folder


@pytest.mark.parametrize("target", [pytest.param(name, marks=needs_tools_of(name)) for name in TARGETS])
@pytest.mark.parametrize("build", ["f64", pytest.param("f32_host", marks=pytest.mark.long)])
def test_nothing_is_found(folder: Path, tmp_path: Path, target: str, build: str) -> None:
    run = make(target, folder, tmp_path, f"BUILDS={build}")
    assert run.returncode == 0, run.stdout + run.stderr


MUTANTS = {
    # The status or the state remembered tells of it, whichever the fuzzer comes upon first.
    "a NaN of the latitude let through": Mutant(
        "fuzz", "sailnet_is_state", "(state->latitude - state->latitude)", "R(0.0)", "promise broken: "
    ),
    "a clock angle below 0 by a turn": Mutant(
        "fuzz",
        "sailnet_angle",
        "return sailnet_limited(&angle, SAILNET_OF_ANGLE);",
        "return angle > R(1.0) ? angle - R(6.2831853) : angle;",
        "promise broken: (double)command->clock_angle > -PI",
    ),
    "a command that is not mirrored": Mutant(
        "fuzz",
        "sailnet_observed",
        "input[5] = northward * input[10];",
        "input[5] = northward;",
        "promise broken: other.cone_angle == command->cone_angle",
    ),
    "another normal remembered than commanded": Mutant(
        "fuzz",
        "sailnet_normal_to",
        "normal[2] = sine * across[1];",
        "normal[2] = sine * across[0];",
        "promise broken: fabs((double)normal[2]",
    ),
    "a normal of any size": Mutant(
        "fuzz",
        "sailnet_steer",
        "estimate->normal[i] = sailnet_limited(&estimate->normal[i], SAILNET_OF_SHARE);",
        "",
        "promise broken: fabs((double)estimate->normal[i]) <= 1.0",
    ),
    "an output left as it was": Mutant(
        "test", "sailnet_law", "    command->lambda_w = R(0.0);\n", "", "failed: is_safe(command)"
    ),
    "no angle of two zeros": Mutant(
        "test", "sailnet_angle", "whole > R(0.0) ? (", "whole >= R(0.0) ? (", "failed: "
    ),
    "half a turn": Mutant(
        "test", "sailnet_turn", "return R(2.0) * sailnet_angle", "return sailnet_angle", "failed: "
    ),
    "a force without its northward part": Mutant(
        "test",
        "sailnet_learn",
        "innovation_north * change->northward",
        "R(0.0) * innovation_north",
        "failed: ",
    ),
}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=needs_tools_of(mutant.target)) for name, mutant in MUTANTS.items()]
)
def test_defects_are_found(folder: Path, tmp_path: Path, name: str) -> None:
    mutant = MUTANTS[name]
    run = make(
        mutant.target, mutant.write(folder, tmp_path / "exported"), tmp_path, "BUILDS=f32", "FUZZ_RUNS=50000"
    )
    assert run.returncode != 0, run.stdout
    assert mutant.says in run.stdout + run.stderr

"""Inputs that data sets do not hold, and the comparisons made with them."""

import math
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sailnet.dataset import open_dataset
from sailnet.mission.mission import Mission
from sailnet.networks.approach import approach_coordinates
from sailnet.networks.guidance_networks import COMMAND_INPUTS, STATE_INPUTS
from sailnet.physics.transfer import Transfer
from training.compare_inputs import APPROACH_TIME_INPUTS, TABLE_1, candidates, squared_errors
from training.samples import Part, load_samples
from training.targets import INTEGRALS, TARGETS


@given(st.floats(0.0, 0.9), st.floats(0.3, 3.0), st.floats(-math.pi, math.pi))
def test_integrals_are_those_of_kepler_orbits(eccentricity: float, axis: float, anomaly: float) -> None:
    parameter = axis * (1.0 - eccentricity**2)
    r = parameter / (1.0 + eccentricity * math.cos(anomaly))
    u = eccentricity * math.sin(anomaly) / math.sqrt(parameter)
    columns = {"r": np.array([r]), "u": np.array([u]), "v": np.array([math.sqrt(parameter) / r])}
    assert INTEGRALS["momentum"](columns)[0] == pytest.approx(math.sqrt(parameter), rel=1e-12)
    assert INTEGRALS["energy"](columns)[0] == pytest.approx(-0.5 / axis, rel=1e-10)


def test_samples_hold_what_is_computed_from_the_state_and_no_arrival(stored: Path, problem: Transfer) -> None:
    target = replace(TARGETS["box"]["tau"], inputs=("r", "u", "v", "energy", *APPROACH_TIME_INPUTS))
    with open_dataset(stored) as data:
        samples = load_samples(data, target, 1, 1000, 1000)
        total, trajectories = data.samples, data.trajectories
    parts = (samples.train, samples.validation, samples.test)
    assert sum(len(part.values) for part in parts) == total - trajectories
    for part in parts:
        r, u, v, energy, *approach, tau = part.inputs.T
        expected = approach_coordinates(problem, part.inputs[:, :3], problem.beta)
        assert np.array_equal(np.column_stack(approach), expected[:, :4])
        assert np.array_equal(energy, (u**2 + v**2) / 2.0 - 1.0 / r)
        assert np.array_equal(tau, part.values)
        assert tau.min() > 0.0


def test_every_row_is_trained_with_the_papers_inputs_and_with_others() -> None:
    pairs = list(zip(candidates("box")[::2], candidates("box")[1::2], strict=True))
    assert [paper.name for paper, _ in pairs] == list(TABLE_1)
    for paper, other in pairs:
        assert paper.inputs == (STATE_INPUTS if paper.name == "tau" else COMMAND_INPUTS)
        assert other.inputs != paper.inputs
        assert (other.name, other.definition) == (paper.name, paper.definition)


def test_errors_are_scaled_and_leave_arrivals_out(mission: Mission) -> None:
    alpha, tau = np.array([0.7, -0.5, 0.2]), np.array([0.0, 1.0, 2.0])
    target, phi_max = TARGETS["box"]["alpha_pre"], mission.problem.phi_max
    test = Part(np.zeros((3, 4)), np.abs(alpha), alpha, tau)
    assert squared_errors(target, np.array([0.1, 0.5, 0.2]), test, 1.0, phi_max) == (0.0, 0.0)
    own, command = squared_errors(target, np.array([0.7, 0.5, 0.3]), test, 0.5, phi_max)
    assert own == pytest.approx(0.2**2 / 2.0)
    assert command == pytest.approx((0.1 / (2.0 * phi_max)) ** 2 / 2.0)
    assert squared_errors(TARGETS["box"]["tau"], np.abs(alpha), test, 1.0, phi_max) == (0.0, None)


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    ("module", "arguments", "rows"),
    [
        ("compare_inputs", ["--network", "tau"], ["tau"] * 2),
        ("compare_targets", [], ["alpha", "cos_direction"]),
    ],
)
def test_comparisons_run(stored: Path, module: str, arguments: list[str], rows: list[str]) -> None:
    command = [sys.executable, "-m", f"training.{module}", str(stored), "--epochs", "1", *arguments]
    # More threads only wait for each other on matrices this small.
    alone = os.environ | {"OMP_NUM_THREADS": "1"}
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=alone)
    assert done.returncode == 0, done.stderr
    first = [line.strip("| ").split()[0] for line in done.stdout.splitlines()]
    assert [name for name in first if name in rows] == rows
    missing = subprocess.run([*command[:3], "none.h5"], capture_output=True, text=True, check=False)
    assert missing.returncode == 1
    assert "none.h5" in missing.stderr
    assert "Traceback" not in missing.stderr

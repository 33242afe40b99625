import shutil
from pathlib import Path
from typing import get_args

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from c_runtime.builds import BUILDS, HEADER, LAYOUTS, PRECISIONS
from sailnet import load_mission
from sailnet.artefacts.checksums import write_checksums
from sailnet.errors import GuidanceError
from sailnet.guidance.backends import Backend, load_guidance
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.exported_files import SUFFIXES, header_and_source, library_name
from sailnet.guidance.facts import describe, round_down
from sailnet.guidance.interface import GuidanceStatus, Layout, Precision
from sailnet.physics.arrays import Array
from tests.conftest import Exported
from tests.random_networks import STATE_MAX, STATE_MIN

MISSION = load_mission("earth_mars")
OTHER = MISSION.model_copy(update={"transfer": MISSION.transfer.model_copy(update={"target_radius": 1.4})})
GOOD = (1.0, 0.0, 1.0)

every_backend = pytest.mark.parametrize("backend", ["c", "onnx"])
every_precision = pytest.mark.parametrize("precision", ["float32", "float64"])


@every_backend
@every_precision
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("place", [0, 1, 2])
def test_invalid_input_gives_the_safe_command(
    exported: Exported, backend: Backend, precision: Precision, bad: float, place: int
) -> None:
    states = np.array([GOOD, GOOD, GOOD])
    states[1, place] = bad
    commands = load_guidance(MISSION, backend, precision, exported.folder).command(states)
    assert commands.status[1] == GuidanceStatus.INVALID_INPUT
    assert commands.cone_angle[1] == 0.0
    longest = describe(exported.networks, MISSION).largest_time_of_flight
    assert commands.time_of_flight[1] == pytest.approx(longest, rel=1e-7)
    assert commands.status[0] == commands.status[2] != GuidanceStatus.INVALID_INPUT
    assert commands.cone_angle[0] == commands.cone_angle[2] != 0.0


@every_backend
@every_precision
def test_outside_the_box_the_status_says_so_and_beyond_the_clamp_nothing_changes(
    exported: Exported, backend: Backend, precision: Precision
) -> None:
    guidance = load_guidance(MISSION, backend, precision, exported.folder)
    inside = np.array([[STATE_MAX[0], 0.0, 1.0], [1.0, STATE_MIN[1], 1.0], [1.0, 0.0, STATE_MAX[2]]])
    assert not (guidance.command(inside).status == GuidanceStatus.OUTSIDE_DOMAIN).any()
    outward = np.diag([1.0, -1.0, 1.0])
    near, far, absurd = (guidance.command(inside + step * outward) for step in (1e-3, 1e3, 1e30))
    for commands in (near, far, absurd):
        assert (commands.status == GuidanceStatus.OUTSIDE_DOMAIN).all()
    np.testing.assert_array_equal(far.cone_angle, absurd.cone_angle)
    np.testing.assert_array_equal(far.time_of_flight, absurd.time_of_flight)
    assert not np.array_equal(near.cone_angle, far.cone_angle)


@every_backend
@every_precision
def test_arrival_is_a_short_predicted_time_inside_the_box(
    exported: Exported, backend: Backend, precision: Precision
) -> None:
    states = np.random.default_rng(3).uniform(STATE_MIN, STATE_MAX, (50_000, 3))
    commands = load_guidance(MISSION, backend, precision, exported.folder).command(states)
    arrived = commands.status == GuidanceStatus.ARRIVED
    np.testing.assert_array_equal(arrived, commands.time_of_flight < MISSION.flight.arrival_threshold)
    assert arrived.any()
    assert not arrived.all()


@every_backend
@every_precision
@settings(max_examples=150, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(state=st.tuples(*[st.floats(allow_subnormal=True)] * 3), beta=st.floats(allow_subnormal=True))
def test_any_numbers_give_a_bounded_command(
    exported: Exported, backend: Backend, precision: Precision, state: tuple[float, float, float], beta: float
) -> None:
    commands = load_guidance(MISSION, backend, precision, exported.folder).command([state], beta)
    assert abs(commands.cone_angle[0]) <= round_down(MISSION.problem.phi_max, precision)
    assert np.isfinite(commands.time_of_flight[0])
    with np.errstate(over="ignore"):
        finite = np.isfinite(np.array(state).astype(precision)).all()
    assert (commands.status[0] == GuidanceStatus.INVALID_INPUT) == (not finite)


@every_backend
def test_no_states_give_no_commands(exported: Exported, backend: Backend) -> None:
    commands = load_guidance(MISSION, backend, folder=exported.folder).command(np.empty((0, 3)))
    assert commands.cone_angle.shape == commands.time_of_flight.shape == commands.status.shape == (0,)


@every_backend
@pytest.mark.parametrize("states", [GOOD, [[1.0, 2.0]], [["a", "b", "c"]], [[1.0, 2.0], [1.0]]])
def test_other_shapes_are_refused(exported: Exported, backend: Backend, states: object) -> None:
    with pytest.raises(GuidanceError, match=r"\(n, 3\)"):
        load_guidance(MISSION, backend, folder=exported.folder).command(states)  # type: ignore[arg-type]


def test_rows_of_a_transposed_array_are_states(exported: Exported) -> None:
    guidance = load_guidance(MISSION, folder=exported.folder)
    states = np.random.default_rng(4).uniform(STATE_MIN, STATE_MAX, (10, 3))
    expected = guidance.command(states).cone_angle
    np.testing.assert_array_equal(guidance.command(np.asfortranarray(states)).cone_angle, expected)


@every_backend
@every_precision
def test_another_mission_is_refused(exported: Exported, backend: Backend, precision: Precision) -> None:
    with pytest.raises(GuidanceError, match="for another mission than 'earth_mars'"):
        load_guidance(OTHER, backend, precision, exported.folder)


@every_backend
def test_missing_files_are_refused(tmp_path: Path, backend: Backend) -> None:
    with pytest.raises(GuidanceError, match="cannot read"):
        load_guidance(MISSION, backend, folder=tmp_path)


@every_backend
@pytest.mark.parametrize("damage", ["truncated", "flipped", "empty"])
def test_damaged_files_are_refused_before_they_are_loaded(
    exported: Exported, tmp_path: Path, backend: Backend, damage: str
) -> None:
    folder = shutil.copytree(exported.folder, tmp_path / "copy")
    file = folder / f"guidance_f64.{'so' if backend == 'c' else 'onnx'}"
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(bytes({"truncated": content[:5000], "flipped": content, "empty": b""}[damage]))
    with pytest.raises(GuidanceError, match="damaged"):
        load_guidance(MISSION, backend, folder=folder)


@every_backend
def test_a_listed_file_that_is_nothing_of_the_kind_is_refused(tmp_path: Path, backend: Backend) -> None:
    name, sums = (
        ("guidance_f64.so", "libraries.sha256") if backend == "c" else ("guidance_f64.onnx", "SHA256SUMS")
    )
    (tmp_path / name).write_bytes(b"neither an ELF file nor a graph")
    write_checksums([tmp_path / name], tmp_path / sums)
    with pytest.raises(GuidanceError, match="cannot load"):
        load_guidance(MISSION, backend, folder=tmp_path)


def test_a_library_of_something_else_is_refused(tmp_path: Path) -> None:
    import _ctypes

    library = Path(shutil.copy(_ctypes.__file__, tmp_path / "guidance_f64.so"))
    write_checksums([library], tmp_path / "libraries.sha256")
    with pytest.raises(GuidanceError, match="cannot load"):
        CGuidance(MISSION, library)


def test_an_unknown_backend_is_refused(exported: Exported) -> None:
    with pytest.raises(GuidanceError, match="known are c and onnx"):
        load_guidance(MISSION, "fortran", folder=exported.folder)  # type: ignore[arg-type]


def test_a_mission_without_shipped_networks_says_what_to_do() -> None:
    elsewhere = MISSION.model_copy(update={"name": "nowhere"})
    with pytest.raises(GuidanceError, match="no networks are shipped for mission 'nowhere'"):
        load_guidance(elsewhere)


def test_both_backends_name_the_same_networks(exported: Exported) -> None:
    c = load_guidance(MISSION, "c", folder=exported.folder)
    graph = load_guidance(MISSION, "onnx", folder=exported.folder)
    assert c.networks_digest == graph.networks_digest


@every_backend
@every_precision
def test_beta_is_clamped_and_nan_is_the_missions(
    exported: Exported, backend: Backend, precision: Precision
) -> None:
    guidance = load_guidance(MISSION, backend, precision, exported.folder)
    states = np.random.default_rng(5).uniform(STATE_MIN, STATE_MAX, (100, 3))
    low, high = guidance.beta_range
    np.testing.assert_allclose((low, high), exported.networks.beta_range, rtol=1e-7)

    def angles(beta: float | None) -> Array:
        return guidance.command(states, beta).cone_angle

    for absurd, same in ((0.0, low), (-np.inf, low), (1e30, high), (np.inf, high)):
        np.testing.assert_array_equal(angles(absurd), angles(same))
    for unknown in (np.nan, MISSION.sail.beta):
        np.testing.assert_array_equal(angles(unknown), angles(None))
    assert np.array_equal(angles(low), angles(high)) == (not exported.networks.approach)


@every_backend
def test_each_sail_has_its_own_beta(approach_exported: Exported, backend: Backend) -> None:
    guidance = load_guidance(MISSION, backend, folder=approach_exported.folder)
    betas = np.linspace(*guidance.beta_range, 7)
    together = guidance.command([GOOD] * 7, betas)
    alone = [guidance.command([GOOD], beta).cone_angle[0] for beta in betas]
    np.testing.assert_allclose(together.cone_angle, alone, rtol=0, atol=1e-15)
    assert len(set(alone)) == 7


@every_backend
@pytest.mark.parametrize("beta", [[0.16, 0.17, 0.18], [[0.16], [0.17]], "much"])
def test_another_number_of_betas_is_refused(exported: Exported, backend: Backend, beta: object) -> None:
    with pytest.raises(GuidanceError, match="beta must be one number"):
        load_guidance(MISSION, backend, folder=exported.folder).command([GOOD, GOOD], beta)  # type: ignore[arg-type]


def test_layouts_and_precisions_are_those_that_are_compiled() -> None:
    assert get_args(Layout) == tuple(LAYOUTS)
    assert set(get_args(Precision)) == set(PRECISIONS)
    assert PRECISIONS == SUFFIXES == {"float32": "f32", "float64": "f64"}
    compiled = {build.library: (HEADER, build.source) for build in BUILDS.values()}
    assert compiled == {
        library_name(precision, layout): header_and_source(layout)
        for layout in get_args(Layout)
        for precision in get_args(Precision)
    }
    assert compiled["guidance_f32.so"] == ("sailnet_guidance.h", "sailnet_guidance.c")
    assert compiled["guidance_f64_host.so"] == ("sailnet_guidance.h", "sailnet_guidance_host.c")

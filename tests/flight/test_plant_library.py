"""The compiled plant: read as it describes itself, held to the guidance, refused when it is not whole."""

import re
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sailnet.flight.plant_library
from c_runtime import shared_library
from c_runtime.shared_library import (
    CompilerError,
    compile_libraries,
    compile_plant,
    find_compiler,
    plant_digest,
)
from sailnet.errors import GuidanceError
from sailnet.flight.closed_loop import Ending, fly_recorded
from sailnet.flight.plant_library import LIBRARY, Plant, plant, sources_digest
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import Guidance, GuidanceStatus
from tests.flight.test_plant import EVERYTHING, STARTS, Indirect
from tests.pilots import MISSION

SHIPPED = Path(sailnet.__file__).parent / "shipped" / "earth_mars"
LISTS = re.compile(r"(#define PLANT_(\w+)\(MEMBER[^\n]*\\\n)((?: +MEMBER\([^\n]*\n)+)")

Edit = Callable[[str], str]


def backwards(*left_alone: str) -> Edit:
    """Turns the members of every structure of the header round, but for those named."""

    def turned(found: re.Match[str]) -> str:
        begin, name, lines = found.groups()
        if name in left_alone:
            return found[0]
        members = [line.rstrip("\\").rstrip() for line in lines.splitlines()]
        return begin + " \\\n".join(reversed(members)) + "\n"

    return lambda text: LISTS.sub(turned, text)


@pytest.fixture
def edited(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[Edit], Plant]]:
    """Compiles the plant with an edit in all its C, and makes it the one that flies."""

    def made(edit: Edit) -> Plant:
        copy = tmp_path / "plant"
        shutil.copytree(shared_library.PLANT, copy)
        for file in copy.glob("*.[ch]"):
            file.write_text(edit(file.read_text()))
        monkeypatch.setattr(shared_library, "PLANT", copy)
        compile_plant(tmp_path)
        monkeypatch.setattr(sailnet.flight.plant_library, "LIBRARY", tmp_path / "plant.so")
        plant.cache_clear()
        return plant()

    yield made
    plant.cache_clear()


def flown(guidance: Guidance) -> dict[str, Any]:
    flights, histories = fly_recorded(MISSION, guidance, STARTS, disturbance=EVERYTHING, period=0.02, first=3)
    columns = dict(vars(flights))
    for number, history in enumerate(histories):
        columns |= {f"{name} of {number}": values for name, values in vars(history).items()}
    return columns


@pytest.mark.slow
@pytest.mark.parametrize(("left_alone", "direct"), [(("COMMAND", "COMMAND_IN_SPACE"), True), ((), False)])
def test_members_in_another_order_make_the_same_flight(
    edited: Callable[[Edit], Plant], left_alone: tuple[str, ...], direct: bool
) -> None:
    """Guidance in C gives its commands in its own order; guidance in Python is asked for them by name."""
    guidance = load_guidance(MISSION, "c")
    pilot = guidance if direct else Indirect(guidance)
    before, expected = dict(plant().structures), flown(pilot)
    after = edited(backwards(*left_alone)).structures
    for name, kind in before.items():
        names = list(kind.names or ())
        turned = name.startswith("plant_command") <= (not left_alone)
        assert list(after[name].names or ()) == (names[::-1] if turned else names)
        assert len(names) > 1
    found = flown(pilot)
    assert found.keys() == expected.keys()
    for name, values in expected.items():
        np.testing.assert_array_equal(found[name], values, err_msg=name)


def test_a_member_that_is_not_known_is_refused(edited: Callable[[Edit], Plant]) -> None:
    edited(lambda text: text.replace("beta_drift", "beta_slide"))
    with pytest.raises(GuidanceError, match=r"plant_rules .* beta_drift, beta_slide; install sailnet again"):
        flown(load_guidance(MISSION, "c"))


def test_enumerations_are_those_of_the_plant() -> None:
    numbers = plant().enumerations
    assert numbers["plant_ending"] == {"FLYING": 0} | {item.name: item.value for item in Ending}
    assert numbers["plant_status"] == {item.name: item.value for item in GuidanceStatus}


@pytest.mark.parametrize(
    ("pattern", "instead"),
    [
        (r"sailnet_real (beta|hold);(?=(?:[^}]*\n)*\} sailnet_command;)", r"sailnet_real other_\1;"),
        (r"SAILNET_(ARRIVED|OUTSIDE_DOMAIN) = [12]", r"SAILNET_\1 = 4"),
    ],
)
def test_a_guidance_that_the_plant_would_misread_is_not_compiled(
    pattern: str, instead: str, tmp_path: Path
) -> None:
    for file in SHIPPED.glob("sailnet_*.[ch]"):
        shutil.copy(file, tmp_path)
    header = tmp_path / "sailnet_guidance.h"
    text, count = re.subn(pattern, instead, header.read_text())
    assert count == 2
    header.write_text(text)
    with pytest.raises(CompilerError, match="same_interface"):
        compile_libraries(tmp_path, tmp_path)


IN_SPACE = [
    ("#define SAILNET_LARGEST_PERIOD", "#define SAILNET_IN_SPACE 1\n#define SAILNET_LARGEST_PERIOD"),
    ("    sailnet_real u; ", "    sailnet_real latitude;\n    sailnet_real u; "),
    ("} sailnet_state;", "    sailnet_real w;\n} sailnet_state;"),
    ("positive: along +v */\n", "positive: along +v */\n    sailnet_real clock_angle;\n"),
    ("} sailnet_command;", "    sailnet_real lambda_w;\n} sailnet_command;"),
]
"""What makes the header of a guidance in the plane one in space."""


@pytest.mark.parametrize("left_out", [None, *range(len(IN_SPACE))])
def test_a_guidance_in_space_is_held_to_what_the_plant_shows_and_takes_there(
    left_out: int | None, tmp_path: Path
) -> None:
    text = (SHIPPED / "sailnet_guidance.h").read_text()
    for number, (planar, in_space) in enumerate(IN_SPACE):
        assert text.count(planar) == 1
        text = text if number == left_out else text.replace(planar, in_space)
    (tmp_path / "sailnet_guidance.h").write_text(text)
    (tmp_path / "sailnet_batch.h").write_text((SHIPPED / "sailnet_batch.h").read_text())
    checked = shared_library.PLANT / "guidance" / "same_interface.c"
    library = shared_library.Library([checked], (f"-I{tmp_path}",))
    if left_out is None:
        shared_library.compile_library(find_compiler(), tmp_path / "whole.so", library)
    else:
        with pytest.raises(CompilerError, match="plant_takes_the_same"):
            shared_library.compile_library(find_compiler(), tmp_path / "none.so", library)


def test_the_library_is_of_these_sources() -> None:
    built = sources_digest()
    assert built == plant_digest(), "the plant was changed: run make setup"


@pytest.mark.parametrize("damage", [lambda b: b[: len(b) // 2], lambda b: b[:-1] + bytes([b[-1] ^ 1])])
def test_a_damaged_library_is_refused(damage: Any, tmp_path: Path) -> None:
    shutil.copytree(LIBRARY.parent, tmp_path / "native")
    copy = tmp_path / "native" / "plant.so"
    copy.write_bytes(damage(copy.read_bytes()))
    with pytest.raises(GuidanceError, match="damaged"):
        Plant(copy)

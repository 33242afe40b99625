"""What optical coefficients may be; what they do to a sail is tested with the plant."""

import pytest

from sailnet.errors import SailnetError
from sailnet.physics.optics import OPTICS, Optics, optics_from


def test_both_sides_may_radiate_alike() -> None:
    alike = Optics(0.88, 0.94, 0.3, 0.3, 0.79, 0.55)
    lambertian = 0.3 * (0.79 - 0.55) / 0.6
    assert alike.facing_share == pytest.approx(
        (1.0 + 0.88 * 0.94 + 0.88 * 0.06 * 0.79 + 0.12 * lambertian) / 2.0
    )


@pytest.mark.parametrize(
    ("coefficients", "says"),
    [
        ({"front_emissivity": 0.0, "back_emissivity": 0.0}, "no heat leaves the sail"),
        ({"reflectivity": 1.01}, "reflectivity must be from 0 to 1, not 1.01"),
        ({"specularity": -0.01}, "specularity must be from 0 to 1"),
        ({"back_lambertian": float("nan")}, "back_lambertian must be"),
        ({"reflectivity": True}, "reflectivity must be"),
        (
            {"reflectivity": 0.0, "front_emissivity": 0.0, "back_lambertian": 1.0},
            "not pushed away from the Sun",
        ),
    ],
)
def test_what_cannot_be_is_refused(coefficients: dict[str, float], says: str) -> None:
    with pytest.raises(SailnetError, match=says):
        Optics(**coefficients)


def test_optics_are_read_by_name_or_as_a_table() -> None:
    assert optics_from("jpl") is OPTICS["jpl"]
    assert optics_from({"reflectivity": 0.9}) == Optics(reflectivity=0.9)
    for wrong in ("mirror", {"colour": 1.0}, 3):
        with pytest.raises(SailnetError, match=r"ideal|optics"):
            optics_from(wrong)

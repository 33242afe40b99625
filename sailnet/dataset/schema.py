"""Names, units and types of what a data set holds, in the plane and in three dimensions."""

from collections.abc import Mapping

from sailnet.artefacts.column_files import Layout
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission

SCHEMA, SCHEMA_IN_SPACE = "sailnet-dataset/2", "sailnet-dataset/3"

SAMPLES: Mapping[str, tuple[str, str]] = {
    "r": ("AU", "distance from the Sun"),
    "u": ("AU/TU", "radial speed"),
    "v": ("AU/TU", "transverse speed"),
    "tau": ("TU", "optimal time of flight to the target orbit"),
    "lambda_r": ("TU/AU", "costate of r"),
    "lambda_u": ("TU^2/AU", "costate of u"),
    "lambda_v": ("TU^2/AU", "costate of v"),
    "alpha": ("rad", "optimal cone angle, Eq. (12)"),
    "alpha_pre": ("rad", "preprocessed cone angle, Eq. (23)"),
    "beta": ("1", "normalised characteristic acceleration of the sail"),
    "trajectory": ("1", "row of /trajectories this sample belongs to"),
}
TRAJECTORIES: Mapping[str, tuple[str, str]] = {
    "lambda_r0": ("TU/AU", "costate of r at arrival"),
    "lambda_u0": ("TU^2/AU", "costate of u at arrival"),
    "lambda_v0": ("TU^2/AU", "costate of v at arrival"),
    "jump_time": ("TU", "time of flight left at the jump of the cone angle; NaN without a jump"),
    "flags": ("1", "bit 0: the cone angle jumps; 1: it is negative at arrival; 2: begins on another's way"),
    "family": ("1", "equal for near-copies: daughters of one flight, ways from one state; -1: like no other"),
    "first_sample": ("1", "row of /samples where the trajectory begins, at arrival (tau = 0)"),
}
SAMPLES_IN_SPACE: Mapping[str, tuple[str, str]] = {
    "r": ("AU", "distance from the Sun"),
    "latitude": ("rad", "latitude over the plane of the target orbit"),
    "u": ("AU/TU", "radial speed"),
    "v": ("AU/TU", "transverse speed, along the target orbit's plane"),
    "w": ("AU/TU", "northward speed"),
    "tau": ("TU", "optimal time of flight to the target orbit"),
    "lambda_r": ("TU/AU", "costate of r"),
    "lambda_latitude": ("TU/rad", "costate of the latitude"),
    "lambda_u": ("TU^2/AU", "costate of u"),
    "lambda_v": ("TU^2/AU", "costate of v"),
    "lambda_w": ("TU^2/AU", "costate of w"),
    "alpha": ("rad", "optimal cone angle, Eq. (12), never negative"),
    "clock_angle": ("rad", "optimal clock angle, from the transverse direction to the north"),
    "beta": ("1", "normalised characteristic acceleration of the sail"),
    "trajectory": ("1", "row of /trajectories this sample belongs to"),
}
TRAJECTORIES_IN_SPACE: Mapping[str, tuple[str, str]] = {
    "lambda_r0": ("TU/AU", "costate of r at arrival"),
    "lambda_latitude0": ("TU/rad", "costate of the latitude at arrival"),
    "lambda_u0": ("TU^2/AU", "costate of u at arrival"),
    "lambda_v0": ("TU^2/AU", "costate of v at arrival"),
    "lambda_w0": ("TU^2/AU", "costate of w at arrival"),
    "jump_time": ("TU", "time of flight left at the last fast turn of the clock angle; NaN without one"),
    "flags": ("1", "bit 0: the clock angle turns fast; 1: arrives pushing back; 2: begins on another's way"),
    "family": TRAJECTORIES["family"],
    "first_sample": ("1", "row of /samples where the trajectory begins, at arrival (tau = 0)"),
}
INTEGER = {"trajectory": "<i4", "flags": "<u1", "family": "<i8", "first_sample": "<i8"}
ALONE = -1
"""The family of a trajectory that is like no other."""
JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG, CROSSING_FLAG = 1, 2, 4


def _layout(
    schema: str, samples: Mapping[str, tuple[str, str]], trajectories: Mapping[str, tuple[str, str]]
) -> Layout:
    return Layout(
        schema=schema,
        kind="data set",
        remedy="generate it again",
        error=DatasetError,
        groups={"samples": samples, "trajectories": trajectories},
        integers=INTEGER,
        chunks={"samples": 16_384, "trajectories": 4_096},
        texts=("mission",),
        since={"trajectories/family"},
    )


LAYOUT = _layout(SCHEMA, SAMPLES, TRAJECTORIES)
LAYOUT_IN_SPACE = _layout(SCHEMA_IN_SPACE, SAMPLES_IN_SPACE, TRAJECTORIES_IN_SPACE)
"""Of missions with an inclination; every other data set is laid out as before there were such."""


def layout_of(mission: Mission) -> Layout:
    """What data sets of a mission hold."""
    return LAYOUT_IN_SPACE if mission.inclined else LAYOUT

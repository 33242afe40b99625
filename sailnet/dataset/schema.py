"""Names, units and types of what a data set holds."""

from collections.abc import Mapping

from sailnet.artefacts.column_files import Layout
from sailnet.errors import DatasetError

SCHEMA = "sailnet-dataset/2"

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
    "first_sample": ("1", "row of /samples where the trajectory begins, at arrival (tau = 0)"),
}
INTEGER = {"trajectory": "<i4", "flags": "<u1", "first_sample": "<i8"}
JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG, CROSSING_FLAG = 1, 2, 4

LAYOUT = Layout(
    schema=SCHEMA,
    kind="data set",
    remedy="generate it again",
    error=DatasetError,
    groups={"samples": SAMPLES, "trajectories": TRAJECTORIES},
    integers=INTEGER,
    chunks={"samples": 16_384, "trajectories": 4_096},
    texts=("mission",),
)

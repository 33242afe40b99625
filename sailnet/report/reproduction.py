"""Figures 7, 8b and 8d, which need networks that do not fly otherwise: the paper's own, by ``make paper``.

Its report leaves what they show in ``reproduction.json``; the file of the last run that was shipped comes
with the package, and the page of the paper's campaign draws it.
"""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import resources
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.errors import SailnetError
from sailnet.mission.mission import Mission
from sailnet.networks.network import Network
from sailnet.physics.arrays import Array
from sailnet.report.bounds import BOUNDS, bound_columns
from sailnet.report.charts import BASELINE, NETWORK, OPTIMUM, PALETTE, Chart, Curve, page_columns
from sailnet.report.comparison import Row
from sailnet.report.optimum import Optimum
from sailnet.report.section5 import Flown, Section5

SCHEMA = "sailnet-reproduction/1"

FILE = "reproduction.json"

FOUR = {
    "tau": "N_τ, time of flight",
    "lambda_v_printed": "N_λv, costate",
    "alpha_pre_eq23": "N_αpre, preprocessed cone angle",
    "alpha": "N_α, cone angle as it is",
}
"""The networks of the paper's Table 1, by the names of our files."""

POINTS = 600
"""Of a flight, evenly over its periods."""

BEYOND = 1.15
"""Times the optimum at which the flight by two networks, which may never arrive, is cut."""


@dataclass(frozen=True)
class Reproduction:
    """A run of the paper's own recipe, for the page of its campaign.

    Attributes:
        section5: its flights.
        rows: the whole table "paper | here": data set, training, flights, times of a command.
        record: of :func:`reproduction_record`.
        remarks: to stand below the table.
    """

    section5: Section5
    rows: Sequence[Row]
    record: Mapping[str, Any]
    remarks: Sequence[str]


def reproduction_record(
    networks: Mapping[str, Network],
    histories: Mapping[str, Sequence[Mapping[str, float]]],
    three: Flown,
    two: Flown,
    software: Mapping[str, object],
) -> dict[str, Any]:
    """What the figures show, ready for JSON.

    Args:
        networks: at least those of Table 1.
        histories: theirs, epoch by epoch.
        three: Case 1 as three networks fly it.
        two: and as N_τ and N_α do.
        software: that flew it.
    """
    training = {
        name: page_columns(
            {
                part: np.array([epoch[part] for epoch in histories[name]])
                for part in ("epoch", "train", "validation", "test")
            }
        )
        for name in FOUR
    }
    flown = three.history
    rows = _some(len(flown.time))
    states = flown.ruv[rows]
    inputs = np.column_stack([states, flown.predicted_time_of_flight[rows]])
    shown = int((two.history.time <= BEYOND * three.extremal.time_of_flight).sum())
    two_rows = _some(shown)
    case = {
        "time": flown.time[rows],
        "lambda_v": networks["lambda_v_printed"](inputs),
        "two_time": two.history.time[two_rows],
        "two_cone": np.degrees(two.history.cone_angle[two_rows]),
    }
    return {
        "schema": SCHEMA,
        "transfer": _posed(networks["tau"].mission),
        "training": training,
        "case_1": page_columns(case),
        "two_networks": {
            "stopped": bool(two.flights.stopped[0]),
            "error": two.error.tolist(),
            "cut": shown < len(two.history.time),
        },
        "networks": {name: networks[name].provenance["revision"] for name in FOUR},
        "software": dict(software),
    }


def _some(count: int) -> NDArray[np.intp]:
    return np.unique(np.linspace(0, count - 1, min(count, POINTS)).astype(np.intp))


def shipped_record(mission: Mission) -> dict[str, Any] | None:
    """That of a mission's last run that was shipped; None if there was none.

    Raises:
        SailnetError: it is damaged, or of another version.
    """
    path = resources.files("sailnet") / "shipped" / mission.name / FILE
    if not path.is_file():
        return None
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        if record["schema"] != SCHEMA:
            raise SailnetError(f"{path} has schema {record['schema']!r}, this version reads {SCHEMA!r}")
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise SailnetError(f"cannot read {path}: {error}; install sailnet again") from error
    return dict(record) if record["transfer"] == _posed(mission) else None


def _posed(mission: Mission) -> dict[str, float]:
    """The numbers of a mission's problem."""
    problem = mission.problem
    return {name: getattr(problem, name) for name in ("beta", "phi_max", "delta", "target_radius")}


def reproduction_charts(record: Mapping[str, Any], optimum: Optimum, bound: float) -> list[Chart]:
    """Figs 7, 8b and 8d.

    Args:
        record: of :func:`reproduction_record`.
        optimum: of Case 1.
        bound: on the cone angle [deg].
    """
    return [*(_training(name, record["training"][name]) for name in FOUR), *_case_1(record, optimum, bound)]


def _training(name: str, columns: Mapping[str, list[float]]) -> Chart:
    curves = [
        Curve("epoch", "train", "training", colour=PALETTE[0]),
        Curve("epoch", "validation", "validation", colour=PALETTE[1], dash=True),
        Curve("epoch", "test", "test", colour=PALETTE[2], dash=True, width=1.0),
    ]
    return Chart(
        f"fig-7-{name.replace('_', '-')}",
        f"Fig. 7: training of {FOUR[name]}",
        "Mean squared error of the output scaled to [0, 1]; the paper's recipe, trained here.",
        "epoch",
        "mean squared error",
        curves,
        {key: np.array(values, float) for key, values in columns.items()},
        logarithmic="y",
    )


def _case_1(record: Mapping[str, Any], optimum: Optimum, bound: float) -> list[Chart]:
    flown = {key: np.array(values, float) for key, values in record["case_1"].items()}
    columns: dict[str, Array] = {
        **flown,
        "optimum_time": optimum.time,
        "optimum_lambda_v": optimum.columns[:, 5],
        "optimum_cone": np.degrees(optimum.columns[:, 6]),
        **bound_columns(bound, 0.0, flown["two_time"][-1], signed=True),
    }
    costate = Chart(
        "fig-8b",
        "Fig. 8b: costate λ_v, Case 1",
        "By the paper's own N_λv along a flight of three networks of its recipe; only the sign is used.",
        "time [TU]",
        "λ_v [TU²/AU]",
        [
            Curve("optimum_time", "optimum_lambda_v", "optimum", colour=OPTIMUM, width=3.5),
            Curve("time", "lambda_v", "N_λv", colour=NETWORK),
        ],
    )
    facts = record["two_networks"]
    end = (
        f"The flight ends {max(facts['error']):.1e} from the target."
        if facts["stopped"]
        else "It never meets the stop rule."
    )
    if facts["cut"]:
        end += f" Cut at {BEYOND:g} times the optimum."
    two = Chart(
        "fig-8d",
        "Fig. 8d: cone angle by two networks, Case 1",
        f"N_τ and N_α of the paper's recipe, without preprocessing. {end}",
        "time [TU]",
        "cone angle [deg]",
        [
            *BOUNDS,
            Curve("optimum_time", "optimum_cone", "optimum", colour=OPTIMUM, width=3.5),
            Curve("two_time", "two_cone", "two networks", "steps", colour=BASELINE),
        ],
    )
    return [costate.with_columns(columns), two.with_columns(columns)]

"""The page that flies: the module, the stored optima and what the mission says, in one file."""

import base64
import json
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet import __version__
from sailnet.artefacts.files import write_text, writing
from sailnet.campaign.printed import CASES, NOISE_START
from sailnet.errors import SailnetError, reason
from sailnet.flight.plant import OPTICS_COEFFICIENTS, rules
from sailnet.guidance.backends import load_guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.optics import OPTICS
from sailnet.physics.units import AU, AU_PER_TU, DAY, TU
from sailnet.report.page import render
from sailnet.report.playground.extremal_script import extremal_script
from sailnet.report.playground.module import FOLDER, module
from sailnet.report.playground.stored_optima import AXES, OPTIMA, SHARES, starts

MISSION = "earth_mars"
"""Whose networks are in the page."""

PERIODS = (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1)
"""Guidance periods that can be chosen [TU]."""

SCRIPTS = ("machine.js", "optimum.js", "drawing.js", "playground.js")

AGREEMENT = "1e-9"
"""What whole flights differ by from native ones at most [AU, AU/TU]; a test holds them to it."""


@dataclass(frozen=True)
class Slider:
    """Of the page: a quantity, how it is called and where it goes from and to."""

    name: str
    label: str
    low: float
    high: float
    step: float


def _along(name: str, label: str) -> Slider:
    values = AXES[name].values
    return Slider(name, label, float(values[0]), float(values[-1]), 0.01)


GROUPS = (
    ("start", (_along("r", "distance r"), _along("u", "radial speed u"), _along("v", "transverse v"))),
    (
        "the sail that flies",
        (Slider("bias", "β differs by", -0.2, 0.2, 0.01), Slider("noise", "β noise", 0.0, 0.3, 0.01)),
    ),
    (
        "on board",
        (
            Slider("delay", "delay", 0.0, 0.1, 0.002),
            Slider("period", "guidance period", 0, len(PERIODS) - 1, 1),
        ),
    ),
)
STARTS = {"Earth's orbit": CASES["Case 1"], "Case 2": CASES["Case 2"], "start of Section 5.2": NOISE_START}
SAILS = {"ideal": "ideal", "jpl": "JPL's square sail", "nasa": "NASA's reference sail"}
HANDLES = (("position", "distance r at the start", "r"), ("velocity", "velocity u, v at the start", "v"))


def _plain(value: NDArray[Any] | np.void) -> Any:
    """A structure of the plant as JSON has it."""
    names = value.dtype.names
    return value.tolist() if names is None else {name: _plain(value[name]) for name in names}


def content_of(mission: Mission) -> dict[str, Any]:
    """What the scripts of the page read."""
    given = rules(mission, Disturbance(), mission.flight.period, load_guidance(mission).beta_range)
    try:
        optima = json.loads(OPTIMA.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise SailnetError(f"cannot read {OPTIMA}: {reason(error)}; install sailnet again") from error
    if optima["mission"] != mission.digest("sail", "transfer"):
        raise SailnetError(
            f"{OPTIMA} is of another mission: python -m sailnet.report.playground.stored_optima"
        )
    r, u, v = CASES["Case 1"]
    nothing = {"bias": 0, "noise": 0, "optics": "ideal", "delay": 0, "seed": 0}
    return {
        "rules": _plain(given),
        "optics": {name: dict(zip(OPTICS_COEFFICIENTS, OPTICS[name].force, strict=True)) for name in SAILS},
        "units": {"days": TU / DAY, "kilometres": AU / 1e3, "kilometres_per_second": AU_PER_TU / 1e3},
        "orbits": {"departure": mission.transfer.departure_radius, "target": mission.transfer.target_radius},
        "target": dict(zip("ruv", mission.problem.target_state, strict=True)),
        "bound": mission.sail.max_cone_angle,
        "tolerance": mission.flight.arrival_tolerance,
        "periods": PERIODS,
        "first": {"r": r, "u": u, "v": v, "period": mission.flight.period, **nothing},
        "optima": optima,
    }


def playground_page(command: str = "sailnet playground", documentation: str = "") -> str:
    """The page.

    Args:
        command: that writes it again.
        documentation: where a link to it leads, if it is to have one.

    Raises:
        GuidanceError: the module or the guidance is missing or damaged.
        SailnetError: the stored optima are, or are another mission's.
    """
    mission, compiled = load_mission(MISSION), module()
    text = json.dumps(content_of(mission), ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    scripts = [(FOLDER / name).read_text(encoding="utf-8") for name in SCRIPTS]
    return render(
        "playground.html.jinja",
        FOLDER,
        title=mission.title,
        documentation=documentation,
        handles=[(name, label, AXES[axis]) for name, label, axis in HANDLES],
        groups=GROUPS,
        starts=STARTS,
        optics=SAILS,
        bound=f"{mission.sail.max_cone_angle:g}",
        agreement=AGREEMENT,
        count=f"{len(starts()):,}",
        shares=", ".join(f"{share:g}" for share in SHARES),
        module_size=f"{len(compiled) / 1e3:.0f}",
        digest=_digest_of(compiled),
        version=__version__,
        command=command,
        content=text.replace("<", "\\u003c"),
        module=base64.b64encode(compiled).decode("ascii"),
        scripts=[extremal_script(mission.problem), *scripts],
    )


def _digest_of(compiled: bytes) -> str:
    """SHA-256 of the sources, which the module carries."""
    found = re.search(rb"[0-9a-f]{64}", compiled)
    return found[0].decode("ascii") if found else "unknown"


def write_playground(path: Path, command: str = "sailnet playground", documentation: str = "") -> int:
    """Write the page; returns its size in bytes. Arguments and errors as for :func:`playground_page`."""
    text = playground_page(command, documentation)
    with writing(path):
        write_text(path, text)
    return len(text.encode("utf-8"))

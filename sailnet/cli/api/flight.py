"""A closed-loop flight: ``load_guidance`` and ``fly``, and what they give."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from sailnet.artefacts.named_columns import Frame, NamedColumns
from sailnet.campaign.columns import layout_of
from sailnet.campaign.flown_columns import record_columns
from sailnet.cli import fly as fly_command
from sailnet.cli.api.missions import AnyMission, mission_of
from sailnet.cli.output import printed
from sailnet.errors import SailnetError
from sailnet.flight.closed_loop import Flights, History, fly_recorded
from sailnet.guidance import backends
from sailnet.guidance.backends import Backend
from sailnet.guidance.interface import Guidance, Layout, Precision
from sailnet.mission.disturbances import Disturbance, disturbance_from
from sailnet.mission.mission import Mission
from sailnet.report import need_pictures, report


@dataclass(frozen=True, repr=False)
class Flight:
    """One closed-loop flight; ``print`` shows it with units.

    Attributes:
        mission: that was flown.
        disturbance: of sail, navigation and actuator.
        flights: how it ended, in arrays of length 1.
        history: of it, period by period.
    """

    mission: Mission
    disturbance: Disturbance
    flights: Flights
    history: History

    @property
    def arrived(self) -> bool:
        """Whether it stopped within the mission's tolerance, no command out of bounds."""
        return bool(self.flights.arrived[0])

    @property
    def time_of_flight(self) -> float:
        """How long it flew [TU]."""
        return float(self.flights.time_of_flight[0])

    def columns(self) -> NamedColumns:
        """A row a guidance period: truth, what navigation showed, commands and estimates, with units."""
        units, values = layout_of(self.mission).groups["records"], record_columns(self.history)
        return NamedColumns({name: (unit, values[name]) for name, (unit, _) in units.items()})

    def to_frame(self) -> Frame:
        """:meth:`columns` as a ``pandas.DataFrame``."""
        return self.columns().to_frame()

    def plot(self) -> Any:
        """Path, commands, state, approach and what guidance believes, as a ``matplotlib`` figure.

        Raises:
            SailnetError: matplotlib is not installed.
        """
        need_pictures()
        drawn = report("flight_charts")
        charts = drawn.flight_charts(self.mission, drawn.flight_columns(self.mission, self.history, None))
        return report("charts").shown_figure(charts, columns=2)

    def __repr__(self) -> str:
        return printed(fly_command.facts_of(self.flights, self.history), fly_command.LINES)


def load_guidance(
    mission: AnyMission = "earth_mars",
    backend: Backend = "c",
    precision: Precision = "float64",
    folder: str | Path | None = None,
    layout: Layout = "flight",
) -> Guidance:
    """Networks that fly: those shipped for a mission, or one's own.

    Args:
        mission: a :class:`Mission`, its name or a TOML file; networks of another one are refused.
        backend: ``c``, the exported file compiled, or ``onnx``, its graph in onnxruntime.
        precision: of the arithmetic, ``float64`` or ``float32``.
        folder: of the exported files; by default those shipped with the package.
        layout: of the C: ``flight`` is the file that goes on board, ``host`` its form on vectors.

    Raises:
        GuidanceError: a file is missing, damaged, or of another mission.

    >>> import sailnet
    >>> guidance = sailnet.load_guidance("earth_mars")
    >>> command = guidance.command([(1.0, 0.0, 1.0)])
    >>> f"cone angle {command.cone_angle[0]:.2f} rad, {command.time_of_flight[0]:.2f} TU to go"
    'cone angle 0.38 rad, 7.01 TU to go'
    """
    chosen = mission_of(mission)
    where = None if folder is None else Path(folder)
    return backends.load_guidance(chosen, backend, precision, where, layout)


def fly(
    mission: AnyMission,
    start: ArrayLike,
    guidance: Guidance | None = None,
    *,
    period: float | None = None,
    seed: int | None = None,
    **disturbances: float | str,
) -> Flight:
    """One closed-loop flight, recorded period by period.

    Args:
        mission: a :class:`Mission`, its name or a TOML file.
        start: (3,) r [AU], u, v [AU/TU], or (5,) r, latitude [rad], u, v, w in three dimensions.
        guidance: of :func:`load_guidance`; the networks shipped for the mission by default.
        period: guidance period [TU]; the mission's by default.
        seed: of every random number; the mission's by default.
        disturbances: by name, ``beta_bias=-0.12``, on top of the mission's own; all names and units are
            those of :class:`sailnet.mission.disturbances.Disturbance`.

    Raises:
        SailnetError: a start or a disturbance that cannot be.
        GuidanceError: no networks for this mission.

    >>> import sailnet
    >>> flight = sailnet.fly("earth_mars", (1.05, 0.15, 1.03), beta_bias=-0.05)
    >>> flight.arrived, f"{flight.time_of_flight:.2f} TU"
    (True, '6.25 TU')
    >>> flight.columns().units["attitude"]
    'rad'
    """
    chosen = mission_of(mission)
    pilot = load_guidance(chosen) if guidance is None else guidance
    disturbance = disturbed(chosen, seed, disturbances)
    starts = np.atleast_2d(np.asarray(start, float))
    if len(starts) != 1:
        raise SailnetError(f"fly takes one start, not {len(starts)}: evaluate flies many")
    flights, (history,) = fly_recorded(chosen, pilot, starts, disturbance=disturbance, period=period)
    return Flight(chosen, disturbance, flights, history)


def disturbed(mission: Mission, seed: int | None, disturbances: dict[str, float | str]) -> Disturbance:
    """Disturbances by name on top of a mission's own."""
    given: dict[str, object] = dict(disturbances)
    if seed is not None:
        given["seed"] = seed
    return disturbance_from(given, mission.disturbance)

"""The optimum: ``solve``, ``solve_states`` and ``sample``, and what they give."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from sailnet.artefacts.named_columns import Frame, NamedColumns
from sailnet.cli.api.missions import AnyMission, mission_of
from sailnet.cli.output import printed
from sailnet.cli.solve import LINES, LINES_IN_SPACE, facts_of
from sailnet.errors import SailnetError
from sailnet.expert import any_dimension, fastest, fastest_in_space
from sailnet.expert.nominal import departure_optimum
from sailnet.expert.optima import Extremal, Optima
from sailnet.mission.mission import Mission
from sailnet.physics.units import DAY, TU
from sailnet.report import need_pictures, report
from sailnet.report.optimum import COLUMNS_IN_SPACE, Optimum

COMPONENTS = {
    "state": {"r": "AU", "u": "AU/TU", "v": "AU/TU"},
    "costates": {"lambda_r": "TU/AU", "lambda_u": "TU^2/AU", "lambda_v": "TU^2/AU"},
}
"""Names and units of the columns of (n, 3) attributes of ``Optima``."""

COMPONENTS_IN_SPACE = {
    "state": dict(list(COLUMNS_IN_SPACE.items())[:5]),
    "costates": dict(list(COLUMNS_IN_SPACE.items())[5:10]),
}
"""Of (n, 5) ones."""

SCALARS = {
    "time_of_flight": "TU", "cone_angle": "rad", "jumps": "1", "jump_time": "TU", "residual": "1",
    "rival_time": "TU", "complete": "1",
}  # fmt: skip
"""Units of its (n,) attributes."""


@dataclass(frozen=True, repr=False)
class OptimalTransfer:
    """The minimum-time transfer from one state; ``print`` shows it with units.

    Attributes:
        mission: whose problem it solves.
        extremal: all that is known of it: costates, cone angle and jumps, see
            :class:`sailnet.expert.optima.Extremal`.
    """

    mission: Mission
    extremal: Extremal

    @property
    def time_of_flight(self) -> float:
        """Shortest time to the target orbit [TU]."""
        return self.extremal.time_of_flight

    @property
    def days(self) -> float:
        """The same in days."""
        return self.time_of_flight * TU / DAY

    def to_frame(self) -> Frame:
        """Time, state, costates and cone angle along the way as a ``pandas.DataFrame``."""
        return sample(self).to_frame()

    def plot(self) -> Any:
        """Path, cone angle, state and costates as a ``matplotlib`` figure.

        Raises:
            SailnetError: matplotlib is not installed; or it has three dimensions.
        """
        if len(self.extremal.state) == 5:
            raise SailnetError("plot draws flights in the plane; in three dimensions there is to_frame()")
        need_pictures()
        charts = report("optimum_charts").optimum_charts(self.mission, self.extremal)
        return report("charts").shown_figure(charts, columns=2)

    def __repr__(self) -> str:
        state = {"state": self.extremal.state.tolist()}
        lines = LINES if len(self.extremal.state) == 3 else LINES_IN_SPACE
        return printed({**state, **facts_of(self.extremal)}, lines)


@dataclass(frozen=True, repr=False)
class OptimalTransfers(Sequence[OptimalTransfer]):
    """The minimum-time transfers from many states, one a row; item i is that from state i.

    Attributes:
        mission: whose problem they solve.
        optima: arrays with a row a state, NaN where none was found, see
            :class:`sailnet.expert.optima.Optima`.
    """

    mission: Mission
    optima: Optima

    def __len__(self) -> int:
        return len(self.optima.state)

    def __getitem__(self, row: Any) -> Any:
        if isinstance(row, slice):
            return OptimalTransfers(self.mission, self.optima.rows(row))
        return OptimalTransfer(self.mission, self.optima.extremal(range(len(self))[row]))

    def columns(self) -> NamedColumns:
        """All that is known of each, a row a state, with units."""
        components = COMPONENTS if self.optima.state.shape[1] == 3 else COMPONENTS_IN_SPACE
        of_each = {
            name: (unit, values)
            for attribute, units in components.items()
            for (name, unit), values in zip(units.items(), getattr(self.optima, attribute).T, strict=True)
        }
        return NamedColumns(
            of_each | {name: (unit, getattr(self.optima, name)) for name, unit in SCALARS.items()}
        )

    def to_frame(self) -> Frame:
        """:meth:`columns` as a ``pandas.DataFrame``."""
        return self.columns().to_frame()

    def __repr__(self) -> str:
        return f"{int(self.optima.found.sum())} of {len(self)} states solved\n{self.columns()!r}"


def solve(mission: AnyMission = "earth_mars", state: ArrayLike | None = None) -> OptimalTransfer:
    """The minimum-time transfer from a state to the mission's target orbit.

    Args:
        mission: a :class:`Mission`, its name or a TOML file.
        state: (3,) r [AU], u, v [AU/TU], or (5,) r, latitude [rad], u, v, w in three dimensions; the
            mission's departure orbit by default.

    Raises:
        MissionError: no such mission.
        SolveError: the state cannot be, or no extremal was found from it.

    >>> import sailnet
    >>> optimum = sailnet.solve("earth_mars", (1.05, 0.15, 1.03))
    >>> f"{optimum.time_of_flight:.4f} TU are {optimum.days:.1f} days"
    '6.1552 TU are 357.8 days'
    >>> optimum.extremal.jumps  # the cone angle jumps once on the way
    1
    """
    chosen = mission_of(mission)
    if state is not None:
        solved_by = fastest_in_space if chosen.inclined else any_dimension
        extremal = solved_by.solve(chosen.problem, state)
    else:
        extremal = departure_optimum(chosen)
    return OptimalTransfer(chosen, extremal)


def solve_states(mission: AnyMission, states: ArrayLike) -> OptimalTransfers:
    """The minimum-time transfers from many states: one index of extremals serves all of them.

    Args:
        mission: a :class:`Mission`, its name or a TOML file.
        states: (n, 3) rows r [AU], u, v [AU/TU]; or (n, 5) rows r, latitude [rad], u, v, w in three
            dimensions.

    Raises:
        MissionError: no such mission.
        SolveError: a state cannot be, or is on the target orbit.

    >>> import sailnet
    >>> optima = sailnet.solve_states("earth_mars", [(1.05, 0.15, 1.03), (1.05, 0.14, 1.03)])
    >>> [round(optimum.time_of_flight, 4) for optimum in optima]
    [6.1552, 6.1699]
    """
    chosen = mission_of(mission)
    given = np.asarray(states, float)
    if chosen.inclined or given.shape[-1:] == (5,):
        return OptimalTransfers(chosen, fastest_in_space.solve_states(chosen.problem, given))
    return OptimalTransfers(chosen, fastest.solve_states(chosen.problem, given))


def sample(optimum: OptimalTransfer, count: int = 501) -> NamedColumns:
    """An optimum from departure to arrival, evenly in time.

    Args:
        optimum: of :func:`solve`, or an item of :func:`solve_states`.
        count: rows.

    Returns:
        Columns ``time``, ``r``, ``u``, ``v``, ``lambda_r``, ``lambda_u``, ``lambda_v``, ``cone_angle``; in
        three dimensions ``latitude``, ``w``, their costates and ``clock_angle`` as well.

    >>> import sailnet
    >>> path = sailnet.sample(sailnet.solve("earth_mars", (1.05, 0.15, 1.03)), 101)
    >>> path.units["cone_angle"], path.rows
    ('rad', 101)
    >>> f"arrives at r = {path['r'][-1]:.4f} {path.units['r']}"
    'arrives at r = 1.5240 AU'
    """
    return Optimum.of(optimum.mission.problem, optimum.extremal, count).named()

"""How the problems of the papers are shown: units, names of axes, paths through space."""

from collections.abc import Mapping, Sequence

import numpy as np
from scipy.integrate import cumulative_trapezoid

from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.solution import Solution
from sailnet.ocp.problems import (
    asteroid_rendezvous,
    earth_dionysus,
    earth_mars,
    equinoctial,
    leo_geo,
    lunar_landing,
    mars_landing,
)
from sailnet.papers.views import NONE, Group, Motion, Plane, View
from sailnet.physics.arrays import Array
from sailnet.physics.units import DAY, HOUR


def view_of(problem: Problem) -> View:
    """How a problem is shown; one that is not of the papers, without units."""
    if problem.name in VIEWS:
        return VIEWS[problem.name]
    names = problem.names
    states = Group("States", NONE, {name: name for name in names["states"]})
    controls = Group("Controls", NONE, {name: name for name in names["controls"]})
    return View(problem.name, [states], [controls])


def _cartesian(solution: Solution) -> Array:
    return solution.state[:, :6]


def _equinoctial(solution: Solution) -> Array:
    return np.vstack(equinoctial.to_position(solution.state[:, :6].T)).T


def _polar(radial: str) -> Motion:
    """Of states r, v and a radial velocity; the angle is a state ``theta``, or follows from them."""

    def motion(solution: Solution) -> Array:
        r, v, u = solution["r"], solution["v"], solution[radial]
        angle = cumulative_trapezoid(v / r, solution.time, initial=0.0)
        if "theta" in solution.names["states"]:
            angle = solution["theta"]
        cos, sin, zero = np.cos(angle), np.sin(angle), np.zeros_like(r)
        return np.array([r * cos, r * sin, zero, u * cos - v * sin, u * sin + v * cos, zero]).T

    return motion


def _same(names: Sequence[str]) -> dict[str, str]:
    return {name: name for name in names}


def _elements(unit: str, scale: float) -> list[Group]:
    return [
        Group("Semi-latus rectum", unit, {"p": "p"}, scale),
        Group("Eccentricity and inclination", NONE, _same("fghk")),
        Group("True longitude", "rad", {"L": "L"}),
    ]


def _engine(directions: Sequence[str], throttle: bool = True) -> list[Group]:
    axes = {f"alpha_{axis}": f"α_{axis}" for axis in directions}
    thrust = [Group("Throttle", NONE, {"delta": "δ"})] if throttle else []
    return [*thrust, Group("Direction of thrust", NONE, axes)]


def _mass(scale: float) -> Group:
    return Group("Mass", "kg", {"m": "m"}, scale)


_V = ("v_x", "v_y", "v_z")
_ASTEROID = asteroid_rendezvous.problem().units
_REL = ("r_x", "r_y", "r_z")


def _reorientation(title: str, spins: int) -> View:
    numbers = "123"[:spins]
    return View(
        title,
        [
            Group("Attitude", NONE, {"x_1": "x_1", "x_2": "x_2"}),
            Group("Angular velocity", NONE, {f"omega_{i}": f"ω_{i}" for i in numbers}),
        ],
        [Group("Torques", NONE, {f"u_{i}": f"u_{i}" for i in numbers})],
        ("t_f", NONE, 1.0),
        planes=[
            Plane("Path of the attitude", "x_1", "x_2", "x_1", "x_2"),
            Plane("Path of the angular velocity", "omega_1", "omega_2", "ω_1", "ω_2"),
        ],
    )


def _transfer_to_geo(title: str, cost: tuple[str, str, float], throttle: str) -> View:
    return View(
        title,
        [*_elements("km", leo_geo.LENGTH), _mass(leo_geo.MASS)],
        _engine("rtn", bool(throttle)),
        cost,
        "h",
        leo_geo.TIME / HOUR,
        motion=_equinoctial,
        body="Earth",
        length_unit="km",
        length_scale=leo_geo.LENGTH,
        throttle=throttle,
    )


VIEWS: Mapping[str, View] = {
    "earth-mars": View(
        "Earth to Mars with the least fuel",
        [
            Group("Position", "AU", _same("xyz")),
            Group("Velocity", "km/s", _same(_V), earth_mars.LENGTH / earth_mars.TIME),
            _mass(earth_mars.MASS),
        ],
        _engine("xyz"),
        ("fuel", "kg", earth_mars.MASS),
        "d",
        earth_mars.TIME / DAY,
        motion=_cartesian,
        body="Sun",
        throttle="delta",
    ),
    "mars-landing": View(
        "Powered landing on Mars",
        [
            Group("Position", "m", _same("xyz"), mars_landing.LENGTH),
            Group("Velocity", "m/s", _same(_V), mars_landing.LENGTH / mars_landing.TIME),
            _mass(mars_landing.MASS),
        ],
        _engine("xyz"),
        ("fuel", "kg", mars_landing.MASS),
        "s",
        mars_landing.TIME,
        planes=[
            Plane("Path, from the side", "x", "z", "x", "height z"),
            Plane("Path, from above", "x", "y", "x", "y"),
        ],
        throttle="delta",
        coasting="least thrust",
    ),
    "intercept": View(
        "Intercept of an accelerating target",
        [Group("Relative position", "m", _same(_REL)), Group("Relative velocity", "m/s", _same(_V))],
        [Group("Acceleration", "m/s²", _same(("a_x", "a_y", "a_z")))],
        ("J", NONE, 1.0),
        "s",
        planes=[
            Plane("Path of the target, seen from the interceptor: x-y", "r_x", "r_y", "r_x", "r_y"),
            Plane("Path of the target, seen from the interceptor: x-z", "r_x", "r_z", "r_x", "r_z"),
        ],
    ),
    "goddard": View(
        "Goddard's rocket",
        [
            Group(title, NONE, {name: name})
            for title, name in (("Altitude", "h"), ("Speed", "v"), ("Mass", "m"))
        ],
        [Group("Thrust: −1 is none, 1 is T_max", NONE, {"u": "u"})],
        ("h(t_f)", NONE, -1.0),
        planes=[Plane("Speed over altitude", "h", "v", "altitude h", "speed v")],
        throttle="u",
    ),
    "reorientation-1": _reorientation("Reorientation, three torques", 3),
    "reorientation-2": _reorientation("Reorientation, two torques", 2),
    "earth-dionysus": View(
        "Earth to Dionysus",
        [*_elements("AU", 1.0), _mass(earth_dionysus.MASS)],
        _engine("rtn"),
        ("m(t_f)", "kg", -earth_dionysus.MASS),
        "d",
        earth_dionysus.TIME / DAY,
        motion=_equinoctial,
        body="Sun",
        throttle="delta",
    ),
    "lunar-landing": View(
        "Soft landing on the Moon",
        [
            Group("Height", "m", {"y": "y"}, lunar_landing.HEIGHT),
            Group("Speed", "m/s", {"v": "v"}, lunar_landing.HEIGHT / lunar_landing.TIME),
            _mass(lunar_landing.MASS),
        ],
        [Group("Mass flow", "kg/s", {"u": "u"}, lunar_landing.MOST_FLOW)],
        ("t_f", "s", lunar_landing.TIME),
        "s",
        lunar_landing.TIME,
        planes=[Plane("Height over speed", "v", "y", "speed v", "height y")],
        throttle="u",
    ),
    "asteroid-rendezvous": View(
        "Rendezvous with an asteroid",
        [
            Group("Distance from the Sun", "AU", {"r": "r"}),
            Group("Angle", "rad", {"theta": "θ"}),
            Group(
                "Velocity",
                "km/s",
                {"w": "radial w", "v": "transverse v"},
                1e-3 * _ASTEROID["length [m]"] / _ASTEROID["time [s]"],
            ),
            _mass(_ASTEROID["mass [kg]"]),
        ],
        _engine("rt"),
        ("fuel", "kg", _ASTEROID["mass [kg]"]),
        "d",
        _ASTEROID["time [s]"] / DAY,
        motion=_polar("w"),
        body="Sun",
        flat=True,
        throttle="delta",
    ),
    "leo-geo-time": _transfer_to_geo("LEO to GEO in the least time", ("t_f", "h", leo_geo.TIME / HOUR), ""),
    "leo-geo-fuel": _transfer_to_geo(
        "LEO to GEO with the least fuel", ("m(t_f)", "kg", -leo_geo.MASS), "delta"
    ),
    "solar-sail": View(
        "The solar sail, Earth to Mars",
        [
            Group("Distance from the Sun", "AU", {"r": "r"}),
            Group("Velocity", "AU/TU", {"u": "radial u", "v": "transverse v"}),
        ],
        [Group("Cone angle", "deg", {"alpha": "α"}, float(np.degrees(1.0)))],
        ("t_f", "TU", 1.0),
        "TU",
        motion=_polar("u"),
        body="Sun",
        flat=True,
    ),
}
"""By the problem's name."""

"""The charts of one flight, without what they show."""

from dataclasses import replace

from sailnet.mission.mission import Mission
from sailnet.report.bounds import BOUNDS
from sailnet.report.charts import BAD, BASELINE, GREY, NETWORK, OPTIMUM, PALETTE, Chart, Curve


def path_chart(in_space: bool, said: str, flown: list[Curve]) -> Chart:
    """The path of a flight or an optimum among the orbits and the Sun; in space it can be turned.

    Args:
        in_space: whether there is more than a plane to see.
        said: of what is drawn, for the caption.
        flown: curves of ``x`` and ``y``; in space each gets its ``z``.
    """
    curves = [
        Curve("departure_x", "departure_y", "departure orbit", colour=GREY, dash=True, width=1.0),
        Curve("target_x", "target_y", "target orbit", colour=GREY, width=1.0),
        *flown,
        Curve("sun_x", "sun_y", "", "points", colour="#f2b705", width=11.0),
    ]
    orbits = f"Heliocentric; the circles are departure and target orbit, {said}."
    if not in_space:
        return Chart("path", "Path", orbits, "X [AU]", "Y [AU]", curves, equal=True)
    lifted = [replace(curve, z=curve.y.removesuffix("y") + "z") for curve in curves]
    turned = " Z is drawn larger than it is; mouse or finger turn the picture."
    return Chart("path", "Path", orbits + turned, "X [AU]", "Y [AU]", lifted, z="Z [AU]")


def flight_templates(mission: Mission) -> list[Chart]:
    """The charts of one flight; :func:`flight_columns` gives what they show."""
    bound = f"{'' if mission.inclined else '±'}{mission.sail.max_cone_angle:g}"
    speeds = "u, v, w" if mission.inclined else "u, v"

    def optimal(x: str, y: str, label: str) -> Curve:
        return Curve(x, y, label, colour=OPTIMUM, width=3.5)

    first, second, third, fourth, fifth = (PALETTE[place] for place in (0, 3, 2, 4, 5))
    return [
        path_chart(
            mission.inclined,
            "the optimum is the assumed sail's",
            [
                optimal("optimum_x", "optimum_y", "optimum"),
                Curve("x", "y", "flown", colour=NETWORK),
                Curve("start_x", "start_y", "departure", "points", colour=GREY, width=8.0),
                Curve("end_x", "end_y", "end", "points", colour=NETWORK, width=8.0),
            ],
        ),
        Chart(
            "command",
            "Cone angle",
            f"Dashed: the bound of {bound}°.",
            "time [TU]",
            "cone angle [deg]",
            [
                *BOUNDS,
                optimal("optimum_time", "optimum_cone", "optimum"),
                Curve("time", "attitude", "flown", "steps", colour=BASELINE),
                Curve("time", "cone", "commanded", "steps", colour=NETWORK),
            ],
        ),
        Chart(
            "clock",
            "Clock angle",
            "Of the sail's normal about the Sun line, from the transverse direction to the north.",
            "time [TU]",
            "clock angle [deg]",
            [
                optimal("optimum_time", "optimum_clock", "optimum"),
                Curve("time", "attitude_clock", "flown", "steps", colour=BASELINE),
                Curve("time", "clock", "commanded", "steps", colour=NETWORK),
            ],
        ),
        Chart(
            "state",
            "State",
            "Thick: the optimum of the sail as assumed, from the same start.",
            "time [TU]",
            f"r [AU], {speeds} [AU/TU]",
            [
                optimal("optimum_time", "optimum_r", ""),
                optimal("optimum_time", "optimum_u", ""),
                optimal("optimum_time", "optimum_v", ""),
                optimal("optimum_time", "optimum_w", ""),
                Curve("time", "r", "r", colour=first),
                Curve("time", "u", "u", colour=second),
                Curve("time", "v", "v", colour=third),
                Curve("time", "w", "w", colour=fourth),
            ],
        ),
        Chart(
            "latitude",
            "Latitude",
            "Over the plane of the target orbit.",
            "time [TU]",
            "latitude [deg]",
            [
                optimal("optimum_time", "optimum_latitude", "optimum"),
                Curve("time", "latitude", "flown", colour=NETWORK),
            ],
        ),
        Chart(
            "approach",
            "Distance from the target",
            "Size of each component of the deviation; dashed: the tolerance for arrival.",
            "time [TU]",
            "deviation [AU, AU/TU]",
            [
                Curve("span", "tolerance", "", colour=GREY, dash=True, width=1.0),
                Curve("time", "off_r", "Δr", colour=first),
                Curve("time", "off_u", "Δu", colour=second),
                Curve("time", "off_v", "Δv", colour=third),
                Curve("time", "off_w", "Δw", colour=fourth),
                Curve("time", "off_latitude", "Δlatitude x target's radius", colour=fifth),
            ],
            logarithmic="y",
        ),
        Chart(
            "left",
            "Time left",
            "What the network predicts along the way; the flight ends by it. Marked: without a state, where "
            "the sail must be by what it was told; beyond that it faces the Sun, and nothing is predicted.",
            "time [TU]",
            "time of flight left [TU]",
            [
                optimal("optimum_time", "optimum_left", "of the optimum"),
                Curve("time", "left", "predicted", colour=NETWORK),
                Curve("time", "left_reckoned", "by dead reckoning", "points", colour=second, width=4.0),
                Curve("time", "left_outside", "outside the domain", "points", colour=third, width=4.0),
                Curve("time", "left_unknown", "no state: faces the Sun", "points", colour=BAD, width=4.0),
            ],
        ),
        Chart(
            "beta",
            "β of the sail",
            "Real, and as guidance estimates it on board, against the mission's.",
            "time [TU]",
            "β above the mission's [%]",
            [
                Curve("time", "beta", "real", "steps", colour=OPTIMUM, width=1.0),
                Curve("time", "beta_estimate", "estimated", colour=NETWORK),
                Curve("time", "beta_at_limit", "no thrust margin left", "points", colour=BAD, width=4.0),
            ],
        ),
        Chart(
            "navigation",
            "Error of navigation",
            "What guidance was shown less what is; gaps are outages.",
            "time [TU]",
            "shown − real [AU, AU/TU]",
            [
                Curve("time", "seen_r", "r", colour=first, width=1.0),
                Curve("time", "seen_u", "u", colour=second, width=1.0),
                Curve("time", "seen_v", "v", colour=third, width=1.0),
                Curve("time", "seen_w", "w", colour=fourth, width=1.0),
                Curve("time", "seen_latitude", "latitude [rad]", colour=fifth, width=1.0),
            ],
        ),
    ]

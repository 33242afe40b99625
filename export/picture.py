"""The README's picture: the mission flown from its departure orbit by the flight file, beside the optimum."""

from pathlib import Path

from sailnet.expert.nominal import departure_optimum
from sailnet.flight.closed_loop import fly_recorded
from sailnet.guidance.backends import load_guidance
from sailnet.mission.mission import Mission
from sailnet.report.charts import write_picture
from sailnet.report.flight_charts import flight_charts, flight_columns
from sailnet.report.optimum import Optimum

SHOWN = ("Path", "Cone angle", "Clock angle")


def draw_departure(path: Path, mission: Mission, folder: Path) -> None:
    """Fly and draw.

    Args:
        path: of the PNG.
        mission: what is flown, undisturbed.
        folder: of the exported files.

    Raises:
        GuidanceError: they are missing, damaged or of another mission.
    """
    guidance = load_guidance(mission, folder=folder)
    _, (history,) = fly_recorded(mission, guidance, [mission.departure])
    optimum = Optimum.of(mission.problem, departure_optimum(mission))
    charts = flight_charts(mission, flight_columns(mission, history, optimum))
    shown = [chart for chart in charts if chart.title in SHOWN]
    write_picture(path, shown, columns=len(shown))

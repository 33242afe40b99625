"""``python -m export.shipped_index``: the missions whose networks ship, as one table and a picture of each.

Every figure is taken from the tables that ``make ship`` and ``make campaigns`` wrote; only the optimum from
the departure orbit is solved for, and with ``--draw`` the flight from there is flown.
"""

import argparse
import math
import os
import shutil
import sys
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path

from export.picture import draw_departure
from sailnet import SailnetError, load_mission
from sailnet.artefacts.files import fill_block, split_at_block, write_whole
from sailnet.campaign.tables import Table
from sailnet.expert.nominal import departure_optimum
from sailnet.guidance.backends import missions_with_networks
from sailnet.mission.mission import Mission
from sailnet.physics.units import DAY, TU
from sailnet.workers.interruption import run_command

MARK = "missions"

HEADS = ("mission", "AU", "sail", "optimum from the departure orbit")

SERIES = {"nominal": "undisturbed", "unknown bias": "β unknown", "unknown bias and white noise": "and noise"}
"""Of the acceptance, as they are called here."""

MEAN, HOME = "mean excess", "no extra revolution"

FAIL, ARRIVE = "failed", "arrived"

MAIN = "earth_mars"
"""Its campaigns have a text of their own."""

REACH, MAP = "reach-rv.png", "-reach.png"
"""The map of the campaign `reach`, and how the name of its copy ends."""

INSIDE = "anywhere inside the domain"
"""The series of the campaign `reach` that is told of."""

NONE = "not flown"

Row = Mapping[str, str]
"""Cells by the heads of their columns."""


def rows_of(text: str) -> list[Row]:
    """The rows of the first table of a text, by the heads of their columns."""
    lines: list[str] = []
    for line in text.splitlines():
        if line.startswith("|"):
            lines.append(line)
        elif lines:
            break
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return [dict(zip(rows[0], row, strict=True)) for row in rows[2:]] if rows else []


def index_row(mission: Mission, acceptance: str, campaigns: str) -> list[str]:
    """A mission's row.

    Args:
        mission: whose networks ship.
        acceptance: the block of its acceptance in the results.
        campaigns: the text with its campaigns, ``reach`` among them if that was flown.
    """
    orbits, optimum = mission.transfer, departure_optimum(mission).time_of_flight
    inclined = f", inclined by {orbits.inclination:g}°" if mission.inclined else ""
    bound, optics = math.degrees(mission.problem.phi_max), mission.sail.optics.description
    cells = [
        f"[`{mission.name}`]({mission.name}/MODEL_CARD.md)",
        f"{orbits.departure_radius:g} to {orbits.target_radius:g}{inclined}",
        f"β {mission.sail.beta:g}, {bound:.0f}°, {optics}",
        f"{optimum:.4f} TU ({optimum * TU / DAY:,.0f} days)",
    ]
    flown = {row["flown"]: row for row in rows_of(acceptance)}
    for series in SERIES:
        row = flown[series]
        mean, home, fail = (row[head].split(", ")[0] for head in (MEAN, HOME, FAIL))
        cells.append(f"{mean}; {home}; {fail}")
    _, found, reach = campaigns.partition("(`reach`,")
    inside = [row for row in rows_of(reach) if row["series"] == INSIDE] if found else []
    return [*cells, inside[0][ARRIVE] if inside else NONE]


def index_table(rows: Sequence[list[str]]) -> list[str]:
    """Lines of Markdown."""
    told = [f"{name}: mean excess; without an extra revolution; failed" for name in SERIES.values()]
    return Table("", [*HEADS, *told, "inside the domain: arrived"], list(rows)).markdown()


def pictures(mission: Mission, folder: Path, shown: Path, campaigns: Path) -> None:
    """Draw the flight from the departure orbit, and take along the map of a campaign that was flown.

    Args:
        mission: that is flown.
        folder: of its exported files.
        shown: where ``NAME.png`` and ``NAME-reach.png`` go.
        campaigns: where its campaigns were flown to.
    """
    shown.mkdir(parents=True, exist_ok=True)
    draw_departure(shown / f"{mission.name}.png", mission, folder)
    drawn = campaigns / "reach" / REACH
    if drawn.exists():
        write_whole(shown / f"{mission.name}{MAP}", partial(shutil.copyfile, drawn))


def album(names: Sequence[str], shown: Path, text: Path) -> list[str]:
    """Lines of Markdown: every mission's pictures that there are."""
    lines = []
    for name in names:
        for file, what in ((f"{name}.png", "from the departure orbit"), (f"{name}{MAP}", "from elsewhere")):
            if (shown / file).exists():
                where = os.path.relpath(shown / file, text.parent)
                told = f"`{name}`, flown by its flight file {what}"
                lines += ["", f"{told}:", "", f"![{told}]({where})"]
    return lines


def main() -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m export.shipped_index",
        description=__doc__,
        epilog="example: python -m export.shipped_index sailnet/shipped/README.md --draw build",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("text", type=Path, help="file with the block, in the folder of the networks")
    parser.add_argument("--results", type=Path, default=Path("RESULTS.md"), help="acceptances (%(default)s)")
    parser.add_argument(
        "--campaigns", type=Path, default=Path("sailnet/campaign/RESULTS.md"),
        help="those of earth_mars; of others they stand beside the networks (%(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--pictures", type=Path, default=Path("docs/missions"), help="folder of pictures (%(default)s)"
    )
    parser.add_argument(
        "--draw", type=Path, metavar="BUILD", help="draw them anew, with maps from BUILD/MISSION/campaigns"
    )
    options = parser.parse_args()
    try:
        rows, names = [], []
        for name in missions_with_networks(options.text.parent):
            mission, folder = load_mission(name), options.text.parent / name
            names.append(mission.name)
            acceptance = split_at_block(options.results, f"acceptance {mission.name}")[1]
            place = options.campaigns if mission.name == MAIN else folder / "RESULTS.md"
            rows.append(index_row(mission, acceptance, place.read_text("utf-8") if place.exists() else ""))
            if options.draw:
                pictures(mission, folder, options.pictures, options.draw / mission.name / "campaigns")
        content = [*index_table(rows), *album(names, options.pictures, options.text)]
        fill_block(options.text, MARK, "\n".join(content))
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))

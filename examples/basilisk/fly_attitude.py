"""Earth to Mars in Basilisk with attitude dynamics: wheels, a controller and planets beside the point mass.

    python fly_attitude.py --longest 0.1

The same flight four times, of more and more: the point mass, whose attitude is prescribed; a rigid sail that
three wheels turn; the same with planets; and one whose centre of pressure is off, with a trim mass. A fifth,
without the trim mass, lasts until a wheel is full.
"""

import argparse
import json
import sys
import time
from importlib.metadata import version
from pathlib import Path
from typing import Any

from attitude_flight import Craft, fly
from attitude_picture import draw
from attitude_table import ended, filled_after, table, watched
from point_mass import fly as fly_point
from sailcraft import OFFSET
from tqdm import tqdm

from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.exported_c import CGuidance
from sailnet.mission.mission import load_mission

MISSION = "earth_mars"
START = (1.0, 0.0, 1.0)
"""The mission's: a circular orbit at 1 AU."""

CRAFTS = {
    "on wheels": Craft(),
    "and planets": Craft(planets=True),
    "and off centre, trimmed": Craft(planets=True, offset=OFFSET, trim=True),
}
"""What is flown, by its column."""

UNTRIMMED = Craft(planets=True, offset=OFFSET)

ORIGIN = (
    "Written by `python examples/basilisk/fly_attitude.py {options}--text examples/basilisk/README.md` on "
    "{machine}, {date}, revision {revision}, Basilisk {basilisk}."
)


def main(arguments: list[str] | None = None) -> int:
    """Fly and compare; returns the exit status: 1 where a flight of the whole way misses, or wheels fill."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--start", type=float, nargs=3, metavar=("R", "U", "V"), help="[AU], [AU/TU] (the mission's orbit)"
    )
    parser.add_argument("--longest", type=float, help="time after which a flight ends [TU] (the mission's)")
    parser.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    parser.add_argument(
        "--text",
        type=Path,
        metavar="FILE",
        help="a text whose table is to be rewritten: of flights from a start, its second",
    )
    parser.add_argument("--picture", type=Path, metavar="PNG", help="of the last flight")
    options = parser.parse_args(arguments)
    if options.text is not None and options.longest is not None:
        parser.error("a text is told of flights of the whole way")
    mission = load_mission(MISSION)
    guidance, beta = load_guidance(mission), mission.sail.beta
    assert isinstance(guidance, CGuidance)
    start = START if options.start is None else tuple(options.start)
    began = time.monotonic()
    point = fly_point(guidance, start, beta, options.longest)
    found: dict[str, Any] = {"point mass": ended(mission, point, time.monotonic() - began)}
    for name, craft in tqdm(CRAFTS.items(), desc="flight", file=sys.stderr, disable=None):
        began = time.monotonic()
        flight = fly(guidance, start, beta, craft, options.longest)
        found[name] = ended(mission, flight.flown, time.monotonic() - began) | watched(mission, flight)
    hours = filled_after(fly(guidance, start, beta, UNTRIMMED, options.longest))
    told = table(found, hours, mission)
    if options.text is not None:
        given = [] if options.start is None else ["--start", *map(repr, start)]
        given += [] if options.picture is None else ["--picture", f"examples/basilisk/{options.picture.name}"]
        written = "".join(f"{word} " for word in given)
        origin = ORIGIN.format(**software(), basilisk=version("bsk"), options=written)
        fill_block(options.text, "attitude" if options.start is None else "start", f"{origin}\n\n{told}")
    if options.picture is not None:
        draw(flight, mission.flight.period, options.picture)
    print(json.dumps(found | {"untrimmed": {"full after [h]": hours}}) if options.json else told)
    missed = options.longest is None and not all(one["arrives"] for one in found.values())
    return int(missed or any(one.get("full", False) for one in found.values()))


if __name__ == "__main__":
    sys.exit(main())

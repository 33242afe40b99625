"""``python -m benchmarks.playground``: how long the page takes for a flight, and how large it is.

Driven in Chromium as by hand; the block ``playground`` of docs/in-the-browser.md is written.
"""

import argparse
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.driven_browser import Tab, opened
from sailnet.artefacts.files import fill_block
from sailnet.artefacts.provenance import software
from sailnet.expert.fastest import solve_states
from sailnet.mission.mission import load_mission
from sailnet.report.playground.module import module
from sailnet.report.playground.page import write_playground
from sailnet.report.playground.stored_optima import AXES, OPTIMA

TEXT = Path(__file__).parents[1] / "docs" / "in-the-browser.md"
READY = 'document.getElementById("flight")?.dataset.ready === "yes"'

SETTINGS = {
    "as assumed, a period of 7 h": {},
    "β 12 % weaker, noise of 15 %, late by 0.02 TU": {"bias": -0.12, "noise": 0.15, "delay": 0.02},
    "the same, a period of 1.4 h": {"bias": -0.12, "noise": 0.15, "delay": 0.02, "period": 0},
}
"""Sliders of the page and where they are put; of the period the number of its place."""

TIMES = 3
"""How often each flight is flown: the fastest counts, since others take turns on the machine."""

Measured = list[tuple[float, float, int]]
"""Milliseconds of flights, those from the change to what is drawn, and guidance periods."""


def fly_all(tab: Tab, settings: dict[str, float], starts: list[tuple[float, ...]]) -> Measured:
    """Fly from each start."""
    measured = []
    for start in starts:
        wanted = {**settings, **dict(zip("ruv", start, strict=True))}
        moved = "".join(f"put('{name}', {value});" for name, value in wanted.items())
        flown = []
        for _ in range(TIMES):
            tab.evaluate(
                "(() => { const put = (name, value) => {"
                "const input = document.getElementById('set-' + name);"
                f"input.value = value; input.dispatchEvent(new Event('input')); }}; {moved} }})()"
            )
            tab.frame()
            said = tab.evaluate('({...document.getElementById("flight").dataset})')
            flown.append((float(said["milliseconds"]), float(said["shown"])))
        fastest, shown = np.min(flown, axis=0)
        measured.append((fastest, shown, int(said["periods"])))
    return measured


def compared(tab: Tab, count: int, random: np.random.Generator) -> str:
    """The shortest times that the page interpolates beside the expert's, of sails 12 % weaker."""
    problem = load_mission("earth_mars").problem
    sail = replace(problem, beta=0.88 * problem.beta)
    # Near each other, so that the expert has little to index.
    states = random.integers([100, 0, 95], [108, 9, 105], (count, 3)) / 100.0
    optima = solve_states(sail, states)
    ratios = []
    for state, time in zip(states, optima.time_of_flight, strict=True):
        fly_all(tab, {"bias": -0.12}, [tuple(map(float, state))])
        best = float(tab.evaluate('document.getElementById("flight").dataset.best'))
        ratios.append(abs(best / time - 1.0))
    return (
        f"Of {count} sails 12 % weaker, between stored β, the interpolated shortest time is off the expert's "
        f"by {100.0 * np.median(ratios):.1g} % in the median and {100.0 * max(ratios):.1g} % at most."
    )


def main() -> int:
    """Measure, and write."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.playground", description=__doc__)
    parser.add_argument("--flights", type=int, default=100, help="a row (%(default)s)")
    parser.add_argument("--compared", type=int, default=40, help="shortest times (%(default)s)")
    parser.add_argument("--seed", type=int, default=2, help="of the starts (%(default)s)")
    parser.add_argument("--text", type=Path, default=TEXT, help="(%(default)s)")
    options = parser.parse_args()
    random = np.random.default_rng(options.seed)
    starts = [
        tuple(float(random.choice(axis.values)) for axis in AXES.values()) for _ in range(options.flights)
    ]
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "playground.html"
        size = write_playground(page)
        with opened(page, Path(folder) / "profile") as tab:
            tab.wait_for(READY)
            for name, settings in SETTINGS.items():
                of_all = np.array(fly_all(tab, settings, starts)).T
                cells = [f"{value:,.0f}" for of in of_all for value in (np.median(of), of.max())]
                rows.append(f"| {name} | {' | '.join(cells)} |")
            beside = compared(tab, options.compared, random)
    origin, stored = software(), OPTIMA.stat().st_size
    table = [
        f"Written by `python -m benchmarks.playground` on {origin['machine']}, {origin['date']}: "
        f"{options.flights} starts, seed {options.seed}, headless Chromium on a shared machine, "
        f"each the fastest of {TIMES} times. The page has {size / 1e3:.0f} kB; "
        f"the module has {len(module()) / 1e3:.0f} kB before base64, the stored optima "
        f"{stored / 1e3:.0f} kB.",
        "",
        "| flown | ms a flight: median | worst | ms with the drawing: median | worst "
        "| guidance periods: median | most |",
        "|---|---|---|---|---|---|---|",
        *rows,
        "",
        beside,
    ]
    fill_block(options.text, "playground", "\n".join(table))
    print("\n".join(table))
    return 0


if __name__ == "__main__":
    sys.exit(main())

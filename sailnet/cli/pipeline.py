"""``sailnet pipeline``: from a mission file to what flies on board, every step that is not done yet."""

import argparse
import json
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, redirect_stdout
from pathlib import Path
from typing import Any

from sailnet.artefacts.files import write_text, writing
from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.cli import accept, select
from sailnet.cli.arguments import Commands, count, distribution
from sailnet.errors import SailnetError
from sailnet.mission.derived import flat
from sailnet.mission.mission import Mission, derived_for, load_mission
from sailnet.mission.sizes import FLIGHTS, SIZES, sized
from sailnet.mission.written import whole_text
from sailnet.workers.interruption import going_on

Steps = Sequence[tuple[str, Callable[[], int]]]

MISSION_FILE = "mission.toml"
"""In the pipeline's folder: the whole mission, derived values included."""


def add(commands: Commands) -> None:
    """Add the command."""
    about = (
        "From a mission file to networks, C and the flights that they passed. What the same command finished "
        "is kept, and what it left half done is gone on with."
    )
    pipeline = commands.add_parser(
        "pipeline",
        help="From a mission file to networks, C and the flights that they passed.",
        description=about,
        epilog="example: sailnet mission new --target 0.9 --beta 0.12 --output mine.toml; "
        "sailnet pipeline mine.toml --size quick",
    )
    pipeline.add_argument(
        "mission", metavar="MISSION", help="mission name or TOML file; two tables are enough"
    )
    pipeline.add_argument(
        "--output",
        type=Path,
        metavar="DIR",
        help="folder of all that is made (build/NAME, or build/NAME-quick)",
    )
    pipeline.add_argument(
        "--size",
        choices=SIZES,
        default="full",
        help="quick: some minutes on 2 cores, to see that it flies; full: what ships (%(default)s)",
    )
    pipeline.add_argument("--flights", type=count, metavar="N", help="that accept the networks, a series")
    pipeline.add_argument("--seed", type=int, default=2, help="of those flights (%(default)s)")
    distribution(pipeline)
    pipeline.add_argument("--restart", action="store_true", help="begin anew, whatever there is")
    pipeline.add_argument(
        "--overwrite",
        action="store_true",
        help="replace what another mission, size or software finished there",
    )
    pipeline.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    pipeline.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Run every step that is not done; the exit status."""
    from sailnet.report import need_pictures
    from sailnet.workers.stages import need

    need("data", "training", "export")
    need_pictures()
    mission = sized(load_mission(options.mission), options.size)
    quick = "-quick" if options.size == "quick" else ""
    folder: Path = options.output or Path("build") / f"{mission.name}{quick}"
    with (
        going_on(lambda: f"the same command goes on with what is in {folder}"),
        sole_owner(folder / LOCK, f"a pipeline in {folder}"),
    ):
        _refuse_start(mission)
        _keep_mission(mission, folder, options.restart or options.overwrite)
        return _carry_out(options, folder)


def _refuse_start(mission: Mission) -> None:
    """What training would say of its start after minutes is said at once."""
    from sailnet.guidance.backends import exported_folder

    if mission.training.wide.start is not None:
        exported_folder(load_mission(mission.training.wide.start))


def _keep_mission(mission: Mission, folder: Path, replace: bool) -> None:
    """Write the whole mission into the folder.

    Raises:
        SailnetError: the folder has another, or cannot be written.
    """
    kept = folder / MISSION_FILE
    if kept.exists() and not replace and load_mission(kept) != mission:
        raise SailnetError(
            f"{folder} holds a pipeline of another mission or size, see {kept}: name another folder with "
            "--output, or say --overwrite to replace it"
        )
    with writing(kept):
        write_text(kept, whole_text(mission))


def _carry_out(options: argparse.Namespace, folder: Path) -> int:
    from sailnet.workers.stages import run_stage

    made = flat(json.loads(load_mission(folder / MISSION_FILE).to_json()))
    # As it is carried out: a quick recipe is smaller than the one that is derived.
    derived = {key: made[key] for key in derived_for(options.mission) if key in made}
    whole, learned, flown = folder / MISSION_FILE, folder / "wide.h5", folder / "wide"
    networks, exported = flown / "networks", flown / "export"
    workers = ["--workers", str(options.workers)]
    cluster = (
        [] if options.scheduler is None else ["--scheduler", options.scheduler, "--wait", str(options.wait)]
    )
    replace = ["--overwrite"] if options.overwrite or options.restart else []
    anew = ["--restart"] if options.restart else []
    go_on = [] if options.restart else ["--resume"]
    found: dict[str, Any] = {}

    def chosen() -> int:
        return select.run(
            argparse.Namespace(
                dataset=learned,
                output=networks,
                mission=str(whole),
                size="full",  # the file says what is carried out
                seed=None,
                resume=not options.restart,
                overwrite=options.overwrite or options.restart,
                json=False,
                **{name: getattr(options, name) for name in ("workers", "scheduler", "wait")},
            )
        )

    def accepted() -> int:
        found.update(
            accept.accepted(
                argparse.Namespace(
                    mission=whole,
                    networks=exported,
                    output=flown,
                    flights=options.flights or FLIGHTS[options.size],
                    **{name: getattr(options, name) for name in ("seed", "workers", "scheduler", "wait")},
                    restart=options.restart,
                    overwrite=options.overwrite or options.restart,
                    json=True,
                )
            )
        )
        return accept.status_of(found)

    steps: Steps = (
        ("data", lambda: run_stage(
            "data", [str(learned), "--mission", str(whole), *workers, *cluster, *anew, *replace]
        )),
        ("train", chosen),
        ("export", lambda: run_stage(
            "export", [str(networks), str(exported), "--mission", str(whole), *go_on, *replace]
        )),
        ("accept", accepted),
    )  # fmt: skip
    seconds: dict[str, float] = {}
    status = 0
    with _to_stderr(options.json):
        for key, value in derived.items():
            print(f"derived: {key} = {value}")
        for number, (name, step) in enumerate(steps, start=1):
            print(f"{number} of {len(steps)}: {name}", flush=True)
            started = time.perf_counter()
            status = step()
            seconds[name] = time.perf_counter() - started
            if status:
                break
    if status and not found:
        return status
    result = {
        "mission": str(whole),
        "size": options.size,
        "derived": derived,
        "data": str(learned),
        "networks": str(networks),
        "c": str(exported / "sailnet_guidance.c"),
        "seconds": seconds,
        **found,
    }
    print(json.dumps(result) if options.json else "\n".join(_told(result, options.size)))
    return status


@contextmanager
def _to_stderr(json_wanted: bool) -> Iterator[None]:
    """What the steps print must not stand beside the one JSON object."""
    if not json_wanted:
        yield
        return
    with redirect_stdout(sys.stderr):
        yield


def _told(result: dict[str, Any], size: str) -> list[str]:
    """The table of acceptance, where everything is, and what comes next."""
    from sailnet.campaign.acceptance import headline
    from sailnet.campaign.results import open_results

    results = open_results(Path(result["results"]))
    networks = Path(result["c"]).parent
    named = f"--mission {result['mission']} --networks {networks}"
    low, high = results.mission.generalisation.corners
    start = " ".join(f"{value:g}" for value in (low + high) / 2.0)
    times = ", ".join(f"{name} {seconds:.0f} s" for name, seconds in result["seconds"].items())
    return [
        "",
        *headline(results).lines(),
        "",
        *accept.verdict_lines(result),
        "",
        f"The C that flies:  {result['c']}",
        f"The whole mission: {result['mission']}",
        f"The report:        {result['report']}",
        f"Taken: {times}",
        "",
        "Next:",
        f"  sailnet fly {start} {named} --plot flight.html",
        f"  sailnet evaluate --flights 1000 --beta-spread 0.15 {named}",
        *(
            ["  the same without --size quick, for the networks that one would ship"]
            if size == "quick"
            else []
        ),
    ]

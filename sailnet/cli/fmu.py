"""``sailnet fmu``: the guidance for simulators that take FMI 3.0."""

import argparse
from pathlib import Path

from sailnet.cli.arguments import Commands, add_command, existing_folder
from sailnet.cli.output import Line, Result
from sailnet.errors import SailnetError
from sailnet.mission.mission import in_the_plane, load_mission

LINES = {
    "file": Line("written"),
    "mission": Line("mission"),
    "precision": Line("precision"),
    "fmi": Line("FMI"),
    "binary": Line("binary", lambda name: f"{name}, for this machine; others compile the sources"),
    "sources": Line("sources", ", ".join),
    "token": Line("instantiation token"),
    "inputs": Line("inputs", ", ".join),
    "parameters": Line("parameters", ", ".join),
    "outputs": Line("outputs", ", ".join),
}


def add(commands: Commands) -> None:
    """Add the command."""
    fmu = add_command(
        commands,
        "fmu",
        run,
        "The guidance as a Functional Mock-up Unit: FMI 3.0 co-simulation, with sources and a binary.",
        example="sailnet fmu guidance.fmu --mission earth_mars",
    )
    fmu.add_argument("output", metavar="OUT.fmu", type=Path, help="the file to write")
    fmu.add_argument("--networks", type=Path, metavar="DIR", help="exported networks (default: shipped)")
    fmu.add_argument("--precision", choices=("float64", "float32"), default="float64")
    fmu.add_argument("--overwrite", action="store_true", help="replace a file that is there")
    fmu.set_defaults(lines=LINES)


def run(options: argparse.Namespace) -> Result:
    """Write it; what it holds, by name."""
    from sailnet.guidance.backends import exported_folder, load_guidance
    from sailnet.workers.stages import need, write_fmu

    output: Path = options.output
    if output.suffix != ".fmu":
        raise SailnetError(f"the FMU is a file OUT.fmu, not {output}")
    existing_folder("sailnet fmu", output)
    if output.exists() and not options.overwrite:
        raise SailnetError(f"{output} is there: name another file, or say --overwrite to replace it")
    need("fmi")
    mission = in_the_plane(load_mission(options.mission))
    load_guidance(mission, precision=options.precision, folder=options.networks)  # refuses another mission's
    return write_fmu(mission, exported_folder(mission, options.networks), options.precision, output)

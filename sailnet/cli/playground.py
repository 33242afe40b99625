"""``sailnet playground``: a page that flies the shipped networks, to drag and disturb."""

import argparse
from pathlib import Path

from sailnet.cli.arguments import Commands, existing_folder
from sailnet.cli.output import Line, Result, number
from sailnet.errors import SailnetError

LINES = {"page": Line("the page, for any browser"), "bytes": Line("its size [bytes]", number)}


def add(commands: Commands) -> None:
    """Add the command."""
    about = (
        "Write a page that flies: the flight file and the plant in it as WebAssembly, a start to drag, "
        "a sail to disturb. It needs no server and no network."
    )
    playground = commands.add_parser(
        "playground",
        help=about.split(":")[0] + ".",
        description=about,
        epilog="example: sailnet playground fly.html",
    )
    playground.add_argument(
        "output",
        type=Path,
        nargs="?",
        metavar="FILE.html",
        default=Path("playground.html"),
        help="(%(default)s)",
    )
    playground.add_argument("--overwrite", action="store_true", help="replace a file that is there")
    playground.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    playground.set_defaults(run=run, lines=LINES)


def run(options: argparse.Namespace) -> Result:
    """Write the page."""
    from sailnet.report import need_pictures, report

    output: Path = options.output
    if output.suffix != ".html":
        raise SailnetError(f"the page is FILE.html, not {output}")
    need_pictures()
    existing_folder("the page", output)
    if output.exists() and not options.overwrite:
        raise SailnetError(f"{output} is there: name another file, or say --overwrite to replace it")
    size = report("playground.page").write_playground(output, options.command_line)
    return {"page": str(output), "bytes": size}

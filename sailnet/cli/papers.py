"""``sailnet papers``: what other papers print, checked."""

import argparse
from pathlib import Path

from sailnet.cli.arguments import Commands


def add(commands: Commands) -> None:
    """Add the command."""
    about = "What four papers print, beside ours and a second method's; minutes."
    example = (
        "example: sailnet papers 003; sailnet papers sail --output pictures; sailnet papers goddard --json"
    )
    papers = commands.add_parser("papers", help=about, description=about, epilog=example)
    papers.add_argument("name", metavar="NAME", nargs="?", help="number of a paper or a problem (all)")
    papers.add_argument("--json", action="store_true", help="print one JSON list and nothing else")
    papers.add_argument(
        "--output", metavar="DIR", type=Path, help="write papers.json, papers.md, a page and pictures there"
    )
    papers.add_argument("--readme", metavar="FILE", type=Path, help="fill its blocks `papers` and `sail`")
    papers.add_argument(
        "--workers", type=int, default=1, metavar="N", help="problems solved side by side (%(default)s)"
    )
    papers.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Solve and print; the exit status."""
    from sailnet.papers import command

    return command.run(
        options.name,
        options.json,
        options.output,
        options.readme,
        options.workers,
        command_line=options.command_line,
    )

"""``sailnet accept``: everything that a set of networks has to stand, and the table of it."""

import argparse
from pathlib import Path

from sailnet.cli import evaluate
from sailnet.cli.arguments import Commands, add_command, count, distribution
from sailnet.cli.output import Result
from sailnet.cli.spelling import HelpfulParser


def add(commands: Commands) -> None:
    """Add the command."""
    accept = add_command(
        commands,
        "accept",
        run,
        "The campaign that networks have to pass before they fly: as assumed, unknown sails, noise, drift.",
        example="sailnet accept build/mine/wide/export --mission mine.toml --output build/mine/wide",
    )
    accept.add_argument("networks", type=Path, metavar="EXPORT_DIR", help="what sailnet export wrote")
    accept.add_argument("--output", type=Path, metavar="DIR", required=True, help="for results and report")
    accept.add_argument("--flights", type=count, metavar="N", help="of each series (10,000)")
    accept.add_argument("--seed", type=int, help="of every random number (the campaign's)")
    accept.add_argument("--restart", action="store_true", help="throw away what was flown before")
    accept.add_argument("--overwrite", action="store_true", help="replace what others finished there")
    distribution(accept)
    accept.set_defaults(lines=evaluate.LINES)


def run(options: argparse.Namespace) -> Result:
    """Fly it, or read it if it is flown; its tables are printed unless JSON is wanted."""
    words = ["evaluate", "--campaign", "acceptance"]
    for name in ("mission", "networks", "output", "flights", "seed", "workers", "scheduler", "wait"):
        if (value := getattr(options, name)) is not None:
            words += [f"--{name}", str(value)]
    words += [f"--{name}" for name in ("restart", "overwrite", "json") if getattr(options, name)]
    parser = HelpfulParser()
    evaluate.add(parser.add_subparsers())
    return evaluate.run(parser.parse_args(words))

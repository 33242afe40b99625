"""The command line: which sub-commands there are, what they print and how they end."""

import argparse
import json
import sys
from collections.abc import Callable, Sequence

from sailnet import __version__
from sailnet.cli import evaluate, fly, guide, info, optics, papers, solve
from sailnet.cli.output import Result, readable
from sailnet.errors import SailnetError

COMMANDS = (solve, guide, fly, evaluate, info, optics, papers)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; returns the exit status: 0, or 1 when something cannot be done or is wrong."""
    given = sys.argv[1:] if arguments is None else list(arguments)
    options = parser().parse_args([_shield(argument) for argument in given])
    run: Callable[[argparse.Namespace], Result | int] = options.run
    try:
        result = run(options)
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return 130
    if isinstance(result, int):
        return result  # The command has printed what it found.
    if options.json:
        print(json.dumps(result))
    else:
        print("\n".join(f"{key:28s} {readable(value)}" for key, value in result.items()))
    return 0


def _shield(argument: str) -> str:
    """Keep argparse from taking -1e-3 or -inf for an option: it looks at the first character."""
    try:
        float(argument)
    except ValueError:
        return argument
    return f" {argument}" if argument.startswith("-") else argument


def parser() -> argparse.ArgumentParser:
    """The whole command line."""
    made = argparse.ArgumentParser(
        prog="sailnet",
        description="Optimal guidance of a solar sail: expert, networks, onboard C, closed loop.",
        epilog="R in AU, U and V in AU/TU (a circular orbit at 1 AU has speed 1); angles in radians.",
    )
    made.add_argument("--version", action="version", version=f"sailnet {__version__}")
    commands = made.add_subparsers(title="commands", required=True, metavar="COMMAND")
    for command in COMMANDS:
        command.add(commands)
    return made

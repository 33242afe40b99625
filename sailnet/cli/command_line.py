"""The command line: which sub-commands there are, what they print and how they end."""

import argparse
import json
import os
import shlex
import sys
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from sailnet import __version__
from sailnet.cli import (
    accept,
    completion,
    evaluate,
    fly,
    fmu,
    guide,
    info,
    mission,
    optics,
    papers,
    pipeline,
    playground,
    select,
    solve,
    stage,
)
from sailnet.cli.output import Result, printed
from sailnet.cli.spelling import HelpfulParser, in_letters_it_has
from sailnet.errors import SailnetError

COMMANDS = (
    *(solve, guide, fly, playground, evaluate, mission, pipeline, stage, select, accept, fmu),
    *(info, optics, papers, completion),
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; returns the exit status: 0, or 1 when something cannot be done or is wrong.

    As from other programs, it is 130 after Ctrl-C, and 141 when nobody reads what is printed any more.
    """
    for stream in (sys.stdout, sys.stderr):
        in_letters_it_has(stream)
    given = sys.argv[1:] if arguments is None else list(arguments)
    try:
        status = _run(given)
        sys.stdout.flush()
    except BrokenPipeError:
        # Python flushes once more when it ends, and would complain.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141
    return status


def _run(arguments: Sequence[str]) -> int:
    try:
        if arguments and arguments[0] in stage.STAGES:
            return stage.run(arguments)
        options = parser().parse_args([_shield(argument) for argument in arguments])
        options.command_line = shlex.join(["sailnet", *arguments])
        run: Callable[[argparse.Namespace], Result | int] = options.run
        with np.errstate(all="ignore"):  # what overflows, far off anything that flies, is said in words
            result = run(options)
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    if isinstance(result, int):
        return result  # The command has printed what it found.
    print(json.dumps(result) if options.json else printed(result, options.lines))
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
    made = HelpfulParser(
        prog="sailnet",
        description="Optimal guidance of a solar sail: expert, networks, onboard C, closed loop.",
        epilog="R in AU, U and V in AU/TU (a circular orbit at 1 AU has speed 1); angles in radians "
        "where they are typed and in JSON, in degrees where they are printed for people.",
    )
    made.add_argument("--version", action="version", version=f"sailnet {__version__}")
    commands = made.add_subparsers(title="commands", required=True, metavar="COMMAND")
    for command in COMMANDS:
        command.add(commands)
    return made


def sub_commands(whole: argparse.ArgumentParser) -> Mapping[str, argparse.ArgumentParser]:
    """The parsers of the sub-commands, by name."""
    (chosen,) = (action for action in whole._actions if isinstance(action, argparse._SubParsersAction))
    return dict(chosen.choices)

"""References made from the code: every command with its options, and every disturbance with its unit.

A page has `{commands}` or `{disturbances}` alone on a line.
"""

import argparse
import os
from typing import Any

from sailnet.cli.command_line import parser, sub_commands
from sailnet.cli.stage import STAGES
from sailnet.mission.disturbances import catalogue
from sailnet.workers.stages import parser_of


def commands() -> str:
    """Each sub-command of ``sailnet``, as it explains itself."""
    whole = parser()
    parts = [_fenced(whole.format_help())]
    for name, one in sub_commands(whole).items():
        told = parser_of(STAGES[name][0]) if name in STAGES else one
        parts.append(f"## sailnet {name}\n\n{_told(told)}")
    return "\n\n".join(parts)


def _told(one: argparse.ArgumentParser) -> str:
    lines = [one.description or "", "", _fenced(one.format_usage())]
    for group in one._action_groups:
        actions = [action for action in group._group_actions if action.help != argparse.SUPPRESS]
        if actions:
            lines += ["", f"**{(group.title or '').capitalize()}.** {group.description or ''}", ""]
        for action in actions:
            value = "" if action.nargs == 0 else f" {action.metavar or _choices(action)}"
            names = ", ".join(f"{name}{value}" for name in action.option_strings) or value.strip()
            meaning = one._get_formatter()._expand_help(action) if action.help else ""
            lines += [f"`{names}`", f": {meaning}", ""] if meaning else [f"`{names}`", ""]
    if one.epilog:
        lines += [_fenced("\n".join(one.epilog.removeprefix("example: ").split("; ")))]
    return "\n".join(lines)


def _choices(action: argparse.Action) -> str:
    return f"{{{','.join(map(str, action.choices))}}}" if action.choices else action.dest.upper()


def _fenced(text: str) -> str:
    return f"```text\n{text.rstrip()}\n```"


def disturbances() -> str:
    """A table of what a real sail, its navigation and its actuator can do."""
    known = [(one.name, "" if one.unit == "1" else one.unit, one.meaning) for one in catalogue()]
    rows = [f"| `{name}` | {unit} | {meaning} |" for name, unit, meaning in known]
    return "\n".join(["| name | unit | meaning |", "|---|---|---|", *rows])


MADE = {"{commands}": commands, "{disturbances}": disturbances}


def expand(app: Any, docname: str, source: list[str]) -> None:
    """Put the references into a page before it is read."""
    for mark, make in MADE.items():
        if f"\n{mark}\n" in source[0]:
            source[0] = source[0].replace(f"\n{mark}\n", f"\n{make()}\n")


def setup(app: Any) -> dict[str, object]:
    """Take part in the build, after the excerpts."""
    os.environ.setdefault("COLUMNS", "86")
    app.connect("source-read", expand)
    return {"parallel_read_safe": True, "version": "1"}

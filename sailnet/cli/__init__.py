"""The ``sailnet`` command: one module a sub-command."""

from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line, of this process by default; returns the exit status."""
    from sailnet.cli import command_line

    return command_line.main(arguments)

"""The ``sailnet`` command: one module a sub-command."""

from sailnet.cli.command_line import main

__all__ = ["main"]

"""``python -m sailnet.cli``, and the ``sailnet`` script: the command line, which signals end in words."""

import sys

from sailnet.cli import main
from sailnet.workers.interruption import run_command


def script() -> int:
    """Run the command line of this process; returns the exit status."""
    return run_command(main, "the same command begins again")


if __name__ == "__main__":
    sys.exit(script())

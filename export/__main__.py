"""``python -m export``: from trained weights to what flies."""

import sys

from sailnet.workers.interruption import run_command


def _main() -> int:
    from export.command import main

    return main()


if __name__ == "__main__":
    sys.exit(run_command(_main, "the same command begins again"))

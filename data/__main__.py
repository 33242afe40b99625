"""``python -m data``: generate a mission's data set."""

import sys

from sailnet.workers.interruption import run_command


def _main() -> int:
    from data.command import main

    return main()


if __name__ == "__main__":
    sys.exit(run_command(_main, "nothing was finished yet; the same command begins again"))

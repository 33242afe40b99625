"""``python -m training``: train a mission's networks."""

import sys

from sailnet.workers.interruption import run_command


def _main() -> int:
    from training.command import main

    return main()


if __name__ == "__main__":
    sys.exit(run_command(_main, "nothing was trained yet; the same command begins again"))

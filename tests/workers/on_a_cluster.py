"""``python -m tests.workers.on_a_cluster ADDRESS``: work without end on a cluster."""

import sys
import time
from itertools import count

from sailnet.errors import SailnetError
from sailnet.workers.executors import cluster


def nap(number: int) -> int:
    """One piece of it."""
    time.sleep(0.05)
    return number


if __name__ == "__main__":
    try:
        with cluster(sys.argv[1]) as workers:
            for _ in workers.map(nap, count()):
                print("begun", flush=True)
    except SailnetError as error:
        sys.exit(f"error: {error}")

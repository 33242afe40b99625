"""``python -m tests.campaign.gated ...``: ``sailnet`` with a gate before the batches of a campaign."""

import sys
from unittest.mock import patch

from sailnet.campaign.batches import Columns, Job
from sailnet.cli.__main__ import script
from tests.gate import wait_at_gate

_freely = Job.carry_out


def carry_out(job: Job, number: int) -> Columns:
    """A batch, behind the gate; of the name by which a worker is told what to do."""
    wait_at_gate(number)
    return _freely(job, number)


patch.object(Job, "carry_out", carry_out).start()  # here, for workers import this module too

if __name__ == "__main__":
    sys.exit(script())

"""Paper 003's figures."""

import pytest

from sailnet.papers import bbsr, command
from sailnet.papers.tables import tables


@pytest.mark.slow
def test_a_real_row_through_the_table() -> None:
    rows = bbsr.goddard_rows(2.5)
    assert all(map(command.agree, rows))
    assert "2.024430e-01" in tables(rows)

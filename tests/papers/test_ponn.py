"""What papers 000 and 002 print."""

import pytest

from sailnet.papers import ponn as papers


@pytest.mark.exhaustive
def test_printed_figures_and_their_verdicts() -> None:
    rows = papers.intercept_rows(starts=2) + papers.bounded_rows()
    verdicts = {(row.problem, row.quantity): row.verdict for row in rows}
    for gamma in ("0", "1", "5", "10"):
        name = f"intercept, Gamma = {gamma}"
        assert verdicts[name, "t_f [s]"] == "agrees"
        assert verdicts[name, "J"] == "paper in error"
    assert verdicts["intercept, Gamma = 10, GPOPS-II", "J"] == "agrees"
    assert verdicts["intercept, +-0.7 m/s^2", "t_f [s]"] == "paper in error"
    for row in rows:
        if row.quantity in ("t_f [s]", "J"):
            assert row.ours == pytest.approx(row.check, rel=1e-6)
            # The trapezoidal rule is where the paper's costs come from, to the last digit.
            assert "trapezoidal" not in row.reason or row.reason.endswith(row.printed)
    assert sum("trapezoidal" in row.reason for row in rows) == 4
    assert papers.verdict("18.62", 18.629) == "agrees"
    assert papers.verdict("18.62", 18.631) == "paper in error"

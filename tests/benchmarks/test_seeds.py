"""What is said of several trainings: every seed's numbers, and the worst of all."""

from typing import Any

import pytest

from benchmarks.seeds import CAMPAIGN, headline, table

UNKNOWN = 4
"""Flights of a series whose optimum is not known: nobody can say that they were late."""


def record(seed: int, *rows: tuple[str, int, int, float, float]) -> dict[str, Any]:
    """Of one training: series, arrived, first approaches, mean above the optimum and reversals, of 1,000."""
    scores = [
        {
            "series": name,
            "flights": 1000,
            "arrived": arrived,
            "first_approach": first - UNKNOWN,
            "own_optimum_unknown": UNKNOWN,
            "time_above_own_optimum": {"mean": mean},
            "reversals": {"0.99": reversals},
        }
        for name, arrived, first, mean, reversals in rows
    ]
    return {"seed": seed, "test_mse": {"tau": 1e-6 * seed, "lambda_v": 2e-5}, CAMPAIGN: scores}


RECORDS = [
    record(11, ("nominal", 1000, 1000, 0.0006, 2.0), ("noise", 999, 997, 0.0123, 4.0)),
    record(12, ("nominal", 1000, 998, 0.0007, 2.0), ("noise", 1000, 991, 0.0045, 3.0)),
]


def test_a_row_has_the_numbers_of_every_seed_side_by_side() -> None:
    text = "\n".join(table(RECORDS))
    assert "Seeds 11, 12, 1,000 flights a series." in text
    assert "1.1e-05, 2.0e-05; 1.2e-05, 2.0e-05" in text
    (nominal,) = (line for line in text.splitlines() if line.startswith("| nominal"))
    (noise,) = (line for line in text.splitlines() if line.startswith("| noise"))
    assert [cell.strip() for cell in nominal.strip("|").split("|")] == [
        "nominal", "0, 0", "0, 2", "0.06, 0.07", "2, 2",
    ]  # fmt: skip
    assert [cell.strip() for cell in noise.strip("|").split("|")] == [
        "noise", "1, 0", "3, 9", "1.23, 0.45", "4, 3",
    ]  # fmt: skip


@pytest.mark.parametrize("records", [RECORDS, RECORDS[::-1]])
def test_the_headline_is_the_worst_of_all(records: list[dict[str, Any]]) -> None:
    """Of each figure: the three need not be of one seed."""
    said = headline(records)
    assert "99.90 % arrive, 99.10 % at the first approach (noise, seed 12)" in said
    assert "mean at most 1.23 % above the own optimum" in said

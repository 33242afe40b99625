"""The delta method's table: medians over seeds, and how many searches arrive."""

from sailnet.papers import delta_table
from sailnet.papers.delta_searches import Entry


def searched(method: str, seed: int, converged: bool, end_error: float, cost: float) -> Entry:
    """A search of the landing, whose least cost is 2."""
    return Entry(
        "lunar-landing", "Fourier", "GA-PSO", method, seed, 100 + seed, converged, end_error, cost, 2.0,
        cost, 2.0, [], [], {}, [], [], 1.0 + seed,
    )  # fmt: skip


FOUND = [
    *(searched("alone", seed, seed == 0, 1e-2 * (1 + seed), 2.2) for seed in range(3)),
    *(searched("polished", seed, True, 1e-7, cost) for seed, cost in enumerate((2.0, 2.003, 2.02))),
]


def test_a_row_has_medians_over_seeds() -> None:
    origin = {"machine": "a machine", "date": "today", "revision": "abc"}
    table = delta_table.markdown(FOUND, origin)
    assert "on a machine, today, revision abc; 3 seeds." in table
    (row,) = (line for line in table.splitlines() if line.startswith("| lunar"))
    assert row == (
        "| lunar-landing | GA-PSO | Fourier | 1 of 3, 2e-02, +10 % | 3 of 3, 1e-07, +0.15 % |  | 101, 101 |"
        " 2.0, 2.0 | 91.73 |"
    )


def test_searches_that_arrive_are_counted_and_those_near_the_optimum() -> None:
    table = delta_table.counted(FOUND).splitlines()
    assert table[2].startswith("| alone | 1 (0) of 3 | 0 (0) of 0 |")
    assert table[3].startswith("| polished | 3 (2) of 3 |")

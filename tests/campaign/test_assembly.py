"""Results come together batch by batch: the same as from everything at once, in memory that is not more."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sailnet.artefacts.resumable import Columns
from sailnet.campaign import assembly, batches
from sailnet.campaign.assembly import write_results
from sailnet.campaign.batches import Batch, Job, own_column
from sailnet.campaign.columns import OWN, optimum_of
from sailnet.campaign.results import Results, open_results
from sailnet.physics.geometry import PLANE
from tests.campaign.small_plan import CASE, GUIDANCE, plan_of, short

OPTIMUM = optimum_of(PLANE.state_names)
SERIES = [
    {"name": "calm", "flights": 23, "periods": [0.02, 0.05], "optima": 17},
    {"name": "noisy", "flights": 12, "optima": 12, "disturbance": {"beta_noise": 0.1}},
    {"name": "unasked", "flights": 11, "optima": 0},
    {"name": "case", "flights": 15, "optima": 9, "starts": [CASE]},
]


class Invented:
    """What batches of ten flights and of seven optima give, each value telling whose it is."""

    def __init__(self, small: Results, job: Job) -> None:
        self.small, self.job, self.asked = small, job, list[int]()

    def __call__(self, number: int) -> Columns:
        self.asked.append(number)
        batch = self.job.batches[number]
        numbers = np.arange(batch.first, batch.first + batch.count)
        if batch.kind == "optima":
            found = {name: 1000.0 * batch.series + numbers for name in OPTIMUM if name != OWN}
            own = {own_column(series): 5e5 + 1000.0 * series + numbers for series in range(len(SERIES))}
            return found | own
        columns = {f"flights/{name}": values[numbers] for name, values in self.small.flights.items()}
        columns["flights/number"] = numbers
        columns["flights/series"] = np.full(batch.count, batch.series)
        columns["flights/period"] = np.full(batch.count, batch.period)
        columns |= {"kept/flight": numbers[:0], "kept/records": numbers[:0]}
        return columns | {f"records/{name}": values[:0] for name, values in self.small._records.items()}

    def outcomes(self) -> Iterator[tuple[Batch, Columns]]:
        return ((batch, self(number)) for number, batch in enumerate(self.job.batches))


@pytest.fixture
def job(monkeypatch: pytest.MonkeyPatch) -> Job:
    monkeypatch.setattr(batches, "BATCH", 10)
    for module in (batches, assembly):
        monkeypatch.setattr(module, "OPTIMA_BATCH", 7)
    return Job(short(7.5), GUIDANCE, plan_of(series=SERIES))


def test_every_flight_has_the_optimum_of_its_start(small: Results, job: Job, tmp_path: Path) -> None:
    invented = Invented(small, job)
    write_results(tmp_path / "x.h5", job, invented.outcomes(), invented, {}, tmp_path)
    flights = open_results(tmp_path / "x.h5").flights
    series, number = flights["series"][:], flights["number"][:]
    assert len(series) == 2 * 23 + 12 + 11 + 15
    known = number < np.array([17, 12, 0, 9])[series]
    solved_for = np.array([0, 0, 0, 3])[series]  # the first series with these starts
    for name in OPTIMUM:
        expected = 5e5 + 1000.0 * series + number if name == OWN else 1000.0 * solved_for + number
        np.testing.assert_array_equal(flights[name], np.where(known, expected, np.nan), err_msg=name)


def test_of_batches_it_asks_again_each_about_once(small: Results, job: Job, tmp_path: Path) -> None:
    """That of flights once, and optima as few times as series and periods share them."""
    invented = Invented(small, job)
    outcomes = list(invented.outcomes())
    invented.asked.clear()
    write_results(tmp_path / "x.h5", job, iter(outcomes), invented, {}, tmp_path)
    flown = [number for number, batch in enumerate(job.batches) if batch.kind == "flights"]
    assert [number for number in invented.asked if number in flown] == flown
    asked = [number for number in invented.asked if number not in flown]
    assert len(asked) == 3 + 3 + 2 + 2  # of 17 flights at two periods, 12, and 9


def test_optima_of_another_guidance_are_taken_as_they_are(small: Results, job: Job, tmp_path: Path) -> None:
    invented = Invented(small, job)
    write_results(tmp_path / "x.h5", job, invented.outcomes(), invented, {}, tmp_path)
    first = open_results(tmp_path / "x.h5")
    again = Invented(small, replace(job, asks=False))
    write_results(tmp_path / "y.h5", again.job, again.outcomes(), again, {}, tmp_path, first)
    second = open_results(tmp_path / "y.h5")
    assert second.digest == first.digest
    assert np.isfinite(second.flights[OWN][:]).any()

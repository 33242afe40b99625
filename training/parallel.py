"""Several networks at once, each in a process with its share of the cores.

A step's matrix products are too small to use many cores well; independent networks are not.
"""

import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import torch
from tqdm import tqdm

from sailnet.dataset import open_dataset
from sailnet.mission.mission import Mission
from sailnet.networks.network import Network
from sailnet.workers.executors import processes
from training.folder import make_room
from training.targets import TARGETS
from training.train import run_digest, train_network


def train_networks(
    dataset: Path,
    mission: Mission,
    kind: str,
    names: Sequence[str],
    folder: Path,
    *,
    workers: int | None = None,
    device: str = "cpu",
    resume: bool = False,
    overwrite: bool = False,
    quiet: bool = False,
) -> list[Network]:
    """Train the named networks of ``TARGETS[kind]``; see :func:`train_network`.

    Args:
        kind: of the data set.
        workers: networks trained at once; None for all, which on fewer cores takes the least time.
        resume: go on with what an earlier call of the same left, and keep what it finished.
        overwrite: replace what else is there.
        quiet: show no progress bars.

    Raises:
        NetworkError: something is there that may not be replaced.
    """
    count = min(workers or len(names), len(names))
    threads = max(1, (os.cpu_count() or 1) // count)
    with open_dataset(dataset, mission) as data:
        digest = data.digest
    targets = {name: TARGETS[kind][name] for name in names}
    backend = device.partition(":")[0]
    runs = {name: run_digest(target, digest, mission, backend, threads) for name, target in targets.items()}
    make_room(folder, runs, resume=resume, overwrite=overwrite)
    work = _Work(dataset, mission, kind, tuple(names), folder, threads, device, quiet)
    with processes(count) as pool:
        return list(pool.map(work.train, range(len(names))))


@dataclass(frozen=True)
class _Work:
    dataset: Path
    mission: Mission
    kind: str
    names: tuple[str, ...]
    folder: Path
    threads: int
    device: str
    quiet: bool

    def train(self, number: int) -> Network:
        """One network, in this process, which goes on where one that was lost came to."""
        torch.set_num_threads(self.threads)
        target = TARGETS[self.kind][self.names[number]]
        with tqdm(
            total=target.recipe(self.mission.training).epochs,
            desc=f"{target.name:15}",
            unit="epoch",
            position=number,
            disable=True if self.quiet else None,
            file=sys.stderr,
        ) as bar:

            def watch(record: dict[str, float]) -> None:
                bar.set_postfix_str(f"validation {record['validation']:.2e}", refresh=False)
                bar.update(int(record["epoch"]) - bar.n)

            return train_network(self.dataset, self.mission, target, self.folder, self.device, True, watch)

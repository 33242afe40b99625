"""Several networks at once, each in a process with its share of the cores.

A step's matrix products are too small to use many cores well; independent networks are not.
"""

import os
import sys
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import torch
from tqdm import tqdm

from sailnet.mission.mission import Mission
from sailnet.networks.network import Network
from training.targets import TARGETS
from training.train import train_network


def train_networks(
    dataset: Path,
    mission: Mission,
    kind: str,
    names: Sequence[str],
    folder: Path,
    *,
    workers: int,
    device: str = "cpu",
    resume: bool = False,
    quiet: bool = False,
) -> list[Network]:
    """Train the named networks of ``TARGETS[kind]``; see :func:`train_network`.

    Args:
        kind: of the data set.
        workers: networks trained at once.
        quiet: show no progress bars.
    """
    workers = min(workers, len(names))
    threads = max(1, (os.cpu_count() or 1) // workers)
    with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
        runs = [
            pool.submit(
                _train,
                dataset,
                mission,
                (kind, name),
                folder,
                threads,
                device,
                resume,
                None if quiet else row,
            )
            for row, name in enumerate(names)
        ]
        return [run.result() for run in runs]


def _train(
    dataset: Path,
    mission: Mission,
    key: tuple[str, str],
    folder: Path,
    threads: int,
    device: str,
    resume: bool,
    row: int | None,
) -> Network:
    torch.set_num_threads(threads)
    target = TARGETS[key[0]][key[1]]
    total = target.recipe(mission.training).epochs
    hidden = True if row is None else None
    with tqdm(
        total=total, desc=f"{target.name:15}", unit="epoch", position=row, disable=hidden, file=sys.stderr
    ) as bar:

        def watch(record: dict[str, float]) -> None:
            bar.set_postfix_str(f"validation {record['validation']:.2e}", refresh=False)
            bar.update(int(record["epoch"]) - bar.n)

        return train_network(dataset, mission, target, folder, device, resume, watch)

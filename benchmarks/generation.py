"""Generation beside a bare heyoka loop and SciPy, on one core; then the whole command on all cores."""

import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import heyoka as hy
import numpy as np

from benchmarks import scipy_peer
from data.block import block_of
from data.box import CANDIDATES, box_recipe
from data.domain import domain_shard
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_lambda_v, propagate_extremals
from sailnet.physics.propagation import TOLERANCE
from sailnet.physics.systems import backward_system, law_kind, parameters
from sailnet.physics.transfer import Transfer


def bare_loop(transfer: Transfer) -> Callable[[Array, Array], None]:
    """A batch Taylor integrator without events, whose samples are thrown away."""
    lanes = int(hy.recommended_simd_size())
    system = backward_system(law_kind(transfer))
    integrator: Any = hy.taylor_adaptive_batch(system, np.ones((6, lanes)), tol=TOLERANCE)

    def run(costates: Array, tau: Array) -> None:
        grid = np.repeat(tau[:, None], lanes, axis=1)
        state = np.empty((6, lanes))
        for start in range(0, len(costates), lanes):
            state[:3] = np.array(transfer.target_state)[:, None]
            state[3:] = costates[start : start + lanes].T
            integrator.set_time(np.zeros(lanes))
            integrator.state[:] = state
            integrator.pars[:] = parameters(transfer, state[4], state[5])[: len(integrator.pars)]
            integrator.propagate_grid(grid)

    return run


def _median(run: Callable[[], object], count: int, repeats: int = 7) -> float:
    """Microseconds an item, the median of several runs after a first one."""
    run()
    times = []
    for _ in range(repeats):
        started = time.perf_counter()
        run()
        times.append(time.perf_counter() - started)
    return 1e6 * float(np.median(times)) / count


def measure(mission: Mission, peers: int, seed: int) -> dict[str, float]:
    """The paper's box: microseconds a trajectory of 351 samples over 10 TU, all on the same costates."""
    problem, recipe = mission.problem, box_recipe(mission)
    rng = np.random.default_rng(seed)
    lambda_u = rng.uniform(*recipe.lambda_u, CANDIDATES)
    lambda_v = arrival_lambda_v(problem, lambda_u, 1.0)
    costates = np.column_stack([rng.uniform(*recipe.lambda_r, CANDIDATES), lambda_u, lambda_v])
    tau = np.linspace(0.0, recipe.duration, recipe.samples_per_trajectory)
    lengths = np.full(CANDIDATES, len(tau))

    def generated() -> None:
        found = propagate_extremals(problem, costates, tau)
        states = found.states.reshape(-1, 6)
        block_of(problem, costates, found.tau.ravel(), states, found.jump_times, lengths)

    bare = bare_loop(problem)
    result = {
        "bare_heyoka": _median(lambda: bare(costates, tau), CANDIDATES),
        "propagated": _median(lambda: propagate_extremals(problem, costates, tau), CANDIDATES),
        "generated": _median(generated, CANDIDATES),
    }
    peer = costates[:peers]
    plain = _median(lambda: [scipy_peer.propagate(problem, c.tolist(), tau) for c in peer], peers, repeats=3)
    arrays = _median(
        lambda: [scipy_peer.propagate(problem, c.tolist(), tau, numpy=True) for c in peer], peers, repeats=1
    )
    domain_shard(mission, 0)
    began, count = time.perf_counter(), 0
    for shard in (1, 2, 3):
        count += len(domain_shard(mission, shard).lengths)
    return result | {
        "dop853_plain_python": plain,
        "dop853_numpy": arrays,
        "over_bare": result["generated"] / result["bare_heyoka"],
        "dop853_plain_python_over_generated": plain / result["generated"],
        "dop853_numpy_over_generated": arrays / result["generated"],
        "aimed_with_expert": 1e6 * (time.perf_counter() - began) / count,
    }


def command(recipe: str, trajectories: int) -> dict[str, float]:
    """The whole command, storage and start-up included."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "dataset.h5"
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        started = time.perf_counter()
        arguments = [str(path), "--recipe", recipe, "--trajectories", str(trajectories), "--quiet"]
        subprocess.run([sys.executable, "-m", "data", *arguments], check=True, stdout=subprocess.DEVNULL)
        wall = time.perf_counter() - started
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        size = path.stat().st_size
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"trajectories": trajectories, "wall_seconds": wall, "cpu_seconds": cpu, "megabytes": size / 1e6}

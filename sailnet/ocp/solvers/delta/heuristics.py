"""GA-PSO and CMA-ES over a box, counted in evaluations; pygmo has the swarm and the covariance matrices.

pygmo's genetic algorithm takes one candidate at a time, its swarm and CMA-ES whole generations, which is
what flights are cheap in: so the genetic half is written here, and the imperialist competitive algorithm,
which pygmo lacks, in :mod:`sailnet.ocp.solvers.delta.imperialist`. pygmo is asked for when a search begins:
all else can do without.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, ClassVar, Protocol

import numpy as np

from sailnet.errors import SailnetError
from sailnet.physics.arrays import Array


def _pygmo() -> Any:
    """The library, which is no dependency of the package's.

    Raises:
        SailnetError: it is not installed.
    """
    try:
        import pygmo
    except ImportError as error:
        raise SailnetError(
            "the delta method searches with pygmo, which is not installed: pip install 'sailnet[ocp]'"
        ) from error
    return pygmo


@dataclass
class Search:
    """A cost over a box, and the best point that its evaluations have met.

    Attributes:
        cost: (m,) costs of (m, d) points; infinite where there is none.
        lower, upper: (d,) corners of the box.
        budget: most evaluations.
        used: evaluations so far.
        best: the best point.
        least: its cost.
        history: (evaluations, least cost) after every generation.
    """

    cost: Callable[[Array], Array]
    lower: Array
    upper: Array
    budget: int
    used: int = 0
    best: Array = field(default_factory=lambda: np.zeros(0))
    least: float = np.inf
    history: list[tuple[int, float]] = field(default_factory=list)

    @property
    def left(self) -> int:
        """Evaluations left."""
        return self.budget - self.used

    def __call__(self, points: Array) -> Array:
        """Costs of points; those beyond the budget are infinite and cost nothing."""
        costs = np.full(len(points), np.inf)
        count = min(len(points), self.left)
        if count == 0:
            return costs
        costs[:count] = self.cost(points[:count])
        self.used += count
        first = int(np.argmin(costs))
        if costs[first] < self.least:
            self.best, self.least = points[first].copy(), float(costs[first])
        self.history.append((self.used, self.least))
        return costs

    def draw(self, rng: np.random.Generator, count: int) -> Array:
        """Points drawn uniformly from the box."""
        return rng.uniform(self.lower, self.upper, (count, len(self.lower)))


class Heuristic(Protocol):
    """Minimises a search until its budget is used."""

    name: ClassVar[str]

    def run(self, search: Search, seed: int) -> None:
        """Use the budget; the same seed gives the same points."""
        ...


class _Posed:
    """A search as pygmo sees it."""

    def __init__(self, search: Search) -> None:
        self.search = search

    def __deepcopy__(self, memo: object) -> "_Posed":
        # pygmo copies its problems, and the evaluations of all copies are counted together.
        return self

    def fitness(self, point: Array) -> Array:
        return self.batch_fitness(point)

    def batch_fitness(self, points: Array) -> Array:
        costs = self.search(np.asarray(points).reshape(-1, len(self.search.lower)))
        # pygmo compares costs by arithmetic that infinity upsets.
        return np.where(np.isfinite(costs), costs, 1e300)

    def get_bounds(self) -> tuple[Array, Array]:
        return self.search.lower, self.search.upper


def _population(search: Search, points: Array, costs: Array, seed: int) -> Any:
    pygmo = _pygmo()
    found = pygmo.population(pygmo.problem(_Posed(search)), size=0, seed=seed)
    for point, cost in zip(points, costs, strict=True):
        found.push_back(point, [cost if np.isfinite(cost) else 1e300])
    return found


@dataclass(frozen=True)
class GaPso:
    """A genetic algorithm whose elite is a particle swarm (Juang, IEEE Trans. SMC-B 34, 2004).

    In a generation the best ``keep`` of the population fly as a swarm; ``cross`` of it are children of the
    elite, chosen by tournaments; the rest are mutants of the elite. Numbers are those of Tables 1 and 3,
    but for the population, whose 5000 would leave ten generations.

    Attributes:
        population: its size.
        keep, cross: shares of it.
        mutation: chance that a child's coefficient is drawn anew.
        flights: generations of the swarm in each of the algorithm's.
        speed: greatest step of the swarm, as a share of the box; pygmo's own 0.5 never settles.
    """

    name: ClassVar[str] = "GA-PSO"
    population: int = 200
    keep: float = 0.4
    cross: float = 0.4
    mutation: float = 0.05
    flights: int = 30
    speed: float = 0.05

    def run(self, search: Search, seed: int) -> None:
        """Use the budget."""
        pygmo, rng = _pygmo(), np.random.default_rng(seed)
        points = search.draw(rng, self.population)
        costs = search(points)
        elite, children = round(self.keep * self.population), round(self.cross * self.population)
        swarm = pygmo.pso_gen(gen=self.flights, max_vel=self.speed, memory=False, seed=seed)
        swarm.set_bfe(pygmo.bfe(pygmo.member_bfe()))
        while search.left > 0:
            best = np.argsort(costs, kind="stable")[:elite]
            flock = _population(search, points[best], costs[best], int(rng.integers(2**31)))
            flock = pygmo.algorithm(swarm).evolve(flock)
            kept, kept_costs = flock.get_x(), flock.get_f()[:, 0]
            new = np.vstack(
                [
                    self._children(search, rng, kept, kept_costs, children),
                    self._mutants(search, rng, kept, self.population - elite - children),
                ]
            )
            points, costs = np.vstack([kept, new]), np.concatenate([kept_costs, search(new)])

    def _children(
        self, search: Search, rng: np.random.Generator, points: Array, costs: Array, count: int
    ) -> Array:
        """Blends of two parents that have each won a tournament of two, some coefficients drawn anew."""
        entrants = rng.integers(len(points), size=(2, count, 2))
        winners = np.where(
            costs[entrants[..., 0]] <= costs[entrants[..., 1]], entrants[..., 0], entrants[..., 1]
        )
        one, two = points[winners]
        children = one + rng.uniform(-0.25, 1.25, one.shape) * (two - one)
        fresh = search.draw(rng, count)
        children = np.where(rng.random(children.shape) < self.mutation, fresh, children)
        return np.clip(children, search.lower, search.upper)

    def _mutants(self, search: Search, rng: np.random.Generator, points: Array, count: int) -> Array:
        """Members of the elite, moved by steps of all sizes down to rounding of the answer."""
        chosen = points[rng.integers(len(points), size=count)]
        width = (search.upper - search.lower) * 10.0 ** rng.uniform(-6.0, -1.0, (count, 1))
        return np.clip(chosen + width * rng.standard_normal(chosen.shape), search.lower, search.upper)


@dataclass(frozen=True)
class CmaEs:
    """CMA-ES, begun again with twice the population when it has converged (IPOP).

    Attributes:
        population: of the first run.
        step: first step, as a share of the box.
    """

    name: ClassVar[str] = "CMA-ES"
    population: int = 50
    step: float = 0.3

    def run(self, search: Search, seed: int) -> None:
        """Use the budget."""
        pygmo, rng, size = _pygmo(), np.random.default_rng(seed), self.population
        while search.left > 0:
            points = search.draw(rng, size)
            begun = _population(search, points, search(points), int(rng.integers(2**31)))
            evolution = pygmo.cmaes(
                gen=max(1, search.left // size),
                sigma0=self.step,
                ftol=1e-10,
                xtol=1e-10,
                force_bounds=True,
                seed=int(rng.integers(2**31)),
            )
            evolution.set_bfe(pygmo.bfe(pygmo.member_bfe()))
            before = search.used
            pygmo.algorithm(evolution).evolve(begun)
            if search.used == before:
                break
            size *= 2

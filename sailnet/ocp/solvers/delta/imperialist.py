"""The imperialist competitive algorithm (Atashpaz-Gargari and Lucas, IEEE CEC 2007)."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from sailnet.ocp.solvers.delta.heuristics import Search
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class Imperialist:
    """Countries in empires: colonies move to their imperialist, empires compete for colonies.

    Numbers are those of Table 1, but for the number of countries, whose 5000 would leave ten decades.

    Attributes:
        countries: how many there are.
        imperialists: how many of them rule at first.
        revolution: share of the colonies that are drawn anew in a decade, at first.
        calming: factor of that share from decade to decade.
        assimilation: a colony moves by up to this times its distance from its imperialist.
        angle: and as far as this times that distance away from the straight line.
        colonies_count: share of its colonies' mean cost in the cost of an empire.
        settled: share of the box within which all countries are one.
    """

    name: ClassVar[str] = "ICA"
    countries: int = 80
    imperialists: int = 8
    revolution: float = 0.3
    calming: float = 0.95
    assimilation: float = 2.0
    angle: float = 0.5
    colonies_count: float = 0.1
    settled: float = 1e-3

    def run(self, search: Search, seed: int) -> None:
        """Use the budget; a world whose countries have all become one begins again."""
        rng = np.random.default_rng(seed)
        while search.left > 0:
            self._world(search, rng)

    def _world(self, search: Search, rng: np.random.Generator) -> None:
        points = search.draw(rng, self.countries)
        costs = search(points)
        order = np.argsort(costs, kind="stable")
        rulers, subjects = order[: self.imperialists], order[self.imperialists :]
        # Stronger imperialists get more colonies.
        owner = np.empty(self.countries, int)
        owner[rulers] = rulers
        owner[subjects] = rng.choice(rulers, len(subjects), p=_shares(costs[rulers]))
        share = self.revolution
        smallest = self.settled * (search.upper - search.lower)
        while search.left > 0 and np.any(np.std(points, axis=0) > smallest):
            colonies = np.flatnonzero(owner != np.arange(self.countries))
            points[colonies] = self._moved(search, rng, points[colonies], points[owner[colonies]], share)
            costs[colonies] = search(points[colonies])
            self._revolt(costs, owner)
            self._compete(rng, costs, owner)
            share *= self.calming

    def _moved(
        self, search: Search, rng: np.random.Generator, points: Array, rulers: Array, share: float
    ) -> Array:
        """Colonies assimilated, some of them revolting instead."""
        towards = rulers - points
        aside = rng.standard_normal(points.shape)
        size = np.linalg.norm(towards, axis=1, keepdims=True)
        aside *= (
            self.angle * size * rng.random((len(points), 1)) / np.linalg.norm(aside, axis=1, keepdims=True)
        )
        moved = points + self.assimilation * rng.random(points.shape) * towards + aside
        rebels = rng.random(len(points)) < share
        moved[rebels] = search.draw(rng, int(rebels.sum()))
        return np.clip(moved, search.lower, search.upper)

    @staticmethod
    def _revolt(costs: Array, owner: Array) -> None:
        """A colony that is better than its imperialist takes its place."""
        for ruler in np.unique(owner):
            members = np.flatnonzero(owner == ruler)
            best = members[np.argmin(costs[members])]
            if costs[best] < costs[ruler]:
                owner[members] = best

    def _compete(self, rng: np.random.Generator, costs: Array, owner: Array) -> None:
        """The weakest empire loses its weakest colony, and falls when it has none left."""
        rulers = np.unique(owner)
        if len(rulers) == 1:
            return
        power = np.empty(len(rulers))
        for i, ruler in enumerate(rulers):
            colonies = np.flatnonzero((owner == ruler) & (np.arange(len(owner)) != ruler))
            power[i] = costs[ruler] + (
                self.colonies_count * np.mean(costs[colonies]) if len(colonies) else 0.0
            )
        weakest = rulers[int(np.argmax(power))]
        winner = rng.choice(rulers, p=_shares(power))
        lost = np.flatnonzero((owner == weakest) & (np.arange(len(owner)) != weakest))
        if len(lost):
            owner[lost[np.argmax(costs[lost])]] = winner
        else:
            owner[weakest] = winner


def _shares(costs: Array) -> Array:
    """Chances that grow as costs fall, by rank so that no cost, infinite or huge, can spoil them."""
    rank = np.empty(len(costs))
    rank[np.argsort(costs, kind="stable")] = np.arange(len(costs), 0, -1)
    return np.asarray(rank / rank.sum())

"""The judgement of all builds: blocks of states, then the worst of them, then the reference itself."""

import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from tqdm import tqdm

from c_runtime import builds as exported_builds
from c_runtime.builds import PRECISIONS
from c_runtime.shared_library import FLAGS
from c_runtime.verification.accuracy.errors import (
    QUANTITIES,
    Tally,
    at_sign_change,
    compare,
    differences,
    in_domain,
    refine,
)
from c_runtime.verification.accuracy.reference import extended, reference
from c_runtime.verification.accuracy.states import Domain
from c_runtime.verification.bench.compiled import Library
from c_runtime.verification.bench.exported_c import NATIVE, compile_exported
from sailnet.networks.guidance_networks import GuidanceNetworks
from sailnet.physics.arrays import Array

TARGETS: Mapping[str, tuple[str, ...]] = {NATIVE: ("-march=native",), "portable": ()}
PAIRS = 1_000
"""Of states between which lambda_v = 0 is looked for, where its sign differs."""

CHECKED = 400
"""States at which the reference itself is judged."""

UNIFORM, FLIGHTS = "uniform in the trained domain", "along optimal flights"


@dataclass(frozen=True)
class Build:
    """One way to compile the exported C."""

    layout: str
    precision: str
    target: str
    library: Library

    @property
    def name(self) -> str:
        """For a person."""
        return f"{self.precision}, {self.layout}, {self.target}"


def compile_builds(compiler: Sequence[str], exported: Path, folder: Path) -> list[Build]:
    """Every layout and precision, with this host's instructions and with the portable ones.

    Raises:
        CompilerError: the compiler refused.
    """
    builds: list[Build] = []
    for build in exported_builds.BUILDS.values():
        for target, instructions in TARGETS.items():
            place, flags = folder / f"build{len(builds)}", (*FLAGS, *instructions)
            library = compile_exported(compiler, exported, place, build=build, flags=flags)
            builds.append(Build(build.layout, build.precision, target, library))
    return builds


@dataclass(frozen=True)
class Judge:
    """Judges builds of one export.

    Attributes:
        networks: what was exported.
        builds: of the C.
        domain: states stay in it.
        seed: of every random number.
    """

    networks: GuidanceNetworks
    builds: Sequence[Build]
    domain: Domain
    seed: int

    def count(self, blocks: Iterator[Array], states: int, kind: str) -> dict[str, Tally]:
        """Errors over blocks of states, by name of the build."""
        tallies = {build.name: Tally() for build in self.builds}
        with tqdm(total=states, desc=kind, unit="state", file=sys.stderr, disable=None) as bar:
            for block in blocks:
                for precision in PRECISIONS:
                    builds = [build for build in self.builds if build.precision == precision]
                    found = compare(self.networks, [build.library for build in builds], block)
                    for build, compared in zip(builds, found, strict=True):
                        tallies[build.name].add(compared)
                bar.update(len(block))
        return tallies

    def uniform(self, states: int) -> Iterator[Array]:
        """Blocks of states, uniform in the box of the domain, that the guard of the C accepts."""
        judge = next(build.library for build in self.builds if build.precision == "float64")
        return self.domain.uniform_inside(lambda rows: in_domain(judge.evaluate(rows)), states, self.seed)

    def refined(self, starts: Mapping[str, Mapping[str, Array]], rounds: int) -> dict[str, dict[str, float]]:
        """Largest errors near the worst states of each build and quantity.

        Args:
            starts: (n, 4) by name of the build and quantity.
            rounds: steps of the search.

        Returns:
            By name of the build: each quantity's largest error, and under ``quantity, extended`` the
            largest at the same states against extended precision.
        """
        found: dict[str, dict[str, float]] = {}
        for build in tqdm(self.builds, "worst states refined", file=sys.stderr, disable=None):
            result = found[build.name] = {}
            for quantity in QUANTITIES:
                start = starts[build.name][quantity]
                result[quantity], worst = refine(
                    lambda rows, one=build, name=quantity: self._error(one, name, rows),  # type: ignore[misc]
                    start,
                    self.domain,
                    rounds,
                    self.seed,
                )
                given = worst.astype(build.precision)
                angle, tau = build.library.evaluate(given).astype(float).T[:2]
                exact = differences(angle, tau, extended(self.networks, given.astype(float)))
                result[f"{quantity}, extended"] = float(exact[quantity].max(initial=0.0))
        return found

    def _error(self, build: Build, quantity: str, rows: Array) -> Array:
        errors = np.full(len(rows), -1.0)
        (compared,) = compare(self.networks, [build.library], rows)
        errors[compared.inside] = compared.errors[quantity]
        return errors

    def sign_changes(self) -> dict[str, dict[str, float]]:
        """Flips close to lambda_v = 0, by name of the build; see ``at_sign_change``."""
        ends = next(self.domain.uniform(2 * PAIRS, self.seed))
        return {build.name: at_sign_change(self.networks, build.library, ends) for build in self.builds}

    def reference_error(self, inputs: Array) -> dict[str, float]:
        """Largest errors of the reference in double precision, against extended precision."""
        mine, exact = reference(self.networks, inputs), extended(self.networks, inputs)
        errors = differences(mine.cone_angle, mine.time_of_flight, exact)
        return {name: float(error.max(initial=0.0)) for name, error in errors.items()}

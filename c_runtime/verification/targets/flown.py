"""One flight steered by a processor in emulation, beside the same flight steered on the host."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from c_runtime.builds import Build
from c_runtime.verification.targets.build import FLY, TargetError, build, flight_flags
from c_runtime.verification.targets.console import ByConsole, FlightComputer
from c_runtime.verification.targets.machines import HOST, Target
from sailnet.flight.closed_loop import Flights, fly_recorded
from sailnet.guidance.backends import exported_folder, load_guidance
from sailnet.guidance.interface import Precision
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission

BOUNDS = {"float32": 2e-4, "float64": 1e-9}
"""On the difference from the host's end, in r [AU], latitude [rad] and speeds [AU/TU], with sums fused.

Rounding alone: commands that differ by it are held for a period, corrections of plans magnify it, and
guidance steers against what comes of them. The plant is the same, in float64. In float32 r is known to
6e-8 AU, and what is left of that when a flight ends is a speed of 2 sqrt(6e-8 a), a the acceleration at the
target: 2e-4 AU/TU at 1 AU.
"""


@dataclass(frozen=True)
class Sail:
    """Which flight it is.

    Attributes:
        start: r [AU], u, v [AU/TU], in space r, latitude [rad], u, v, w; the mission's departure if None.
        disturbance: on top of the mission's.
    """

    start: tuple[float, ...] | None
    disturbance: Disturbance


@dataclass(frozen=True)
class Steered:
    """A flight, and every answer of the computer by its bits.

    Attributes:
        flights: the one.
        bits: of each period the status and the numbers of the command.
        most, mean: instructions of a command; None where nothing counts.
        stack: bytes that ``sailnet_steer`` needs, by the compiler's account; None if nothing was compiled.
    """

    flights: Flights
    bits: list[list[int]] = field(repr=False)
    most: int | None
    mean: float | None
    stack: int | None = None


@dataclass(frozen=True)
class Flown:
    """A flight by one build on one target.

    Attributes:
        mission: its name.
        target, precision, contract: which; ``contract`` if products and sums may be fused.
        flown, host: by the target, and on the host without fusing.
    """

    mission: str
    target: Target
    precision: Precision
    contract: bool
    flown: Steered
    host: Steered

    @property
    def end_difference(self) -> float:
        """Largest difference from the host's end, in r [AU], latitude [rad] and speeds [AU/TU]."""
        return float(np.abs(self.flown.flights.ends - self.host.flights.ends).max())

    @property
    def same_bits(self) -> bool:
        """Every number of every command, and with them the flight, is the host's."""
        return self.flown.bits == self.host.bits and self.end_difference == 0.0

    @property
    def wrong(self) -> list[str]:
        """What should not be; empty if the target flies as it should."""
        found = []
        if not self.flown.flights.arrived[0]:
            found.append("does not arrive")
        if not self.contract and not self.same_bits:
            found.append(f"is not the host's, bit for bit; it ends {self.end_difference:.1e} from it")
        if self.end_difference > BOUNDS[self.precision]:
            found.append(
                f"ends {self.end_difference:.1e} from the host's, more than {BOUNDS[self.precision]:g}"
            )
        return found

    def to_json(self) -> dict[str, object]:
        """As it is stored."""
        flights = self.flown.flights
        return {
            "mission": self.mission,
            "target": self.target.name,
            "precision": self.precision,
            "fused": self.contract,
            "arrived": bool(flights.arrived[0]),
            "periods": int(flights.periods[0]),
            "time_of_flight": float(flights.time_of_flight[0]),
            "end": flights.ends[0].tolist(),
            "end_unlike_host": self.end_difference,
            "time_unlike_host": float(flights.time_of_flight[0] - self.host.flights.time_of_flight[0]),
            "same_bits": self.same_bits,
            "instructions": {"most": self.flown.most, "mean": self.flown.mean},
            "stack": self.flown.stack,
            "wrong": self.wrong,
        }


class Range:
    """Where missions are flown: their flight files, and a place for programs.

    Args:
        sail: that flies.
        folder: for what is built.
        plugin: that counts instructions.
        exported: folder of the one mission's exported files; None for those that ship.
    """

    def __init__(self, sail: Sail, folder: Path, plugin: Path, exported: Path | None = None) -> None:
        self._sail, self._folder, self._plugin, self._exported = sail, folder, plugin, exported
        self._host: dict[tuple[str, Precision], Steered] = {}

    def fly(self, mission: Mission, target: Target, precision: Precision, contract: bool) -> Flown:
        """Build and fly.

        Raises:
            TargetError: it cannot be compiled, or the computer falls silent.
        """
        host = self._host.get((mission.name, precision))
        if host is None:
            host = self._steered(mission, HOST, precision, False)
            self._host[mission.name, precision] = host
        flown = self._steered(mission, target, precision, contract)
        return Flown(mission.name, target, precision, contract, flown, host)

    def _steered(self, mission: Mission, target: Target, precision: Precision, contract: bool) -> Steered:
        chosen = Build(precision, "flight")
        name = f"{target.name}-{precision}-{'fused' if contract else 'exact'}"
        flags = flight_flags(target, chosen, contract)
        exported = exported_folder(mission, self._exported)
        program = build(target, exported, chosen, FLY, flags, self._folder / mission.name / name)
        plugin = self._plugin if target.emulator else None
        start = mission.departure if self._sail.start is None else self._sail.start
        with FlightComputer(target, program.path, precision, plugin, mission.components) as computer:
            same = load_guidance(mission, precision=precision, folder=exported)
            guidance = ByConsole(same, computer)
            flights, _ = fly_recorded(mission, guidance, [start], disturbance=self._sail.disturbance)
            computer.end()
            counts = computer.counts()
        if counts is not None and len(counts) != len(computer.bits):
            raise TargetError(f"{len(computer.bits)} commands, but {len(counts)} were counted")
        most, mean = (None, None) if counts is None else (int(counts.max()), float(counts.mean()))
        return Steered(flights, computer.bits, most, mean, program.stack[1])

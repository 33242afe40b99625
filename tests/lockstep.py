"""Steering in C held against the reference in NumPy step by step: both start each step from the same memory.

Nothing that rounding did before is left then, and what it does in one step is found by asking: the reference
answers also with its memory, and the commands' beta, a few rounding errors beside. Within the spread of those
answers the C's must lie, and where they differ in kind (a status, or a sign that one digit decides) it must
be of one of those kinds.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from typing import Any
from unittest.mock import patch

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.homing import FLOWN
from sailnet.guidance.interface import Commands, Steered
from sailnet.guidance.memory import ARCS, COUNTS, TILTS, Memory
from sailnet.guidance.plans import ANGLE, SMALL, Sails
from sailnet.guidance.rules import rules_for
from sailnet.guidance.steering import ReferenceSteering
from sailnet.guidance.tilts import spread
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array

ROUNDINGS = 8.0
"""How far a nudge goes, in rounding errors: C rounds less often in any one number."""

PLANS = ("arc_tilt", "arc_time", "ahead", "looked", "promised", "nearest", "nearest_time")
"""Of a memory: only what flies its model ahead has them."""

NUDGES = 16
"""Networks round within too, in float by more than a nudge: the farthest of eight fell short once."""


def memory_type(precision: str, mission: Mission) -> np.dtype[np.void]:
    """``sailnet_memory``: the members of the reference's, in order; in space a normal in place of tilts.

    Args:
        precision: of its numbers.
        mission: of which it depends what is remembered.
    """
    components = mission.components
    shapes: dict[str, tuple[str, int | tuple[int, ...]]] = {
        "state": (precision, components),
        "normal": (precision, 3),
        "arc_tilt": (precision, (ARCS,) if components == 3 else (ARCS, 2)),
        "arc_time": (precision, ARCS),
        "ahead": (precision, components),
    }
    left_out = set() if mission.degradation.loss > 0.0 else {"worn"}
    if not mission.flight.homing:
        left_out |= {*PLANS, *COUNTS} - {"periods"}
    known = [item.name for item in fields(Memory) if item.name not in left_out]
    if components > 3:
        known = [name for name in known if name not in TILTS]
        known.insert(known.index("state") + 1, "normal")
    members = [(name, *shapes.get(name, ("u4" if name in COUNTS else precision,))) for name in known]
    return np.dtype(members, align=True)


@dataclass
class Nudged:
    """A guidance that is asked a rounding error beside the question.

    Attributes:
        size: of the largest nudge, relative.
        shown: (n, 3) or (n, 5) states that are exact, as both were shown them.
    """

    guidance: CGuidance
    rng: np.random.Generator
    size: float = 0.0
    shown: Array = field(default_factory=lambda: np.empty((0, 0)))

    def __post_init__(self) -> None:
        self.mission, self.beta_range = self.guidance.mission, self.guidance.beta_range

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        asked = np.asarray(states, float)
        nudged = asked * (1.0 + self.size * self.rng.uniform(-1.0, 1.0, asked.shape))
        sails = np.asarray(beta, float) * (1.0 + self.size * self.rng.uniform(-1.0, 1.0, len(asked)))
        sails = np.clip(sails, *self.beta_range)
        exact = (asked[:, None] == self.shown).all(axis=2).any(axis=1)
        return self.guidance.command(np.where(exact[:, None], asked, nudged), sails)


class Lockstep:
    """Steers by the C, and fails where the reference does not.

    Args:
        guidance: the C.
        count: number of sails.

    Attributes:
        compared: answers in which every number was compared.
        undecided: those whose kind a rounding error decides.
    """

    def __init__(self, guidance: CGuidance, count: int) -> None:
        self._c = guidance.steering(count)
        components = guidance.mission.components
        flown = guidance.mission
        self._homes = bool(flown.flight.homing)
        self._kind = memory_type(guidance.precision, flown)
        assert self._c.memories.shape == (count, self._kind.itemsize)
        self._precision = guidance.precision
        self._epsilon = float(np.finfo(guidance.precision).eps)
        self._double = Nudged(guidance, np.random.default_rng(count))
        self._reference = ReferenceSteering(self._double, count)  # type: ignore[arg-type]
        # Differences of angles, and the time to turn from bound to bound.
        bound, rate = guidance.mission.problem.phi_max, guidance.mission.flight.turn_rate
        self._scales = {
            "memory.slewing": 2.0 * bound / rate,
            "memory.offset": bound,
            "memory.attitude": bound,
            "memory.cone_angle": bound if components > 3 else 0.0,
            "clock_angle": 1.0,
        }
        self._scales["cone_angle"] = bound
        # When a sail is nearest: of what is missing, far from the target, hardly any lies along a step, and
        # what is rounded of the rest is some times as much of the step. These networks end flights anywhere.
        self._scales["hold"] = self._scales["memory.held"] = 1.0
        self._after_miss = rules_for(flown).wait_after_a_miss(flown.problem.target_radius)
        # What a plan is corrected by comes of small differences, and of rounding it has as much the more.
        self._scales |= {
            "memory.arc_tilt": ANGLE / SMALL,
            "memory.arc_time": ANGLE / SMALL,
            "memory.nearest": 1.0,
        }
        self._planned = {
            "cone_angle": ANGLE / SMALL,
            "clock_angle": ANGLE / SMALL,
            "memory.cone_angle": ANGLE / SMALL,
            "memory.attitude": ANGLE / SMALL,
            "memory.slewing": ANGLE / SMALL / rate,
            "time_of_flight": ANGLE / SMALL,
            "memory.time_of_flight": ANGLE / SMALL,
        }
        self.compared = self.undecided = 0

    def memory(self) -> Memory:
        """That of the C, in the reference's form."""
        packed = self._c.memories.view(self._kind)[:, 0]
        wide = {name: packed[name].astype(float) for name in self._kind.fields or {}}
        if "normal" in wide:
            tilt = _tilt_of_normal(wide.pop("normal"))
            wide |= {"cone_angle": tilt, "attitude": tilt} | dict.fromkeys(("measured", "offset"), 0.0 * tilt)
        counts = {name: packed[name].astype(np.int64) for name in COUNTS if name in wide}
        # What the C has not is as it was at the start.
        started = Memory.started(len(packed), 0.0, wide["state"].shape[1])
        return replace(started, **wide | counts)

    def put(self, **values: ArrayLike) -> None:
        """Into the memory of the C, by the reference's names."""
        packed = self._c.memories.view(self._kind)[:, 0]
        for name, value in values.items():
            packed[name] = value

    def steer(
        self, states: ArrayLike, period: float, sails: NDArray[np.intp], attitudes: ArrayLike | None = None
    ) -> Steered:
        """See :class:`sailnet.guidance.interface.Steering`; what the C says.

        Raises:
            AssertionError: the reference says something else.
        """
        shown = np.asarray(states, self._precision).astype(float)
        before = self.memory()
        # A multiple of the golden section is rounded before its whole turns are taken off.
        turned = self._after_miss * before.periods.max()
        self._scales["memory.waited"] = self._scales["memory.wait"] = turned
        measured = None if attitudes is None else np.asarray(attitudes, self._precision).astype(float)
        told = self._c.steer(shown, period, sails, measured)
        self._double.shown = shown
        sizes = [0.0] + [ROUNDINGS * self._epsilon] * NUDGES
        answers = [self._answer(before, shown, period, sails, measured, size) for size in sizes]
        self._compare(_numbers(told, self.memory().rows(sails)), answers)
        return told

    def _answer(
        self,
        before: Memory,
        shown: Array,
        period: float,
        sails: NDArray[np.intp],
        measured: Array | None,
        size: float,
    ) -> dict[str, Array]:
        """Of the reference, with a memory that is nudged."""
        memory, rng = before.rows(np.arange(len(before.held))), self._double.rng
        for item in fields(Memory):
            if item.name not in ("state", *COUNTS, "cone_angle", "attitude", "measured"):
                value = getattr(memory, item.name)
                setattr(memory, item.name, value * (1.0 + size * rng.uniform(-1.0, 1.0, value.shape)))
        # The C rounds of a state by how much it changed, the reference, in double precision, the state.
        changed = memory.held[sails, None] + np.nan_to_num(abs(shown - memory.state[sails]), posinf=0.0)
        rounded = size * changed + 2.0 * np.finfo(float).eps * abs(memory.state[sails]) * (size > 0.0)
        memory.state[sails] += rounded * rng.uniform(-1.0, 1.0, changed.shape)
        self._double.size, self._reference._memory = size, memory
        with patch.object(Sails, "after", self._rounded(size)):
            return _numbers(self._reference.steer(shown, period, sails, measured), memory.rows(sails))

    def _rounded(self, size: float) -> Callable[..., Array]:
        """Where the model flies ahead, in the C's precision: of small differences rounding takes the more."""
        exact, rng = Sails.after, self._double.rng

        def after(*asked: Any) -> Array:
            states = exact(*asked)
            return states + 0.5 * size * states * rng.uniform(-1.0, 1.0, states.shape)

        return after

    def _compare(self, told: dict[str, Array], answers: list[dict[str, Array]]) -> None:
        exact, *nudged = answers
        kinds = np.array([_kinds(answer) for answer in answers])
        decided = (kinds == kinds[0]).all(axis=(0, 2))
        assert (kinds == _kinds(told)).all(axis=2).any(axis=0).all(), "an answer of another kind"
        self.compared += int(decided.sum())
        self.undecided += int((~decided).sum())
        for name, value in exact.items():
            apart = np.max([abs(answer[name] - value) for answer in nudged], axis=0)
            least: Array | float = self._scales.get(name, 0.0)
            if self._homes and name in self._planned:
                flown = spread(exact["memory.homing"] == FLOWN, value)
                least = np.where(flown, self._planned[name], least)
            bound = 4.0 * (apart + self._epsilon * np.maximum(abs(value), least))
            wrong = ~(abs(told[name] - value) <= bound)[decided]
            numbers = (numbers[decided][wrong] for numbers in (told[name], value, bound))
            assert not wrong.any(), "{}: {} is not {} within {}".format(name, *numbers)


def _numbers(steered: Steered, memory: Memory) -> dict[str, Array]:
    """Everything that a step gives, and everything that it leaves in memory, by name."""
    left = {f"memory.{item.name}": np.asarray(getattr(memory, item.name), float) for item in fields(Memory)}
    said = {item.name: getattr(steered, item.name) for item in fields(Steered)}
    if steered.clock_angle is not None:  # by its direction, as pi is where -pi is
        said["clock_angle"] = np.column_stack([np.cos(steered.clock_angle), np.sin(steered.clock_angle)])
    return {name: np.asarray(value, float) for name, value in said.items() if value is not None} | left


def _kinds(answer: dict[str, Array]) -> NDArray[np.int64]:
    """(n, k) what of an answer is no matter of degree."""
    signs = [np.sign(answer[name]) for name in ("cone_angle", "lambda_v", "memory.stake", "memory.regret")]
    signs += [np.sign(answer["lambda_w"])] if "lambda_w" in answer else []
    plans = [answer[f"memory.{name}"] for name in COUNTS]
    return np.stack([answer["status"], *signs, answer["memory.unseen"] > 0.0, *plans], axis=1).astype(
        np.int64
    )


def _tilt_of_normal(normal: Array) -> Array:
    """(n, 2) tilts of :mod:`sailnet.guidance.tilts` that have (n, 3) normals."""
    across = np.hypot(normal[:, 1], normal[:, 2])
    size = np.arctan2(across, normal[:, 0])
    return np.asarray(normal[:, 1:] * (size / np.where(across > 0.0, across, 1.0))[:, None])

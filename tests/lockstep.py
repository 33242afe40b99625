"""Steering in C held against the reference in NumPy step by step: both start each step from the same memory.

Nothing that rounding did before is left then, and what it does in one step is found by asking: the reference
answers also with its memory, its plans, and the commands' beta, a few rounding errors beside. Within the
spread of those answers the C's must lie, and where they differ in kind (a status, or a sign that one digit
decides) it must be of one of those kinds.

Of a plan the derivatives are not compared: they are differences of extremals, of which rounding is a part.
What the next step makes of them is. Of a candidate it is compared what vehicle it is for, and the plan that
it becomes: until it converges rounding decides of its steps, and both compute these by the same C.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from typing import Any
from unittest.mock import patch

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.interface import Commands, Steered
from sailnet.guidance.memory import COUNTS, TILTS, Memory
from sailnet.guidance.steering import ReferenceSteering
from sailnet.guidance.tracker.library import Planned, Tracker, tracker_type
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array

ROUNDINGS = 8.0
"""How far a nudge goes, in rounding errors: C rounds less often in any one number."""

DOUBLE = float(np.finfo(float).eps)
"""A rounding error of what the tracker computes, in either precision."""

NUDGES = 16
"""Networks round within too, in float by more than a nudge: the farthest of eight fell short once."""

MORE_NUDGES = 20
"""So many times as many where those miss a decision of rounding."""

ODD = 3e-3
"""Share of answers that may be like none that was asked for: networks round within, and what decides may be
one rounding of theirs that no nudge of the numbers they are given repeats. In float 8 of 5,400 were seen."""

OUTSIDE = ("tracker", "time_of_flight")
"""Of the reference's memory: what is no part of the estimate."""

KINDS = ("planned", "untried")
"""Of a tracker: what is no matter of degree."""

DEGREES = ("since", "stride", "searched", "promised", "tried", "regret")
"""Of a tracker: numbers that are compared, beside those of its plans."""

OF_PLAN = ("direction", "time_to_go", "beta", "across", "residual", "age")


def memory_type(precision: str, mission: Mission) -> np.dtype[np.void]:
    """``sailnet_memory``: ``estimate``, ``tracker``, and the rest.

    Args:
        precision: of its numbers, but for the tracker's.
        mission: of which it depends what is remembered.
    """
    components = mission.components
    shapes: dict[str, tuple[str, int]] = {"state": (precision, components), "normal": (precision, 3)}
    left_out = set(OUTSIDE) | (set() if mission.degradation.loss > 0.0 else {"worn"})
    known = [item.name for item in fields(Memory) if item.name not in left_out]
    if components > 3:
        known = [name for name in known if name not in TILTS]
        known.insert(known.index("state") + 1, "normal")
    members = [(name, *shapes.get(name, ("u4" if name in COUNTS else precision,))) for name in known]
    estimate = np.dtype(members, align=True)
    marks = [(name, "u4") for name in ("source", "version", "checksum")]
    parts = [("estimate", estimate), ("tracker", tracker_type(components)), ("time_of_flight", precision)]
    return np.dtype([*parts, *marks], align=True)


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
        self.known_plans = self.guidance.known_plans

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        asked = np.asarray(states, float)
        nudged = asked * (1.0 + self.size * self.rng.uniform(-1.0, 1.0, asked.shape))
        sails = np.asarray(beta, float) * (1.0 + self.size * self.rng.uniform(-1.0, 1.0, len(asked)))
        sails = np.clip(sails, *self.beta_range)
        exact = self.is_shown(asked)
        return self.guidance.command(np.where(exact[:, None], asked, nudged), sails)

    def is_shown(self, states: Array) -> NDArray[np.bool_]:
        """(n,) which states are as both were shown them."""
        return np.asarray((states[:, None] == self.shown).all(axis=2).any(axis=1))

    def arrival_directions(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array | None:
        sails = np.asarray(beta, float)
        sails = sails * (1.0 + self.size * self.rng.uniform(-1.0, 1.0, sails.shape))
        return self.guidance.arrival_directions(states, np.clip(sails, *self.beta_range))


class Lockstep:
    """Steers by the C, and fails where the reference does not.

    Args:
        guidance: the C.
        count: number of sails.

    Attributes:
        compared: answers in which every number was compared.
        undecided: those whose kind a rounding error decides.
        odd: those like none that a nudge gave, in kind or in a number.
    """

    def __init__(self, guidance: CGuidance, count: int) -> None:
        self._c = guidance.steering(count)
        components = guidance.mission.components
        flown = guidance.mission
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
        # States and unit vectors, whatever is left of them.
        of_plans = *(f"plan.{name}" for name in OF_PLAN), "candidate.beta", "candidate.across", "flown", "end"
        self._scales |= dict.fromkeys((f"tracker.{name}" for name in of_plans), 1.0)
        self._scales |= {"tracker.regret": 1e-3, "lambda_v": 1.0, "lambda_w": 1.0}
        self.compared = self.undecided = self.odd = 0

    def memory(self) -> Memory:
        """That of the C, in the reference's form."""
        packed = self._c.memories.view(self._kind)[:, 0]
        estimate = packed["estimate"]
        wide = {name: estimate[name].astype(float) for name in estimate.dtype.names or ()}
        wide["time_of_flight"] = packed["time_of_flight"].astype(float)
        if "normal" in wide:
            tilt = _tilt_of_normal(wide.pop("normal"))
            wide |= {"cone_angle": tilt, "attitude": tilt} | dict.fromkeys(("measured", "offset"), 0.0 * tilt)
        counts = {name: estimate[name].astype(np.int64) for name in COUNTS}
        # What the C has not is as it was at the start.
        started = Memory.started(len(packed), 0.0, wide["state"].shape[1])
        return replace(started, **wide | counts | {"tracker": packed["tracker"].copy()})

    def put(self, **values: NDArray[np.generic]) -> None:
        """Into the memory of the C, by the reference's names."""
        packed = self._c.memories.view(self._kind)[:, 0]
        for name, value in values.items():
            (packed if name in OUTSIDE else packed["estimate"])[name] = value

    def steer(
        self, states: ArrayLike, period: float, sails: NDArray[np.intp], attitudes: ArrayLike | None = None
    ) -> Steered:
        """See :class:`sailnet.guidance.interface.Steering`; what the C says.

        Raises:
            AssertionError: the reference says something else.
        """
        shown = np.asarray(states, self._precision).astype(float)
        before = self.memory()
        measured = None if attitudes is None else np.asarray(attitudes, self._precision).astype(float)
        told = self._c.steer(shown, period, sails, measured)
        self._double.shown = shown
        numbers = _numbers(told, self.memory().rows(sails))

        def answers(sizes: list[float]) -> list[dict[str, Array]]:
            return [self._answer(before, shown, period, sails, measured, size) for size in sizes]

        nudges = [ROUNDINGS * self._epsilon] * NUDGES
        given = answers([0.0, *nudges])
        try:
            self._compare(numbers, given, 0.0)
        except AssertionError:
            self._compare(numbers, given + answers(nudges * MORE_NUDGES), ODD)
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
            if item.name not in ("state", *COUNTS, "tracker", "cone_angle", "attitude", "measured"):
                value = getattr(memory, item.name)
                setattr(memory, item.name, value * (1.0 + size * rng.uniform(-1.0, 1.0, value.shape)))
        # The C rounds of a state by how much it changed, the reference, in double precision, the state.
        changed = memory.held[sails, None] + np.nan_to_num(abs(shown - memory.state[sails]), posinf=0.0)
        rounded = size * changed + 2.0 * np.finfo(float).eps * abs(memory.state[sails]) * (size > 0.0)
        memory.state[sails] += rounded * rng.uniform(-1.0, 1.0, changed.shape)
        for plan in ("plan", "candidate") if size > 0.0 else ():
            for near in (memory.tracker[plan]["direction"], memory.tracker[plan]["end"]["value"]):
                near *= 1.0 + ROUNDINGS * DOUBLE * rng.uniform(-1.0, 1.0, near.shape)
        self._double.size, self._reference._memory = size, memory
        with patch.object(Tracker, "follow", self._rounded(size)):
            return _numbers(self._reference.steer(shown, period, sails, measured), memory.rows(sails))

    def _rounded(self, size: float) -> Callable[..., Planned]:
        """The tracker with its beta, its hold and in space its latitude as the C's precision has them."""
        exact, rng = Tracker.follow, self._double.rng

        def follow(
            one: Tracker,
            problem: NDArray[np.void],
            trackers: NDArray[np.void],
            states: Array,
            *given: Any,
        ) -> Planned:
            vehicles, hold, most = given
            beta = vehicles.beta
            near = np.array(states)
            # One of dead reckoning the C rounds.
            rough = ~self._double.is_shown(near)
            near[rough] *= 1.0 + size * rng.uniform(-1.0, 1.0, near[rough].shape)
            for column in (near[:, 1],) if near.shape[1] > 3 else ():
                column *= 1.0 + size * rng.uniform(-1.0, 1.0, len(near))
            # A beta that the plan has already, or has but for rounding, does not move it.
            own = trackers["plan"]["beta"]
            moves = (beta != own) & ((abs(beta - own) > size * own) | (rng.random(len(near)) < 0.5))
            beta = np.where(moves, beta * (1.0 + size * rng.uniform(-1.0, 1.0, len(near))), own)
            estimated = vehicles.estimated * (1.0 + size * rng.uniform(-1.0, 1.0, len(near)))
            hold = hold * (1.0 + size * rng.uniform(-1.0, 1.0, len(near)))
            flown = replace(vehicles, beta=beta, estimated=estimated)
            return exact(one, problem, trackers, near, flown, hold, most)

        return follow

    def _compare(self, told: dict[str, Array], answers: list[dict[str, Array]], share: float) -> None:
        exact, *nudged = answers
        kinds = np.array([_kinds(answer) for answer in answers])
        decided = (kinds == kinds[0]).all(axis=(0, 2))
        # Each by itself: where rounding decides on several, not all combinations are among the nudged.
        odd = ~(kinds == _kinds(told)).any(axis=0).all(axis=1)
        said = ["another kind"] * int(odd.any())
        for name, value in exact.items():
            apart = np.max([abs(answer[name] - value) for answer in nudged], axis=0)
            least = self._scales.get(name, 0.0)
            bound = 4.0 * (apart + self._epsilon * np.maximum(abs(value), least))
            wrong = ~(abs(told[name] - value) <= bound)
            wrong = wrong.reshape(len(odd), -1).any(axis=1) & decided & ~odd
            numbers = (numbers[wrong] for numbers in (told[name], value, bound))
            said += ["{}: {} is not {} within {}".format(name, *numbers)] * int(wrong.any())
            odd |= wrong
        allowed = share * (self.compared + self.undecided + len(odd)) + np.ceil(share) - self.odd
        assert odd.sum() <= max(allowed, 0.0), f"after {self.odd} odd answers {odd.sum()} more: {said}"
        self.compared += int((decided & ~odd).sum())
        self.undecided += int((~decided & ~odd).sum())
        self.odd += int(odd.sum())


def _numbers(steered: Steered, memory: Memory) -> dict[str, Array]:
    """Everything that a step gives, and everything that it leaves in memory, by name."""
    names = [item.name for item in fields(Memory) if item.name != "tracker"]
    left = {f"memory.{name}": np.asarray(getattr(memory, name), float) for name in names}
    left |= _of_tracker(memory.tracker)
    said = {item.name: getattr(steered, item.name) for item in fields(Steered)}
    if steered.clock_angle is not None:  # by its direction, as pi is where -pi is
        said["clock_angle"] = np.column_stack([np.cos(steered.clock_angle), np.sin(steered.clock_angle)])
    return {name: np.asarray(value, float) for name, value in said.items() if value is not None} | left


def _kinds(answer: dict[str, Array]) -> NDArray[np.int64]:
    """(n, k) what of an answer is no matter of degree."""
    signs = [np.sign(answer[name]) for name in ("cone_angle", "lambda_v", "lambda_w") if name in answer]
    plans = [answer[f"tracker.{name}"] for name in (*KINDS, "plan.kinds")]
    others = answer["status"], *(answer[f"memory.{name}"] for name in COUNTS), answer["memory.unseen"] > 0.0
    return np.column_stack([*others, *signs, *plans]).astype(np.int64)


def _of_tracker(trackers: NDArray[np.void]) -> dict[str, Array]:
    """What of trackers is compared."""
    numbers = {name: np.asarray(trackers[name], float) for name in (*KINDS, *DEGREES)}
    plan = trackers["plan"]
    numbers |= {f"plan.{name}": np.asarray(plan[name], float) for name in OF_PLAN}
    numbers["plan.kinds"] = np.column_stack([plan["largest"], plan["differentiated"]]).astype(float)
    for name in ("beta", "across"):
        numbers[f"candidate.{name}"] = trackers["candidate"][name].copy()
    numbers["end"] = plan["end"]["value"].copy()
    attitude = trackers["flown"]
    parts = [np.reshape(attitude[name], (len(trackers), -1)) for name in ("cosine", "sine", "across")]
    numbers["flown"] = np.concatenate(parts, axis=1)
    return {f"tracker.{name}": value for name, value in numbers.items()}


def _tilt_of_normal(normal: Array) -> Array:
    """(n, 2) tilts of :mod:`sailnet.guidance.tilts` that have (n, 3) normals."""
    across = np.hypot(normal[:, 1], normal[:, 2])
    size = np.arctan2(across, normal[:, 0])
    return np.asarray(normal[:, 1:] * (size / np.where(across > 0.0, across, 1.0))[:, None])

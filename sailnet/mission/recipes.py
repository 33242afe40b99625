"""The tables of a mission file that say how data sets are made and networks trained."""

from typing import Annotated, Literal

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer

from sailnet.mission.sections import Count, Interval, NotNegative, Ordered, Positive, Section, Seed, Spacing

Width = Annotated[int, Field(gt=0, le=4096)]
"""Of a layer."""


class Grown(Section):
    """A table with keys that it once had not: unwritten at their defaults, so that artefacts stay valid."""

    @model_serializer(mode="wrap")
    def _without_what_is_usual(self, handler: SerializerFunctionWrapHandler) -> dict[str, object]:
        content: dict[str, object] = handler(self)
        keys = type(self).model_fields
        return {name: value for name, value in content.items() if value != keys[name].default}


class DomainRecipe(Section):
    """Optimal trajectories from everywhere in the generalisation set, widened by a margin.

    ``margin`` is added on both sides of r, u and v [AU, AU/TU, AU/TU], for states that disturbances
    lead to; ``spacing`` is the time between samples [TU].
    """

    margin: Annotated[tuple[NotNegative, NotNegative, NotNegative], Field(strict=False)]
    trajectories: Count
    spacing: Spacing
    seed: Seed


class BoxRecipe(Ordered):
    """The paper's box of arrival costates, Eq. (22), and how each extremal is sampled."""

    lambda_r: Interval
    lambda_u: Interval
    arrival_cone_angle: Literal["positive", "negative"]
    duration: Positive
    max_radius: Positive
    max_jumps: Annotated[int, Field(ge=0, le=1000)]
    nominal_exclusion: NotNegative
    trajectories: Count
    samples_per_trajectory: Annotated[int, Field(ge=2, le=10**6)]
    seed: Seed


class WideRecipe(Grown, Ordered):
    """Optimal trajectories for a range of sails, and approaches to the target from every side.

    For each of ``levels`` values of beta between ``beta`` times the mission's: fastest extremals from
    ``starts`` states of the generalisation set widened by ``margin`` [AU, AU/TU, AU/TU], sampled every
    ``spacing`` [TU]; ``approaches`` extremals of at most ``approach_time`` [TU] around theirs; and the
    fastest from ``around`` states beside the target, which a sail that has missed it is in: at most
    ``around_within`` off, in units of the target's orbit. And, from ``crossings`` states on its ways, what is
    fastest for the others: those whose beta is not as planned.
    """

    beta: Interval
    levels: Annotated[int, Field(ge=2, le=1000)]
    margin: Annotated[tuple[NotNegative, NotNegative, NotNegative], Field(strict=False)]
    starts: Count
    spacing: Spacing
    approaches: Count
    approach_time: Positive
    around: Annotated[int, Field(ge=0, le=10**6)] = 0
    around_within: Annotated[float, Field(ge=1e-3, le=0.5)] = 0.1
    crossings: Annotated[int, Field(ge=0, le=10**6)] = 0
    seed: Seed


class Recipes(Section):
    """How data sets are made: for guidance, aimed at a domain, and where there is one the paper's box."""

    wide: WideRecipe
    domain: DomainRecipe
    box: BoxRecipe | None = None


Hidden = Annotated[tuple[Width, ...], Field(strict=False, min_length=1, max_length=15)]
"""Widths of a network's hidden layers."""


Emphasis = Annotated[float, Field(ge=0.0, le=1.0)]
"""The power of what a wrong angle costs at a sample by which |alpha| learns from more such samples."""


PLAN_EPOCHS, PLAN_SAMPLES = 120, 60_000
"""Most epochs and training samples of the networks of the arrival costates
(docs/notebook/arrival-costates.md)."""


class CommandRecipe(Grown):
    """What the networks of |alpha| and of its side have of their own: their errors lose the fastest way.

    No networks that ship are of their size: they begin with random weights.
    """

    hidden: Hidden
    train_samples: Count
    curvature_samples: Count
    emphasis: Emphasis = 0.0


class TrainingRecipe(Grown):
    """Network size and Levenberg-Marquardt settings.

    ``start`` names the mission whose networks, which come with the package, training begins with; without,
    it begins with random weights. ``command`` is of all networks but that of the time to go.
    """

    hidden: Hidden
    train_samples: Count
    curvature_samples: Count
    validation_samples: Count
    epochs: Count
    patience: Count
    goal: Positive
    seed: Seed
    start: str | None = None
    emphasis: Emphasis = 0.0
    command: CommandRecipe | None = None

    @property
    def of_command(self) -> "TrainingRecipe":
        """The recipe of the networks of |alpha| and of its side."""
        if self.command is None:
            return self
        return self.model_copy(update={**dict(self.command), "start": None, "command": None})

    @property
    def of_plan(self) -> "TrainingRecipe":
        """The recipe of the networks of the arrival costates, which begin with random weights."""
        most = {"epochs": PLAN_EPOCHS, "train_samples": PLAN_SAMPLES}
        less = {name: min(getattr(self, name), number) for name, number in most.items()}
        return self.model_copy(update={**less, "start": None, "command": None})


class Training(Section):
    """Recipes for networks of the paper's form, and for those of approach coordinates on wide data."""

    paper: TrainingRecipe
    wide: TrainingRecipe

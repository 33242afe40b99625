"""What a campaign flies: series of flights under conditions of their own, read from a TOML file."""

import json
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import AfterValidator, Discriminator, Field, Tag, ValidationError, model_validator

from sailnet.errors import CampaignError, GuidanceError, SailnetError
from sailnet.flight.starts import inside_domain, near_departure, off_optima, random_starts
from sailnet.guidance.interface import Guidance
from sailnet.guidance.rules import refuse_long_period
from sailnet.mission.disturbances import Disturbance, disturbance_from
from sailnet.mission.explanation import explain
from sailnet.mission.mission import Mission
from sailnet.mission.sections import Count, Positive, Section, Seed
from sailnet.mission.toml_files import read_table, shipped_names
from sailnet.physics.arrays import Array

InPlane = Annotated[tuple[Positive, float, float], Field(strict=False)]
InSpace = Annotated[tuple[Positive, float, float, float, float], Field(strict=False)]
State = Annotated[
    Annotated[InPlane, Tag("plane")] | Annotated[InSpace, Tag("space")],
    Discriminator(lambda given: "space" if isinstance(given, list | tuple) and len(given) > 3 else "plane"),
]
UpTo = Annotated[int, Field(ge=0, le=10**9)]

Random = Literal["generalisation", "departure", "optima", "domain"]
Starts = Random | Annotated[tuple[State, ...], Field(strict=False, min_length=1)]


def _increasing(values: tuple[float, ...]) -> tuple[float, ...]:
    if list(values) != sorted(set(values)):
        raise ValueError("the values must increase")
    return values


Increasing = Annotated[
    tuple[Positive, ...], Field(strict=False, min_length=1, max_length=1000), AfterValidator(_increasing)
]


def _short_enough(values: tuple[float, ...]) -> tuple[float, ...]:
    try:
        refuse_long_period(max(values))
    except GuidanceError as error:
        raise ValueError(str(error)) from error
    return values


Periods = Annotated[Increasing, AfterValidator(_short_enough)]


def _known(table: dict[str, Any]) -> dict[str, Any]:
    if "seed" in table:
        raise ValueError("the seed is the campaign's own key")
    try:
        disturbance_from(table)
    except SailnetError as error:
        raise ValueError(str(error)) from error
    return table


class Series(Section):
    """Flights under the same conditions; what it leaves out is as the campaign says.

    Attributes:
        name: in a few words, unique in the campaign.
        mission: name of the only mission that flies it; by default all do.
        flights: how many; by default one from each start that is listed.
        starts: ``generalisation`` for random ones of the mission's generalisation set, ``departure`` for
            such of the departure orbit's neighbourhood, ``domain`` for such of all that the guidance says it
            knows, ``optima`` for such beside optimal flights (:mod:`sailnet.flight.starts`); or a list of
            (r, u, v), in three dimensions of (r, latitude, u, v, w), flown in turn.
        off: of starts beside optimal flights, how far off they are, as a share of what is left to the target.
        periods: guidance periods [TU], each of which flies all the flights; the mission's by default.
        disturbance: table of disturbances by name, on top of the mission's.
        optima: the expert is asked how fast the first so many flights could have been; by default all.
    """

    name: Annotated[str, Field(min_length=1, max_length=60)]
    mission: str | None = None
    flights: Count | None = None
    starts: Starts | None = None
    off: Annotated[float, Field(gt=0.0, le=1.0)] | None = None
    periods: Periods | None = None
    disturbance: Annotated[dict[str, Any], AfterValidator(_known)] = Field(default_factory=dict)
    optima: UpTo | None = None

    @property
    def source(self) -> tuple[Starts | None, float | None]:
        """Where it starts: the same starts have the same optima."""
        return self.starts, self.off

    @property
    def known(self) -> int:
        """Flights whose optima are known, for each guidance period."""
        return self.count if self.optima is None else min(self.optima, self.count)

    @property
    def count(self) -> int:
        """Flights for each guidance period."""
        if self.flights is not None:
            return self.flights
        assert isinstance(self.starts, tuple)
        return len(self.starts)

    def states(self, mission: Mission, guidance: Guidance, seed: int, first: int, count: int) -> Array:
        """(count, 3) or (count, 5) starts of flights number ``first`` and on.

        Raises:
            GuidanceError: starts are to be of the guidance's domain, and it has hardly any.
        """
        match self.starts:
            case tuple(listed):
                return np.array(listed)[np.arange(first, first + count) % len(listed)]
            case "optima":
                assert self.off is not None
                return off_optima(mission, count, seed, self.off, first)
            case "departure":
                return near_departure(mission, count, seed, first)
            case "domain":
                return inside_domain(mission, guidance, count, seed, first)
        return random_starts(mission, count, seed, first)

    def disturbances(self, mission: Mission, seed: int) -> Disturbance:
        """Everything that disturbs the flights."""
        return disturbance_from({**self.disturbance, "seed": seed}, mission.disturbance)


class Plan(Section):
    """A campaign: series of flights, and what is kept and reported of them.

    Attributes:
        name: of the campaign and of its files.
        title: heading of its report.
        text: what it is about, for its report.
        seed: of every random number.
        thresholds: terminal errors [AU, AU/TU] at which arrivals are counted; the mission's tolerance is
            always one.
        sample: of the first so many flights of each series trajectories are kept, at one of its periods.
        failures: trajectories of at most so many flights that did not arrive are kept, of each series and
            period; by default of all but a campaign in which nearly nothing arrives. One takes some 20 kB.
        series: with the attributes of the campaign itself where they leave them out.
    """

    schema_version: Annotated[Literal[1], Field(alias="schema")]
    name: Annotated[str, Field(pattern=r"^[a-z0-9][a-z0-9_-]*$", max_length=60)]
    title: Annotated[str, Field(max_length=1000)]
    text: Annotated[str, Field(max_length=100_000)] = ""
    seed: Seed = 2
    flights: Count | None = None
    starts: Starts = "generalisation"
    periods: Periods | None = None
    optima: UpTo | None = None
    thresholds: Increasing = (1e-4, 1e-3, 1e-2)
    sample: UpTo = 10
    failures: UpTo = 5000
    series: Annotated[tuple[Series, ...], Field(strict=False, min_length=1, max_length=1000)]

    @model_validator(mode="after")
    def _complete(self) -> "Plan":
        names = [series.name for series in self.series]
        if len(set(names)) < len(names):
            raise ValueError("two series have the same name")
        for series in self.whole:
            if not isinstance(series.starts, tuple) and series.flights is None:
                raise ValueError(f"say how many flights of {series.name!r} there are: flights = 1000")
            if (series.starts == "optima") != (series.off is not None):
                raise ValueError(f"off, as off = 0.05, belongs to starts beside optima; see {series.name!r}")
        return self

    @property
    def whole(self) -> tuple[Series, ...]:
        """The series with nothing left out but their periods."""
        return tuple(
            series.model_copy(
                update={
                    name: getattr(self, name)
                    for name in ("flights", "starts", "periods", "optima")
                    if getattr(series, name) is None
                    and not (name == "flights" and isinstance(series.starts, tuple))
                }
            )
            for series in self.series
        )

    def periods_of(self, series: Series, mission: Mission) -> tuple[float, ...]:
        """Guidance periods of one of the ``whole`` series [TU]."""
        return series.periods or (mission.flight.period,)

    def sampled_period(self, series: Series, mission: Mission) -> float:
        """That at which a sample of trajectories is kept [TU]: the mission's if it is flown, or the first."""
        periods = self.periods_of(series, mission)
        return mission.flight.period if mission.flight.period in periods else periods[0]

    def flown_by(self, mission: Mission) -> "Plan":
        """Without the series of other missions.

        Raises:
            CampaignError: none is left, or one lists states that are none of this mission's.
        """
        mine = tuple(series for series in self.series if series.mission in (None, mission.name))
        if not mine:
            raise CampaignError(f"no series of campaign {self.name!r} is for mission {mission.name!r}")
        for series in self.model_copy(update={"series": mine}).whole:
            if isinstance(series.starts, tuple) and {*map(len, series.starts)} != {mission.components}:
                raise CampaignError(
                    f"starts of {series.name!r} in campaign {self.name!r} are not all of "
                    f"{mission.components} components, as states of mission {mission.name!r} are"
                )
        return self.model_copy(update={"series": mine})

    def changed(self, flights: int | None, seed: int | None) -> "Plan":
        """With another seed, or so many flights in each series of random starts; None keeps what is.

        Raises:
            CampaignError: a number that the file could not have.
        """
        content = self.model_dump(by_alias=True, mode="json", exclude_none=True)
        if seed is not None:
            content["seed"] = seed
        if flights is not None:
            content["flights"] = flights
            for series in content["series"]:
                if not isinstance(series.get("starts", content["starts"]), list):
                    series["flights"] = flights
        return parse_plan(content, f"{self.name} with other numbers")

    def to_json(self) -> str:
        """Canonical text, as stored in results."""
        return json.dumps(self.model_dump(by_alias=True, mode="json", exclude_none=True), sort_keys=True)


FOLDER = "campaign/campaigns"
"""Of the package, where the campaigns that come with it are."""


def ready_campaigns() -> list[str]:
    """Names of the campaigns that come with the package."""
    return shipped_names(FOLDER)


def single_precision(name: str) -> str:
    """What the results of a campaign are called that was flown in float32 beside those in float64."""
    return f"{name}-float32"


OTHER_LAWS = {"plain-law": "plain law", "told-ageing": "told that it ages"}
"""Where, beside the others, campaigns lie that the same networks flew by another flight file, and what that
is: by ``sailnet.guidance.rules.PLAIN``, or for a sail that is known to age."""


def guided_by(name: str, guidance: str) -> str:
    """What the results of a campaign are called that another guidance than the networks flew."""
    return f"{name}-{guidance}"


def load_plan(name_or_path: str | Path) -> Plan:
    """Load a campaign by name (``generalisation``) or from a TOML file.

    Raises:
        CampaignError: no such campaign, not TOML, an unknown or missing key, a value out of range.
    """
    return parse_plan(read_table(name_or_path, "campaign", FOLDER, CampaignError), str(name_or_path))


def parse_plan(content: dict[str, Any], source: str) -> Plan:
    """Validate the content of a campaign file; ``source`` names it in the message.

    Raises:
        CampaignError: naming each offending key, its value, and what is allowed.
    """
    try:
        return Plan.model_validate(content)
    except ValidationError as error:
        raise CampaignError(f"campaign {source} cannot be flown:\n  {explain(error, Plan)}") from error

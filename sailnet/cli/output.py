"""What commands print: one JSON object for machines, lines with names and units for people."""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from sailnet.physics.units import DAY, TU

Result = dict[str, object]
"""What a command found, by name."""

Told = Callable[[Any], str]
"""A value with its unit."""

NAME_WIDTH = 48


@dataclass(frozen=True)
class Line:
    """How one of a command's results is shown to people.

    Attributes:
        name: what it is, in a few words.
        told: the value with its unit; of None nothing but ``without`` is said.
        without: for a value that there is not.
    """

    name: str
    told: Told = str
    without: str = "not known"

    def text(self, value: object) -> str:
        """The value for people."""
        return self.without if value is None else self.told(value)


Lines = Mapping[str, Line]
"""Of a command, by the name in JSON."""


def readable(result: Result, lines: Lines) -> dict[str, str]:
    """Names and values of a result as people read them, in its order."""
    return {lines[key].name: lines[key].text(value) for key, value in result.items()}


def printed(result: Result, lines: Lines) -> str:
    """A result as it is printed for people."""
    told = readable(result, lines)
    nested = any("\n" in value for value in told.values())
    width = NAME_WIDTH if nested else max(map(len, told), default=0) + 1
    return "\n".join(f"{name:{width}s} {value}" for name, value in told.items())


def number(value: float) -> str:
    """Without a unit, or in the unit that its name says."""
    return f"{value:.8g}"


def in_unit(unit: str) -> Told:
    """In a unit, such as ``deg``."""
    return lambda value: f"{value:.8g} {unit}"


def counted(singular: str) -> Told:
    """Of a number of things, by the name of one."""
    return lambda value: f"{value:.8g} {singular if value == 1 else singular + 's'}"


def time(value: float) -> str:
    """Of a time [TU]."""
    return f"{value:.8g} TU ({value * TU / DAY:.6g} days)"


def angle(value: float) -> str:
    """Of an angle [rad]."""
    return f"{math.degrees(value):.8g} deg"


def percent(value: float) -> str:
    """Of a share or a relative number."""
    return f"{100.0 * value:.6g} %"


def yes_or_no(value: bool) -> str:
    """Of a fact."""
    return "yes" if value else "no"


def components(names: Iterable[str], units: Iterable[str | Told]) -> Told:
    """Of several numbers in a row, each by its name and in its unit, or as that tells it."""
    known = [
        (name, in_unit(unit) if isinstance(unit, str) else unit)
        for name, unit in zip(names, units, strict=True)
    ]
    return lambda values: ", ".join(
        f"{name} {told(value)}" for (name, told), value in zip(known, values, strict=True)
    )


def _of_state(angle_: str | Told, distance: str, speed: str) -> Told:
    """Of a state's three components, or of five in space, where one is an angle."""
    in_plane = components("ruv", (distance, speed, speed))
    names = ("r", "latitude", "u", "v", "w")
    in_space = components(names, (distance, angle_, speed, speed, speed))
    return lambda values: (in_plane if len(values) == 3 else in_space)(values)


state = _of_state(angle, "AU", "AU/TU")
deviation = _of_state("AU", "AU", "AU/TU")
"""Of an error at the end, whose latitude is that times the target's radius."""
deviation_in_si = _of_state("km", "km", "m/s")


def table(told: Told, name: Callable[[str], str] = str) -> Told:
    """Of a mapping: a line each, indented."""
    return lambda values: "".join(
        f"\n    {name(key):{NAME_WIDTH - 4}s} {told(value)}" for key, value in values.items()
    )


def over_flights(told: Told) -> Told:
    """Of the mean and of quantiles by level, as ``sailnet.campaign.shares.Spread`` records them."""
    names = {"mean": "mean", "0.5": "median", "1": "worst"}
    return table(told, lambda level: names.get(level) or f"of {100.0 * float(level):g} % at most")

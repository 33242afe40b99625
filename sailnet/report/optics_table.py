"""Sails side by side: what their coefficients are and what force follows, for machines and for people."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from typing import Any

from sailnet.physics.force_facts import ForceFacts
from sailnet.physics.optics import Optics

ANGLES = (35.0, 60.0)
"""Cone angles at which force and normal are compared [deg]: near the largest transverse force, and at the
bound of the paper."""

BOUNDS = (60.0, 89.0)
"""Bounds on the cone angle that the law is asked about [deg]: the paper's, and next to none."""

SYMBOLS = ("ρ", "s", "ε_f", "ε_b", "B_f", "B_b")
"""Of the coefficients, in their order."""

Record = dict[str, Any]


@dataclass(frozen=True)
class Row:
    """One quantity of every sail.

    Attributes:
        quantity: what it is.
        unit: of the numbers.
        values: one a sail, as people read them.
    """

    quantity: str
    unit: str
    values: Sequence[str]


def facts_of(sails: Mapping[str, Optics], bounds: Sequence[float] = BOUNDS) -> dict[str, ForceFacts]:
    """The facts of sails by name, with bounds on the cone angle [deg]."""
    return {name: ForceFacts.of(optics, [math.radians(b) for b in bounds]) for name, optics in sails.items()}


def optics_record(facts: ForceFacts) -> Record:
    """One sail as JSON: coefficients, force per beta / r^2, angles in degrees."""
    square, linear, across = facts.optics.force
    return {
        "coefficients": asdict(facts.optics),
        "force": {"square": square, "linear": linear, "across": across},
        "facing_share": facts.optics.facing_share,
        "force_off_normal_deg": {f"{a:g}": math.degrees(facts.lean(math.radians(a))) for a in ANGLES},
        "widest_useful_deg": math.degrees(facts.widest_useful),
        "largest_transverse": facts.largest_transverse,
        "bounds": {
            f"{math.degrees(met.phi_max):g}": {
                "jumps_from_deg": math.degrees(met.last) if met.jumps else None,
                "active_from_theta_deg": math.degrees(met.takeover),
            }
            for met in facts.at_bounds
        },
    }


def optics_rows(records: Mapping[str, Record]) -> list[Row]:
    """The same numbers as a table, a column a sail."""
    shown = list(records.values())

    def row(quantity: str, unit: str, *path: str) -> Row:
        return Row(quantity, unit, [_number(_found(record, path)) for record in shown])

    def rows() -> Iterator[Row]:
        for symbol, item in zip(SYMBOLS, fields(Optics), strict=True):
            yield row(f"{item.name.replace('_', ' ')} {symbol}", "1", "coefficients", item.name)
        yield row("S: of cos², along the normal", "β/r²", "force", "square")
        yield row("L: of cos, along the normal", "β/r²", "force", "linear")
        yield row("T: of cos sin, along the surface", "β/r²", "force", "across")
        yield row("force facing the Sun", "of ideal", "facing_share")
        for angle in (f"{a:g}" for a in ANGLES):
            yield row(f"force off the normal at {angle}°", "deg", "force_off_normal_deg", angle)
        yield row("largest useful cone angle", "deg", "widest_useful_deg")
        yield row("largest transverse force", "β/r²", "largest_transverse")
        for bound in dict.fromkeys(bound for record in shown for bound in record["bounds"]):
            yield row(f"jumps to a bound of {bound}° from", "deg", "bounds", bound, "jumps_from_deg")
            yield row(f"bound of {bound}° active from θ", "deg", "bounds", bound, "active_from_theta_deg")

    return list(rows())


def _found(record: Record, path: Sequence[str]) -> float | None:
    value: Any = record
    for name in path:
        value = value.get(name) if value is not None else None
    return None if value is None else float(value)


def _number(value: float | None) -> str:
    return "–" if value is None else f"{value:.6g}"


def optics_lines(names: Sequence[str], rows: Sequence[Row]) -> list[str]:
    """The table as aligned text."""
    table = [("", "unit", *names), *((row.quantity, row.unit, *row.values) for row in rows)]
    widths = [max(len(line[column]) for line in table) for column in range(len(table[0]))]
    return [
        "  ".join(
            cell.ljust(width) if column < 2 else cell.rjust(width)
            for column, (cell, width) in enumerate(zip(line, widths, strict=True))
        )
        for line in table
    ]

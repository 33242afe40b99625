"""The variables of the FMU: the one list of them, for its description and for its C."""

from dataclasses import dataclass
from typing import Literal

from sailnet.guidance.interface import GuidanceStatus
from sailnet.mission.mission import Mission
from sailnet.physics.units import AU, AU_PER_TU, TU

NO_COMMAND = -1
"""Of the output ``status``, before the first command; the others are those of ``GuidanceStatus``."""

STATUSES = {"no_command": NO_COMMAND} | {status.name.lower(): int(status) for status in GuidanceStatus}


@dataclass(frozen=True)
class Variable:
    """One variable.

    Attributes:
        name: of it.
        causality: ``independent``, ``input``, ``output`` or ``parameter``, as FMI has them.
        meaning: in a few words.
        unit: one of ``UNITS``; None without.
        start: None for an output, which is calculated.
        kind: its type in FMI.
    """

    name: str
    causality: Literal["independent", "input", "output", "parameter"]
    meaning: str
    unit: str | None = None
    start: float | bool | None = None
    kind: Literal["Float64", "Boolean", "Enumeration"] = "Float64"


@dataclass(frozen=True)
class Unit:
    """A unit by the base units of the SI.

    Attributes:
        exponents: of base units, by their symbols in FMI.
        factor: of the unit in these.
        shown: other units that people may read it in, and one of it in each.
    """

    exponents: dict[str, int]
    factor: float
    shown: dict[str, float]


DEGREES = 57.29577951308232
DAY_IN_SECONDS = 86400.0

UNITS = {
    "AU": Unit({"m": 1}, AU, {"km": AU / 1e3, "m": AU}),
    "AU/TU": Unit({"m": 1, "s": -1}, AU_PER_TU, {"km/s": AU_PER_TU / 1e3, "m/s": AU_PER_TU}),
    "TU": Unit({"s": 1}, TU, {"d": TU / DAY_IN_SECONDS, "s": TU}),
    "m": Unit({"m": 1}, 1.0, {"km": 1e-3, "AU": 1.0 / AU}),
    "m/s": Unit({"m": 1, "s": -1}, 1.0, {"km/s": 1e-3, "AU/TU": 1.0 / AU_PER_TU}),
    "s": Unit({"s": 1}, 1.0, {"d": 1.0 / DAY_IN_SECONDS, "TU": 1.0 / TU}),
    "rad": Unit({"rad": 1}, 1.0, {"deg": DEGREES}),
}


def variables(mission: Mission) -> list[Variable]:
    """Those of a mission's guidance, in the order of their value references: numbers, status, flags."""
    r, u, v = mission.departure_state
    period = mission.flight.period
    meanings = ("distance from the Sun", "radial speed", "transverse speed")
    units, si = ("AU", "AU/TU", "AU/TU"), ("m", "m/s", "m/s")
    starts, in_si = (r, u, v), (r * AU, u * AU_PER_TU, v * AU_PER_TU)
    held = "guidance period: a command is given at the beginning of each"
    told = (
        ("time_to_go", "predicted time of flight to the target orbit"),
        ("hold", "for how long to hold the cone angle: the period, or less where the flight ends"),
    )
    return [
        Variable("time", "independent", "simulation time", "s"),
        *(
            Variable(name, "input", meaning, unit, start)
            for name, meaning, unit, start in zip("ruv", meanings, units, starts, strict=True)
        ),
        *(
            Variable(f"{name}_si", "input", f"{meaning}; read in place of {name} where si", unit, start)
            for name, meaning, unit, start in zip("ruv", meanings, si, in_si, strict=True)
        ),
        Variable(
            "attitude",
            "input",
            "mean cone angle over the period that ends, as measured; read where attitude_measured",
            "rad",
            0.0,
        ),
        Variable("period", "parameter", held, "TU", period),
        Variable("period_si", "parameter", f"{held}; read in place of period where si", "s", period * TU),
        Variable("cone_angle", "output", "to hold; positive: thrust along the motion", "rad"),
        Variable("beta_estimate", "output", "normalised characteristic acceleration, as learnt in flight"),
        *(Variable(name, "output", meaning, "TU") for name, meaning in told),
        *(Variable(f"{name}_si", "output", meaning, "s") for name, meaning in told),
        Variable("status", "output", "of the command; sailnet_guidance.h says more", kind="Enumeration"),
        Variable(
            "si", "parameter", "read the inputs, and the period, in SI units", start=False, kind="Boolean"
        ),
        Variable(
            "attitude_measured",
            "parameter",
            "tell guidance the attitude",
            start=False,
            kind="Boolean",
        ),
    ]


def header(listed: list[Variable], token: str) -> str:
    """``model.h``: value references, start values, and the token of the description that they are of."""
    numbers = [variable for variable in listed if variable.kind == "Float64"]
    flags = [variable for variable in listed if variable.kind == "Boolean"]
    status = len(numbers)
    references = {variable.name: place for place, variable in enumerate(numbers)} | {"status": status}
    starts = ", ".join(repr(float(variable.start or 0.0)) for variable in numbers)
    inputs = sum(1 << place for place, variable in enumerate(numbers) if variable.causality == "input")
    lines = [
        "/* Written with the FMU: its variables, as modelDescription.xml has them. */",
        "#ifndef MODEL_H",
        "#define MODEL_H",
        f'#define MODEL_TOKEN "{token}"',
        *(f"#define MODEL_{name} {place}u" for name, place in references.items()),
        *(f"#define MODEL_{variable.name} {place}u" for place, variable in enumerate(flags)),
        f"#define MODEL_NUMBERS {len(numbers)}u",
        f"#define MODEL_FIRST_FLAG {status + 1}u",
        f"#define MODEL_FLAGS {len(flags)}u",
        f"#define MODEL_INPUTS {inputs:#x}u",
        f"#define MODEL_STARTS {{{starts}}}",
        f"#define MODEL_NO_COMMAND ({NO_COMMAND})",
        "#endif",
    ]
    return "\n".join(lines) + "\n"

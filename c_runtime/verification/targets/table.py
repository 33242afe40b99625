"""The table of targets, and the limits that flight code has to keep."""

from collections.abc import Sequence
from dataclasses import dataclass

from c_runtime.verification.targets.golden import COMMANDS
from c_runtime.verification.targets.measure import Measured, compiler_version
from sailnet.artefacts.provenance import software

BLOCK = "targets"
"""Of the text that the table goes into."""

MEGAHERTZ = 100.0

HEAD = (
    "| processor | precision | compiled with | instructions, law | steer | code [B] | constants [B] "
    "| static [B] | stack [B] | largest error | CPI | ms |"
)
CAPTION = """\
{commands:,} golden commands and {steps} golden calls of steering on each, in emulation; written by
`make targets-table` on {machine}, {date}, revision {revision}.
*Law* is the tier `sailnet_guidance`, as compiled with `-DSAILNET_LAW_ONLY`; *steer* is
`sailnet_steer`. *Instructions*: of a call with valid input on average, and in brackets the most
of any call, which in steering is a first plan by the networks and the 64 extremals of a guidance period.
*Code*, *constants* and *static* memory (which is written) are of the flight file alone.
*Code*: of the law alone, which is what a linker keeps of it with `-ffunction-sections -Wl,--gc-sections`, /
with steering, constants between functions included.
*Stack*: of the law / of steering, the larger of what was seen written and what the compiler reserves.
*Error*: the
largest difference from the float64 reference in cone angle [rad] / time of flight [TU], each divided by 1 +
|reference|. Where products and sums are fused (`fast`) results differ from the host's by rounding; built
without, and on processors that cannot fuse, all outputs are {same} the host's, bit for bit. *ms* is an
**estimate**: instructions of the law / of the longest call of steering at 100 MHz by the cycles per
instruction (*CPI*), which are assumed, not measured. The tracker computes in double precision, whatever
the precision of the rest: where the processor has none of it, functions of the compiler do."""


@dataclass(frozen=True)
class Limit:
    """What flight code must not exceed.

    Attributes:
        what: is limited, and on which target.
        value: measured.
        limit: that it has to keep.
        aim: that it should keep, None if the limit is all.
    """

    what: str
    value: int
    limit: int
    aim: int | None = None

    @property
    def kept(self) -> bool:
        """Whether the limit is kept."""
        return self.value <= self.limit

    def __str__(self) -> str:
        aim = (
            "" if self.aim is None else f", aim {self.aim:,} {'met' if self.value <= self.aim else 'not met'}"
        )
        return f"{'PASS' if self.kept else 'MISS'}  {self.what}: {self.value:,} (limit {self.limit:,}{aim})"


INSTRUCTIONS = {("cortex-m4f", "float32"): (15_000, 12_000), ("leon3", "float64"): (22_000, 18_000)}
"""Limit and aim of one command by the law."""
INSTRUCTIONS_OF_STEERING = {("cortex-m4f", "float32"): 300_000_000, ("leon3", "float64"): 30_000_000}
"""Limit of the longest call of steering; without doubles in hardware it takes some twenty times as many."""
CODE, STACK = 2048, 512
CODE_OF_STEERING, STACK_OF_STEERING = 24_576, 4096


def deployed(measured: Sequence[Measured]) -> list[Measured]:
    """The builds to fly: of the flight file, fused where the processor can."""
    return [m for m in measured if m.layout == "flight" and m.contract == m.target.fuses]


def limits(measured: Sequence[Measured]) -> list[Limit]:
    """Limits on what was measured."""
    checked = []
    for build in deployed(measured):
        counts = build.run.guidance.counts
        if (build.target.name, build.precision) not in INSTRUCTIONS or counts is None:
            continue
        where = f"{build.target.title} {build.precision}"
        limit, aim = INSTRUCTIONS[build.target.name, build.precision]
        checked += [
            Limit(f"{where}, instructions a command", counts.most, limit, aim),
            Limit(f"{where}, bytes of code, law alone", build.program.law, CODE),
            Limit(f"{where}, bytes of stack, law alone", _stack(build)[0], STACK),
            Limit(f"{where}, bytes of code with steering", build.program.sizes.code, CODE_OF_STEERING),
            Limit(f"{where}, bytes of stack with steering", _stack(build)[1], STACK_OF_STEERING),
            Limit(f"{where}, bytes of static memory", build.program.sizes.static, 0),
        ]
        if (steering := build.run.steering.counts) is not None:
            most = INSTRUCTIONS_OF_STEERING[build.target.name, build.precision]
            checked.append(Limit(f"{where}, instructions a call of steering", steering.most, most))
    return checked


def table(measured: Sequence[Measured]) -> str:
    """The table in Markdown with its caption."""
    rows = [HEAD, "|---" * (HEAD.count("|") - 1) + "|", *map(_row, deployed(measured))]
    steps = max((len(m.run.steering.status) for m in measured), default=0)
    differs = any(m.other_bits for m in measured if not m.contract)
    made = software()
    caption = CAPTION.format(
        commands=COMMANDS,
        steps=steps,
        same="*not*" if differs else "equal to",
        **{name: made[name] for name in ("machine", "date", "revision")},
    )
    return "\n".join([caption, "", *rows, "", *(f"- {limit}" for limit in limits(measured))])


def _stack(build: Measured) -> tuple[int, int]:
    run, reserved = build.run, build.program.stack
    return max(run.guidance.stack, reserved[0]), max(run.steering.stack, reserved[1])


def _row(build: Measured) -> str:
    guidance, steering = build.run.guidance.counts, build.run.steering.counts
    if guidance is None or steering is None:
        raise ValueError(f"nothing was counted on {build.target.name}")
    sizes, cycles = build.program.sizes, build.target.precisions[build.precision]
    flags = [flag for flag in build.program.flags if not flag.startswith("-D")]
    milliseconds = [count * cycles / (1e3 * MEGAHERTZ) for count in (guidance.mean, steering.most)]
    columns = [
        build.target.title,
        build.precision,
        f"gcc {compiler_version(build.target)} `{' '.join(flags)}`",
        f"{guidance.mean:,.0f} ({guidance.most:,})",
        f"{steering.mean:,.0f} ({steering.most:,})",
        f"{build.program.law:,} / {sizes.code:,}",
        f"{sizes.constants:,}",
        f"{sizes.static}",
        " / ".join(map(str, _stack(build))),
        " / ".join(f"{error:.1e}" for error in build.errors[0, :2]),
        f"{cycles:g}",
        " / ".join(f"{each:.2f}" for each in milliseconds),
    ]
    return f"| {' | '.join(columns)} |"

"""The trained domain as C tables, which ``c_runtime/source/domain.c`` evaluates."""

from export.tables import literal
from sailnet.guidance_facts import GuidanceFacts
from sailnet.trained_domain import KNOTS, SMALLEST_SQUARE, Table


def domain_tables(facts: GuidanceFacts) -> str:
    """C source of the constants and bounds of :class:`sailnet.trained_domain.TrainedDomain`.

    Raises:
        ExportError: a bound does not fit single precision.
    """
    domain = facts.domain
    constants = {
        "PER_TARGET_R2": 1.0 / facts.target_state[0] ** 2,
        "SMALLEST_SQUARE": SMALLEST_SQUARE,
        "PER_SIZE_STEP": 1.0 / domain.size_step,
        "MOMENTUM_MIN": domain.momentum_min,
        "PER_MOMENTUM_STEP": 1.0 / domain.momentum_step,
    }
    return "\n".join(
        [
            "/* The trained domain: bounds at the knots, of the direction and then of speed and energy. */",
            f"#define SAILNET_KNOTS {KNOTS}",
            *(f"#define SAILNET_{name} R({literal(value)})" for name, value in constants.items()),
            _table("lower", domain.lower),
            _table("upper", domain.upper),
            "",
        ]
    )


def _table(name: str, rows: Table) -> str:
    written = ",\n".join(f" {{{', '.join(f'R({literal(value)})' for value in row)}}}" for row in rows)
    declared = f"sailnet_domain_{name}[SAILNET_KNOTS][{len(rows[0])}]"
    return f"static const sailnet_real {declared} =\n{{\n{written}\n}};"

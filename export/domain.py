"""The trained domain as C tables, which ``c_runtime/simulation/host/domain.inc`` evaluates."""

import numpy as np

from export.numbers import literal
from sailnet.guidance.facts import GuidanceFacts
from sailnet.networks.trained_domain import AXES, DIRECTIONS, KNOTS, ORBITS, SMALLEST_SQUARE
from sailnet.physics.arrays import Array


def domain_tables(facts: GuidanceFacts) -> str:
    """C source of the constants and bounds of :class:`sailnet.networks.trained_domain.TrainedDomain`.

    Raises:
        ExportError: a bound does not fit single precision.
    """
    domain = facts.domain
    lower, upper = np.array(domain.lower), np.array(domain.upper)
    axes = DIRECTIONS[facts.components]
    along = np.zeros((facts.components, axes))
    along[: AXES.shape[1], : len(AXES)] = AXES.T
    # In space the sizes of the lateral components are bounded as they are.
    along[AXES.shape[1] :, len(AXES) :] = np.eye(axes - len(AXES))
    constants = {
        "PER_TARGET_R2": 1.0 / facts.target_state[0] ** 2,
        "SMALLEST_SQUARE": SMALLEST_SQUARE,
        "PER_SIZE_STEP": 1.0 / domain.size_step,
        "MOMENTUM_MIN": domain.momentum_min,
        "PER_MOMENTUM_STEP": 1.0 / domain.momentum_step,
    }
    return "\n".join(
        [
            "/* The trained domain: bounds at the knots, of the direction and of speed and energy. */",
            f"#define SAILNET_KNOTS {KNOTS}",
            *(f"#define SAILNET_{name} R({literal(value)})" for name, value in constants.items()),
            f"#define SAILNET_AXES {axes}",
            _table(f"axes[{len(along)}][SAILNET_PADDED({axes})]", along),
            *(
                _table(f"{name}[SAILNET_KNOTS][{columns}]", rows)
                for family, columns, part in (
                    ("direction", f"SAILNET_PADDED({axes})", slice(0, axes)),
                    ("orbit", str(ORBITS[facts.components]), slice(axes, None)),
                )
                for name, rows in (
                    (f"{family}_middle", 0.5 * (lower + upper)[:, part]),
                    (f"{family}_half", 0.5 * (upper - lower)[:, part]),
                )
            ),
            "",
        ]
    )


def _table(declared: str, rows: Array) -> str:
    written = ",\n".join(f" {{{', '.join(f'R({literal(value)})' for value in row)}}}" for row in rows)
    return f"static const SAILNET_ALIGNED sailnet_real sailnet_{declared} =\n{{\n{written}\n}};"

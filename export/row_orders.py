"""In which order the numbers of a table's row stand in the C: its compilation chooses."""

from collections.abc import Sequence
from dataclasses import dataclass

LANES = 16
"""Numbers in a vector that is wide enough for networks side by side."""

LARGEST_MACRO = 127
"""Parameters that every C compiler takes."""


@dataclass(frozen=True)
class RowOrder:
    """Rows of one stage: the numbers of all its networks, one network after the other or side by side.

    Attributes:
        networks: evaluated in step.
        rows: numbers of each network.
        alike: whether the networks have equally many layers.
    """

    networks: int
    rows: int
    alike: bool

    @property
    def _chosen(self) -> bool:
        return self.alike and self.networks <= 4 and self.networks * self.rows <= LARGEST_MACRO

    def macros(self) -> str:
        """C source of what all rows of the stage go through, and of the sizes that come of it.

        Side by side, lane l of part m is neuron share m + l / networks of network l % networks.
        """
        apart = [
            "#define STAGE_SIDE_BY_SIDE 0",
            "#define STAGE_PARTS STAGE_NETWORKS",
            "#define STAGE_PART STAGE_WIDTH",
            "#define STAGE_OUTPUTS STAGE_NETWORKS",
            "#define STAGE_OUTPUT STAGE_WIDTH",
        ]
        if not self._chosen:
            return "\n".join(apart)
        share = LANES // self.networks
        names = [[f"n{k}_{i}" for i in range(self.rows)] for k in range(self.networks)]
        parameters = ", ".join(name for network in names for name in network)
        by_network = [[f"({name})" for name in network] for network in names]
        by_neuron = list(zip(*by_network, strict=True))
        parts = [sum(by_neuron[i : i + share], ()) for i in range(0, self.rows, share)]
        return "\n".join(
            [
                f"#if defined(SAILNET_VECTORS) && defined(__AVX512F__) && SAILNET_LANES == {LANES}",
                "#define STAGE_SIDE_BY_SIDE 1",
                f"#define STAGE_SHARE {share}",
                f"#define STAGE_PARTS {len(parts)}",
                "#define STAGE_PART SAILNET_LANES",
                "#define STAGE_OUTPUTS STAGE_ROWS",
                "#define STAGE_OUTPUT SAILNET_PER_16_BYTES",
                f"#define STAGE_ROW({parameters}) {_nested(parts)}",
                f"#define STAGE_OUTPUT_ROW({parameters}) {_nested(by_neuron)}",
                "#else",
                *apart,
                f"#define STAGE_ROW({parameters}) {_nested(by_network)}",
                f"#define STAGE_OUTPUT_ROW({parameters}) {_nested(by_network)}",
                "#endif",
            ]
        )

    def row(self, numbers: Sequence[Sequence[str]], macro: str = "ROW") -> str:
        """The initialiser of one row, of (networks, rows) literals."""
        if not self._chosen:
            return _nested(numbers)
        return f"STAGE_{macro}({', '.join(', '.join(network) for network in numbers)})"


def _nested(rows: Sequence[Sequence[str]]) -> str:
    return "{" + ", ".join("{" + ", ".join(row) + "}" for row in rows) + "}"

"""Every format that is loaded: a whole file of it, how one is spoilt, and what loads it."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random

from benchmarks.fuzz_loaders import column_formats, export_formats, table_formats, tensor_formats

Make = Callable[[Path], Path]
Spoil = Callable[[Path, Random], object]
Load = Callable[[Path], object]


@dataclass(frozen=True)
class Format:
    """One kind of file.

    Attributes:
        make: writes a whole one, and whatever lies beside it, into a folder.
        spoil: changes a copy of it.
        load: as the library does, and uses what it holds; raises ``SailnetError`` where it cannot.
    """

    make: Make
    spoil: Spoil
    load: Load


FORMATS = {
    "mission": Format(table_formats.make_mission, table_formats.spoil, table_formats.load_mission_file),
    "campaign": Format(table_formats.make_campaign, table_formats.spoil, table_formats.load_campaign_file),
    "network": Format(
        tensor_formats.make_network, tensor_formats.spoil_network, tensor_formats.load_network_file
    ),
    "checkpoint": Format(
        tensor_formats.make_checkpoint, tensor_formats.spoil_checkpoint, tensor_formats.load_checkpoint_file
    ),
    "part": Format(tensor_formats.make_part, tensor_formats.spoil_part, tensor_formats.load_part),
    "data set": Format(
        column_formats.make_dataset, column_formats.spoil_dataset, column_formats.load_dataset
    ),
    "results": Format(column_formats.make_results, column_formats.spoil_results, column_formats.load_results),
    "graph": Format(export_formats.make_graph, export_formats.spoil_graph, export_formats.load_graph),
    "library": Format(export_formats.make_library, export_formats.spoil_library, export_formats.load_library),
}

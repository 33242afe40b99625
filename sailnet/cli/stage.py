"""``sailnet data``, ``train`` and ``export``: the steps of the pipeline that are packages of their own."""

from collections.abc import Sequence

from sailnet.cli.arguments import Commands

STAGES = {
    "data": ("data", "A mission's data set: optimal trajectories into an HDF5 file."),
    "train": ("training", "The guidance networks of a data set, by Levenberg-Marquardt."),
    "export": ("export", "Trained networks as C, as shared libraries, and as ONNX graphs."),
}
"""By command: the package that does the work, and what that is."""


def add(commands: Commands) -> None:
    """Add the commands by name alone: their arguments are the packages' own, see :func:`run`."""
    for name, (_, about) in STAGES.items():
        commands.add_parser(name, help=about, add_help=False)


def run(arguments: Sequence[str]) -> int:
    """Run one of ``STAGES``, given its name and its own arguments; returns its exit status.

    Raises:
        SailnetError: what it needs is not installed.
    """
    from sailnet.workers.stages import run_stage

    name, *own = arguments
    return run_stage(STAGES[name][0], own)

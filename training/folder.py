"""What a folder holds before networks are trained into it, and what becomes of that."""

from collections.abc import Mapping
from pathlib import Path

from sailnet.errors import NetworkError
from sailnet.networks.network import load_network
from training import checkpoint


def make_room(folder: Path, runs: Mapping[str, str], *, resume: bool, overwrite: bool) -> None:
    """See that a training that goes on with whatever its own runs left replaces nothing unasked.

    Args:
        folder: where the networks go.
        runs: by name of a network, the digest of the run that is about to train it.
        resume: what these very runs left is to be gone on with; otherwise they begin anew.
        overwrite: what is there may be replaced: finished networks of other runs once the new ones are.

    Raises:
        NetworkError: something is there that may not be replaced.
    """
    for name, run in runs.items():
        state, network = folder / f"{name}.checkpoint.npz", folder / f"{name}.safetensors"
        found = {path: checkpoint.run_of(path) for path in [state] if path.exists()}
        found |= {path: _trained_by(path) for path in [network] if path.exists()}
        foreign = [path for path, left_by in found.items() if left_by != run]
        if not overwrite and (refused := foreign if resume else list(found)):
            what = "is there already"
            if resume:
                what = "is of a run with another data set, recipe, seed, device or number of threads"
            go_on = "" if resume else "go on with it (--resume), "
            raise NetworkError(
                f"{refused[0]} {what}: {go_on}replace it (--overwrite), or name another folder"
            )
        for leftover in folder.glob(f".{name}.*.part"):  # of a process that was killed while it wrote
            leftover.unlink()
        if not resume or state in foreign:
            state.unlink(missing_ok=True)
        if not resume and network not in foreign:
            network.unlink(missing_ok=True)


def _trained_by(path: Path) -> str | None:
    try:
        return str(load_network(path).provenance.get("run"))
    except NetworkError:
        return None

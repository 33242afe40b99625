"""TOML files that come with the package, by name, and one's own, by path."""

import tomllib
from importlib import resources
from pathlib import Path
from typing import Any

from sailnet.errors import SailnetError


def shipped_names(folder: str) -> list[str]:
    """Names of the files in a folder of the package."""
    files = (resources.files("sailnet") / folder).iterdir()
    return sorted(file.name.removesuffix(".toml") for file in files if file.name.endswith(".toml"))


def read_table(
    name_or_path: str | Path, kind: str, folder: str, failure: type[SailnetError]
) -> dict[str, Any]:
    """What a file holds: a path if it ends in ``.toml``, otherwise a name.

    Args:
        name_or_path: which file.
        kind: of thing, for messages.
        folder: of the package, where named files are.
        failure: what is raised.

    Raises:
        SailnetError: of the given type: there is no such file, or it is not TOML.
    """
    path = Path(name_or_path)
    try:
        if path.suffix == ".toml":
            text = path.read_text(encoding="utf-8")
        elif str(name_or_path) in shipped_names(folder):
            text = (resources.files("sailnet") / folder / f"{name_or_path}.toml").read_text("utf-8")
        else:
            raise failure(
                f"no {kind} named {str(name_or_path)!r}: known are {', '.join(shipped_names(folder))}; "
                "or give the path of a .toml file"
            )
        return tomllib.loads(text)
    except (OSError, UnicodeDecodeError) as error:
        raise failure(f"cannot read {kind} file {path}: {error}") from error
    except tomllib.TOMLDecodeError as error:
        raise failure(f"{kind} {name_or_path} is not valid TOML: {error}") from error
